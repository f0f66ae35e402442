// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceFeatureFilter.h"

#include "ArrayNames.h"
#include "DataConversion.h"
#include "FeatureConversion.h"
#include "StageCheck.h"

#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkSurfaceFeatureFilter);

using namespace featurehex;

namespace
{
std::string Joined(const std::vector<std::string>& sentences)
{
  std::string text;
  for (const std::string& sentence : sentences)
  {
    text += (text.empty() ? "" : " ") + sentence;
  }
  return text;
}

void AddSurfaceFigures(const SurfaceCheckReport& report, FigureRow& row)
{
  int cavities = 0;
  int genus = 0;
  for (const SurfaceComponent& component : report.Components)
  {
    cavities += component.Cavity ? 1 : 0;
    genus += component.Genus;
  }
  row.Numbers = { { "NumberOfComponents", static_cast<double>(report.Components.size()) },
    { "NumberOfCavities", cavities }, { "Genus", genus }, { "Volume", report.Volume },
    { "Diagonal", report.Diagonal }, { "MergedPoints", report.NumberOfMergedPoints },
    { "UnusedPoints", report.NumberOfUnusedPoints },
    { "CollapsedTriangles", report.NumberOfCollapsedTriangles },
    { "DuplicateTriangles", report.NumberOfDuplicateTriangles },
    { "FlippedEdges", report.NumberOfFlippedEdges },
    { "ReorientedTriangles", report.NumberOfReorientedTriangles } };
  row.Texts = { { "SurfaceRepairs", Joined(report.Warnings) } };
}

void AddFeatureFigures(
  const SurfaceFeatures& features, const FeatureExtractionReport& report, FigureRow& row)
{
  double invalid = 0;
  for (const FeatureCorner& corner : features.Corners)
  {
    invalid += corner.Valid() ? 0 : 1;
  }
  row.Numbers.insert(row.Numbers.end(),
    { { "NumberOfCorners", static_cast<double>(features.Corners.size()) },
      { "NumberOfCurves", static_cast<double>(features.Curves.size()) },
      { "NumberOfPatches", features.NumberOfPatches }, { "InvalidCorners", invalid },
      { "ContinuedEdges", report.Detection.NumberOfContinuedEdges },
      { "ClosedGaps", report.Detection.NumberOfGaps },
      { "DroppedSpurs", report.Detection.NumberOfSpurs },
      { "RedundantCurves", static_cast<double>(report.RedundantCurves.size()) } });
  row.Texts.push_back({ "FeatureRepairs", Joined(report.Notes) });
}
} // namespace

//------------------------------------------------------------------------------
vtkSurfaceFeatureFilter::vtkSurfaceFeatureFilter()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkSurfaceFeatureFilter::~vtkSurfaceFeatureFilter() = default;

//------------------------------------------------------------------------------
int vtkSurfaceFeatureFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkPointSet");
  if (port >= 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceFeatureFilter::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
featurehex::Status vtkSurfaceFeatureFilter::Compute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, featurehex::Monitor& monitor)
{
  monitor.BeginPhase("checking the surface", 0.0, 0.8);
  const SurfaceMesh input = SurfaceFromPolyData(vtkPolyData::GetData(inputs[0]));
  SurfaceMesh surface = input;
  SurfaceCheckReport report;
  Status status = CheckSurface(surface, SurfaceCheckOptions(), report, monitor);
  if (!status.Ok())
  {
    return status;
  }
  if (!report.Warnings.empty())
  {
    vtkWarningMacro("The surface was repaired: " << Joined(report.Warnings));
  }

  monitor.BeginPhase("finding features", 0.8, 1.0);
  FeatureAnnotation annotation;
  vtkPointSet* given = vtkPointSet::GetData(inputs[1]);
  if (given && this->PreserveFeatures)
  {
    Index otherCells = 0;
    status = AnnotationFromPointSet(input, given, annotation, otherCells);
    if (status.Ok())
    {
      status = MapFeatures(report.Points, annotation.Edges, annotation.Corners);
    }
    if (otherCells > 0)
    {
      vtkWarningMacro(<< otherCells
                      << " cells of the annotation are neither lines nor vertices and "
                      << "are ignored.");
    }
  }
  SurfaceFeatures features;
  FeatureExtractionReport found;
  if (status.Ok())
  {
    status =
      ExtractFeatures(surface, given ? &annotation : nullptr, this->Options(), features, found);
  }
  if (status.Ok())
  {
    const std::size_t triangles = surface.Triangles.size();
    status = CheckStageOutput(
      { "surface check", StagePromise::Conforming,
        { { ArrayNames::PatchId, features.PatchOfTriangle.size(), triangles },
          { ArrayNames::ComponentId, report.ComponentOfTriangle.size(), triangles } } },
      surface);
  }
  if (!status.Ok())
  {
    return status;
  }
  if (!found.Warnings.empty())
  {
    vtkWarningMacro(<< Joined(found.Warnings));
  }

  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  PolyDataFromSurface(surface, output);
  AddArray(output->GetCellData(), ArrayNames::PatchId, features.PatchOfTriangle);
  AddArray(output->GetCellData(), ArrayNames::ComponentId, report.ComponentOfTriangle);
  FigureRow row;
  AddSurfaceFigures(report, row);
  AddFeatureFigures(features, found, row);
  row.Write(output->GetFieldData());

  if (!features.Corners.empty() || !features.Curves.empty())
  {
    vtkPolyData* graph = vtkPolyData::GetData(outputs, 1);
    PolyDataFromFeatures(surface, features, graph);
    AddArray(
      graph->GetFieldData(), ArrayNames::FeatureAngle, std::vector<double>{ this->FeatureAngle });
  }
  return status;
}

//------------------------------------------------------------------------------
featurehex::FeatureExtractionOptions vtkSurfaceFeatureFilter::Options() const
{
  FeatureExtractionOptions options;
  options.PreserveFeatures = this->PreserveFeatures;
  options.Mode = static_cast<featurehex::AnnotationMode>(this->AnnotationMode);
  options.CleanUpAnnotation = this->CleanUpAnnotation;
  options.Detection.FeatureAngle = this->FeatureAngle;
  options.Detection.Hysteresis = this->AngleHysteresis;
  options.Detection.MaximumGap = this->MaximumGap;
  options.Detection.MinimumLength = this->MinimumChainLength;
  options.Graph.CornerAngle = this->CornerAngle;
  options.Graph.EnforceAll = this->EnforceAllFeatures;
  return options;
}

//------------------------------------------------------------------------------
void vtkSurfaceFeatureFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "PreserveFeatures: " << (this->PreserveFeatures ? "on" : "off") << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "AnnotationMode: " << this->AnnotationMode << "\n";
  os << indent << "MaximumGap: " << this->MaximumGap << "\n";
  os << indent << "MinimumChainLength: " << this->MinimumChainLength << "\n";
  os << indent << "EnforceAllFeatures: " << (this->EnforceAllFeatures ? "on" : "off") << "\n";
  os << indent << "AngleHysteresis: " << this->AngleHysteresis << "\n";
  os << indent << "CornerAngle: " << this->CornerAngle << "\n";
  os << indent << "CleanUpAnnotation: " << (this->CleanUpAnnotation ? "on" : "off") << "\n";
}

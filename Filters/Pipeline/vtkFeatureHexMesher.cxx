// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureHexMesher.h"

#include "ArrayNames.h"
#include "BoundaryPatches.h"
#include "DataConversion.h"
#include "FeatureConversion.h"
#include "FeatureHexMesher.h"
#include "HexFeatureConversion.h"
#include "StageCheck.h"
#include "vtkFeatureHexVersion.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <cctype>
#include <string>

#include <sys/resource.h>

vtkStandardNewMacro(vtkFeatureHexMesher);

namespace
{
using namespace featurehex;

/// Of the process so far.
double PeakMemoryMiB()
{
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// "surface check" becomes "SecondsSurfaceCheck".
std::string ColumnOfStage(const std::string& stage)
{
  std::string column = "Seconds";
  bool start = true;
  for (char c : stage)
  {
    if (c != ' ')
    {
      column += start ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    }
    start = c == ' ';
  }
  return column;
}

std::string Join(const std::vector<std::string>& texts)
{
  std::string all;
  for (const std::string& text : texts)
  {
    all += (all.empty() ? "" : " ") + text;
  }
  return all;
}

FigureRow Statistics(const MeshingOptions& options, double timeLimit, const MeshingResult& result)
{
  FigureRow row;
  row.Numbers = result.Validation.Figures();
  row.Numbers.emplace_back(ArrayNames::TargetEdgeLength, result.TargetEdgeLength);
  row.Numbers.emplace_back("Rounds", static_cast<double>(result.Rounds.size()));
  row.Numbers.emplace_back("WantedScaledJacobianMissed", result.Improvement.BelowTarget);
  double total = 0.0;
  for (const StageTiming& timing : result.Timings)
  {
    row.Numbers.emplace_back(ColumnOfStage(timing.Stage), timing.Seconds);
    total += timing.Seconds;
  }
  row.Numbers.emplace_back("SecondsTotal", total);
  row.Numbers.emplace_back("PeakMemoryMiB", PeakMemoryMiB());
  row.Numbers.emplace_back("OptionTolerance", options.Tolerance);
  row.Numbers.emplace_back("OptionTargetEdgeLength", options.TargetEdgeLength);
  row.Numbers.emplace_back("OptionEdgeLengths", options.EdgeLengths.empty() ? 0.0 : 1.0);
  row.Numbers.emplace_back("OptionMaximumLevel", options.MaximumLevel);
  row.Numbers.emplace_back(
    "OptionMaximumNumberOfCells", static_cast<double>(options.MaximumNumberOfCells));
  row.Numbers.emplace_back("OptionMinimumScaledJacobian", options.MinimumScaledJacobian);
  row.Numbers.emplace_back("OptionAlignToPrincipalAxes", options.AlignToPrincipalAxes);
  row.Numbers.emplace_back("OptionMaximumRounds", options.MaximumRounds);
  row.Numbers.emplace_back("OptionFeatureMode", static_cast<double>(options.Features.Mode));
  row.Numbers.emplace_back("OptionFeatureAngle", options.Features.Detection.FeatureAngle);
  row.Numbers.emplace_back("OptionEnforceAllFeatures", options.Features.EnforceAll);
  row.Numbers.emplace_back("OptionTimeLimit", timeLimit);

  std::string reasons;
  for (const MeshingRound& round : result.Rounds)
  {
    if (!round.Reason.empty())
    {
      reasons += (reasons.empty() ? "" : "; ") + round.Reason;
    }
  }
  row.Texts = { { "RoundReasons", reasons }, { "SurfaceRepairs", Join(result.Check.Warnings) },
    { "FeatureRepairs", Join(result.FeatureReport.Notes) },
    { "FeaturesMissed", result.Validation.Features.Complaint() },
    { "Version", vtkFeatureHexVersion::GetVersion() } };
  return row;
}

/// Component of each triangle as it was given, -1 for those that were dropped.
std::vector<Index> ComponentOfInputTriangle(const SurfaceCheckReport& check)
{
  std::vector<Index> component(check.Triangles.size(), -1);
  for (std::size_t t = 0; t < component.size(); ++t)
  {
    if (check.Triangles[t] >= 0)
    {
      component[t] = check.ComponentOfTriangle[check.Triangles[t]];
    }
  }
  return component;
}
} // namespace

//------------------------------------------------------------------------------
vtkFeatureHexMesher::vtkFeatureHexMesher()
{
  this->SetEdgeLengthArray("None");
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(5);
}

//------------------------------------------------------------------------------
vtkFeatureHexMesher::~vtkFeatureHexMesher()
{
  this->SetEdgeLengthArray(nullptr);
}

//------------------------------------------------------------------------------
int vtkFeatureHexMesher::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPolyData" : "vtkPointSet");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkFeatureHexMesher::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* types[] = { "vtkUnstructuredGrid", "vtkPolyData", "vtkPolyData", "vtkTable",
    "vtkTable" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
  return 1;
}

//------------------------------------------------------------------------------
featurehex::MeshingOptions vtkFeatureHexMesher::Options() const
{
  MeshingOptions options;
  options.Tolerance = this->Tolerance;
  options.TargetEdgeLength = this->TargetEdgeLength;
  options.MaximumLevel = this->MaximumLevel;
  options.MaximumNumberOfCells = this->MaximumNumberOfCells;
  options.MinimumScaledJacobian = this->MinimumScaledJacobian;
  options.AlignToPrincipalAxes = this->AlignToPrincipalAxes;
  options.MaximumRounds = this->MaximumRounds;
  return options;
}

//------------------------------------------------------------------------------
featurehex::Status vtkFeatureHexMesher::ReadEdgeLengths(
  vtkPolyData* surface, std::vector<double>& lengths)
{
  const std::string name = this->EdgeLengthArray ? this->EdgeLengthArray : "";
  if (name.empty() || name == "None")
  {
    return Status();
  }
  vtkDataArray* array = surface->GetPointData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != 1)
  {
    return Status(StatusCode::InvalidOption,
      "The surface has no point array \"" + name + "\" with one component, the EdgeLengthArray.");
  }
  for (vtkIdType p = 0; p < array->GetNumberOfTuples(); ++p)
  {
    lengths.push_back(array->GetComponent(p, 0));
  }
  return Status();
}

//------------------------------------------------------------------------------
featurehex::Status vtkFeatureHexMesher::ReadFeatures(const featurehex::SurfaceMesh& surface,
  vtkInformationVector* input, featurehex::FeatureInput& features)
{
  vtkPointSet* given = vtkPointSet::GetData(input);
  features.EnforceAll = this->EnforceAllFeatures;
  features.Detection.FeatureAngle = this->FeatureAngle;
  features.Mode = this->FeatureMode == FeaturesByAngle ? featurehex::FeatureMode::Angle
    : this->FeatureMode == FeaturesOfAnnotation && given ? featurehex::FeatureMode::Given
                                                         : featurehex::FeatureMode::None;
  if (!given || features.Mode == featurehex::FeatureMode::None)
  {
    return Status();
  }
  FeatureAnnotation annotation;
  Index otherCells = 0;
  Status status = AnnotationFromPointSet(surface, given, annotation, otherCells);
  if (otherCells > 0)
  {
    vtkWarningMacro(<< otherCells
                    << " cells of the annotation are neither lines nor vertices and are ignored.");
  }
  features.Edges = std::move(annotation.Edges);
  features.Corners = std::move(annotation.Corners);
  // A graph that lists its corners has all of them.
  if (features.Mode == featurehex::FeatureMode::Given &&
    given->GetCellData()->HasArray(ArrayNames::CornerId))
  {
    features.CornerAngle = 0.0;
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkFeatureHexMesher::Warn(const featurehex::MeshingResult& result)
{
  if (!result.Check.Warnings.empty())
  {
    vtkWarningMacro("The surface was repaired: " << Join(result.Check.Warnings));
  }
  if (!result.FeatureReport.Warnings.empty())
  {
    vtkWarningMacro(<< Join(result.FeatureReport.Warnings));
  }
  const std::string missed = result.Validation.Features.Complaint();
  if (!missed.empty())
  {
    vtkWarningMacro(<< "The mesh is valid, but not all features are met: " << missed << ".");
  }
}

//------------------------------------------------------------------------------
featurehex::Status vtkFeatureHexMesher::Compute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, featurehex::Monitor& monitor)
{
  this->NumberOfHexes = 0;
  this->SmallestScaledJacobian = this->MeanScaledJacobian = this->HausdorffBound = 0.0;
  MeshingOptions options = this->Options();
  monitor.SetTimeLimit(this->TimeLimit);
  const SurfaceMesh surface = SurfaceFromPolyData(vtkPolyData::GetData(inputs[0]));
  Status status = this->ReadFeatures(surface, inputs[1], options.Features);
  if (status.Ok())
  {
    status = this->ReadEdgeLengths(vtkPolyData::GetData(inputs[0]), options.EdgeLengths);
  }
  MeshingResult result;
  if (status.Ok())
  {
    status = MeshSurface(surface, options, monitor, result);
  }
  const std::vector<Quad>& quads = result.Validation.Topology.Boundary.Quads;
  if (status.Ok())
  {
    const std::size_t hexes = result.Mesh.Hexes.size();
    status = CheckStageOutput({ "composite", StagePromise::Certified,
                                { { ArrayNames::Region, result.Region.size(), hexes },
                                  { ArrayNames::Level, result.Level.size(), hexes },
                                  { ArrayNames::ScaledJacobian,
                                    result.Validation.ScaledJacobians.size(), hexes },
                                  { ArrayNames::Deviation,
                                    result.Validation.Distance.Deviation.size(), quads.size() } } },
      result.Mesh);
  }
  if (!status.Ok())
  {
    return status;
  }
  this->Warn(result);
  this->NumberOfHexes = static_cast<vtkIdType>(result.Mesh.Hexes.size());
  this->SmallestScaledJacobian = result.Validation.Quality.Minimum;
  this->MeanScaledJacobian = result.Validation.Quality.Mean;
  this->HausdorffBound = result.Validation.Distance.Upper() / result.Validation.Diagonal;

  if (result.Features.Empty())
  {
    result.Features.PatchOfQuad =
      PatchesOfShells(result.Mesh.Points, quads, surface, ComponentOfInputTriangle(result.Check));
  }
  vtkUnstructuredGrid* mesh = vtkUnstructuredGrid::GetData(outputs, 0);
  GridFromMesh(result.Mesh, mesh);
  AddLabels(
    FeatureLabels(result.Features, quads, result.Mesh.Points.size()), mesh->GetPointData());
  AddArray(mesh->GetCellData(), ArrayNames::Region, result.Region);
  AddArray(mesh->GetCellData(), ArrayNames::Level, result.Level);
  AddArray(mesh->GetCellData(), ArrayNames::ScaledJacobian, result.Validation.ScaledJacobians);
  mesh->GetCellData()->SetActiveScalars(ArrayNames::ScaledJacobian);

  vtkPolyData* boundary = vtkPolyData::GetData(outputs, 1);
  PolyDataFromQuads(result.Mesh.Points, quads, boundary);
  AddArray(boundary->GetCellData(), ArrayNames::PatchId, result.Features.PatchOfQuad);
  AddArray(boundary->GetCellData(), ArrayNames::Deviation, result.Validation.Distance.Deviation);

  if (result.Validation.HasFeatures)
  {
    PolyDataFromHexFeatures(result.Mesh.Points, result.Features, result.Validation.Features,
      vtkPolyData::GetData(outputs, 2));
    AddElements(result.Features, quads, mesh->GetFieldData());
    TableFromFindings(result.Validation.Features, vtkTable::GetData(outputs, 4));
  }
  const FigureRow row = Statistics(options, this->TimeLimit, result);
  row.Write(mesh->GetFieldData());
  row.Write(vtkTable::GetData(outputs, 3));
  return status;
}

//------------------------------------------------------------------------------
void vtkFeatureHexMesher::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "TargetEdgeLength: " << this->TargetEdgeLength << "\n";
  os << indent << "EdgeLengthArray: " << (this->EdgeLengthArray ? this->EdgeLengthArray : "(none)")
     << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "MaximumNumberOfCells: " << this->MaximumNumberOfCells << "\n";
  os << indent << "MinimumScaledJacobian: " << this->MinimumScaledJacobian << "\n";
  os << indent << "AlignToPrincipalAxes: " << (this->AlignToPrincipalAxes ? "on" : "off") << "\n";
  os << indent << "MaximumRounds: " << this->MaximumRounds << "\n";
  os << indent << "FeatureMode: " << this->FeatureMode << "\n";
  os << indent << "FeatureAngle: " << this->FeatureAngle << "\n";
  os << indent << "EnforceAllFeatures: " << (this->EnforceAllFeatures ? "on" : "off") << "\n";
  os << indent << "TimeLimit: " << this->TimeLimit << "\n";
  os << indent << "NumberOfHexes: " << this->NumberOfHexes << "\n";
  os << indent << "SmallestScaledJacobian: " << this->SmallestScaledJacobian << "\n";
  os << indent << "MeanScaledJacobian: " << this->MeanScaledJacobian << "\n";
  os << indent << "HausdorffBound: " << this->HausdorffBound << "\n";
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexValidationFilter.h"

#include "ArrayNames.h"
#include "DataConversion.h"
#include "FeatureConversion.h"
#include "FeatureRecovery.h"
#include "HexFeatureConversion.h"
#include "HexValidation.h"
#include "StageCheck.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkHexValidationFilter);

namespace
{
using namespace featurehex;

/// Names of all bits that are set.
std::string DefectNames(std::uint32_t defects)
{
  std::string names;
  for (std::uint32_t bit = 1; bit <= defects && bit != 0; bit <<= 1)
  {
    if (defects & bit)
    {
      names += (names.empty() ? "" : " ") + std::string(HexDefectName(static_cast<HexDefect>(bit)));
    }
  }
  return names;
}

void AddDefects(const HexMesh& mesh, const HexValidationReport& report, vtkUnstructuredGrid* output,
  vtkUnstructuredGrid* offending)
{
  std::vector<int> defects(mesh.Hexes.size(), 0);
  std::vector<int> certified(mesh.Hexes.size(), 1);
  std::vector<Index> ids;
  std::vector<std::string> reasons;
  for (const OffendingHex& bad : report.Offending)
  {
    defects[bad.Hex] = static_cast<int>(bad.Defects);
    certified[bad.Hex] = bad.Defects & NotCertified ? 0 : 1;
    ids.push_back(bad.Hex);
    reasons.push_back(DefectNames(bad.Defects));
  }
  AddArray(output->GetCellData(), ArrayNames::ScaledJacobian, report.ScaledJacobians);
  output->GetCellData()->SetActiveScalars(ArrayNames::ScaledJacobian);
  AddArray(output->GetCellData(), ArrayNames::Certified, certified);
  AddArray(output->GetCellData(), ArrayNames::Defects, defects);
  GridFromHexes(mesh, ids, output, offending);
  AddArray(offending->GetCellData(), ArrayNames::Reason, reasons);
  AddArray(offending->GetCellData(), ArrayNames::OriginalCellId, ids);
}

/// The features of the surface, and those that the labels of the mesh name.
Status ReadFeatures(vtkUnstructuredGrid* input, const HexMesh& mesh, const SurfaceMesh& surface,
  vtkPolyData* graph, SurfaceFeatures& ofSurface, HexFeatures& ofMesh)
{
  if (surface.Triangles.empty())
  {
    return Status(StatusCode::InvalidOption,
      "Features can only be measured together with the surface they belong to (input 1).");
  }
  FeatureLabels labels;
  Status status = LabelsFromGrid(input, labels);
  if (status.Ok())
  {
    status = FeaturesFromPolyData(surface, graph, ofSurface);
  }
  if (status.Ok())
  {
    ofMesh = RecoverFeatures(mesh, ExtractBoundary(mesh), surface, ofSurface, labels);
  }
  return status;
}
} // namespace

//------------------------------------------------------------------------------
vtkHexValidationFilter::vtkHexValidationFilter()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(4);
}

//------------------------------------------------------------------------------
vtkHexValidationFilter::~vtkHexValidationFilter() = default;

//------------------------------------------------------------------------------
int vtkHexValidationFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  if (port >= 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHexValidationFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* types[] = { "vtkUnstructuredGrid", "vtkTable", "vtkUnstructuredGrid", "vtkTable" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
  return 1;
}

//------------------------------------------------------------------------------
featurehex::Status vtkHexValidationFilter::Compute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, featurehex::Monitor& monitor)
{
  this->Valid = 0;
  this->SmallestScaledJacobian = this->MeanScaledJacobian = this->HausdorffBound = 0.0;
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputs[0]);
  monitor.BeginPhase("checking the hexes");
  HexMesh mesh;
  Status status = MeshFromGrid(input, MeshCheck::Ids, mesh);
  SurfaceMesh surface;
  vtkPolyData* surfaceData = vtkPolyData::GetData(inputs[1]);
  if (status.Ok() && surfaceData)
  {
    status = CheckedSurface(surfaceData, surface, monitor);
  }
  HexValidationOptions options;
  options.Tolerance = this->Tolerance;
  SurfaceFeatures ofSurface;
  HexFeatures ofMesh;
  if (vtkPolyData* graph = vtkPolyData::GetData(inputs[2]); graph && status.Ok())
  {
    status = ReadFeatures(input, mesh, surface, graph, ofSurface, ofMesh);
    options.Features = { &ofSurface, &ofMesh };
    for (FeatureCorner& corner : ofSurface.Corners)
    {
      corner.Flaw = this->EnforceAllFeatures ? CornerFlaw::None : corner.Flaw;
    }
  }
  if (!status.Ok())
  {
    return status;
  }
  const HexValidationReport report =
    ValidateHexMesh(mesh, surfaceData ? &surface : nullptr, options, monitor);
  if (!report.Result.Ok() && report.Result.Code != StatusCode::Validation)
  {
    return report.Result;
  }
  status = CheckStageOutput({ "validation", StagePromise::Ids,
                              { { ArrayNames::ScaledJacobian, report.ScaledJacobians.size(),
                                mesh.Hexes.size() } } },
    mesh);
  if (!status.Ok())
  {
    return status;
  }

  this->Valid = report.Valid() ? 1 : 0;
  this->SmallestScaledJacobian = report.Quality.Minimum;
  this->MeanScaledJacobian = report.Quality.Mean;
  this->HausdorffBound = report.HasSurface ? report.Distance.Upper() / report.Diagonal : 0.0;
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs, 0);
  output->ShallowCopy(input);
  AddDefects(mesh, report, output, vtkUnstructuredGrid::GetData(outputs, 2));
  FigureRow row;
  row.Numbers = report.Figures();
  row.Texts = { { "Verdict", report.Result.Ok() ? "valid" : report.Result.Message } };
  if (report.HasFeatures)
  {
    row.Texts.push_back({ "FeaturesMissed", report.Features.Complaint() });
    TableFromFindings(report.Features, vtkTable::GetData(outputs, 3));
  }
  row.Write(output->GetFieldData());
  row.Write(vtkTable::GetData(outputs, 1));
  return Status();
}

//------------------------------------------------------------------------------
void vtkHexValidationFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "EnforceAllFeatures: " << (this->EnforceAllFeatures ? "on" : "off") << "\n";
  os << indent << "Valid: " << this->Valid << "\n";
  os << indent << "SmallestScaledJacobian: " << this->SmallestScaledJacobian << "\n";
  os << indent << "MeanScaledJacobian: " << this->MeanScaledJacobian << "\n";
  os << indent << "HausdorffBound: " << this->HausdorffBound << "\n";
}

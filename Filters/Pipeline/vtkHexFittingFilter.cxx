// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexFittingFilter.h"

#include "ArrayNames.h"
#include "DataConversion.h"
#include "HexUntangling.h"
#include "ProvenFitting.h"
#include "RefinementConversion.h"
#include "StageCheck.h"
#include "StageFeatures.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <limits>
#include <string>

vtkStandardNewMacro(vtkHexFittingFilter);

using namespace featurehex;

//------------------------------------------------------------------------------
vtkHexFittingFilter::vtkHexFittingFilter()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkHexFittingFilter::~vtkHexFittingFilter() = default;

//------------------------------------------------------------------------------
int vtkHexFittingFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  if (port >= 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHexFittingFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
featurehex::Status vtkHexFittingFilter::Compute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, featurehex::Monitor& monitor)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputs[0]);
  monitor.BeginPhase("checking the hexes", 0.0, 0.02);
  HexMesh mesh;
  Status status = MeshFromGrid(input, MeshCheck::Conforming, mesh);
  if (!status.Ok())
  {
    return status;
  }
  if (const std::size_t inverted = InvertedHexes(mesh).size(); inverted > 0)
  {
    return Status(StatusCode::InvalidMesh,
      std::to_string(inverted) +
        " hexes are inverted. Use the Hex Untangle filter before this one.");
  }
  std::vector<int> level;
  if (input->GetCellData()->HasArray(ArrayNames::Level))
  {
    status = ReadCellArray(input, ArrayNames::Level, "the Octree Dual Hex filter makes it", level);
  }
  SurfaceMesh checked;
  if (status.Ok())
  {
    monitor.BeginPhase("checking the surface", 0.02, 0.1);
    status = CheckedSurface(vtkPolyData::GetData(inputs[1]), checked, monitor);
  }
  if (!status.Ok())
  {
    return status;
  }

  monitor.BeginPhase("fitting to the surface", 0.1, 1.0);
  const SurfaceGeometry surface(std::move(checked));
  const HexStars stars(mesh);
  const double edgeLength = FieldValue(input->GetFieldData(), ArrayNames::TargetEdgeLength, 0.0);
  StageFeatures features;
  status = features.Read(surface.Mesh(), vtkPolyData::GetData(inputs[2]), edgeLength);
  if (status.Ok())
  {
    status = features.ReadTargets(this, input, mesh, stars);
  }
  if (!status.Ok())
  {
    return status;
  }
  ProvenFittingOptions options;
  options.Tolerance = this->Tolerance;
  options.MinimumScaledJacobian = this->MinimumScaledJacobian;
  options.FittingIterations = this->FittingIterations;
  options.ImprovementRounds = this->ImprovementRounds;
  ProvenFittingReport report;
  status = ProvenFitting(surface, options).Run(
    mesh, stars, features.Targets(), nullptr, report, monitor);
  const std::vector<Vec3>& places = report.Places;
  if (status.Ok())
  {
    // A mesh that is to be refined anyway only has to be sound. The check is cheap beside the fit.
    status = CheckStageOutput(
      { "fitting", places.empty() ? StagePromise::Certified : StagePromise::PositiveCorners }, mesh,
      CheckDepth::Full);
  }
  if (!status.Ok())
  {
    return status;
  }
  const bool improved = this->MinimumScaledJacobian > 0 && report.Improvement.Drawn;
  FigureRow row;
  row.Numbers = { { "WithinTolerance", report.Outcome == FittingOutcome::Proven ? 1.0 : 0.0 },
    { "Improved", improved ? 1.0 : 0.0 } };
  if (improved)
  {
    row.Numbers.emplace_back("HexesBelowMinimum", report.Improvement.BelowTarget);
  }
  if (features.Targets())
  {
    row.Numbers.emplace_back("VerticesOffFeatures", report.Improvement.OffFeatures);
  }

  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs, 0);
  GridFromMesh(mesh, output);
  PassArrays(input, output);
  row.Write(output->GetFieldData());
  std::vector<std::pair<RefinementPoint, std::string>> points;
  AppendPlaces({ mesh.Points, stars.Quads, stars.QuadOwners, level, edgeLength }, report.Places,
    std::numeric_limits<int>::max(), "distance", points);
  PolyDataFromRefinementPoints(points, vtkPolyData::GetData(outputs, 1));
  return status;
}

//------------------------------------------------------------------------------
void vtkHexFittingFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "MinimumScaledJacobian: " << this->MinimumScaledJacobian << "\n";
  os << indent << "FittingIterations: " << this->FittingIterations << "\n";
  os << indent << "ImprovementRounds: " << this->ImprovementRounds << "\n";
}

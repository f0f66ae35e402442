// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexFittingFilter.h"

#include "ArrayNames.h"
#include "BoundaryPatches.h"
#include "DataConversion.h"
#include "HexUntangling.h"
#include "ProvenFitting.h"
#include "StageCheck.h"
#include "SurfaceSizing.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkHexFittingFilter);

namespace
{
using namespace featurehex;

/// One level finer than the hexes next to @a places.
std::vector<std::pair<RefinementPoint, std::string>> PointsToRefine(const HexMesh& mesh,
  const HexStars& stars, const std::vector<Vec3>& places, const std::vector<int>& level,
  double edgeLength)
{
  std::vector<RefinementPoint> points;
  const std::vector<Index> nearest = NearestQuads(mesh.Points, stars.Quads, places);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const int current = level.empty() ? 0 : level[stars.QuadOwners[nearest[i]]];
    points.push_back({ places[i], current + 1 });
  }
  if (edgeLength > 0)
  {
    points = ThinRefinementPoints(points, edgeLength);
  }
  std::vector<std::pair<RefinementPoint, std::string>> result;
  for (const RefinementPoint& point : points)
  {
    result.emplace_back(point, "distance");
  }
  return result;
}
} // namespace

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
  this->WarnAboutFeatures(inputs[2]);
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
  ProvenFittingOptions options;
  options.Tolerance = this->Tolerance;
  options.MinimumScaledJacobian = this->MinimumScaledJacobian;
  options.FittingIterations = this->FittingIterations;
  options.ImprovementRounds = this->ImprovementRounds;
  ProvenFittingReport report;
  status = ProvenFitting(surface, options).Run(mesh, stars, nullptr, report, monitor);
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

  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs, 0);
  GridFromMesh(mesh, output);
  PassArrays(input, output);
  row.Write(output->GetFieldData());
  const double edgeLength = FieldValue(input->GetFieldData(), ArrayNames::TargetEdgeLength, 0.0);
  PolyDataFromRefinementPoints(
    PointsToRefine(mesh, stars, places, level, edgeLength), vtkPolyData::GetData(outputs, 1));
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

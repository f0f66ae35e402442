// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexFittingFilter.h"

#include "ArrayNames.h"
#include "BoundaryPatches.h"
#include "CertifiedDistance.h"
#include "DataConversion.h"
#include "HexFitting.h"
#include "HexImprovement.h"
#include "HexUntangling.h"
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

// As in the composite (recipe-quality 2 and 3).
constexpr double SampleSpacing = 0.5; // tolerances, between samples of the input
constexpr int QuadGrid = 7;           // samples per quad side

constexpr double RefineBeyond =
  1.4; // tolerances: the improvement repairs the rest (recipe-pipeline 2.8)

/// Samples of the surface farther than @a limit from the boundary, either way.
std::vector<Vec3> SamplesBeyond(SurfaceEnvelope& envelope, const HexStars& stars, double limit)
{
  std::vector<EnvelopeContact> contacts;
  for (Index q = 0; q < static_cast<Index>(stars.Quads.size()); ++q)
  {
    envelope.Collect(q, limit, contacts);
  }
  std::vector<Vec3> places;
  for (const EnvelopeContact& contact : contacts)
  {
    places.push_back(contact.SurfacePoint);
  }
  return places;
}

/// Both directions: points of the mesh and of the surface that are not proven to be near enough.
std::vector<Vec3> WitnessPoints(const DistanceDecision& decision)
{
  std::vector<Vec3> places;
  for (const std::vector<DistanceWitness>* witnesses : { &decision.Triangles, &decision.Quads })
  {
    for (const DistanceWitness& witness : *witnesses)
    {
      places.push_back(witness.Point);
    }
  }
  return places;
}

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

  monitor.BeginPhase("fitting to the surface", 0.1, 0.5);
  const SurfaceGeometry surface(std::move(checked));
  const double tolerance = this->Tolerance * surface.Diagonal();
  const std::vector<Vec3> samples = surface.Samples(SampleSpacing * tolerance);
  const HexStars stars(mesh);
  SurfaceEnvelope envelope(surface, samples, mesh, stars, QuadGrid);
  FittingOptions fitting;
  fitting.Tolerance = this->Tolerance;
  fitting.Iterations = this->FittingIterations;
  status = FitHexes(mesh, stars, surface, envelope, fitting, monitor);
  std::vector<Vec3> places;
  if (status.Ok())
  {
    places = SamplesBeyond(envelope, stars, RefineBeyond * tolerance);
  }
  FigureRow row;
  row.Numbers = { { "WithinTolerance", 0.0 }, { "Improved", 0.0 } };
  if (status.Ok() && places.empty() && this->MinimumScaledJacobian > 0)
  {
    ImprovementReport report;
    monitor.BeginPhase("improving the worst hexes", 0.5, 0.9);
    ImprovementOptions improvement;
    improvement.Tolerance = this->Tolerance;
    improvement.MinimumScaledJacobian = this->MinimumScaledJacobian;
    improvement.MaximumRounds = this->ImprovementRounds;
    status = ImproveHexes(mesh, stars, surface, envelope, improvement, report, monitor);
    row.Numbers[1].second = report.Drawn;
    if (!report.Drawn)
    {
      places = SamplesBeyond(envelope, stars, improvement.EnvelopeShare * tolerance);
    }
    row.Numbers.emplace_back("HexesBelowMinimum", report.BelowTarget);
  }
  if (status.Ok() && places.empty())
  {
    monitor.BeginPhase("measuring distances", 0.9, 1.0);
    const DistanceDecision decision =
      CertifiedDistance(surface.Mesh())
        .DistanceWithin(mesh.Points, stars.Quads, tolerance, monitor);
    row.Numbers[0].second = decision.Within;
    places = WitnessPoints(decision);
  }
  if (!status.Ok())
  {
    return status;
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

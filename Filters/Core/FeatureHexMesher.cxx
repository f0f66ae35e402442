// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureHexMesher.h"

#include "AutomaticSizing.h"
#include "FeatureSizing.h"
#include "MeshingRounds.h"
#include "MessageText.h"
#include "SurfaceSizing.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
constexpr double FarFromOrigin = 100;    // diagonals
}

Status MeshingRounds::CheckOptions(const SurfaceMesh& surface) const
{
  const auto bad = [](const std::string& text) { return Status(StatusCode::InvalidOption, text); };
  if (!(this->Options.Tolerance > 0 && this->Options.Tolerance < 1))
  {
    return bad("Tolerance is " + NumberText(this->Options.Tolerance) +
      "; it is a fraction of the bounding-box diagonal, above 0 and below 1 (default 0.005).");
  }
  if (!(this->Options.TargetEdgeLength >= 0 && this->Options.TargetEdgeLength < 1e300))
  {
    return bad("TargetEdgeLength is " + NumberText(this->Options.TargetEdgeLength) +
      "; give a length in model units, or 0 for automatic.");
  }
  const std::vector<double>& lengths = this->Options.EdgeLengths;
  if (!lengths.empty() && lengths.size() != surface.Points.size())
  {
    return bad("There are " + std::to_string(lengths.size()) + " edge lengths for " +
      std::to_string(surface.Points.size()) + " points of the surface; give one for each.");
  }
  const auto wrong = std::find_if(lengths.begin(), lengths.end(),
    [](double length) { return !(length >= 0 && length < 1e300); });
  if (wrong != lengths.end())
  {
    const std::size_t p = wrong - lengths.begin();
    return Status(StatusCode::InvalidOption,
      "The edge length wanted at point " + std::to_string(p) + ", " +
        PlaceText(surface.Points[p]) + ", is " + NumberText(*wrong) +
        "; give a length in model units, or 0 for no wish.",
      { surface.Points[p] });
  }
  return Status();
}

/// A surface far from the origin has few bits left for its shape: all stages work near the origin.
/// The shift is a multiple of the spacing of its coordinates, so that no point of the surface is
/// rounded.
void MeshingRounds::MoveToOrigin(SurfaceMesh& surface)
{
  const Box box = BoundingBox(surface);
  for (int k = 0; k < 3; ++k)
  {
    const double center = box.Center()[k];
    if (std::abs(center) > FarFromOrigin * box.Diagonal())
    {
      int exponent = 0;
      std::frexp(std::max(std::abs(box.Low[k]), std::abs(box.High[k])), &exponent);
      const double spacing = std::ldexp(1.0, exponent - 53);
      this->Offset[k] = std::round(center / spacing) * spacing;
    }
  }
  for (Vec3& p : surface.Points)
  {
    p -= this->Offset;
  }
}

std::vector<Vec3> MeshingRounds::MovedBack(std::vector<Vec3> points) const
{
  for (Vec3& p : points)
  {
    p += this->Offset;
  }
  return points;
}

Status MeshingRounds::Prepare(const SurfaceMesh& input)
{
  SurfaceMesh checked = input;
  {
    const StageClock clock(this->Result.Timings, "surface check");
    this->Progress.BeginPhase("checking the surface", 0.0, 0.05);
    const Status status =
      CheckSurface(checked, SurfaceCheckOptions(), this->Result.Check, this->Progress);
    if (!status.Ok())
    {
      return status;
    }
  }
  if (Status status = this->FindFeatures(checked); !status.Ok())
  {
    return status;
  }
  this->MoveToOrigin(checked);
  const StageClock clock(this->Result.Timings, "sizing");
  this->Progress.BeginPhase("measuring thickness and gaps", 0.05, 0.1);
  this->Surface = std::make_unique<SurfaceGeometry>(std::move(checked));
  this->Winding = WindingNumber(this->Surface->Mesh());
  ProvenFittingOptions fitting;
  fitting.Tolerance = this->Options.Tolerance;
  fitting.MinimumScaledJacobian = this->Options.MinimumScaledJacobian;
  this->Fitting = std::make_unique<ProvenFitting>(*this->Surface, fitting);
  this->EdgeLength = this->Options.TargetEdgeLength > 0
    ? this->Options.TargetEdgeLength
    : AutomaticEdgeLength(*this->Surface, this->Result.SurfaceGraph,
        GridAxes(this->Surface->Mesh(), this->Options.AlignToPrincipalAxes),
        this->AbsoluteTolerance(), this->Progress);
  this->Result.TargetEdgeLength = this->EdgeLength;

  this->PrepareSizing();
  return this->Progress.StopStatus();
}

Status MeshingRounds::FindFeatures(const SurfaceMesh& checked)
{
  const FeatureInput& input = this->Options.Features;
  if (input.Mode == FeatureMode::None)
  {
    return Status();
  }
  const StageClock clock(this->Result.Timings, "features");
  FeatureAnnotation annotation = { input.Edges, input.Corners };
  if (Status status =
        featurehex::MapFeatures(this->Result.Check.Points, annotation.Edges, annotation.Corners);
      !status.Ok())
  {
    return status;
  }
  FeatureExtractionOptions options;
  options.Mode =
    input.Mode == FeatureMode::Angle ? AnnotationMode::Add : AnnotationMode::Replace;
  options.Detection = input.Detection;
  options.Graph.EnforceAll = input.EnforceAll;
  options.Graph.CornerAngle = input.CornerAngle;
  return ExtractFeatures(
    checked, &annotation, options, this->Result.SurfaceGraph, this->Result.FeatureReport);
}

/// Refinement points that follow from the surface and its features alone.
void MeshingRounds::PrepareSizing()
{
  SizingOptions sizing = AutomaticSizingOptions(!this->Result.SurfaceGraph.Curves.empty(),
    this->EdgeLength, this->AbsoluteTolerance());
  sizing.MaximumSizingLevel = std::min(sizing.MaximumSizingLevel, this->Options.MaximumLevel);
  this->Points =
    ComputeSizing(this->Surface->Mesh(), this->Surface->Search(), sizing, this->Progress);
  const auto append = [this](const std::vector<RefinementPoint>& points) {
    this->Points.insert(this->Points.end(), points.begin(), points.end());
  };
  if (!this->Options.EdgeLengths.empty())
  {
    append(ComputeWantedSizing(this->Surface->Mesh(), this->Surface->Search(),
      this->WantedLengths(), this->EdgeLength, this->Options.MaximumLevel, this->Progress));
  }
  if (this->Result.SurfaceGraph.Curves.empty())
  {
    return;
  }
  this->Enforced.Build(
    this->Surface->Mesh(), this->Result.SurfaceGraph, TrimCells * this->EdgeLength);
  FeatureSizingOptions features;
  features.TargetEdgeLength = this->EdgeLength;
  features.MaximumLevel = this->Options.MaximumLevel;
  append(ThinRefinementPoints(
    ComputeFeatureSizing(*this->Enforced.Geometry(), features), this->EdgeLength));
}

/// Options.EdgeLengths for the points of the checked surface.
std::vector<double> MeshingRounds::WantedLengths() const
{
  std::vector<double> wanted(this->Surface->Mesh().Points.size(), 0.0);
  const std::vector<Index>& checked = this->Result.Check.Points;
  for (std::size_t p = 0; p < checked.size(); ++p)
  {
    const double length = this->Options.EdgeLengths[p];
    if (checked[p] >= 0 && length > 0)
    {
      double& least = wanted[checked[p]];
      least = least > 0 ? std::min(least, length) : length;
    }
  }
  return wanted;
}

Status MeshingRounds::Run(const SurfaceMesh& input)
{
  Status status = this->CheckOptions(input);
  if (status.Ok())
  {
    status = this->Prepare(input);
  }
  if (!status.Ok())
  {
    return status;
  }
  for (int round = 0;; ++round)
  {
    const Outcome outcome = this->RunRound(round, status);
    if (outcome != Outcome::Refine)
    {
      break;
    }
  }
  if (status.Code == StatusCode::TimeLimit && !this->LastReason.empty())
  {
    status.Message += " The round before was not the last because: " + this->LastReason + ".";
  }
  if (this->Best.Mesh.Hexes.empty() || status.Code == StatusCode::Aborted)
  {
    return status;
  }
  this->Result.TargetEdgeLength = this->Best.TargetEdgeLength;
  // A later round may have failed or run out of time: the best valid mesh counts.
  this->Result.Mesh = std::move(this->Best.Mesh);
  this->Result.Region = std::move(this->Best.Region);
  this->Result.Features = std::move(this->Best.Features);
  this->Result.Level = std::move(this->Best.Level);
  this->Result.Improvement = this->Best.Improvement;
  this->Result.Validation = std::move(this->Best.Validation);
  return Status();
}

Status MeshSurface(const SurfaceMesh& surface, const MeshingOptions& options, Monitor& monitor,
  MeshingResult& result)
{
  result = MeshingResult();
  Status status = MeshingRounds(options, monitor, result).Run(surface);
  if (!status.Ok())
  {
    result.Mesh = HexMesh();
    result.Region.clear();
    result.Features = HexFeatures();
    result.Level.clear();
  }
  return status;
}
}

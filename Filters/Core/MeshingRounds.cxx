// SPDX-License-Identifier: BSD-3-Clause
#include "MeshingRounds.h"

#include "AutomaticSizing.h"
#include "FeatureSizing.h"
#include "HexLocalPadding.h"
#include "MessageText.h"
#include "QualityHistogram.h"
#include "StageCheck.h"
#include "SurfaceSizing.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace featurehex
{
namespace
{
constexpr double LabelBias = 0.1;        // local cells (recipe-pipeline 2.3)
/// Of the wanted minimum scaled Jacobian: below, cells get finer.
constexpr double AcceptableShare = 0.92;
constexpr double StuckBand = 0.05;       // above the minimum
constexpr int MaximumQualityRounds = 4;
constexpr int MaximumFeatureRounds = 3;
constexpr int PatientRounds = 3; // in which a feature may fail before it is given up
constexpr double StructuralShare = 0.002; // of the hexes near the minimum: not a local flaw
constexpr Index FewHexes = 10;            // may be refined at once in any case
constexpr std::size_t ManyPlaces = 100; // of a broken promise: not a local flaw
constexpr double BeyondShare = 0.95; // of the tolerance: samples see less than the proof
/// Of the wanted minimum: below, curves that bound no patch are given up.
constexpr double LooseShare = 0.2;
}

void MeshingRounds::BeginPhase(const std::string& name, double from, double to)
{
  // Nobody knows how many rounds there will be: each takes half of what is left.
  const double first = 0.1 + 0.85 * (1 - std::pow(0.5, this->Round));
  const double width = 0.85 * std::pow(0.5, this->Round + 1);
  const std::string title =
    this->Round == 0 ? name : name + " (round " + std::to_string(this->Round + 1) + ")";
  this->Progress.BeginPhase(title, first + from * width, first + to * width);
}

/// Adds refinement points one level below the cells at @a places. When nothing can be refined there
/// any more, or rounds run out, without a valid mesh, the grid is no longer fitted to flat faces,
/// once; then all cells are halved, once; then it fails with @a reason. Where a promise is broken at
/// many places, both come at once.
MeshingRounds::Outcome MeshingRounds::Refine(const std::string& reason, StatusCode code,
  const std::vector<Vec3>& places, Status& status)
{
  std::vector<RefinementPoint> points;
  for (const Vec3& p : places)
  {
    const int level = this->Octree.LeafLevelAt(p) + 1;
    if (level <= this->Options.MaximumLevel)
    {
      points.push_back({ p, level });
    }
  }
  points = ThinRefinementPoints(points, this->EdgeLength);
  MeshingRound& round = this->Result.Rounds.back();
  round.Reason = reason;
  this->LastReason =
    reason + (places.empty() ? "" : ", first at " + PlaceText(places.front() + this->Offset));
  round.RefinementPoints = static_cast<Index>(points.size());
  const bool last = this->Round + 1 >= this->LastRound;
  const bool stuck = (points.empty() || last) && this->Best.Mesh.Hexes.empty();
  const bool folded = code == StatusCode::Validation && places.size() > ManyPlaces &&
    this->Best.Mesh.Hexes.empty();
  const bool foldedAgain = folded && !this->FitGrid;
  if ((stuck || folded) && this->FitGrid && this->Enforced.Geometry())
  {
    // A thin wedge on a flat face has no room for hexes where that lies between their layers: a
    // large fold that finer cells don't cure.
    this->FitGrid = false;
    this->LastRound += this->Options.MaximumRounds;
    round.Reason += "; the grid is no longer fitted to flat faces";
    return Outcome::Refine;
  }
  if ((stuck || foldedAgain) && !this->Halved)
  {
    this->Halved = true;
    this->LastRound += this->Options.MaximumRounds;
    this->EdgeLength /= 2;
    this->Enforced.SetTrim(TrimCells * this->EdgeLength);
    for (RefinementPoint& point : this->Points)
    {
      --point.Level;
    }
    round.Reason += "; all cells are halved";
    return Outcome::Refine;
  }
  if (points.empty() || last)
  {
    const int rounds = this->Round + 1;
    status = Status(code,
      this->LastReason + ", after " + std::to_string(rounds) + (rounds == 1 ? " round" : " rounds") +
        " of refinement" + (points.empty() ? " with cells at MaximumLevel there" : "") +
        ". Lower TargetEdgeLength or raise MaximumLevel for finer cells, or raise Tolerance.",
      this->MovedBack(places));
    return Outcome::Failed;
  }
  this->Points.insert(this->Points.end(), points.begin(), points.end());
  return Outcome::Refine;
}

MeshingRounds::Outcome MeshingRounds::BuildDomain(Status& status)
{
  {
    const StageClock clock(this->Result.Timings, "octree");
    this->BeginPhase("building the octree", 0.0, 0.03);
    OctreeOptions octree;
    octree.TargetEdgeLength = this->EdgeLength;
    octree.MaximumLevel = this->Options.MaximumLevel;
    octree.MaximumNumberOfCells = this->Options.MaximumNumberOfCells;
    octree.CoarseLevels = AutomaticCoarseLevels(
      *this->Surface, this->EdgeLength, !this->Result.SurfaceGraph.Curves.empty());
    octree.FitToFlatFaces = this->FitGrid;
    octree.AlignToPrincipalAxes = this->Options.AlignToPrincipalAxes;
    status = BuildBlockOctree(
      this->Surface->Mesh(), this->Points, octree, this->Octree, nullptr, this->Progress);
    this->Result.Rounds.back().OctreeLeaves = static_cast<Index>(this->Octree.Leaves.size());
  }
  if (status.Ok())
  {
    const StageClock clock(this->Result.Timings, "dual");
    this->BeginPhase("converting the octree to hexes", 0.03, 0.06);
    status = ConvertOctreeToHexes(this->Octree, this->Dual, &this->DualArrays, this->Progress);
  }
  if (status.Ok())
  {
    status = CheckStageOutput({ "octree dual", StagePromise::PositiveCorners }, this->Dual);
  }
  if (status.Ok())
  {
    const StageClock clock(this->Result.Timings, "domain");
    this->BeginPhase("finding inside and outside", 0.06, 0.15);
    DomainOptions domain;
    domain.TargetEdgeLength = this->EdgeLength;
    domain.MaximumLevel = this->Options.MaximumLevel;
    domain.Slack = this->AbsoluteTolerance();
    domain.LabelBias = LabelBias;
    status = ComputeHexDomain(this->Dual, this->Surface->Mesh(), this->Surface->Search(),
      this->Winding, domain, this->Progress, this->Domain);
  }
  if (!status.Ok())
  {
    return Outcome::Failed;
  }
  const bool sound = this->Domain.Topology.Same();
  std::vector<Vec3> places;
  for (const std::vector<RefinementPoint>* points :
    { &this->Domain.TopologyPoints, &this->Domain.MissingPoints })
  {
    for (const RefinementPoint& p : *points)
    {
      places.push_back(p.Position);
    }
  }
  if (!sound)
  {
    return this->Refine("The hexes have other components, tunnels or cavities than the surface",
      StatusCode::Topology, places, status);
  }
  if (!places.empty() && this->Round + 1 < this->LastRound)
  {
    const Outcome outcome = this->Refine(
      "Parts of the surface have no hexes near them", StatusCode::Distance, places, status);
    if (outcome == Outcome::Refine)
    {
      return outcome;
    }
    status = Status(); // the fit may still reach them
  }
  return Outcome::Done;
}

/// Corners and curves on which these hexes have vertices.
std::set<FeatureName> MeshingRounds::FeaturesAt(const std::vector<Index>& hexes) const
{
  return featurehex::FeaturesAt(
    this->Body.Mesh, hexes, FeatureLabels(this->Features, this->Stars));
}

/// Loose curves that hold the quality far down: what the rest of the surface could have is not
/// spoilt for them.
bool MeshingRounds::GiveUpSpoilers()
{
  std::vector<Index> bad;
  for (std::size_t h = 0; h < this->Body.Mesh.Hexes.size(); ++h)
  {
    if (this->Result.Validation.ScaledJacobians[h] <
        LooseShare * this->Options.MinimumScaledJacobian)
    {
      bad.push_back(static_cast<Index>(h));
    }
  }
  return this->Enforced.GiveUpLoose(this->FeaturesAt(bad));
}

MeshingRounds::Outcome MeshingRounds::MapFeatures(Status& status)
{
  if (!this->Enforced.Geometry())
  {
    return Outcome::Done;
  }
  const StageClock clock(this->Result.Timings, "feature mapping");
  this->BeginPhase("mapping the features", 0.15, 0.16);
  status = MapFeaturesToInterface(this->Dual, this->Domain.Interface, *this->Enforced.Geometry(),
    FeatureMappingOptions(), this->Progress, this->Mapping);
  if (!status.Ok())
  {
    return Outcome::Failed;
  }
  if (this->Mapping.Complete())
  {
    return Outcome::Done;
  }
  const double finest = std::ldexp(this->EdgeLength, -this->Options.MaximumLevel);
  std::set<FeatureName> failed;
  std::set<FeatureName> hopeless; // no cells are fine enough
  for (const MappingFailure& failure : this->Mapping.Failures)
  {
    const bool unresolved = failure.Kind == FeatureKind::Curve &&
      TooCloseForCells(*this->Enforced.Geometry(), failure.Id, finest);
    (unresolved ? hopeless : failed).insert({ failure.Kind, failure.Id });
  }
  const bool someHopeless = this->Enforced.GiveUp(hopeless, 1);
  if (this->Enforced.GiveUp(failed, PatientRounds) || someHopeless)
  {
    return this->MapFeatures(status);
  }
  std::vector<Vec3> places;
  for (const MappingFailure& failure : this->Mapping.Failures)
  {
    places.insert(places.end(), failure.Places.begin(), failure.Places.end());
  }
  const std::size_t others = this->Mapping.Failures.size() - 1;
  return this->Refine(this->Mapping.Failures.front().Reason +
      (others > 0 ? ", and " + std::to_string(others) + " more" : ""),
    StatusCode::Features, places, status);
}

FeatureLabels MeshingRounds::Labels() const
{
  FeatureLabels labels;
  if (this->Enforced.Geometry())
  {
    return FeatureLabels(this->Features, this->Stars);
  }
  for (Index v = 0; v < static_cast<Index>(this->Body.Mesh.Points.size()); ++v)
  {
    labels.Kind.push_back(
      this->Stars.OnBoundary(v) ? FeatureKind::Surface : FeatureKind::Interior);
  }
  labels.Id.assign(this->Body.Mesh.Points.size(), -1);
  return labels;
}

/// From where the last round ended, where the mesh is the same; when that fails, from the start.
Status MeshingRounds::Untangle(UntangleReport& report)
{
  const auto untangle = [&] {
    UntangleOptions options;
    options.Features = this->Targets.get();
    options.Changed = this->Changed.empty() ? nullptr : &this->Changed;
    return UntangleHexes(
      this->Body.Mesh, this->Stars, this->Surface.get(), options, report, this->Progress);
  };
  this->Unfitted = this->Body.Mesh.Points;
  this->Changed = this->Carried.Apply(this->Body.Mesh, this->Stars, this->Labels());
  Status status = untangle();
  if (status.Ok() && report.InvertedAfter > 0 && !this->Changed.empty())
  {
    this->Body.Mesh.Points = this->Unfitted;
    this->Changed.clear();
    status = untangle();
  }
  return status;
}

MeshingRounds::Outcome MeshingRounds::BuildBody(Status& status)
{
  {
    const StageClock clock(this->Result.Timings, "padding");
    this->BeginPhase("padding", 0.15, 0.17);
    this->Features = this->Mapping.Features;
    status = PadInterface(this->Dual, this->Domain.Region, PaddingOptions(), this->Body,
      this->Enforced.Geometry() ? &this->Features : nullptr, this->Enforced.Geometry());
    if (!status.Ok())
    {
      return Outcome::Failed;
    }
    if (this->Enforced.Geometry())
    {
      PadDegenerateQuads(
        this->Body, this->Features, *this->Enforced.Geometry(), LocalPaddingOptions());
    }
    status = CheckStageOutput({ "padding", StagePromise::Conforming }, this->Body.Mesh);
    if (!status.Ok())
    {
      return Outcome::Failed;
    }
    this->Result.Rounds.back().Hexes = static_cast<Index>(this->Body.Mesh.Hexes.size());
    this->Stars = HexStars(this->Body.Mesh);
    if (this->Enforced.Geometry())
    {
      this->Targets = std::make_unique<FeatureTargets>(
        *this->Enforced.Geometry(), this->Features, this->Stars, this->Body.Mesh.Points);
    }
  }
  const StageClock clock(this->Result.Timings, "untangling");
  this->BeginPhase("untangling", 0.17, 0.22);
  UntangleReport report;
  status = this->Untangle(report);
  if (status.Ok() && report.InvertedAfter > 0)
  {
    const std::vector<Index> inverted = InvertedHexes(this->Body.Mesh);
    if (this->Enforced.Geometry() &&
        this->Enforced.GiveUp(this->FeaturesAt(inverted), PatientRounds))
    {
      const Outcome outcome = this->MapFeatures(status);
      return outcome == Outcome::Done ? this->BuildBody(status) : outcome;
    }
    std::vector<Vec3> places;
    for (Index h : inverted)
    {
      places.push_back(this->Body.Mesh.Points[this->Body.Mesh.Hexes[h][0]]);
    }
    return this->Refine(std::to_string(report.InvertedAfter) + " hexes stay inverted",
      StatusCode::Untangling, places, status);
  }
  if (status.Ok())
  {
    status = CheckStageOutput({ "untangling", StagePromise::PositiveCorners }, this->Body.Mesh);
  }
  return status.Ok() ? Outcome::Done : Outcome::Failed;
}

MeshingRounds::Outcome MeshingRounds::Fit(Status& status)
{
  const StageClock clock(this->Result.Timings, "fitting");
  this->BeginPhase("fitting to the surface", 0.22, 0.9);
  ProvenFittingReport report;
  status = this->Fitting->Run(this->Body.Mesh, this->Stars, this->Targets.get(),
    this->Changed.empty() ? nullptr : &this->Changed, report, this->Progress);
  this->Result.Improvement = report.Improvement;
  if (status.Ok())
  {
    // Certificates are the validation's: it asks for refinement where one is missing.
    status = CheckStageOutput({ "fitting", StagePromise::PositiveCorners }, this->Body.Mesh);
  }
  if (!status.Ok())
  {
    return Outcome::Failed;
  }
  switch (report.Outcome)
  {
    case FittingOutcome::Far:
      return this->Refine("The fitted boundary is far from the surface", StatusCode::Distance,
        report.Places, status);
    case FittingOutcome::NotDrawn:
      return this->Refine("The boundary can't be drawn inside the tolerance",
        StatusCode::Distance, report.Places, status);
    case FittingOutcome::NotProven:
      return this->Refine("The boundary leaves the tolerance", StatusCode::Distance,
        report.Places, status);
    case FittingOutcome::Proven:
      break;
  }
  return Outcome::Done;
}

MeshingRounds::Outcome MeshingRounds::Validate(Status& status)
{
  const StageClock clock(this->Result.Timings, "validation");
  this->BeginPhase("validating", 0.9, 1.0);
  HexValidationOptions validation;
  validation.Tolerance = this->Options.Tolerance;
  if (this->Enforced.Geometry())
  {
    validation.Features = { &this->Result.SurfaceGraph, &this->Features };
  }
  HexValidationReport& report = this->Result.Validation;
  // What is judged is what the user gets: the points moved back, rounding included.
  const HexMesh mesh = { this->MovedBack(this->Body.Mesh.Points), this->Body.Mesh.Hexes };
  const SurfaceMesh surface = { this->MovedBack(this->Surface->Mesh().Points),
    this->Surface->Mesh().Triangles };
  report = ValidateHexMesh(mesh, &surface, validation, this->Progress);
  if (report.Result.Ok())
  {
    this->Carried.Remember(
      this->Unfitted, this->Labels(), this->Body.Mesh.Points, this->EdgeLength);
    return Outcome::Done;
  }
  if (report.Result.Code != StatusCode::Validation)
  {
    status = report.Result;
    return Outcome::Failed;
  }
  std::vector<Vec3> places;
  std::vector<Index> hexes;
  for (const OffendingHex& bad : report.Offending)
  {
    hexes.push_back(bad.Hex);
    places.push_back(this->Body.Mesh.Points[this->Body.Mesh.Hexes[bad.Hex][0]]);
  }
  if (this->Enforced.Geometry())
  {
    this->Enforced.GiveUp(this->FeaturesAt(hexes), PatientRounds);
  }
  return this->Refine(report.Result.Message, StatusCode::Validation, places, status);
}

/// A valid mesh may have vertices that are trapped beside their corner or curve, and edges and quads
/// that leave their own curve or patch by more than the tolerance: finer cells there.
MeshingRounds::Outcome MeshingRounds::FollowFeatures(Status& status)
{
  this->KeepBest();
  if (!this->Enforced.Geometry() || this->Result.Validation.Features.AllCaptured() ||
    ++this->FeatureRounds > MaximumFeatureRounds)
  {
    return Outcome::Done;
  }
  const std::vector<Vec3> places = MissedFeaturePlaces(this->Body.Mesh, this->Stars.Quads,
    this->Features, *this->Enforced.Geometry(), this->Result.Validation.Features,
    BeyondShare * this->AbsoluteTolerance());
  if (places.empty())
  {
    return Outcome::Done;
  }
  const Outcome outcome =
    this->Refine("Features are missed or left by more than the tolerance",
      StatusCode::Features, places, status);
  if (outcome == Outcome::Failed)
  {
    status = Status(); // the mesh is valid
    return Outcome::Done;
  }
  return outcome;
}

/// A valid mesh whose worst hex is stuck far below the wanted quality gets finer cells there, a few
/// times. What that can't cure, loose curves may have caused.
MeshingRounds::Outcome MeshingRounds::RaiseQuality(Status& status)
{
  const double minimum = this->Result.Validation.Quality.Minimum;
  if (minimum >= AcceptableShare * this->Options.MinimumScaledJacobian)
  {
    return Outcome::Done;
  }
  if (++this->QualityRounds <= MaximumQualityRounds)
  {
    const Index stuck = this->CountStuckHexes();
    const Index share = static_cast<Index>(
      StructuralShare * static_cast<double>(this->Body.Mesh.Hexes.size()));
    // Many at creases: finer cells would look the same.
    if (stuck <= share || !this->Enforced.Geometry())
    {
      std::vector<Vec3> places;
      for (Index h : SmallestValues(this->Result.Validation.ScaledJacobians,
             std::min(stuck, std::max(FewHexes, share))))
      {
        Vec3 center = Vec3::Zero();
        for (Index v : this->Body.Mesh.Hexes[h])
        {
          center += 0.125 * this->Body.Mesh.Points[v];
        }
        places.push_back(this->Surface->Search().Closest(center).Point);
      }
      const Outcome outcome = this->Refine("The worst hexes are stuck at a low scaled Jacobian",
        StatusCode::Validation, places, status);
      if (outcome == Outcome::Refine)
      {
        return outcome;
      }
      status = Status(); // the quality is best effort
    }
  }
  if (this->Enforced.Geometry() && this->Round + 1 < this->LastRound && this->GiveUpSpoilers())
  {
    this->PrepareSizing(); // without them
    this->QualityRounds = 0;
    this->Result.Rounds.back().Reason =
      "Loose curves hold the quality down: not enforced any more";
    return Outcome::Refine;
  }
  return Outcome::Done;
}

/// Hexes that hold the minimum down: the others below the wanted value had no chance to rise yet.
Index MeshingRounds::CountStuckHexes() const
{
  const double level = this->Result.Validation.Quality.Minimum + StuckBand;
  const std::vector<double>& qualities = this->Result.Validation.ScaledJacobians;
  return static_cast<Index>(std::count_if(
    qualities.begin(), qualities.end(), [level](double quality) { return quality < level; }));
}

/// Sound quality counts first, then missed features, then quality.
void MeshingRounds::KeepBest()
{
  const auto rank = [this](const HexValidationReport& report) {
    Index missed = 0;
    for (const FeatureTotals& totals : { report.Features.CornerTotals(),
           report.Features.CurveTotals(), report.Features.PatchTotals() })
    {
      missed += totals.Enforced - totals.Captured;
    }
    const double minimum = report.Quality.Minimum;
    return std::make_tuple(
      minimum >= LooseShare * this->Options.MinimumScaledJacobian, -missed, minimum);
  };
  if (this->Best.Mesh.Hexes.empty() ||
    rank(this->Result.Validation) > rank(this->Best.Validation))
  {
    this->Best.Mesh = { this->MovedBack(this->Body.Mesh.Points), this->Body.Mesh.Hexes };
    this->Best.Region = this->Body.Region;
    this->Best.Features = this->Features;
    this->Best.Level.clear();
    for (Index source : this->Body.SourceHex)
    {
      this->Best.Level.push_back(this->DualArrays.HexLevel[source] - this->Octree.BaseLevel);
    }
    this->Best.TargetEdgeLength = this->EdgeLength;
    this->Best.Improvement = this->Result.Improvement;
    this->Best.Validation = this->Result.Validation;
  }
}

MeshingRounds::Outcome MeshingRounds::RunRound(int round, Status& status)
{
  this->Round = round;
  this->Result.Rounds.emplace_back();
  for (const auto stage : { &MeshingRounds::BuildDomain, &MeshingRounds::MapFeatures, &MeshingRounds::BuildBody,
         &MeshingRounds::Fit, &MeshingRounds::Validate, &MeshingRounds::FollowFeatures, &MeshingRounds::RaiseQuality })
  {
    const Outcome outcome = (this->*stage)(status);
    if (outcome != Outcome::Done)
    {
      return outcome;
    }
  }
  return Outcome::Done;
}
}

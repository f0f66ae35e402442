// SPDX-License-Identifier: BSD-3-Clause
#include "ProvenFitting.h"

#include "QuadSearch.h"
#include "SubMonitor.h"

#include <algorithm>

namespace featurehex
{
namespace
{
/// Tolerances: the improvement repairs the rest (recipe-pipeline 2.8).
constexpr double RefineBeyond = 1.4;
constexpr double RefineBeyondWithFeatures = 4.0; // vertices beside creases arrive late
/// Between samples of the input: the quads there divided by this, as their own grid, but not less
/// than this many tolerances.
constexpr double SamplesPerQuadSide = 8;
constexpr double LeastSampleSpacing = 0.5;
/// The same round a witness of a failed proof, and how many of them each way.
constexpr double WitnessSpacing = 0.25;
constexpr int WitnessNeighbors = 6;
constexpr Index QuadsPerQuestion = 1000;
constexpr int QuadGrid = 7;           // samples per quad side (recipe-quality 3)
constexpr int MaximumProofs = 6;
constexpr int RingsRoundUnproven = 3; // of hexes, improved again after a failed proof
constexpr int RoundsAfterProof = 3; // of improvement: most was done before the proof
/// Of the tolerance: what is proven. The rest is for the rounding of coordinates in files, and for
/// other programs whose bounds have a slack of one percent.
constexpr double ProofShare = 0.985;
constexpr double ShareStep = 0.01; // tightening of the sampled limit after a failed proof
constexpr double FittingShare = 0.4; // of the progress

/// Points of the surface whose samples are farther than @a limit from the boundary, either way.
std::vector<Vec3> PlacesBeyond(
  SurfaceEnvelope& envelope, const HexStars& stars, double limit, Monitor& monitor)
{
  envelope.Measure(limit); // in parallel: few quads are left to look at again
  std::vector<EnvelopeContact> contacts;
  for (Index q = 0; q < static_cast<Index>(stars.Quads.size()); ++q)
  {
    if (q % QuadsPerQuestion == 0 && !monitor.Ask())
    {
      break;
    }
    envelope.Collect(q, limit, contacts);
  }
  std::vector<Vec3> places;
  places.reserve(contacts.size());
  for (const EnvelopeContact& contact : contacts)
  {
    places.push_back(contact.SurfacePoint);
  }
  return places;
}

/// Samples of the surface that suit the quads of the boundary.
std::vector<Vec3> SampleLike(const SurfaceGeometry& surface, const HexMesh& mesh,
  const std::vector<Quad>& quads, double leastSpacing)
{
  const QuadSearch search(mesh, quads);
  return surface.Samples([&](const Vec3& p, Index& near) {
    const Quad& quad = quads[search.Closest(p, near)];
    double perimeter = 0;
    for (int k = 0; k < 4; ++k)
    {
      perimeter += (mesh.Points[quad[(k + 1) % 4]] - mesh.Points[quad[k]]).norm();
    }
    return std::max(leastSpacing, 0.25 * perimeter / SamplesPerQuadSide);
  });
}

/// 1 for the vertices round the places of a failed proof.
std::vector<char> VerticesNear(
  const DistanceDecision& decision, const HexMesh& mesh, const std::vector<Quad>& quads)
{
  std::vector<char> near(mesh.Points.size(), 0);
  const auto mark = [&](const Quad& quad) {
    for (Index v : quad)
    {
      near[v] = 1;
    }
  };
  for (const DistanceWitness& w : decision.Quads)
  {
    mark(quads[w.Element]);
  }
  const QuadSearch search(mesh, quads);
  for (const DistanceWitness& w : decision.Triangles)
  {
    mark(quads[search.Closest(w.Point)]);
  }
  MarkRings(mesh, RingsRoundUnproven, near);
  return near;
}
}

ProvenFitting::ProvenFitting(const SurfaceGeometry& surface, const ProvenFittingOptions& options)
  : Surface(surface)
  , Options(options)
  , Distance(surface.Mesh())
{
}

Status ProvenFitting::Run(HexMesh& mesh, const HexStars& stars, FeatureTargets* features,
  const std::vector<char>* changed, ProvenFittingReport& report, Monitor& monitor)
{
  report = ProvenFittingReport();
  this->Samples = SampleLike(
    this->Surface, mesh, stars.Quads, LeastSampleSpacing * this->AbsoluteTolerance());
  this->Samples.insert(this->Samples.end(), this->Witnesses.begin(), this->Witnesses.end());
  FittingOptions fitting;
  fitting.Tolerance = this->Options.Tolerance;
  fitting.Iterations = this->Options.FittingIterations;
  fitting.Changed = changed;
  SurfaceEnvelope envelope(this->Surface, this->Samples, mesh, stars, QuadGrid, &monitor);
  {
    SubMonitor part(monitor, 0.0, FittingShare);
    Status status = FitHexes(mesh, stars, this->Surface, features, envelope, fitting, part);
    if (!status.Ok())
    {
      return monitor.Stopped() ? monitor.StopStatus() : status;
    }
    report.Places = PlacesBeyond(envelope, stars,
      (features ? RefineBeyondWithFeatures : RefineBeyond) * this->AbsoluteTolerance(), part);
  }
  if (monitor.Stopped())
  {
    return monitor.StopStatus();
  }
  return report.Places.empty()
    ? this->ImproveAndProve(mesh, stars, envelope, features, changed, report, monitor)
    : Status();
}

/// The distance has its maximum between the samples near a witness, and another one once the
/// boundary has followed it: samples along the edges' directions, on both sides, in its triangle.
void ProvenFitting::AddSamplesRound(const DistanceWitness& witness)
{
  const auto add = [this](const Vec3& p) {
    this->Samples.push_back(p);
    this->Witnesses.push_back(p);
  };
  add(witness.Point);
  const Triangle& t = this->Surface.Mesh().Triangles[witness.Element];
  const double step = WitnessSpacing * this->AbsoluteTolerance();
  for (int k = 0; k < 3; ++k)
  {
    const Vec3 edge =
      this->Surface.Mesh().Points[t[(k + 1) % 3]] - this->Surface.Mesh().Points[t[k]];
    for (int i = -WitnessNeighbors; i <= WitnessNeighbors; ++i)
    {
      const Vec3 p = witness.Point + i * step * edge.normalized();
      const TrianglePoint inside = this->Surface.Search().ClosestOn(p, witness.Element);
      if (i != 0 && inside.Distance < 0.5 * step)
      {
        add(inside.Point);
      }
    }
  }
}

Status ProvenFitting::ImproveAndProve(HexMesh& mesh, const HexStars& stars,
  SurfaceEnvelope& envelope, FeatureTargets* features, const std::vector<char>* changed,
  ProvenFittingReport& report, Monitor& monitor)
{
  ImprovementOptions improvement;
  improvement.Tolerance = this->Options.Tolerance;
  improvement.MinimumScaledJacobian = this->Options.MinimumScaledJacobian;
  improvement.MaximumRounds = this->Options.ImprovementRounds;
  improvement.Features = features;
  improvement.Changed = changed;
  std::vector<char> unproven;
  const double width = (1 - FittingShare) / MaximumProofs;
  for (int proof = 0; proof < MaximumProofs; ++proof)
  {
    const double start = FittingShare + proof * width;
    if (this->Options.MinimumScaledJacobian > 0)
    {
      SubMonitor part(monitor, start, start + 0.8 * width);
      if (proof > 0)
      {
        envelope.Rebuild(); // with the new samples
      }
      Status status = ImproveHexes(
        mesh, stars, this->Surface, envelope, improvement, report.Improvement, part);
      if (!status.Ok())
      {
        return monitor.Stopped() ? monitor.StopStatus() : status;
      }
      if (!report.Improvement.Drawn)
      {
        report.Outcome = FittingOutcome::NotDrawn;
        report.Places = PlacesBeyond(
          envelope, stars, improvement.EnvelopeShare * this->AbsoluteTolerance(), part);
        return monitor.StopStatus();
      }
    }
    SubMonitor part(monitor, start + 0.8 * width, start + width);
    const DistanceDecision decision = this->Distance.DistanceWithin(
      mesh.Points, stars.Quads, ProofShare * this->AbsoluteTolerance(), part);
    if (monitor.Stopped())
    {
      return monitor.StopStatus();
    }
    report.Outcome = decision.Within ? FittingOutcome::Proven : FittingOutcome::NotProven;
    report.Places.clear();
    for (const DistanceWitness& w : decision.Triangles)
    {
      report.Places.push_back(w.Point);
      this->AddSamplesRound(w);
    }
    for (const DistanceWitness& w : decision.Quads)
    {
      report.Places.push_back(this->Surface.Search().Closest(w.Point).Point);
    }
    if (decision.Within || this->Options.MinimumScaledJacobian <= 0)
    {
      break;
    }
    if (proof > 0)
    {
      improvement.EnvelopeShare -= ShareStep;
    }
    unproven = VerticesNear(decision, mesh, stars.Quads);
    improvement.Changed = &unproven;
    improvement.OnlyChanged = true;
    improvement.MaximumRounds = std::min(improvement.MaximumRounds, RoundsAfterProof);
  }
  return Status();
}
}

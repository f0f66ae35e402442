// SPDX-License-Identifier: BSD-3-Clause
#include "HexUntangling.h"

#include "BoundarySpreading.h"
#include "HexOptimizer.h"
#include "HexStitching.h"
#include "SurfaceTerms.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
std::vector<Index> InvertedHexes(const HexMesh& mesh)
{
  std::vector<Index> inverted;
  for (Index h = 0; h < static_cast<Index>(mesh.Hexes.size()); ++h)
  {
    if (!(LeastCornerDeterminant(mesh, h) > 0))
    {
      inverted.push_back(h);
    }
  }
  return inverted;
}

namespace
{
constexpr int MaximumUnfoldings = 3;
constexpr int WideSweeps = 15; // over the whole mesh, with a wide regularisation

/// Sweeps until no hex is inverted.
class Untangler
{
public:
  Untangler(HexMesh& mesh, const HexStars& stars, const UntangleOptions& options,
    UntangleReport& report, Monitor& monitor)
    : Mesh(mesh)
    , Stars(stars)
    , Options(options)
    , Report(report)
    , Progress(monitor)
    , Optimizer(mesh, stars)
  {
  }

  Status Run(const SurfaceGeometry* surface);

private:
  void CountInverted()
  {
    this->Inverted = InvertedHexes(this->Mesh);
    this->Report.InvertedAfter = static_cast<Index>(this->Inverted.size());
  }
  void Activate(int sweep, bool everything);
  void ActivateMoved(const std::vector<Vec3>& before);
  bool Untangled() const { return this->Report.InvertedAfter <= this->Report.Hopeless; }
  Status Settle(const SurfaceGeometry* surface, bool everything);
  Status Sweep(bool everything);

  HexMesh& Mesh;
  const HexStars& Stars;
  const UntangleOptions& Options;
  UntangleReport& Report;
  Monitor& Progress;
  HexOptimizer Optimizer;
  std::vector<Index> Inverted;
};

/// The first sweeps visit everything if wanted; later ones what still moves and what surrounds
/// inverted hexes: most of a large mesh is at rest while the last ones are freed.
void Untangler::Activate(int sweep, bool everything)
{
  if (everything && sweep < WideSweeps)
  {
    this->Optimizer.ActivateAll();
  }
  for (Index h : this->Inverted)
  {
    this->Optimizer.ActivateAround(this->Mesh.Hexes[h]);
  }
}

void Untangler::ActivateMoved(const std::vector<Vec3>& before)
{
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    if (this->Mesh.Points[v] != before[v])
    {
      this->Optimizer.ActivateAround(static_cast<Index>(v));
    }
  }
}

Status Untangler::Sweep(bool everything)
{
  if (this->Options.Method == UntangleMethod::Stitching)
  {
    int sweeps = 0;
    const Status status = StitchHexes(this->Mesh, this->Stars, this->Optimizer,
      this->Options.MaximumSweeps, sweeps, this->Progress);
    this->Report.Sweeps += sweeps;
    this->CountInverted();
    return status;
  }
  for (int sweep = 0; !this->Untangled() && sweep < this->Options.MaximumSweeps; ++sweep)
  {
    if (!this->Progress.Update(static_cast<double>(sweep) / this->Options.MaximumSweeps))
    {
      return this->Progress.StopStatus();
    }
    // Regularisation of recipe-pipeline 2.6: follows the worst determinant, wide in the first
    // sweeps.
    const double worst = std::min(this->Optimizer.LeastDeterminant(), 0.0);
    double delta = std::sqrt(1e-6 + 0.04 * worst * worst);
    if (sweep < WideSweeps)
    {
      delta = std::max(delta, 0.05);
    }
    this->Activate(sweep, everything);
    this->Optimizer.Sweep(delta, &this->Progress);
    ++this->Report.Sweeps;
    this->CountInverted();
  }
  return this->Progress.StopStatus();
}

Status Untangler::Settle(const SurfaceGeometry* surface, bool everything)
{
  this->CountInverted();
  if (surface)
  {
    SurfaceTerms(this->Mesh, this->Stars, *surface, this->Options.Features)
      .UpdatePlanes(this->Optimizer, this->Options.SurfaceWeight, this->Options.SurfaceWeight);
  }
  return this->Sweep(everything);
}

Status Untangler::Run(const SurfaceGeometry* surface)
{
  for (std::size_t v = 0; v < this->Mesh.Points.size(); ++v)
  {
    this->Optimizer.Fixed[v] = !surface && this->Stars.OnBoundary(static_cast<Index>(v));
  }
  this->Optimizer.FixUnchanged(this->Options.Changed);
  for (std::size_t h = 0; h < this->Mesh.Hexes.size(); ++h)
  {
    this->Report.Hopeless += this->Optimizer.Hopeless(static_cast<Index>(h)) ? 1 : 0;
  }
  this->CountInverted();
  this->Report.InvertedBefore = this->Report.InvertedAfter;
  const FeatureTargets* features = surface ? this->Options.Features : nullptr;
  const std::vector<Vec3> start = this->Mesh.Points;
  if (features)
  {
    SpreadAtFeatures(this->Mesh, this->Stars, *features, this->Options.Changed);
  }
  Status status = this->Settle(surface, true);
  if (features && status.Ok() && !this->Untangled())
  {
    // Thin wedges, whose patch has two sides near each other.
    this->Mesh.Points = start;
    status = this->Settle(surface, true);
  }
  for (int attempt = 0; features && status.Ok() && this->Untangled() && attempt < MaximumUnfoldings;
       ++attempt)
  {
    const std::vector<Vec3> before = this->Mesh.Points;
    this->Report.Folded = UnfoldBoundary(this->Mesh, this->Stars, *features);
    if (this->Report.Folded == 0)
    {
      break;
    }
    this->ActivateMoved(before);
    status = this->Settle(surface, false);
    if (!this->Untangled())
    {
      this->Mesh.Points = before;
      this->CountInverted();
      break;
    }
  }
  return status;
}
}

Status UntangleHexes(HexMesh& mesh, const HexStars& stars, const SurfaceGeometry* surface,
  const UntangleOptions& options, UntangleReport& report, Monitor& monitor)
{
  report = UntangleReport();
  return Untangler(mesh, stars, options, report, monitor).Run(surface);
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "HexFitting.h"

#include "SurfaceTerms.h"

#include <algorithm>

namespace featurehex
{
namespace
{
constexpr double ReverseThreshold = 0.2; // of the tolerance: closer samples of the input exert no pull
constexpr int ReverseStart = 3;          // iterations before samples of the input pull
constexpr int SnapSweeps = 30;           // attempts to put feature vertices on their features
constexpr int SnapTrials = 4;            // halvings of one such move

/// Moves feature vertices to their features, one at a time; those that arrive are locked. Returns how many are not.
Index Snap(HexMesh& mesh, FeatureTargets& features, HexOptimizer& optimizer)
{
  Index left = 0;
  for (Index v : features.Vertices())
  {
    if (features.Locked(v))
    {
      continue;
    }
    const Vec3 target = features.Project(v, mesh.Points[v]);
    const Vec3 displacement = target - mesh.Points[v];
    double alpha = 1;
    int trial = 0;
    while (trial < SnapTrials && !optimizer.TryMove(v, alpha * displacement))
    {
      alpha *= 0.5;
      ++trial;
    }
    if (trial == 0)
    {
      mesh.Points[v] = target; // without the rounding of the sum
      features.Lock(v);
    }
    else
    {
      ++left;
    }
  }
  return left;
}

/// Snap, relax, and again, until all feature vertices are locked or nothing changes.
Status SnapFeatures(HexMesh& mesh, FeatureTargets& features, SurfaceTerms& terms,
  HexOptimizer& optimizer, double weight, Monitor& monitor)
{
  optimizer.Features = &features;
  Index last = -1;
  int idle = 0;
  for (int sweep = 0; sweep < SnapSweeps && idle < 6; ++sweep)
  {
    if (!monitor.Update(1.0))
    {
      return monitor.StopStatus();
    }
    features.FollowCurves(mesh.Points);
    const Index left = Snap(mesh, features, optimizer);
    optimizer.UpdateSizes();
    terms.UpdatePlanes(optimizer, weight);
    optimizer.ActivateBoundary();
    for (int relax = 0; relax < 2; ++relax)
    {
      optimizer.Sweep(-1.0);
    }
    idle = left == last ? idle + 1 : 0;
    last = left;
    if (left == 0)
    {
      break;
    }
  }
  return Status();
}
}

Status FitHexes(HexMesh& mesh, const HexStars& stars, const SurfaceGeometry& surface,
  FeatureTargets* features, SurfaceEnvelope& envelope, const FittingOptions& options,
  Monitor& monitor)
{
  HexOptimizer optimizer(mesh, stars);
  SurfaceTerms terms(mesh, stars, surface, features);
  const double threshold = ReverseThreshold * options.Tolerance * surface.Diagonal();
  double weight = options.InitialWeight;
  for (int iteration = 0; iteration < options.Iterations; ++iteration)
  {
    if (!monitor.Update(static_cast<double>(iteration) / options.Iterations))
    {
      return monitor.StopStatus();
    }
    optimizer.UpdateSizes();
    if (features)
    {
      features->FollowCurves(mesh.Points);
    }
    terms.UpdatePlanes(optimizer, weight);
    if (iteration == ReverseStart)
    {
      envelope.Rebuild();
    }
    else if (iteration > ReverseStart)
    {
      envelope.Update(threshold);
    }
    if (iteration >= ReverseStart)
    {
      terms.UpdateReverse(optimizer, envelope, weight, threshold);
    }
    optimizer.ActivateBoundary();
    optimizer.Sweep(-1.0);
    weight = std::min(weight * options.WeightGrowth, options.MaximumWeight);
  }
  if (features)
  {
    Status status = SnapFeatures(mesh, *features, terms, optimizer, weight, monitor);
    if (!status.Ok())
    {
      return status;
    }
  }
  envelope.Rebuild();
  return Status();
}
}

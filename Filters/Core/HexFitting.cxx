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
constexpr double FeatureShare = 4.0;     // weight of corners and curves against that of the surface
constexpr int SnapSweeps = 40;           // attempts to put feature vertices on their features
constexpr double SnapGrowth = 1.5;       // of the weight of features per attempt ...
constexpr double SnapWeight = 1e6;       // ... up to this
constexpr double SnapNear = 0.02;        // local sizes: vertices as near as this are put on their features ...
constexpr int SnapFarStart = 25;         // ... and, after so many attempts, all others
constexpr int ForceRings = 3;            // neighbourhood that gives way to a trapped vertex
constexpr int ForceSweeps = 40;
constexpr int SnapTrials = 4;            // halvings of one such move

/// Moves feature vertices to their features, one at a time; those that arrive are locked. Returns how many are not.
Index Snap(HexMesh& mesh, FeatureTargets& features, HexOptimizer& optimizer, double reach)
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
    if (displacement.norm() > reach * optimizer.SizeAt(v))
    {
      ++left;
      continue;
    }
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

/// Puts a trapped vertex on its feature although that inverts hexes, and untangles its neighbourhood round it. False:
/// that failed, and nothing has changed.
bool ForceSnap(HexMesh& mesh, const HexStars& stars, FeatureTargets& features,
  HexOptimizer& optimizer, Index vertex)
{
  std::vector<Index> region = { vertex };
  std::vector<Index> hexes;
  std::vector<char> seen(mesh.Hexes.size(), 0);
  std::fill(optimizer.Fixed.begin(), optimizer.Fixed.end(), true);
  optimizer.Fixed[vertex] = false;
  std::size_t first = 0;
  for (int ring = 0; ring <= ForceRings; ++ring)
  {
    const std::size_t last = region.size();
    for (; first < last; ++first)
    {
      for (Index h : stars.Hexes[region[first]])
      {
        if (seen[h])
        {
          continue;
        }
        seen[h] = 1;
        hexes.push_back(h);
        for (Index v : mesh.Hexes[h])
        {
          if (optimizer.Fixed[v] && ring < ForceRings)
          {
            optimizer.Fixed[v] = false;
            region.push_back(v);
          }
        }
      }
    }
  }
  std::vector<Vec3> before;
  for (Index v : region)
  {
    before.push_back(mesh.Points[v]);
  }
  const auto worst = [&] {
    double least = 1e300;
    for (Index h : hexes)
    {
      const double size = optimizer.SizeAt(mesh.Hexes[h][0]);
      least = std::min(least, LeastCornerDeterminant(mesh, h) / (size * size * size));
    }
    return least;
  };
  mesh.Points[vertex] = features.Project(vertex, mesh.Points[vertex]);
  features.Lock(vertex);
  double least = worst();
  for (int sweep = 0; sweep < ForceSweeps && !(least > 0); ++sweep)
  {
    double delta = std::sqrt(1e-6 + 0.04 * least * least);
    if (sweep < ForceSweeps / 3)
    {
      delta = std::max(delta, 0.05);
    }
    optimizer.ActivateAll();
    optimizer.Sweep(delta);
    least = worst();
  }
  if (!(least > 0))
  {
    features.Unlock(vertex);
    for (std::size_t i = 0; i < region.size(); ++i)
    {
      mesh.Points[region[i]] = before[i];
    }
  }
  std::fill(optimizer.Fixed.begin(), optimizer.Fixed.end(), false);
  return least > 0;
}

/// Draw, snap what is near, and again with a higher weight, until all feature vertices are locked or nothing changes.
/// Locking far ones early would trap their neighbours.
Status SnapFeatures(HexMesh& mesh, const HexStars& stars, FeatureTargets& features,
  SurfaceTerms& terms, HexOptimizer& optimizer, double weight, Monitor& monitor)
{
  optimizer.Features = &features;
  double featureWeight = FeatureShare * weight;
  Index last = -1;
  int idle = 0;
  for (int sweep = 0; sweep < SnapSweeps && idle < 6; ++sweep)
  {
    if (!monitor.Update(1.0))
    {
      return monitor.StopStatus();
    }
    features.FollowCurves(mesh.Points);
    const bool far = sweep >= SnapFarStart;
    const Index left = Snap(mesh, features, optimizer, far ? 1e300 : SnapNear);
    if (left == 0)
    {
      break;
    }
    optimizer.UpdateSizes();
    terms.UpdatePlanes(optimizer, weight, featureWeight);
    optimizer.ActivateBoundary();
    for (int relax = 0; relax < 2; ++relax)
    {
      optimizer.Sweep(-1.0, &monitor);
    }
    featureWeight = std::min(featureWeight * SnapGrowth, SnapWeight);
    idle = far && left == last ? idle + 1 : 0;
    last = left;
  }
  for (Index v : features.Vertices())
  {
    if (features.Locked(v))
    {
      continue;
    }
    if (!monitor.Ask())
    {
      return monitor.StopStatus();
    }
    if (!ForceSnap(mesh, stars, features, optimizer, v))
    {
      features.FollowCurves(mesh.Points);
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
    terms.UpdatePlanes(optimizer, weight, FeatureShare * weight);
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
    optimizer.Sweep(-1.0, &monitor);
    weight = std::min(weight * options.WeightGrowth, options.MaximumWeight);
  }
  if (features)
  {
    Status status = SnapFeatures(mesh, stars, *features, terms, optimizer, weight, monitor);
    if (!status.Ok())
    {
      return status;
    }
  }
  envelope.Rebuild();
  return monitor.StopStatus();
}
}

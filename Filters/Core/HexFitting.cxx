// SPDX-License-Identifier: BSD-3-Clause
#include "HexFitting.h"

#include "FeatureSnapping.h"

#include <algorithm>

namespace featurehex
{
namespace
{
/// Of the tolerance: closer samples of the input exert no pull.
constexpr double ReverseThreshold = 0.2;
constexpr int ReverseStart = 3;          // iterations before samples of the input pull
}

Status FitHexes(HexMesh& mesh, const HexStars& stars, const SurfaceGeometry& surface,
  FeatureTargets* features, SurfaceEnvelope& envelope, const FittingOptions& options,
  Monitor& monitor)
{
  HexOptimizer optimizer(mesh, stars);
  optimizer.FixUnchanged(options.Changed);
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

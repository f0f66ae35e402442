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
}

Status FitHexes(HexMesh& mesh, const HexStars& stars, const SurfaceGeometry& surface,
  SurfaceEnvelope& envelope, const FittingOptions& options, Monitor& monitor)
{
  HexOptimizer optimizer(mesh, stars);
  SurfaceTerms terms(mesh, stars, surface);
  const double threshold = ReverseThreshold * options.Tolerance * surface.Diagonal();
  double weight = options.InitialWeight;
  for (int iteration = 0; iteration < options.Iterations; ++iteration)
  {
    if (!monitor.Update(static_cast<double>(iteration) / options.Iterations))
    {
      return monitor.StopStatus();
    }
    optimizer.UpdateSizes();
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
    optimizer.Sweep(-1.0, &monitor);
    weight = std::min(weight * options.WeightGrowth, options.MaximumWeight);
  }
  envelope.Rebuild();
  return monitor.StopStatus();
}
}

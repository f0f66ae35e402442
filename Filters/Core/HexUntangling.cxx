// SPDX-License-Identifier: BSD-3-Clause
#include "HexUntangling.h"

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

Status UntangleHexes(HexMesh& mesh, const HexStars& stars, const SurfaceGeometry* surface,
  const UntangleOptions& options, UntangleReport& report, Monitor& monitor)
{
  HexOptimizer optimizer(mesh, stars);
  report = UntangleReport();
  const auto countInverted = [&mesh] { return static_cast<Index>(InvertedHexes(mesh).size()); };
  report.InvertedBefore = report.InvertedAfter = countInverted();
  if (surface)
  {
    SurfaceTerms(mesh, stars, *surface, options.Features)
      .UpdatePlanes(optimizer, options.SurfaceWeight, options.SurfaceWeight);
  }
  else
  {
    for (std::size_t v = 0; v < mesh.Points.size(); ++v)
    {
      optimizer.Fixed[v] = stars.OnBoundary(static_cast<Index>(v));
    }
  }
  for (std::size_t h = 0; h < mesh.Hexes.size(); ++h)
  {
    report.Hopeless += optimizer.Hopeless(static_cast<Index>(h)) ? 1 : 0;
  }
  if (options.Method == UntangleMethod::Stitching)
  {
    const Status status =
      StitchHexes(mesh, stars, optimizer, options.MaximumSweeps, report.Sweeps, monitor);
    report.InvertedAfter = countInverted();
    return status;
  }
  while (report.InvertedAfter > report.Hopeless && report.Sweeps < options.MaximumSweeps)
  {
    if (!monitor.Update(static_cast<double>(report.Sweeps) / options.MaximumSweeps))
    {
      return monitor.StopStatus();
    }
    // Regularisation of recipe-pipeline 2.6: follows the worst determinant, wide in the first sweeps.
    const double worst = std::min(optimizer.LeastDeterminant(), 0.0);
    double delta = std::sqrt(1e-6 + 0.04 * worst * worst);
    if (report.Sweeps < 15)
    {
      delta = std::max(delta, 0.05);
    }
    optimizer.ActivateAll();
    optimizer.Sweep(delta, &monitor);
    ++report.Sweeps;
    report.InvertedAfter = countInverted();
  }
  return monitor.StopStatus();
}
}

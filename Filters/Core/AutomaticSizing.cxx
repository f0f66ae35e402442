// SPDX-License-Identifier: BSD-3-Clause
#include "AutomaticSizing.h"

#include "BlockOctree.h"
#include "FeatureSizing.h"
#include "GridFit.h"
#include "SurfaceSizing.h"

#include <cmath>

namespace featurehex
{
namespace
{
constexpr double LargerCells[] = { 1.8, 1.35 }; // of the usual size
constexpr double DemandingShare = 0.005; // of the samples of the surface: fewer are no reason
constexpr double SagShare = 0.5;         // of the tolerance

/// Nothing asks for smaller cells.
bool FineEnough(const SurfaceGeometry& surface, const FeatureGeometry& features, double size,
  double slack, Monitor& monitor)
{
  FeatureSizingOptions alongCurves;
  alongCurves.TargetEdgeLength = size;
  if (!ComputeFeatureSizing(features, alongCurves).empty())
  {
    return false;
  }
  SizingOptions sizing;
  sizing.TargetEdgeLength = size;
  sizing.Slack = slack;
  sizing.CellsPerThickness = AutomaticSizingFor(true).CellsPerThickness;
  sizing.MaximumSizingLevel = 1;
  sizing.Sag = SagShare * slack;
  const std::size_t demands =
    ComputeSizing(surface.Mesh(), surface.Search(), sizing, monitor).size();
  const std::size_t samples =
    SampleSurface(surface.Mesh(), sizing.SampleSpacing * size).size();
  return demands <= DemandingShare * samples && !monitor.Stopped();
}
}

double AutomaticEdgeLength(const SurfaceGeometry& surface, const SurfaceFeatures& features,
  const Mat3& axes, double slack, Monitor& monitor)
{
  const double side = surface.Bounds().Size().maxCoeff();
  const double usual = side / AutomaticSizingFor(!features.Curves.empty()).CellsPerSide;
  if (features.Curves.empty())
  {
    return usual;
  }
  const FeatureGeometry geometry(surface.Mesh(), features, TrimCells * usual);
  const GridFit fit(surface.Mesh(), axes);
  for (double factor : LargerCells)
  {
    const double size = fit.BestSize(factor * usual);
    if (FineEnough(surface, geometry, size, slack, monitor))
    {
      return size;
    }
  }
  return fit.BestSize(usual);
}

int AutomaticCoarseLevels(const SurfaceGeometry& surface, double edgeLength, bool features)
{
  const SurfaceMesh& mesh = surface.Mesh();
  const Vec3 origin = surface.Bounds().Center();
  double volume = 0;
  for (const Triangle& t : mesh.Triangles)
  {
    volume += (mesh.Points[t[0]] - origin)
                .dot((mesh.Points[t[1]] - origin).cross(mesh.Points[t[2]] - origin)) /
      6;
  }
  const bool few = std::abs(volume) <=
    AutomaticSizingFor(features).UniformHexes * edgeLength * edgeLength * edgeLength;
  return few ? 0 : OctreeOptions().CoarseLevels;
}
} // namespace featurehex

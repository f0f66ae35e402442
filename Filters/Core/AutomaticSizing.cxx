// SPDX-License-Identifier: BSD-3-Clause
#include "AutomaticSizing.h"

#include "BlockOctree.h"
#include "FeatureSizing.h"
#include "GridFit.h"

#include <cmath>

namespace featurehex
{
namespace
{
constexpr double LargerCells[] = { 1.8, 1.35 }; // of the usual size
constexpr double DemandingShare = 0.005; // of the samples of the surface: fewer are no reason
constexpr double SagShare = 0.5;         // of the tolerance
constexpr double SaggingSamples = 0.13; // share of the samples where quads may sag by more
/// Edge lengths: quads can follow curvature to the tolerance where it is not smaller than this; to
/// less of it where it is.
constexpr double EasyTolerance = 0.11;
constexpr double RefinedSag = 2.2; // of the tolerance: where flat quads sag by more, cells are finer
constexpr int CurvatureLevels = 2; // by so many halvings
constexpr double SmallestCells = 0.05;  // of the usual size
constexpr double FactorStep = 1.189207115002721; // four steps halve

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
  SizingOptions sizing = AutomaticSizingOptions(true, size, slack);
  sizing.MaximumSizingLevel = sizing.MaximumCurvatureLevel = 1;
  sizing.Sag = SagShare * slack;
  const std::size_t demands =
    ComputeSizing(surface.Mesh(), surface.Search(), sizing, monitor).size();
  const std::size_t samples =
    SampleSurface(surface.Mesh(), sizing.SampleSpacing * size).size();
  return demands <= DemandingShare * samples && !monitor.Stopped();
}

/// The largest cells, in usual ones and at most one step larger, whose quads can follow the curvature
/// within the tolerance nearly everywhere. With features at most one: FineEnough() asks for more.
double CurvatureFactor(const SurfaceGeometry& surface, double usual, double slack, bool features,
  Monitor& monitor)
{
  SizingOptions sizing = AutomaticSizingOptions(features, usual, slack);
  const std::vector<SurfaceSample> samples =
    SampleSurface(surface.Mesh(), sizing.SampleSpacing * usual);
  const auto share = [&](double factor) {
    sizing.TargetEdgeLength = factor * usual;
    const double ease = slack / (EasyTolerance * sizing.TargetEdgeLength);
    sizing.Sag = slack * std::min(1.0, ease * ease);
    return SaggingShare(samples, surface.Search(), sizing, monitor);
  };
  if (!features && share(FactorStep) <= DemandingShare)
  {
    return FactorStep;
  }
  double factor = 1;
  while (factor > SmallestCells && share(factor) > SaggingSamples && !monitor.Stopped())
  {
    factor /= FactorStep;
  }
  return factor;
}
}

SizingOptions AutomaticSizingOptions(bool features, double edgeLength, double slack)
{
  SizingOptions sizing;
  sizing.TargetEdgeLength = edgeLength;
  sizing.Slack = slack;
  sizing.CellsPerThickness = AutomaticSizingFor(features).CellsPerThickness;
  sizing.MaximumSizingLevel = AutomaticSizingFor(features).MaximumSizingLevel;
  sizing.Sag = RefinedSag * slack;
  sizing.MaximumCurvatureLevel = CurvatureLevels;
  return sizing;
}

double AutomaticEdgeLength(const SurfaceGeometry& surface, const SurfaceFeatures& features,
  const Mat3& axes, double slack, Monitor& monitor)
{
  const double side = surface.Bounds().Size().maxCoeff();
  const double usual = side / AutomaticSizingFor(!features.Curves.empty()).CellsPerSide;
  const bool sharp = !features.Curves.empty();
  const double factor = CurvatureFactor(surface, usual, slack, sharp, monitor);
  if (!sharp)
  {
    return factor * usual;
  }
  const FeatureGeometry geometry(surface.Mesh(), features, TrimCells * usual);
  const GridFit fit(surface.Mesh(), axes);
  if (factor < 1)
  {
    return fit.BestSize(factor * usual);
  }
  for (double larger : LargerCells)
  {
    const double size = fit.BestSize(larger * usual);
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

// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureSizing.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace featurehex
{
namespace
{
constexpr double SampleSpacing = 0.25; // target edge lengths, along a curve
constexpr double NearAccuracy = 0.05; // of the distance in question

struct CurveSample
{
  Vec3 Position;
  Index Curve;
};

using GridCell = std::array<std::int64_t, 3>;

GridCell CellAt(const Vec3& p, double size)
{
  return { static_cast<std::int64_t>(std::floor(p[0] / size)),
    static_cast<std::int64_t>(std::floor(p[1] / size)),
    static_cast<std::int64_t>(std::floor(p[2] / size)) };
}

/// Halvings of @a h that make cells of at most @a size.
int LevelOf(double size, double h, int maximum)
{
  return size > 0 ? std::clamp(static_cast<int>(std::ceil(std::log2(h / size) - 1e-9)), 0, maximum)
                  : maximum;
}

bool Meet(const EnforcedCurve& a, const EnforcedCurve& b)
{
  for (Index corner : { a.FirstCorner, a.LastCorner })
  {
    if (corner >= 0 && (corner == b.FirstCorner || corner == b.LastCorner))
    {
      return true;
    }
  }
  return false;
}

/// Some point of a piece of a curve is nearer than @a distance to another. Distances change by at
/// most the way along the curve.
bool ComesNear(const EnforcedCurve& curve, double from, double to, const EnforcedCurve& other,
  double distance)
{
  const double middle = 0.5 * (from + to);
  const double half = 0.5 * (to - from);
  const double atMiddle = other.Closest(curve.At(middle)).Distance;
  if (atMiddle < distance || atMiddle - half > distance || half < NearAccuracy * distance)
  {
    return atMiddle < distance;
  }
  return ComesNear(curve, from, middle, other, distance) ||
    ComesNear(curve, middle, to, other, distance);
}
}

std::vector<RefinementPoint> ComputeFeatureSizing(
  const FeatureGeometry& geometry, const FeatureSizingOptions& options)
{
  const double h = options.TargetEdgeLength;
  const std::vector<EnforcedCurve>& curves = geometry.Curves();
  std::vector<CurveSample> samples;
  for (std::size_t c = 0; c < curves.size(); ++c)
  {
    if (curves[c].Points.empty())
    {
      continue;
    }
    const int pieces = std::clamp(
      static_cast<int>(std::ceil(curves[c].Length() / (SampleSpacing * h))), 4, 100000);
    for (int i = 0; i <= pieces; ++i)
    {
      samples.push_back({ curves[c].At(curves[c].Length() * i / pieces), static_cast<Index>(c) });
    }
  }
  const double reach = options.CellsBetween * h;
  std::map<GridCell, std::vector<Index>> grid;
  for (std::size_t s = 0; s < samples.size(); ++s)
  {
    grid[CellAt(samples[s].Position, reach)].push_back(static_cast<Index>(s));
  }
  std::vector<RefinementPoint> points;
  for (const CurveSample& sample : samples)
  {
    const EnforcedCurve& curve = curves[sample.Curve];
    const double perLoop = curve.Closed ? curve.Length() / options.CellsPerLoop : h;
    const double perCurve = curve.Closed ? h : curve.Length() / options.CellsPerCurve;
    const GridCell cell = CellAt(sample.Position, reach);
    double nearest = reach;
    for (int i = 0; i < 27; ++i)
    {
      const auto found =
        grid.find({ cell[0] + i % 3 - 1, cell[1] + i / 3 % 3 - 1, cell[2] + i / 9 - 1 });
      for (std::size_t k = 0; found != grid.end() && k < found->second.size(); ++k)
      {
        const CurveSample& other = samples[found->second[k]];
        const double distance = (other.Position - sample.Position).norm();
        if (other.Curve != sample.Curve && distance < nearest && !Meet(curve, curves[other.Curve]))
        {
          nearest = distance;
        }
      }
    }
    const int level = std::max(LevelOf(perLoop, h, options.MaximumLevel),
      LevelOf(std::min(perCurve, nearest / options.CellsBetween), h,
        std::min(options.MaximumSizingLevel, options.MaximumLevel)));
    if (level > 0)
    {
      points.push_back({ sample.Position, level });
    }
  }
  return points;
}

bool TooCloseForCells(const FeatureGeometry& geometry, Index curve, double size)
{
  const double distance = FeatureSizingOptions().CellsBetween * size;
  const EnforcedCurve& line = geometry.Curves()[curve];
  return std::any_of(geometry.Curves().begin(), geometry.Curves().end(),
    [&](const EnforcedCurve& other) {
      return &other != &line && !other.Points.empty() && !Meet(line, other) &&
        ComesNear(line, 0.0, line.Length(), other, distance);
    });
}
} // namespace featurehex

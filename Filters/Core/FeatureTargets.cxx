// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureTargets.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
constexpr int SpreadPasses = 3; // of averaging the arcs of the vertices before and after
constexpr int WindowSteps = 4; // vertices before and after whose curve points bound the search

/// Arcs in rising order, then averaged: vertices that crowd or have changed places get room.
std::vector<double> SpreadArcs(std::vector<double> arcs, bool closed, double length)
{
  const std::size_t count = arcs.size();
  if (!closed)
  {
    std::sort(arcs.begin(), arcs.end());
  }
  for (int pass = 0; pass < SpreadPasses; ++pass)
  {
    const std::vector<double> old = arcs;
    for (std::size_t i = 1; i + 1 < count; ++i)
    {
      arcs[i] = 0.5 * old[i] + 0.25 * (old[i - 1] + old[i + 1]);
    }
    if (closed) // the first vertex is the last one, a length further
    {
      arcs[0] = 0.5 * old[0] + 0.25 * (old[count - 2] - length + old[1]);
      arcs[count - 1] = arcs[0] + length;
    }
  }
  return arcs;
}
}

FeatureTargets::FeatureTargets(const FeatureGeometry& geometry, const HexFeatures& features,
  const HexStars& stars, const std::vector<Vec3>& points)
  : Geometry(geometry)
  , Features(features)
  , Labels(features, stars)
  , Windows(points.size())
  , IsLocked(points.size(), 0)
{
  for (Index v = 0; v < static_cast<Index>(points.size()); ++v)
  {
    if (this->OnFeature(v))
    {
      this->FeatureVertices.push_back(v);
    }
  }
  // First the arcs a path would have if its vertices were spread evenly, then those of closest
  // points.
  for (std::size_t c = 0; c < features.CurvePaths.size(); ++c)
  {
    const std::vector<Index>& path = features.CurvePaths[c];
    const double length = geometry.Curves()[c].Length();
    for (std::size_t i = 0; i < path.size(); ++i)
    {
      if (this->KindOf(path[i]) == FeatureKind::Curve)
      {
        const double arc = length * static_cast<double>(i) / static_cast<double>(path.size() - 1);
        const double reach = 0.3 * length;
        this->Windows[path[i]] = { arc - reach, arc + reach, arc };
      }
    }
  }
  this->FollowCurves(points);
}

CurvePoint FeatureTargets::OnCurve(Index v, const Vec3& p) const
{
  const EnforcedCurve& curve = this->Geometry.Curves()[this->Labels.Id[v]];
  Window window = this->Windows[v];
  if (!curve.Closed)
  {
    window = { std::max(0.0, window.From), std::min(curve.Length(), window.To) };
  }
  else if (window.From < 0)
  {
    window.From += curve.Length();
    window.To += curve.Length();
  }
  return curve.Closest(p, window.From, window.To);
}

double FeatureTargets::SpreadFrom(Index v, double arc) const
{
  const EnforcedCurve& curve = this->Geometry.Curves()[this->Labels.Id[v]];
  const double ahead = this->Windows[v].Spread - arc;
  return curve.Closed ? ahead - std::round(ahead / curve.Length()) * curve.Length() : ahead;
}

Vec3 FeatureTargets::Project(Index v, const Vec3& p) const
{
  return this->KindOf(v) == FeatureKind::Corner ? this->Geometry.CornerPoint(this->Labels.Id[v])
                                                : this->OnCurve(v, p).Point;
}

Vec3 FeatureTargets::Allowed(Index v, const Vec3& p, const Vec3& direction) const
{
  if (this->KindOf(v) == FeatureKind::Corner)
  {
    return Vec3::Zero();
  }
  const Vec3 tangent = this->OnCurve(v, p).Tangent;
  return tangent.dot(direction) * tangent;
}

void FeatureTargets::FollowCurves(const std::vector<Vec3>& points)
{
  for (std::size_t c = 0; c < this->Features.CurvePaths.size(); ++c)
  {
    const std::vector<Index>& path = this->Features.CurvePaths[c];
    const EnforcedCurve& curve = this->Geometry.Curves()[c];
    const int count = static_cast<int>(path.size());
    if (count < 2)
    {
      continue;
    }
    const double length = curve.Length();
    std::vector<double> arcs(count);
    for (int i = 0; i < count; ++i)
    {
      arcs[i] = this->KindOf(path[i]) == FeatureKind::Curve
                  ? this->OnCurve(path[i], points[path[i]]).Arc
                : i == 0 ? 0.0
                         : length;
      // Round the loop: arcs rise from vertex to vertex.
      if (curve.Closed && i > 0)
      {
        arcs[i] -= std::round((arcs[i] - arcs[i - 1]) / length) * length;
      }
    }
    if (curve.Closed)
    {
      arcs[count - 1] = arcs[0] + length;
    }
    const double step = length / (count - 1);
    const std::vector<double> spread = SpreadArcs(arcs, curve.Closed, length);
    for (int i = 0; i < count; ++i)
    {
      if (this->KindOf(path[i]) == FeatureKind::Curve)
      {
        double from, to;
        if (curve.Closed)
        {
          from = arcs[i] - WindowSteps * step;
          to = arcs[i] + WindowSteps * step;
          const double turns = std::floor(from / length) * length;
          from -= turns;
          to -= turns;
          to = std::min(to, from + length);
        }
        else
        {
          from = arcs[std::max(0, i - WindowSteps)];
          to = arcs[std::min(count - 1, i + WindowSteps)];
          from = std::min(from, arcs[i] - step);
          to = std::max(to, arcs[i] + step);
        }
        this->Windows[path[i]] = { from, to, spread[i] };
      }
    }
  }
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause
#include "RedundantCurves.h"

#include "BoxTree.h"
#include "DisjointSets.h"

#include <cmath>
#include <tuple>

namespace featurehex
{
namespace
{
constexpr double SampleSpacing = 2.0; // distances, along a curve
constexpr int MaximumSamples = 1000;  // on an edge

double DistanceToSegment(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 edge = b - a;
  const double square = edge.squaredNorm();
  const double t = square > 0 ? std::clamp((p - a).dot(edge) / square, 0.0, 1.0) : 0.0;
  return (p - a - t * edge).norm();
}

/// The segments of all curves, and which of them still count.
class CurveSearch
{
public:
  CurveSearch(const SurfaceMesh& surface, const SurfaceFeatures& features, double distance)
    : Points(surface.Points)
    , Distance(distance)
    , Segments(SegmentsOf(features))
    , Tree(surface.Points, this->Segments)
    , Counts(features.Curves.size(), 1)
  {
    for (std::size_t c = 0; c < features.Curves.size(); ++c)
    {
      this->CurveOfSegment.insert(
        this->CurveOfSegment.end(), features.Curves[c].Points.size() - 1, static_cast<Index>(c));
    }
  }

  void Drop(Index curve) { this->Counts[curve] = 0; }

  /// A curve other than @a except is near the point.
  bool Near(const Vec3& p, Index except) const
  {
    bool near = false;
    Box box;
    box.Extend(p - Vec3::Constant(this->Distance));
    box.Extend(p + Vec3::Constant(this->Distance));
    this->Tree.VisitBox(box, [&](Index s) {
      const Index curve = this->CurveOfSegment[s];
      const Triangle& segment = this->Segments[s];
      near = near ||
        (curve != except && this->Counts[curve] &&
          DistanceToSegment(p, this->Points[segment[0]], this->Points[segment[1]]) <=
            this->Distance);
    });
    return near;
  }

  /// The same for all points from @a a to @a b. Ends often are: samples start from the middle.
  bool NearAlong(const Vec3& a, const Vec3& b, Index except) const
  {
    const int pieces =
      std::clamp(static_cast<int>(std::ceil((b - a).norm() / (SampleSpacing * this->Distance))), 1,
        MaximumSamples);
    for (int k = 0; k < pieces; ++k)
    {
      if (!this->Near(a + (k + 0.5) / pieces * (b - a), except))
      {
        return false;
      }
    }
    return this->Near(a, except) && this->Near(b, except);
  }

  bool Covered(const FeatureCurve& curve, Index id) const;

private:
  static std::vector<Triangle> SegmentsOf(const SurfaceFeatures& features)
  {
    std::vector<Triangle> segments;
    for (const FeatureCurve& curve : features.Curves)
    {
      for (std::size_t i = 1; i < curve.Points.size(); ++i)
      {
        segments.push_back({ curve.Points[i - 1], curve.Points[i], curve.Points[i] });
      }
    }
    return segments;
  }

  const std::vector<Vec3>& Points;
  double Distance;
  std::vector<Triangle> Segments; ///< with their second point twice
  BoxTree Tree;
  std::vector<Index> CurveOfSegment;
  std::vector<char> Counts;
};

/// All points of the curve are near others.
bool CurveSearch::Covered(const FeatureCurve& curve, Index id) const
{
  for (std::size_t i = 1; i < curve.Points.size(); ++i)
  {
    if (!this->NearAlong(this->Points[curve.Points[i - 1]], this->Points[curve.Points[i]], id))
    {
      return false;
    }
  }
  return true;
}

double LengthOf(const SurfaceMesh& surface, const FeatureCurve& curve)
{
  double length = 0;
  for (std::size_t i = 1; i < curve.Points.size(); ++i)
  {
    length += (surface.Points[curve.Points[i]] - surface.Points[curve.Points[i - 1]]).norm();
  }
  return length;
}
}

std::vector<Index> FindRedundantCurves(
  const SurfaceMesh& surface, const SurfaceFeatures& features, double distance)
{
  std::vector<Index> redundant;
  if (features.Curves.size() < 2 || !(distance > 0))
  {
    return redundant;
  }
  CurveSearch search(surface, features, distance);
  std::vector<std::tuple<bool, double, Index>> candidates; // loose ones first, then long ones
  for (Index c = 0; c < static_cast<Index>(features.Curves.size()); ++c)
  {
    const FeatureCurve& curve = features.Curves[c];
    if (search.Covered(curve, c))
    {
      candidates.emplace_back(curve.LeftPatch != curve.RightPatch, -LengthOf(surface, curve), c);
    }
  }
  std::sort(candidates.begin(), candidates.end());
  DisjointSets joined(features.NumberOfPatches);
  // Points of a large patch may all lie on its curves: its edges and middles count, too.
  const auto sliver = [&](int patch, Index curve) {
    const Index set = joined.Find(patch);
    for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
    {
      if (joined.Find(features.PatchOfTriangle[t]) != set)
      {
        continue;
      }
      Vec3 p[3];
      for (int k = 0; k < 3; ++k)
      {
        p[k] = surface.Points[surface.Triangles[t][k]];
      }
      if (!search.Near((p[0] + p[1] + p[2]) / 3.0, curve) ||
        !search.NearAlong(p[0], p[1], curve) || !search.NearAlong(p[1], p[2], curve) ||
        !search.NearAlong(p[2], p[0], curve))
      {
        return false;
      }
    }
    return true;
  };
  for (const auto& [bounding, length, c] : candidates)
  {
    const FeatureCurve& curve = features.Curves[c];
    if (search.Covered(curve, c) &&
      (joined.Find(curve.LeftPatch) == joined.Find(curve.RightPatch) ||
        sliver(curve.LeftPatch, c) || sliver(curve.RightPatch, c)))
    {
      search.Drop(c);
      joined.Join(curve.LeftPatch, curve.RightPatch);
      redundant.push_back(c);
    }
  }
  std::sort(redundant.begin(), redundant.end());
  return redundant;
}
} // namespace featurehex

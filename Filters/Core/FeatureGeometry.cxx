// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureGeometry.h"

#include "DisjointSets.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace featurehex
{
namespace
{
/// Cuts a polyline to the arcs [from, to].
std::vector<Vec3> Cut(const std::vector<Vec3>& points, double from, double to)
{
  std::vector<Vec3> result;
  double arc = 0;
  for (std::size_t i = 0; i + 1 < points.size(); ++i)
  {
    const double length = (points[i + 1] - points[i]).norm();
    const auto at = [&](double s)
    { return Vec3(points[i] + (s - arc) / length * (points[i + 1] - points[i])); };
    if (length > 0 && arc + length > from && arc < to)
    {
      if (result.empty())
      {
        result.push_back(arc >= from ? points[i] : at(from));
      }
      result.push_back(arc + length <= to ? points[i + 1] : at(to));
    }
    arc += length;
  }
  return result;
}

double PolylineLength(const std::vector<Vec3>& points)
{
  double length = 0;
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    length += (points[i] - points[i - 1]).norm();
  }
  return length;
}

double SpanAt(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 u = a - p;
  const Vec3 v = b - p;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}
}

Vec3 EnforcedCurve::At(double arc) const
{
  if (this->Closed)
  {
    arc -= std::floor(arc / this->Length()) * this->Length();
  }
  const auto next = std::upper_bound(this->Arcs.begin(), this->Arcs.end(), arc);
  const std::size_t i = std::clamp<std::ptrdiff_t>(
    next - this->Arcs.begin(), 1, static_cast<std::ptrdiff_t>(this->Arcs.size()) - 1);
  const double length = this->Arcs[i] - this->Arcs[i - 1];
  const double t = length > 0 ? std::clamp((arc - this->Arcs[i - 1]) / length, 0.0, 1.0) : 0.0;
  return this->Points[i - 1] + t * (this->Points[i] - this->Points[i - 1]);
}

CurvePoint EnforcedCurve::Closest(const Vec3& p, double from, double to) const
{
  CurvePoint best;
  double least = 1e300;
  const double length = this->Length();
  // A range over the end of a loop: the segments are seen once more, one length further.
  for (double shift = 0; shift <= (this->Closed && to > length ? length : 0.0); shift += length)
  {
    for (std::size_t i = 1; i < this->Points.size(); ++i)
    {
      const double a = this->Arcs[i - 1] + shift;
      const double b = this->Arcs[i] + shift;
      if (b < from || a > to || !(b > a))
      {
        continue;
      }
      const Vec3 edge = this->Points[i] - this->Points[i - 1];
      const double low = std::max(0.0, (from - a) / (b - a));
      const double high = std::min(1.0, (to - a) / (b - a));
      const double t =
        std::clamp((p - this->Points[i - 1]).dot(edge) / edge.squaredNorm(), low, high);
      const Vec3 point = this->Points[i - 1] + t * edge;
      const double square = (p - point).squaredNorm();
      if (square < least)
      {
        least = square;
        best.Point = point;
        best.Tangent = edge;
        best.Arc = a + t * (b - a);
      }
    }
  }
  best.Distance = std::sqrt(least);
  best.Tangent.normalize();
  return best;
}

FeatureGeometry::FeatureGeometry(
  const SurfaceMesh& surface, const SurfaceFeatures& features, double trim,
  const GivenUpFeatures& givenUp)
  : Mesh(surface)
  , Graph(features)
  , GivenUp(givenUp)
{
  this->MergePatches();
  this->BuildCurves(trim);
  this->BuildFans();
  this->BuildPatches();
}

void FeatureGeometry::MergePatches()
{
  DisjointSets sets(this->Graph.NumberOfPatches);
  for (Index c : this->GivenUp.Curves)
  {
    sets.Join(this->Graph.Curves[c].LeftPatch, this->Graph.Curves[c].RightPatch);
  }
  for (const FeatureCurve& curve : this->Graph.Curves)
  {
    for (Index corner : { curve.FirstCorner, curve.LastCorner })
    {
      if (corner >= 0 && !this->Enforced(corner))
      {
        sets.Join(curve.LeftPatch, curve.RightPatch);
      }
    }
  }
  for (int patch = 0; patch < this->Graph.NumberOfPatches; ++patch)
  {
    this->MergedPatch.push_back(sets.Find(patch));
  }
}

void FeatureGeometry::BuildCurves(double trim)
{
  for (const FeatureCurve& curve : this->Graph.Curves)
  {
    EnforcedCurve enforced;
    std::vector<Vec3> points;
    for (Index v : curve.Points)
    {
      points.push_back(this->Mesh.Points[v]);
    }
    const bool cutFirst = curve.FirstCorner >= 0 && !this->Enforced(curve.FirstCorner);
    const bool cutLast = curve.LastCorner >= 0 && !this->Enforced(curve.LastCorner);
    enforced.FirstCorner = cutFirst ? -1 : curve.FirstCorner;
    enforced.LastCorner = cutLast ? -1 : curve.LastCorner;
    enforced.Closed = curve.Closed() && curve.FirstCorner < 0;
    enforced.LeftPatch = curve.LeftPatch;
    enforced.RightPatch = curve.RightPatch;
    const double length = PolylineLength(points);
    const double from = cutFirst ? trim : 0.0;
    const double to = length - (cutLast ? trim : 0.0);
    // What is left of a cut curve must be worth following.
    const bool givenUp =
      this->GivenUp.Curves.count(static_cast<Index>(this->EnforcedCurves.size())) > 0;
    if (!givenUp && to - from >= (cutFirst || cutLast ? trim : 0.0))
    {
      enforced.Points = cutFirst || cutLast ? Cut(points, from, to) : points;
      double arc = 0;
      for (std::size_t i = 0; i < enforced.Points.size(); ++i)
      {
        arc += i > 0 ? (enforced.Points[i] - enforced.Points[i - 1]).norm() : 0.0;
        enforced.Arcs.push_back(arc);
      }
    }
    this->EnforcedCurves.push_back(std::move(enforced));
  }
}

void FeatureGeometry::BuildFans()
{
  // For each corner the ring of triangles: after(a) = b in the triangle corner, a, b.
  std::map<Index, Index> cornerOfPoint;
  for (std::size_t c = 0; c < this->Graph.Corners.size(); ++c)
  {
    cornerOfPoint[this->Graph.Corners[c].Point] = static_cast<Index>(c);
  }
  std::vector<std::map<Index, Index>> after(this->Graph.Corners.size());
  for (const Triangle& t : this->Mesh.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (const auto found = cornerOfPoint.find(t[k]); found != cornerOfPoint.end())
      {
        after[found->second][t[(k + 1) % 3]] = t[(k + 2) % 3];
      }
    }
  }
  std::vector<std::map<Index, std::pair<Index, bool>>> spokes(this->Graph.Corners.size());
  for (std::size_t c = 0; c < this->EnforcedCurves.size(); ++c)
  {
    const std::vector<Index>& points = this->Graph.Curves[c].Points;
    const EnforcedCurve& curve = this->EnforcedCurves[c];
    if (!curve.Points.empty() && curve.FirstCorner >= 0)
    {
      spokes[curve.FirstCorner][points[1]] = { static_cast<Index>(c), false };
    }
    if (!curve.Points.empty() && curve.LastCorner >= 0)
    {
      spokes[curve.LastCorner][points[points.size() - 2]] = { static_cast<Index>(c), true };
    }
  }
  this->CornerFans.resize(this->Graph.Corners.size());
  for (std::size_t c = 0; c < this->CornerFans.size(); ++c)
  {
    CornerFan& fan = this->CornerFans[c];
    if (spokes[c].empty())
    {
      continue;
    }
    const Vec3& p = this->CornerPoint(static_cast<Index>(c));
    const Index start = spokes[c].begin()->first;
    Index v = start;
    do
    {
      if (const auto spoke = spokes[c].find(v); spoke != spokes[c].end())
      {
        fan.Spokes.push_back({ spoke->second.first, spoke->second.second, fan.FullAngle });
      }
      const Index next = after[c][v];
      fan.FullAngle += SpanAt(p, this->Mesh.Points[v], this->Mesh.Points[next]);
      v = next;
    } while (v != start);
  }
}

void FeatureGeometry::BuildPatches()
{
  std::vector<SurfaceMesh> meshes(this->Graph.NumberOfPatches);
  for (std::size_t t = 0; t < this->Mesh.Triangles.size(); ++t)
  {
    meshes[this->Graph.PatchOfTriangle[t]].Triangles.push_back(this->Mesh.Triangles[t]);
  }
  std::vector<Index> local(this->Mesh.Points.size(), -1);
  for (SurfaceMesh& mesh : meshes)
  {
    std::vector<Index> used;
    for (Triangle& triangle : mesh.Triangles)
    {
      for (Index& v : triangle)
      {
        if (local[v] < 0)
        {
          local[v] = static_cast<Index>(used.size());
          used.push_back(v);
          mesh.Points.push_back(this->Mesh.Points[v]);
        }
        v = local[v];
      }
    }
    for (Index v : used)
    {
      local[v] = -1;
    }
    this->Patches.push_back(std::make_unique<SurfaceGeometry>(std::move(mesh)));
  }
}
} // namespace featurehex

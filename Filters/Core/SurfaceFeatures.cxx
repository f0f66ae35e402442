// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFeatures.h"

#include "DisjointSets.h"
#include "ExactPredicates.h"
#include "MessageText.h"
#include "SurfaceFlaws.h"
#include "SurfaceTopology.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
constexpr double DegreesPerRadian = 57.295779513082321;

/// A direction is measured over at least this fraction of the diagonal.
constexpr double ProbeLength = 0.002;

/// Neighbours of each point: Ids[First[p]] to Ids[First[p + 1]], ascending.
struct PointGraph
{
  PointGraph(const std::vector<std::uint64_t>& keys, std::size_t numberOfPoints)
    : First(numberOfPoints + 1, 0)
    , Ids(2 * keys.size())
  {
    for (const std::uint64_t key : keys)
    {
      ++this->First[Low(key) + 1];
      ++this->First[High(key) + 1];
    }
    for (std::size_t p = 0; p < numberOfPoints; ++p)
    {
      this->First[p + 1] += this->First[p];
    }
    std::vector<Index> next(this->First.begin(), this->First.end() - 1);
    // Keys ascend: first come the lower neighbours of a point, then the higher ones.
    for (const std::uint64_t key : keys)
    {
      this->Ids[next[Low(key)]++] = High(key);
      this->Ids[next[High(key)]++] = Low(key);
    }
    for (std::size_t p = 0; p < numberOfPoints; ++p)
    {
      std::sort(this->Ids.begin() + this->First[p], this->Ids.begin() + this->First[p + 1]);
    }
  }

  static Index Low(std::uint64_t key) { return static_cast<Index>(key >> 32); }
  static Index High(std::uint64_t key) { return static_cast<Index>(key & 0xffffffffU); }
  Index Count(Index p) const { return this->First[p + 1] - this->First[p]; }
  const Index* begin(Index p) const { return this->Ids.data() + this->First[p]; }
  const Index* end(Index p) const { return this->Ids.data() + this->First[p + 1]; }

  std::vector<Index> First;
  std::vector<Index> Ids;
};

std::string PointText(const SurfaceMesh& surface, Index p)
{
  return std::to_string(p) + " at " + PlaceText(surface.Points[p]);
}

/// One graph of one surface, step by step.
class Builder
{
public:
  Builder(const SurfaceMesh& surface, const FeatureGraphOptions& options, SurfaceFeatures& features,
    FeatureGraphReport& report)
    : Surface(surface)
    , Options(options)
    , Features(features)
    , Report(report)
    , Sides(surface.Triangles)
    , Probe(ProbeLength * BoundingBox(surface).Diagonal())
  {
  }

  Status CheckIds(const std::vector<PointPair>& edges, const std::vector<Index>& corners) const;
  Status CollectEdges(const std::vector<PointPair>& edges);
  void FindCorners(const std::vector<Index>& corners);
  void FindPatches();
  void TraceCurves();
  void FindFlaws();

private:
  struct CurveEnd
  {
    Index Corner;
    Vec3 Direction;
  };

  bool IsSurfaceEdge(std::uint64_t key) const;
  bool CoverEdge(
    const PointPair& edge, const PointGraph& neighbors, const std::vector<Vec3>& exact);
  void Trace(Index corner, Index next, const PointGraph& graph);
  void AddCurve(std::vector<Index> points);
  Index TriangleAt(Index a, Index b) const;
  Vec3 Direction(const std::vector<Index>& points, bool fromEnd) const;

  const SurfaceMesh& Surface;
  const FeatureGraphOptions& Options;
  SurfaceFeatures& Features;
  FeatureGraphReport& Report;
  EdgeTable Sides;
  double Probe;                     ///< model units
  std::vector<std::uint64_t> Keys;  ///< feature edges, ascending
  std::vector<char> Traced;         ///< of each key
  std::vector<Index> CornerOfPoint; ///< -1: none
};

Status Builder::CheckIds(
  const std::vector<PointPair>& edges, const std::vector<Index>& corners) const
{
  const Index count = static_cast<Index>(this->Surface.Points.size());
  const auto outside = [count](Index p) { return p < 0 || p >= count; };
  const auto range = [count]
  { return " of a surface with " + CountText(count, "point", "points"); };
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    const Index a = edges[e][0], b = edges[e][1];
    const std::string name = "Feature edge " + std::to_string(e);
    if (outside(a) || outside(b))
    {
      return Status(StatusCode::IndexOutOfRange, name + " goes to point " +
                                                   std::to_string(outside(a) ? a : b) + range() +
                                                   ": the features belong to another surface.");
    }
    if (a == b)
    {
      return Status(StatusCode::Degenerate,
        name + " goes from a point to itself: point " + PointText(this->Surface, a) + ".",
        { this->Surface.Points[a] });
    }
  }
  const auto bad = std::find_if(corners.begin(), corners.end(), outside);
  if (bad != corners.end())
  {
    return Status(StatusCode::IndexOutOfRange,
      "Feature corner " + std::to_string(bad - corners.begin()) + " is point " +
        std::to_string(*bad) + range() + ": the features belong to another surface.");
  }
  return Status();
}

bool Builder::IsSurfaceEdge(std::uint64_t key) const
{
  const std::vector<EdgeUse>& uses = this->Sides.Uses();
  const auto at = std::lower_bound(uses.begin(), uses.end(), key,
    [](const EdgeUse& use, std::uint64_t edge) { return use.Edge < edge; });
  return at != uses.end() && at->Edge == key;
}

/// Walks from one end to the other along surface edges that lie on the straight line between them.
bool Builder::CoverEdge(
  const PointPair& edge, const PointGraph& neighbors, const std::vector<Vec3>& exact)
{
  std::vector<std::uint64_t> keys;
  const Vec3& end = exact[edge[1]];
  Index at = edge[0];
  while (at != edge[1])
  {
    const Vec3 left = end - exact[at];
    const Index* const next = std::find_if(neighbors.begin(at), neighbors.end(at),
      [&](Index p)
      {
        const Vec3 step = exact[p] - exact[at];
        // Between here and the end: it can't be beyond, and every step comes closer.
        return (p == edge[1] || step.dot(left) > 0.0) && (end - exact[p]).dot(left) >= 0.0 &&
               Collinear(exact[at], exact[p], end);
      });
    if (next == neighbors.end(at))
    {
      return false;
    }
    keys.push_back(EdgeKey(at, *next));
    at = *next;
  }
  this->Keys.insert(this->Keys.end(), keys.begin(), keys.end());
  ++this->Report.NumberOfSplitEdges;
  return true;
}

Status Builder::CollectEdges(const std::vector<PointPair>& edges)
{
  std::vector<std::size_t> missing;
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    const std::uint64_t key = EdgeKey(edges[e][0], edges[e][1]);
    if (this->IsSurfaceEdge(key))
    {
      this->Keys.push_back(key);
    }
    else
    {
      missing.push_back(e);
    }
  }
  if (!missing.empty())
  {
    std::vector<std::uint64_t> all;
    this->Sides.VisitEdges([&](const EdgeUse* use, const EdgeUse*) { all.push_back(use->Edge); });
    const PointGraph neighbors(all, this->Surface.Points.size());
    const std::vector<Vec3> exact = PointsForPredicates(this->Surface.Points);
    const auto uncovered = std::remove_if(missing.begin(), missing.end(),
      [&](std::size_t e) { return this->CoverEdge(edges[e], neighbors, exact); });
    missing.erase(uncovered, missing.end());
  }
  if (!missing.empty())
  {
    const PointPair& first = edges[missing[0]];
    std::vector<Vec3> places;
    for (std::size_t i = 0; i < missing.size() && i < 100; ++i)
    {
      const PointPair& edge = edges[missing[i]];
      places.push_back(0.5 * (this->Surface.Points[edge[0]] + this->Surface.Points[edge[1]]));
    }
    return Status(StatusCode::IndexOutOfRange,
      CountText(missing.size(), "feature edge is", "feature edges are") +
        " not in the surface; the first, edge " + std::to_string(missing[0]) +
        ", goes from point " + PointText(this->Surface, first[0]) + " to point " +
        PointText(this->Surface, first[1]) +
        ". Use the features of this very surface, point ids starting at 0.",
      std::move(places));
  }
  const std::size_t given = this->Keys.size();
  std::sort(this->Keys.begin(), this->Keys.end());
  this->Keys.erase(std::unique(this->Keys.begin(), this->Keys.end()), this->Keys.end());
  this->Report.NumberOfDuplicateEdges = static_cast<Index>(given - this->Keys.size());
  return Status();
}

void Builder::FindCorners(const std::vector<Index>& corners)
{
  const std::size_t count = this->Surface.Points.size();
  const PointGraph graph(this->Keys, count);
  std::vector<char> isCorner(count, 0);
  for (const Index p : corners)
  {
    const bool keep = graph.Count(p) > 0 || this->Options.KeepIsolatedCorners;
    this->Report.NumberOfDroppedCorners += keep ? 0 : 1;
    isCorner[p] = keep;
  }
  const std::vector<Vec3>& points = this->Surface.Points;
  this->CornerOfPoint.assign(count, -1);
  for (Index p = 0; p < static_cast<Index>(count); ++p)
  {
    const Index* const next = graph.begin(p);
    const Index valence = graph.Count(p);
    const bool kink = valence == 2 && AngleAt(points[next[0]], points[p], points[next[1]]) <
                                        this->Options.CornerAngle;
    if (isCorner[p] || kink || (valence != 0 && valence != 2))
    {
      this->CornerOfPoint[p] = static_cast<Index>(this->Features.Corners.size());
      this->Features.Corners.push_back({ p, CornerFlaw::None });
    }
  }
}

/// Triangles are of one patch when they share an edge that is no feature.
void Builder::FindPatches()
{
  DisjointSets sets(this->Surface.Triangles.size());
  std::size_t feature = 0;
  this->Sides.VisitEdges(
    [&](const EdgeUse* first, const EdgeUse* last)
    {
      if (feature < this->Keys.size() && this->Keys[feature] == first->Edge)
      {
        ++feature;
        return;
      }
      for (const EdgeUse* use = first + 1; use < last; ++use)
      {
        sets.Join(first->Triangle(), use->Triangle());
      }
    });
  std::vector<int>& patches = this->Features.PatchOfTriangle;
  patches.resize(this->Surface.Triangles.size());
  for (Index t = 0; t < static_cast<Index>(patches.size()); ++t)
  {
    const Index first = sets.Find(t);
    patches[t] = first == t ? this->Features.NumberOfPatches++ : patches[first];
  }
}

/// The triangle on the left of the edge from @a a to @a b, seen from outside.
Index Builder::TriangleAt(Index a, Index b) const
{
  const std::vector<EdgeUse>& uses = this->Sides.Uses();
  const std::uint64_t key = EdgeKey(a, b);
  auto use = std::lower_bound(uses.begin(), uses.end(), key,
    [](const EdgeUse& u, std::uint64_t edge) { return u.Edge < edge; });
  for (; use != uses.end() && use->Edge == key; ++use)
  {
    if (this->Surface.Triangles[use->Triangle()][use->Side % 3] == a)
    {
      return use->Triangle();
    }
  }
  return -1;
}

/// From the lower corner to the higher one; loops start to the side of the lower neighbour.
void Builder::AddCurve(std::vector<Index> points)
{
  const bool loop = points.front() == points.back();
  if (loop ? points[1] > points[points.size() - 2] : points.front() > points.back())
  {
    std::reverse(points.begin(), points.end());
  }
  FeatureCurve curve;
  curve.FirstCorner = this->CornerOfPoint[points.front()];
  curve.LastCorner = this->CornerOfPoint[points.back()];
  const Index left = this->TriangleAt(points[0], points[1]);
  const Index right = this->TriangleAt(points[1], points[0]);
  curve.LeftPatch = left < 0 ? -1 : this->Features.PatchOfTriangle[left];
  curve.RightPatch = right < 0 ? -1 : this->Features.PatchOfTriangle[right];
  curve.Points = std::move(points);
  this->Features.Curves.push_back(std::move(curve));
}

void Builder::TraceCurves()
{
  const PointGraph graph(this->Keys, this->Surface.Points.size());
  this->Traced.assign(this->Keys.size(), 0);
  for (std::size_t e = 0; e < this->Keys.size(); ++e)
  {
    if (this->Traced[e])
    {
      continue;
    }
    // Back to a corner, or once round; then along the whole curve.
    const Index low = PointGraph::Low(this->Keys[e]);
    Index start = low;
    Index next = PointGraph::High(this->Keys[e]);
    while (this->CornerOfPoint[start] < 0)
    {
      const Index* const ends = graph.begin(start);
      const Index before = ends[0] == next ? ends[1] : ends[0];
      next = start;
      start = before;
      if (start == low)
      {
        break;
      }
    }
    this->Trace(start, next, graph);
  }
}

void Builder::Trace(Index corner, Index next, const PointGraph& graph)
{
  std::vector<Index> points = { corner };
  Index at = corner;
  for (;;)
  {
    const std::uint64_t key = EdgeKey(at, next);
    const auto edge = std::lower_bound(this->Keys.begin(), this->Keys.end(), key);
    this->Traced[edge - this->Keys.begin()] = 1;
    points.push_back(next);
    if (this->CornerOfPoint[next] >= 0 || next == corner)
    {
      break;
    }
    const Index* const ends = graph.begin(next);
    const Index after = ends[0] == at ? ends[1] : ends[0];
    at = next;
    next = after;
  }
  this->AddCurve(std::move(points));
}

Vec3 Builder::Direction(const std::vector<Index>& points, bool fromEnd) const
{
  const std::size_t count = points.size();
  const auto place = [&](std::size_t i) -> const Vec3&
  { return this->Surface.Points[points[fromEnd ? count - 1 - i : i]]; };
  // Of a loop at most half: the rest belongs to its other end.
  const std::size_t last =
    points.front() == points.back() ? std::max<std::size_t>(1, (count - 1) / 2) : count - 1;
  Vec3 at = place(1);
  double length = (at - place(0)).norm();
  for (std::size_t i = 2; i <= last && length < this->Probe; ++i)
  {
    const Vec3 step = place(i) - place(i - 1);
    const double part = std::min(1.0, (this->Probe - length) / step.norm());
    at = place(i - 1) + part * step;
    length += step.norm();
  }
  return at - place(0);
}

void Builder::FindFlaws()
{
  std::vector<std::vector<Vec3>> directions(this->Features.Corners.size());
  for (const FeatureCurve& curve : this->Features.Curves)
  {
    if (curve.FirstCorner >= 0)
    {
      directions[curve.FirstCorner].push_back(this->Direction(curve.Points, false));
    }
    if (curve.LastCorner >= 0)
    {
      directions[curve.LastCorner].push_back(this->Direction(curve.Points, true));
    }
  }
  for (std::size_t c = 0; c < directions.size(); ++c)
  {
    const std::vector<Vec3>& ends = directions[c];
    CornerFlaw flaw = CornerFlaw::None;
    for (std::size_t i = 0; i < ends.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        const bool acute = AngleAt(ends[i], Vec3::Zero(), ends[j]) < MinimumAngleOfCurves;
        flaw = acute ? CornerFlaw::AcuteCurves : flaw;
      }
      if (i >= MaximumCurvesAtCorner)
      {
        flaw = CornerFlaw::ManyCurves;
        break;
      }
    }
    if (flaw == CornerFlaw::None)
    {
      continue;
    }
    this->Report.Flawed.push_back(static_cast<Index>(c));
    ++(flaw == CornerFlaw::ManyCurves ? this->Report.NumberOfManyCurveCorners
                                      : this->Report.NumberOfAcuteCorners);
    if (!this->Options.EnforceAll)
    {
      this->Features.Corners[c].Flaw = flaw;
    }
  }
}
} // namespace

double AngleAt(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 u = a - b, v = c - b;
  return std::atan2(u.cross(v).norm(), u.dot(v)) * DegreesPerRadian;
}

Status BuildSurfaceFeatures(const SurfaceMesh& surface, const std::vector<PointPair>& edges,
  const std::vector<Index>& corners, const FeatureGraphOptions& options, SurfaceFeatures& features,
  FeatureGraphReport& report)
{
  features = SurfaceFeatures();
  report = FeatureGraphReport();
  Builder builder(surface, options, features, report);
  Status status = builder.CheckIds(edges, corners);
  if (status.Ok())
  {
    status = builder.CollectEdges(edges);
  }
  if (status.Ok())
  {
    builder.FindCorners(corners);
    builder.FindPatches();
    builder.TraceCurves();
    builder.FindFlaws();
  }
  return status;
}

Status MapFeatures(
  const std::vector<Index>& pointMap, std::vector<PointPair>& edges, std::vector<Index>& corners)
{
  const auto map = [&](Index& id, const char* what, std::size_t position)
  {
    const bool inside = id >= 0 && id < static_cast<Index>(pointMap.size());
    if (inside && pointMap[id] >= 0)
    {
      id = pointMap[id];
      return Status();
    }
    return Status(StatusCode::IndexOutOfRange,
      std::string("Feature ") + what + " " + std::to_string(position) + " refers to point " +
        std::to_string(id) +
        (inside ? ", which no triangle uses."
                : " of a surface with " + CountText(pointMap.size(), "point", "points") + ".") +
        " Use the features of this very surface, point ids starting at 0.");
  };
  Status status;
  for (std::size_t i = 0; i < 2 * edges.size() && status.Ok(); ++i)
  {
    status = map(edges[i / 2][i % 2], "edge", i / 2);
  }
  for (std::size_t i = 0; i < corners.size() && status.Ok(); ++i)
  {
    status = map(corners[i], "corner", i);
  }
  edges.erase(std::remove_if(edges.begin(), edges.end(),
                [](const PointPair& edge) { return edge[0] == edge[1]; }),
    edges.end());
  return status;
}

std::vector<PointPair> FeatureEdges(const SurfaceFeatures& features)
{
  std::vector<PointPair> edges;
  for (const FeatureCurve& curve : features.Curves)
  {
    for (std::size_t i = 1; i < curve.Points.size(); ++i)
    {
      edges.push_back({ curve.Points[i - 1], curve.Points[i] });
    }
  }
  return edges;
}

std::vector<Index> CornersOfPoints(const SurfaceFeatures& features, std::size_t numberOfPoints)
{
  std::vector<Index> corners(numberOfPoints, -1);
  for (std::size_t c = 0; c < features.Corners.size(); ++c)
  {
    corners[features.Corners[c].Point] = static_cast<Index>(c);
  }
  return corners;
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause

#include "CertifiedDistance.h"

#include "DistancePieces.h"
#include "Parallel.h"
#include "SubMonitor.h"

#include <cmath>
#include <functional>
#include <numeric>

namespace featurehex
{
namespace
{
/// Rounding of coordinates and distances, fraction of the surface's diagonal.
constexpr double Rounding = 1e-12;

/// Bounds of the value end up this close, fraction of the tolerance.
constexpr double ValueGap = 0.01;

/// Error of the triangles that stand for patches, fractions of the tolerance.
constexpr double DecisionSplitError = 0.01;
constexpr double CoarseSplitError = 0.02;
constexpr double FineSplitError = 0.0025;

/// More triangles than this are not made of the patches; their error grows instead.
constexpr double MaximumTargetTriangles = 1.5e6;

/// Pieces of all elements together; a measure of the longest possible time (about 2 us each).
constexpr std::int64_t TotalBudget = 60000000;

/// Large triangles are cut until there are about so many elements, for parallelism and for the
/// mean.
constexpr double LeastElements = 20000;

/// Elements of one side with what is known about them.
struct Elements
{
  std::vector<Vec3> Points;
  std::vector<TrianglePoint> Nearest;      ///< of Points in the target
  std::vector<std::array<Index, 4>> Corner; ///< of each element, in Points; triangles end with -1
  std::vector<Index> Owner;                ///< quad or triangle of the caller
  std::vector<double> Area;
  std::vector<double> MeanDistance;
  std::vector<ElementDistance> Result;
  std::vector<char> Exhausted; ///< ended at its budget

  std::size_t Size() const { return this->Corner.size(); }
  int Count(std::size_t e) const { return this->Corner[e][3] < 0 ? 3 : 4; }
};

/// body(begin, end) over blocks of at most @a block items, in some 20 batches so that the monitor
/// is asked in between. False: stopped.
bool ParallelBlocks(std::size_t count, std::size_t block, double from, double to, Monitor& monitor,
  const std::function<void(std::size_t, std::size_t)>& body)
{
  const std::size_t blocks = (count + block - 1) / block;
  const std::size_t batch = std::max<std::size_t>(8, (blocks + 19) / 20);
  for (std::size_t b = 0; b < blocks; b += batch)
  {
    if (!monitor.Update(from + (to - from) * static_cast<double>(b) / static_cast<double>(blocks)))
    {
      return false;
    }
    ParallelFor(std::min(batch, blocks - b), 1, [&](std::size_t i) {
      body((b + i) * block, std::min(count, (b + i + 1) * block));
    });
  }
  return monitor.Update(to);
}

Vec3 Bilinear(const Vec3* c, double u, double v)
{
  return (1 - v) * ((1 - u) * c[0] + u * c[1]) + v * ((1 - u) * c[3] + u * c[2]);
}

/// Quads with the points they use, recentred; false when a point is not finite.
bool QuadElements(const std::vector<Vec3>& points, const std::vector<Quad>& quads,
  const Vec3& center, Elements& elements)
{
  std::vector<Index> local(points.size(), -1);
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    Quad corners;
    for (int k = 0; k < 4; ++k)
    {
      const Index v = quads[q][k];
      if (local[v] < 0)
      {
        local[v] = static_cast<Index>(elements.Points.size());
        elements.Points.push_back(points[v] - center);
        if (!elements.Points.back().allFinite())
        {
          return false;
        }
      }
      corners[k] = local[v];
    }
    const std::vector<Vec3>& p = elements.Points;
    elements.Corner.push_back(corners);
    elements.Owner.push_back(static_cast<Index>(q));
    elements.Area.push_back(
      0.5 * (p[corners[2]] - p[corners[0]]).cross(p[corners[3]] - p[corners[1]]).norm());
  }
  return true;
}

/// The surface's triangles, large ones as n x n.
Elements TriangleElements(const TriangleSearch& search)
{
  Elements elements;
  std::vector<Index> local(search.Points().size(), -1); // only points in use may count
  const auto pointOf = [&](Index v) {
    if (local[v] < 0)
    {
      local[v] = static_cast<Index>(elements.Points.size());
      elements.Points.push_back(search.Points()[v]);
    }
    return local[v];
  };
  const std::vector<Triangle>& triangles = search.Triangles();
  const auto area = [&](const Triangle& t) {
    const Vec3& a = search.Points()[t[0]];
    return 0.5 * (search.Points()[t[1]] - a).cross(search.Points()[t[2]] - a).norm();
  };
  double total = 0.0;
  for (const Triangle& t : triangles)
  {
    total += area(t);
  }
  for (std::size_t i = 0; i < triangles.size(); ++i)
  {
    const Triangle& t = triangles[i];
    const double whole = area(t);
    const double share = total > 0.0 ? whole / total * LeastElements : 0.0;
    const int n = static_cast<int>(std::clamp(std::ceil(std::sqrt(share)), 1.0, 150.0));
    const auto add = [&](Index a, Index b, Index c) {
      elements.Corner.push_back({ a, b, c, -1 });
      elements.Owner.push_back(static_cast<Index>(i));
      elements.Area.push_back(whole / (static_cast<double>(n) * n));
    };
    if (n == 1)
    {
      add(pointOf(t[0]), pointOf(t[1]), pointOf(t[2]));
      continue;
    }
    // Rows of points parallel to the edge 1-2; row r has r + 1 points and starts at r (r + 1) / 2.
    const auto first = static_cast<Index>(elements.Points.size());
    const Vec3& a = search.Points()[t[0]];
    const Vec3 &b = search.Points()[t[1]], &c = search.Points()[t[2]];
    for (int r = 0; r <= n; ++r)
    {
      for (int s = 0; s <= r; ++s)
      {
        elements.Points.push_back(a + (r - s) * ((b - a) / n) + s * ((c - a) / n));
      }
    }
    for (int r = 0; r < n; ++r)
    {
      const Index row = first + r * (r + 1) / 2, next = row + r + 1;
      for (int s = 0; s <= r; ++s)
      {
        add(row + s, next + s, next + s + 1);
        if (s < r)
        {
          add(row + s, next + s + 1, row + s + 1);
        }
      }
    }
  }
  return elements;
}

/// Nearest triangle of every point.
bool SearchPoints(
  const DistanceTarget& target, Elements& elements, double from, double to, Monitor& monitor)
{
  elements.Nearest.resize(elements.Points.size());
  return ParallelBlocks(elements.Points.size(), 64, from, to, monitor,
    [&](std::size_t begin, std::size_t end) {
      Index hint = -1;
      for (std::size_t i = begin; i < end; ++i)
      {
        elements.Nearest[i] = target.Search->Closest(elements.Points[i], hint);
        hint = elements.Nearest[i].Triangle;
      }
    });
}

/// Samples inside the elements: mean distances, and good lower bounds from the start.
bool SampleElements(
  const DistanceTarget& target, Elements& elements, double from, double to, Monitor& monitor)
{
  elements.MeanDistance.resize(elements.Size());
  return ParallelBlocks(
    elements.Size(), 64, from, to, monitor, [&](std::size_t begin, std::size_t end) {
      for (std::size_t e = begin; e < end; ++e)
      {
        const std::array<Index, 4>& corner = elements.Corner[e];
        Vec3 p[4] = {};
        for (int k = 0; k < elements.Count(e); ++k)
        {
          p[k] = elements.Points[corner[k]];
        }
        constexpr int n = 4;
        const bool quad = elements.Count(e) == 4;
        const int count = quad ? n * n : 3;
        double sum = 0.0;
        for (int i = 0; i < count; ++i)
        {
          // Triangles: the three points of the rule that is exact for quadratic functions.
          const Vec3 x = quad ? Bilinear(p, (i % n + 0.5) / n, (i / n + 0.5) / n)
                              : Vec3((p[0] + p[1] + p[2]) / 6.0 + 0.5 * p[i]);
          const double d =
            target.Search->Closest(x, elements.Nearest[corner[i % 3]].Triangle).Distance;
          elements.Result[e].Found(x, d, target);
          sum += d;
        }
        elements.MeanDistance[e] = sum / count;
      }
    });
}

DistancePiece RootPiece(const Elements& elements, std::size_t e)
{
  DistancePiece piece;
  piece.Count = elements.Count(e);
  for (int k = 0; k < piece.Count; ++k)
  {
    const Index v = elements.Corner[e][k];
    piece.Corner[k] = elements.Points[v];
    piece.Near[k] = elements.Nearest[v].Triangle;
    piece.Distance[k] = elements.Nearest[v].Distance;
    piece.Exact[k] = true;
  }
  return piece;
}

/// Bounds of the elements @a ids.
bool BoundSome(const DistanceTarget& target, Elements& elements,
  const std::vector<std::size_t>& ids, const DistanceGoal& goal, Monitor& monitor)
{
  return ParallelBlocks(
    ids.size(), 16, 0.0, 1.0, monitor, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        const std::size_t e = ids[i];
        ElementDistance& result = elements.Result[e];
        const std::int64_t before = result.Pieces;
        result.Pieces = 0;
        BoundElement(target, RootPiece(elements, e), goal, result);
        elements.Exhausted[e] = result.Pieces >= goal.Budget;
        result.Pieces += before;
      }
    });
}

std::int64_t BudgetOf(std::int64_t pieces, std::size_t elements)
{
  const auto count = static_cast<std::int64_t>(std::max<std::size_t>(1, elements));
  return std::clamp<std::int64_t>(pieces / count, 1000, 1000000);
}

/// Most elements need few pieces. When a value is wanted, those that need more, where a large
/// triangle lies on a fine part of the mesh, start again with what the others left.
bool BoundAll(
  const DistanceTarget& target, Elements& elements, DistanceGoal goal, Monitor& monitor)
{
  std::vector<std::size_t> ids(elements.Size());
  std::iota(ids.begin(), ids.end(), std::size_t(0));
  elements.Exhausted.assign(elements.Size(), 0);
  goal.Budget = BudgetOf(TotalBudget, ids.size());
  SubMonitor first(monitor, 0.4, goal.Decide ? 1.0 : 0.8);
  if (!BoundSome(target, elements, ids, goal, first) || goal.Decide)
  {
    return !first.Stopped();
  }
  std::int64_t used = 0;
  ids.clear();
  for (std::size_t e = 0; e < elements.Size(); ++e)
  {
    used += elements.Result[e].Pieces;
    if (elements.Exhausted[e])
    {
      ids.push_back(e);
    }
  }
  const std::int64_t more = BudgetOf(TotalBudget - used, ids.size());
  if (more <= goal.Budget)
  {
    return true;
  }
  goal.Budget = more;
  SubMonitor second(monitor, 0.8, 1.0);
  return BoundSome(target, elements, ids, goal, second);
}

/// Decides for every element whether it is within goal.Accept.
bool DecideElements(
  const DistanceTarget& target, Elements& elements, DistanceGoal goal, Monitor& monitor)
{
  goal.Decide = true;
  goal.GiveUp = goal.Accept;
  elements.Result.assign(elements.Size(), {});
  return SearchPoints(target, elements, 0.0, 0.4, monitor) &&
    BoundAll(target, elements, goal, monitor);
}

/// Samples, then bounds of the greatest distance of all elements, or of @a known where that is
/// greater. With @a coarse the elements that come near it are left alone: their Upper is large.
bool BoundElements(const DistanceTarget& target, Elements& elements, DistanceGoal goal, bool coarse,
  double known, Monitor& monitor)
{
  elements.Result.assign(elements.Size(), {});
  if (!SearchPoints(target, elements, 0.0, 0.2, monitor) ||
    !SampleElements(target, elements, 0.2, 0.4, monitor))
  {
    return false;
  }
  double lower = known;
  for (const ElementDistance& r : elements.Result)
  {
    lower = std::max(lower, r.Lower);
  }
  for (const TrianglePoint& q : elements.Nearest)
  {
    lower = std::max(lower, q.Distance - target.LargestSlack);
  }
  goal.Gap = std::max(goal.Gap, ValueGap * lower);
  goal.Accept = lower + goal.Gap;
  goal.Decide = coarse;
  // Lower has the slack subtracted, a bound has it added.
  goal.GiveUp = goal.Accept - 2.0 * target.LargestSlack;
  return BoundAll(target, elements, goal, monitor);
}

/// The elements whose bound is greater than @a accept, without results; their ids in @a ids.
Elements Remaining(const Elements& all, double accept, std::vector<std::size_t>& ids)
{
  Elements some;
  for (std::size_t e = 0; e < all.Size(); ++e)
  {
    if (all.Result[e].Upper > accept)
    {
      ids.push_back(e);
      const auto first = static_cast<Index>(some.Points.size());
      std::array<Index, 4> corner = all.Corner[e];
      for (int k = 0; k < all.Count(e); ++k)
      {
        some.Points.push_back(all.Points[corner[k]]);
        corner[k] = first + k;
      }
      some.Corner.push_back(corner);
      some.Owner.push_back(all.Owner[e]);
      some.Area.push_back(all.Area[e]);
    }
  }
  return some;
}

/// Elements that are not proven to be within @a tolerance: one point for each owner, the farthest.
std::vector<DistanceWitness> CollectWitnesses(
  const Elements& elements, double tolerance, bool unproven, const Vec3& center)
{
  std::vector<DistanceWitness> witnesses;
  for (std::size_t e = 0; e < elements.Size(); ++e)
  {
    const ElementDistance& r = elements.Result[e];
    if (r.Lower > tolerance || (unproven && r.Upper > tolerance))
    {
      const Vec3& place = r.Lower > tolerance ? r.Where : r.Unproven;
      const DistanceWitness w{ place + center, r.Lower, elements.Owner[e] };
      if (witnesses.empty() || witnesses.back().Element != w.Element)
      {
        witnesses.push_back(w);
      }
      else if (w.Distance > witnesses.back().Distance)
      {
        witnesses.back() = w;
      }
    }
  }
  return witnesses;
}

DirectedDistance Summarize(const Elements& elements, double gap, const Vec3& center)
{
  DirectedDistance d;
  double area = 0.0, sum = 0.0;
  d.Upper = 0.0;
  for (std::size_t e = 0; e < elements.Size(); ++e)
  {
    const ElementDistance& r = elements.Result[e];
    d.Upper = std::max(d.Upper, r.Upper);
    if (r.Lower > d.Lower)
    {
      d.Lower = r.Lower;
      d.Where = r.Where + center;
    }
    d.Pieces += r.Pieces;
    area += elements.Area[e];
    sum += elements.Area[e] * elements.MeanDistance[e];
  }
  d.Mean = area > 0.0 ? sum / area : 0.0;
  d.Converged = d.Upper <= d.Lower + std::max(gap, ValueGap * d.Lower);
  return d;
}

/// Triangles that stand for the quads in searches.
struct QuadTarget
{
  TriangleSearch Search;
  DistanceTarget Target;
};

/// Into how many cells a patch is cut; four triangles stand for each.
struct PatchSplit
{
  std::array<Vec3, 4> Corner;
  int N = 1, M = 1;
  double Error = 0.0; ///< of the triangles

  /// A patch is an affine map plus u v times its twist: the error is |twist| / (16 N M).
  PatchSplit(const Elements& quads, std::size_t q, double error)
  {
    for (int k = 0; k < 4; ++k)
    {
      this->Corner[k] = quads.Points[quads.Corner[q][k]];
    }
    this->Error = TriangleError(this->Corner.data(), 1.0 / 16.0);
    if (this->Error > error)
    {
      const Vec3 twist = this->Corner[0] - this->Corner[1] + this->Corner[2] - this->Corner[3];
      const double cells = twist.norm() / (16.0 * error);
      this->N = static_cast<int>(std::clamp(std::ceil(std::sqrt(cells)), 1.0, 64.0));
      this->M = static_cast<int>(std::clamp(std::ceil(cells / this->N), 1.0, 64.0));
      this->Error = std::min(this->Error, twist.norm() / (16.0 * this->N * this->M));
    }
  }
};

void BuildTarget(const Elements& quads, double error, QuadTarget& result)
{
  for (double triangles = 1e300; triangles > MaximumTargetTriangles; error *= 2.0)
  {
    triangles = 0.0;
    for (std::size_t q = 0; q < quads.Size(); ++q)
    {
      const PatchSplit split(quads, q, error);
      triangles += 4.0 * (split.N * split.M - 1);
    }
    if (triangles <= MaximumTargetTriangles)
    {
      break;
    }
  }
  // Where the points and triangles of each patch begin.
  std::vector<Index> firstPoint(quads.Size() + 1, 0);
  std::vector<Index> firstTriangle(quads.Size() + 1, 0);
  for (std::size_t q = 0; q < quads.Size(); ++q)
  {
    const PatchSplit split(quads, q, error);
    firstPoint[q + 1] = firstPoint[q] + (split.N + 1) * (split.M + 1) + split.N * split.M;
    firstTriangle[q + 1] = firstTriangle[q] + 4 * split.N * split.M;
    result.Target.LargestSlack = std::max(result.Target.LargestSlack, split.Error);
  }
  std::vector<Vec3> points(firstPoint.back());
  std::vector<Triangle> triangles(firstTriangle.back());
  std::vector<double>& slack = result.Target.Slack;
  slack.resize(triangles.size());
  ParallelFor(quads.Size(), 256, [&](std::size_t q) {
    const PatchSplit split(quads, q, error);
    const int n = split.N;
    const int m = split.M;
    const Vec3* p = split.Corner.data();
    const Index base = firstPoint[q];
    for (int j = 0; j <= m; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        points[base + j * (n + 1) + i] =
          Bilinear(p, static_cast<double>(i) / n, static_cast<double>(j) / m);
      }
    }
    const auto at = [&](int i, int j) { return base + j * (n + 1) + i; };
    Index middle = at(0, m + 1);
    Index triangle = firstTriangle[q];
    for (int j = 0; j < m; ++j)
    {
      for (int i = 0; i < n; ++i, ++middle)
      {
        points[middle] = Bilinear(p, (i + 0.5) / n, (j + 0.5) / m);
        const Index ring[4] = { at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) };
        for (int k = 0; k < 4; ++k, ++triangle)
        {
          triangles[triangle] = { ring[k], ring[(k + 1) % 4], middle };
          slack[triangle] = split.Error;
        }
      }
    }
  });
  result.Search = TriangleSearch(std::move(points), std::move(triangles), SearchBuild::Quick);
  result.Target.Search = &result.Search;
}

std::vector<Vec3> Recentred(const SurfaceMesh& surface, const Vec3& center)
{
  std::vector<Vec3> points = surface.Points;
  for (Vec3& p : points)
  {
    p -= center;
  }
  return points;
}
}

CertifiedDistance::CertifiedDistance(const SurfaceMesh& surface)
{
  const Box box = BoundingBox(surface);
  if (!box.Empty())
  {
    this->Center = box.Center();
    this->SurfaceDiagonal = box.Diagonal();
    this->Search = TriangleSearch(Recentred(surface, this->Center), surface.Triangles);
  }
}

DistanceDecision CertifiedDistance::DistanceWithin(const std::vector<Vec3>& points,
  const std::vector<Quad>& quads, double tolerance, Monitor& monitor) const
{
  DistanceDecision decision;
  Elements patches;
  if (quads.empty() || this->Search.Triangles().empty() ||
    !QuadElements(points, quads, this->Center, patches))
  {
    return decision;
  }
  DistanceGoal goal;
  goal.Accept = tolerance - Rounding * this->SurfaceDiagonal;
  goal.Flat = DecisionSplitError * tolerance;
  goal.Tiny = 0.001 * tolerance;

  DistanceTarget surface;
  surface.Search = &this->Search;
  SubMonitor first(monitor, 0.0, 0.5);
  if (!DecideElements(surface, patches, goal, first))
  {
    return decision;
  }
  decision.Quads = CollectWitnesses(patches, goal.Accept, true, this->Center);

  QuadTarget mesh;
  BuildTarget(patches, DecisionSplitError * tolerance, mesh);
  Elements triangles = TriangleElements(this->Search);
  SubMonitor second(monitor, 0.5, 1.0);
  if (!DecideElements(mesh.Target, triangles, goal, second))
  {
    return decision;
  }
  decision.Triangles = CollectWitnesses(triangles, goal.Accept, true, this->Center);
  decision.Within = decision.Quads.empty() && decision.Triangles.empty();
  return decision;
}

DistanceBounds CertifiedDistance::Measure(const std::vector<Vec3>& points,
  const std::vector<Quad>& quads, double tolerance, Monitor& monitor) const
{
  DistanceBounds bounds;
  Elements patches;
  bounds.Deviation.assign(quads.size(), 1e300);
  bounds.DeviationFound.assign(quads.size(), 0.0);
  if (quads.empty() || this->Search.Triangles().empty() ||
    !QuadElements(points, quads, this->Center, patches))
  {
    return bounds;
  }
  const double rounding = Rounding * this->SurfaceDiagonal;
  DistanceGoal goal;
  goal.Gap = std::max(ValueGap * tolerance, rounding);
  goal.Flat = 0.1 * goal.Gap;
  goal.Tiny = 0.02 * goal.Gap;

  DistanceTarget surface;
  surface.Search = &this->Search;
  SubMonitor first(monitor, 0.0, 0.5);
  if (!BoundElements(surface, patches, goal, false, 0.0, first))
  {
    return bounds;
  }
  bounds.MeshToSurface = Summarize(patches, goal.Gap, this->Center);
  bounds.MeshToSurface.Upper += rounding;
  bounds.MeshToSurface.Witnesses = CollectWitnesses(patches, tolerance, false, this->Center);
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    bounds.Deviation[q] = patches.Result[q].Upper + rounding;
    bounds.DeviationFound[q] = patches.Result[q].Lower;
  }

  // A coarse split settles most of the surface; the rest is measured to a fine one.
  Elements triangles = TriangleElements(this->Search);
  SubMonitor second(monitor, 0.5, 0.8);
  {
    QuadTarget coarse;
    BuildTarget(patches, CoarseSplitError * tolerance, coarse);
    if (!second.Ask() || !BoundElements(coarse.Target, triangles, goal, true, 0.0, second))
    {
      return bounds;
    }
    bounds.SplitError = coarse.Target.LargestSlack;
  }
  double lower = 0.0;
  for (const ElementDistance& r : triangles.Result)
  {
    lower = std::max(lower, r.Lower);
  }
  std::vector<std::size_t> ids;
  Elements rest = Remaining(triangles, lower + std::max(goal.Gap, ValueGap * lower), ids);
  SubMonitor third(monitor, 0.8, 1.0);
  if (!ids.empty())
  {
    if (!third.Ask())
    {
      return bounds;
    }
    QuadTarget fine;
    BuildTarget(patches, FineSplitError * tolerance, fine);
    bounds.SplitError = fine.Target.LargestSlack;
    goal.Gap = std::max(goal.Gap, 0.5 * goal.Gap + 2.0 * bounds.SplitError);
    if (!BoundElements(fine.Target, rest, goal, false, lower, third))
    {
      return bounds;
    }
  }
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    triangles.Result[ids[i]].Merge(rest.Result[i]);
    triangles.MeanDistance[ids[i]] = rest.MeanDistance[i];
  }
  bounds.SurfaceToMesh = Summarize(triangles, goal.Gap, this->Center);
  bounds.SurfaceToMesh.Upper += rounding;
  bounds.SurfaceToMesh.Witnesses = CollectWitnesses(triangles, tolerance, false, this->Center);
  return bounds;
}
}

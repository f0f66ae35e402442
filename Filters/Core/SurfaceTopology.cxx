// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceTopology.h"

#include "ExactPredicates.h"

#include <algorithm>
#include <numeric>
#include <set>

namespace featurehex
{
EdgeTable::EdgeTable(const std::vector<Triangle>& triangles)
{
  this->Sides.resize(3 * triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const std::size_t side = 3 * t + k;
      this->Sides[side] = { EdgeKey(triangles[t][k], triangles[t][(k + 1) % 3]),
        static_cast<std::uint32_t>(side) };
    }
  }
  std::sort(this->Sides.begin(), this->Sides.end(),
    [](const EdgeUse& a, const EdgeUse& b)
    { return a.Edge != b.Edge ? a.Edge < b.Edge : a.Side < b.Side; });
}

std::size_t EdgeTable::NumberOfFaces(Index u, Index v) const
{
  const EdgeUse key = { EdgeKey(u, v), 0 };
  const auto range = std::equal_range(this->Sides.begin(), this->Sides.end(), key,
    [](const EdgeUse& a, const EdgeUse& b) { return a.Edge < b.Edge; });
  return range.second - range.first;
}

std::vector<Index> FirstDuplicates(const std::vector<Triangle>& triangles)
{
  std::vector<std::pair<Triangle, Index>> sorted(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    sorted[t] = { triangles[t], static_cast<Index>(t) };
    std::sort(sorted[t].first.begin(), sorted[t].first.end());
  }
  std::sort(sorted.begin(), sorted.end());
  std::vector<Index> first(triangles.size());
  for (std::size_t i = 0; i < sorted.size(); ++i)
  {
    const bool same = i > 0 && sorted[i].first == sorted[i - 1].first;
    first[sorted[i].second] = same ? first[sorted[i - 1].second] : sorted[i].second;
  }
  return first;
}

std::vector<Index> OppositeSides(const EdgeTable& edges)
{
  std::vector<Index> opposite(edges.Uses().size(), -1);
  edges.VisitEdges(
    [&opposite](const EdgeUse* first, const EdgeUse* last)
    {
      if (last - first == 2)
      {
        opposite[first[0].Side] = static_cast<Index>(first[1].Side);
        opposite[first[1].Side] = static_cast<Index>(first[0].Side);
      }
    });
  return opposite;
}

std::vector<Index> CountFans(const std::vector<Triangle>& triangles,
  const std::vector<Index>& opposite, std::size_t numberOfPoints)
{
  std::vector<Index> fans(numberOfPoints, 0);
  std::vector<char> visited(3 * triangles.size(), 0);
  for (std::size_t start = 0; start < visited.size(); ++start)
  {
    if (visited[start])
    {
      continue;
    }
    const Index point = triangles[start / 3][start % 3];
    ++fans[point];
    // Leave each triangle through the side at the point through which we didn't come.
    std::size_t corner = start;
    std::size_t exit = start;
    do
    {
      visited[corner] = 1;
      const std::size_t entry = opposite[exit];
      const std::size_t base = entry - entry % 3;
      const Triangle& t = triangles[entry / 3];
      const std::size_t k = t[0] == point ? 0 : (t[1] == point ? 1 : 2);
      corner = base + k;
      exit = entry == corner ? base + (k + 2) % 3 : corner;
    } while (corner != start);
  }
  return fans;
}

namespace
{
class CollinearFlipper
{
public:
  CollinearFlipper(
    const std::vector<Vec3>& points, std::vector<Triangle>& triangles, std::vector<Index>& opposite)
    : Points(points)
    , Triangles(triangles)
    , Opposite(opposite)
  {
  }

  CollinearFlips Run()
  {
    CollinearFlips result;
    for (std::size_t t = 0; t < this->Triangles.size(); ++t)
    {
      if (this->IsCollinear(static_cast<Index>(t)))
      {
        result.Remaining.push_back(static_cast<Index>(t));
      }
    }
    if (result.Remaining.empty())
    {
      return result;
    }
    for (const Triangle& t : this->Triangles)
    {
      for (int k = 0; k < 3; ++k)
      {
        this->Edges.insert(EdgeKey(t[k], t[(k + 1) % 3]));
      }
    }
    // A collinear triangle waits for a collinear neighbour with a longer longest edge. Each flip
    // lowers the number of collinear triangles, or the sum of their longest edges: it ends.
    for (bool progress = true; progress && !result.Remaining.empty();)
    {
      progress = false;
      std::set<Index> next;
      for (Index t : result.Remaining)
      {
        if (!this->IsCollinear(t))
        {
          continue;
        }
        const Index neighbor = this->Flip(t);
        if (neighbor < 0)
        {
          next.insert(t);
          continue;
        }
        ++result.NumberOfFlips;
        progress = true;
        for (Index changed : { t, neighbor })
        {
          if (this->IsCollinear(changed))
          {
            next.insert(changed);
          }
        }
      }
      result.Remaining.assign(next.begin(), next.end());
    }
    return result;
  }

private:
  bool IsCollinear(Index t) const
  {
    const Triangle& v = this->Triangles[t];
    return Collinear(this->Points[v[0]], this->Points[v[1]], this->Points[v[2]]);
  }

  /// Side opposite to the corner that lies between the others. Along a line every coordinate that
  /// isn't constant is strictly monotone.
  int LongestSide(Index t) const
  {
    const Triangle& v = this->Triangles[t];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double x[3] = { this->Points[v[0]][axis], this->Points[v[1]][axis],
        this->Points[v[2]][axis] };
      for (int k = 0; k < 3; ++k)
      {
        const double middle = x[(k + 2) % 3];
        if (std::min(x[k], x[(k + 1) % 3]) < middle && middle < std::max(x[k], x[(k + 1) % 3]))
        {
          return k;
        }
      }
    }
    return 0;
  }

  Index SideOf(Index t, Index u, Index v) const
  {
    const Triangle& corners = this->Triangles[t];
    for (int k = 0; k < 3; ++k)
    {
      if (EdgeKey(corners[k], corners[(k + 1) % 3]) == EdgeKey(u, v))
      {
        return 3 * t + k;
      }
    }
    return -1;
  }

  void Link(Index side, Index other)
  {
    this->Opposite[side] = other;
    this->Opposite[other] = side;
  }

  /// Replaces the edge p q between t = (p q b) and its neighbour n = (p q d) by b d. Returns n, or
  /// -1 when this can't be done (now).
  Index Flip(Index t)
  {
    const int longest = this->LongestSide(t);
    const Index p = this->Triangles[t][longest];
    const Index q = this->Triangles[t][(longest + 1) % 3];
    const Index b = this->Triangles[t][(longest + 2) % 3];
    const Index across = this->Opposite[3 * t + longest];
    const Index n = across / 3;
    const Index d = this->Triangles[n][(across + 2 - 3 * n) % 3];
    if (d == b || this->Edges.count(EdgeKey(b, d)) > 0 ||
        (this->IsCollinear(n) && 3 * n + this->LongestSide(n) != across))
    {
      return -1;
    }
    const Index pb = this->Opposite[this->SideOf(t, p, b)];
    const Index qb = this->Opposite[this->SideOf(t, q, b)];
    const Index pd = this->Opposite[this->SideOf(n, p, d)];
    const Index qd = this->Opposite[this->SideOf(n, q, d)];
    this->Triangles[t] = this->Triangles[n];
    std::replace(this->Triangles[t].begin(), this->Triangles[t].end(), p, b);
    std::replace(this->Triangles[n].begin(), this->Triangles[n].end(), q, b);
    this->Link(this->SideOf(n, p, b), pb);
    this->Link(this->SideOf(t, q, b), qb);
    this->Link(this->SideOf(n, p, d), pd);
    this->Link(this->SideOf(t, q, d), qd);
    this->Link(this->SideOf(n, b, d), this->SideOf(t, b, d));
    this->Edges.erase(EdgeKey(p, q));
    this->Edges.insert(EdgeKey(b, d));
    return n;
  }

  const std::vector<Vec3>& Points;
  std::vector<Triangle>& Triangles;
  std::vector<Index>& Opposite;
  std::set<std::uint64_t> Edges;
};

/// Sign of the turn a, b, p in y and z for the point p moved by (e, e * e), e infinitesimal: zero
/// only when a and b have the same projection.
int PerturbedTurn(const Vec3& a, const Vec3& b, const Vec3& p)
{
  const int turn = Orient2D(a, b, p, 1, 2);
  if (turn != 0)
  {
    return turn;
  }
  if (a[2] != b[2])
  {
    return a[2] < b[2] ? -1 : 1;
  }
  return a[1] == b[1] ? 0 : (a[1] < b[1] ? 1 : -1);
}
} // namespace

CollinearFlips FlipCollinearTriangles(
  const std::vector<Vec3>& points, std::vector<Triangle>& triangles, std::vector<Index>& opposite)
{
  return CollinearFlipper(points, triangles, opposite).Run();
}

bool RayCrosses(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const int ab = PerturbedTurn(a, b, p);
  if (ab == 0 || PerturbedTurn(b, c, p) != ab || PerturbedTurn(c, a, p) != ab)
  {
    return false;
  }
  // Seen counter-clockwise in y and z, the normal points to larger x: p is left of the plane when
  // it is on the other side of it.
  return Orient3D(a, b, c, p) * ab < 0;
}
} // namespace featurehex

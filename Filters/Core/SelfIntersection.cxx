// SPDX-License-Identifier: BSD-3-Clause
#include "SelfIntersection.h"

#include "BoxTree.h"
#include "ExactPredicates.h"
#include "Parallel.h"

#include <algorithm>

namespace featurehex
{
namespace
{
/// Closed segments p q and r s meet in the projection to coordinates i and j.
bool SegmentsMeet2D(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s, int i, int j)
{
  const int pqr = Orient2D(p, q, r, i, j);
  const int pqs = Orient2D(p, q, s, i, j);
  if (pqr * pqs > 0)
  {
    return false;
  }
  const int rsp = Orient2D(r, s, p, i, j);
  const int rsq = Orient2D(r, s, q, i, j);
  if (rsp * rsq > 0)
  {
    return false;
  }
  if (pqr == 0 && pqs == 0 && rsp == 0 && rsq == 0)
  {
    // On one line: compare the intervals.
    for (int k : { i, j })
    {
      if (std::max(p[k], q[k]) < std::min(r[k], s[k]) ||
          std::max(r[k], s[k]) < std::min(p[k], q[k]))
      {
        return false;
      }
    }
  }
  return true;
}

/// Closed segments meet in space. At least one of the projections of coplanar, not collinear points
/// is injective; a common point is common in all projections. So all three decide.
bool SegmentsMeet3D(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s)
{
  return Orient3D(p, q, r, s) == 0 && SegmentsMeet2D(p, q, r, s, 0, 1) &&
         SegmentsMeet2D(p, q, r, s, 1, 2) && SegmentsMeet2D(p, q, r, s, 2, 0);
}

struct Corners
{
  const Vec3& A;
  const Vec3& B;
  const Vec3& C;
};

/// The first pair of coordinates in which the triangle has area; false: zero area in space.
bool ProjectionWithArea(const Corners& t, int& i, int& j, int& sign)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    i = axis;
    j = (axis + 1) % 3;
    sign = Orient2D(t.A, t.B, t.C, i, j);
    if (sign != 0)
    {
      return true;
    }
  }
  return false;
}

/// Segment in the plane of the triangle.
bool CoplanarSegmentMeetsTriangle(const Vec3& p, const Vec3& q, const Corners& t)
{
  int i, j, sign;
  if (!ProjectionWithArea(t, i, j, sign))
  {
    return SegmentsMeet3D(p, q, t.A, t.B) || SegmentsMeet3D(p, q, t.B, t.C) ||
           SegmentsMeet3D(p, q, t.C, t.A);
  }
  const int ab = sign * Orient2D(t.A, t.B, p, i, j);
  const int bc = sign * Orient2D(t.B, t.C, p, i, j);
  const int ca = sign * Orient2D(t.C, t.A, p, i, j);
  return (ab >= 0 && bc >= 0 && ca >= 0) || SegmentsMeet2D(p, q, t.A, t.B, i, j) ||
         SegmentsMeet2D(p, q, t.B, t.C, i, j) || SegmentsMeet2D(p, q, t.C, t.A, i, j);
}

/// Closed segment and closed triangle meet. @a sideP, @a sideQ: sides of the plane of @a t.
bool SegmentMeetsTriangle(const Vec3& p, const Vec3& q, int sideP, int sideQ, const Corners& t)
{
  if (sideP * sideQ > 0)
  {
    return false;
  }
  if (sideP == 0 && sideQ == 0)
  {
    return CoplanarSegmentMeetsTriangle(p, q, t);
  }
  const int ab = Orient3D(p, q, t.A, t.B);
  const int bc = Orient3D(p, q, t.B, t.C);
  if (ab * bc < 0)
  {
    return false;
  }
  const int ca = Orient3D(p, q, t.C, t.A);
  return ab * ca >= 0 && bc * ca >= 0;
}

bool SegmentMeetsTriangle(const Vec3& p, const Vec3& q, const Corners& t)
{
  return SegmentMeetsTriangle(p, q, Orient3D(t.A, t.B, t.C, p), Orient3D(t.A, t.B, t.C, q), t);
}

/// No shared vertex. The ends of a common segment, and every component of a coplanar overlap, lie
/// on an edge of one of the two: six segment tests decide.
bool SeparateTrianglesMeet(const Corners& s, const Corners& t)
{
  const int sA = Orient3D(t.A, t.B, t.C, s.A);
  const int sB = Orient3D(t.A, t.B, t.C, s.B);
  const int sC = Orient3D(t.A, t.B, t.C, s.C);
  if (sA != 0 && sA == sB && sA == sC)
  {
    return false;
  }
  const int tA = Orient3D(s.A, s.B, s.C, t.A);
  const int tB = Orient3D(s.A, s.B, s.C, t.B);
  const int tC = Orient3D(s.A, s.B, s.C, t.C);
  if (tA != 0 && tA == tB && tA == tC)
  {
    return false;
  }
  return SegmentMeetsTriangle(s.A, s.B, sA, sB, t) || SegmentMeetsTriangle(s.B, s.C, sB, sC, t) ||
         SegmentMeetsTriangle(s.C, s.A, sC, sA, t) || SegmentMeetsTriangle(t.A, t.B, tA, tB, s) ||
         SegmentMeetsTriangle(t.B, t.C, tB, tC, s) || SegmentMeetsTriangle(t.C, t.A, tC, tA, s);
}

/// Both contain the edge of A and B; C is the other corner of each.
bool TrianglesAtEdgeOverlap(const Corners& s, const Vec3& other)
{
  if (Orient3D(s.A, s.B, s.C, other) != 0)
  {
    return false;
  }
  int i, j, sign;
  return !ProjectionWithArea(s, i, j, sign) || Orient2D(s.A, s.B, other, i, j) != -sign;
}

bool TrianglesMeet(const std::vector<Vec3>& points, const Triangle& s, const Triangle& t)
{
  int inS[3], inT[3];
  int shared = 0;
  for (int a = 0; a < 3; ++a)
  {
    for (int b = 0; b < 3; ++b)
    {
      if (s[a] == t[b] && shared < 3)
      {
        inS[shared] = a;
        inT[shared] = b;
        ++shared;
      }
    }
  }
  if (shared == 0)
  {
    return SeparateTrianglesMeet(
      { points[s[0]], points[s[1]], points[s[2]] }, { points[t[0]], points[t[1]], points[t[2]] });
  }
  if (shared == 1)
  {
    // The common part is convex and contains the shared vertex V. Going from V to another common
    // point and on, one leaves the first of the two triangles through its edge opposite to V.
    const Corners cs = { points[s[inS[0]]], points[s[(inS[0] + 1) % 3]],
      points[s[(inS[0] + 2) % 3]] };
    const Corners ct = { points[t[inT[0]]], points[t[(inT[0] + 1) % 3]],
      points[t[(inT[0] + 2) % 3]] };
    return SegmentMeetsTriangle(cs.B, cs.C, ct) || SegmentMeetsTriangle(ct.B, ct.C, cs);
  }
  if (shared == 2)
  {
    return TrianglesAtEdgeOverlap(
      { points[s[inS[0]]], points[s[inS[1]]], points[s[3 - inS[0] - inS[1]]] },
      points[t[3 - inT[0] - inT[1]]]);
  }
  return true;
}
} // namespace

std::vector<TrianglePair> FindSelfIntersections(const std::vector<Vec3>& points,
  const std::vector<Triangle>& triangles, std::size_t limit, Monitor* monitor)
{
  std::vector<TrianglePair> result;
  if (triangles.empty() || limit == 0)
  {
    return result;
  }
  const std::vector<Vec3> scaled = PointsForPredicates(points);
  const BoxTree tree(scaled, triangles);
  // Fixed chunks, so that stopping at the limit doesn't depend on the threads.
  constexpr std::size_t chunk = 2048;
  std::vector<std::vector<TrianglePair>> found(chunk);
  for (std::size_t begin = 0; begin < tree.NumberOfLeaves() && result.size() < limit;
       begin += chunk)
  {
    if (monitor && !monitor->Update(static_cast<double>(begin) / tree.NumberOfLeaves()))
    {
      break;
    }
    const std::size_t count = std::min(chunk, tree.NumberOfLeaves() - begin);
    ParallelFor(count, 64,
      [&](std::size_t k)
      {
        found[k].clear();
        tree.VisitPairs(begin + k,
          [&](Index a, Index b)
          {
            if (TrianglesMeet(scaled, triangles[a], triangles[b]))
            {
              found[k].push_back({ std::min(a, b), std::max(a, b) });
            }
            return found[k].size() < limit;
          });
      });
    for (std::size_t k = 0; k < count; ++k)
    {
      result.insert(result.end(), found[k].begin(), found[k].end());
    }
  }
  std::sort(result.begin(), result.end());
  if (result.size() > limit)
  {
    result.resize(limit);
  }
  return result;
}

Vec3 IntersectionPlace(
  const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, const TrianglePair& pair)
{
  const Box first = TriangleBox(points, triangles[pair.First]);
  const Box second = TriangleBox(points, triangles[pair.Second]);
  return 0.5 * first.Low.cwiseMax(second.Low) + 0.5 * first.High.cwiseMin(second.High);
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exact self-intersection test of triangle surfaces.

#ifndef featurehex_SelfIntersection_h
#define featurehex_SelfIntersection_h

#include "Monitor.h"
#include "Types.h"

#include <cstddef>

namespace featurehex
{
/// Two triangles, First < Second.
struct TrianglePair
{
  Index First = -1;
  Index Second = -1;

  bool operator==(const TrianglePair& other) const
  {
    return this->First == other.First && this->Second == other.Second;
  }
  bool operator<(const TrianglePair& other) const
  {
    return this->First != other.First ? this->First < other.First : this->Second < other.Second;
  }
};

/// Pairs of triangles that cross or touch beyond the vertices they share by id:
/// no shared vertex: any common point; one: anything beyond that vertex; two: coplanar overlap (a
/// fold by exactly 180 degrees); three: always. Points of equal coordinates and different ids are
/// a contact; merge them first where they are meant to be one.
///
/// Exact: the doubles are taken as they are, there is no tolerance (ExactPredicates.h).
/// A triangle of zero area counts as the segment it is, except that its contacts with triangles
/// that share vertices with it may be reported when they are only those vertices.
///
/// Ascending; at most @a limit pairs: when there are more, which ones are found depends on the
/// input only, never on the number of threads.
/// @a monitor, when given, sees progress; when it stops, the pairs found so far are returned: ask
/// its Stopped(). Parallel; n log n for surfaces without very long triangles.
/// Precondition: finite points, ids in range, no repeated id in a triangle.
std::vector<TrianglePair> FindSelfIntersections(const std::vector<Vec3>& points,
  const std::vector<Triangle>& triangles, std::size_t limit = 100, Monitor* monitor = nullptr);

/// A place to show for a pair: the middle of the overlap of the two bounding boxes.
Vec3 IntersectionPlace(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles,
  const TrianglePair& pair);
} // namespace featurehex

#endif

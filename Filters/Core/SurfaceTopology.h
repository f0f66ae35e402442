// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Edges, neighbours and fans of a triangle surface that may be broken in any way.

#ifndef featurehex_SurfaceTopology_h
#define featurehex_SurfaceTopology_h

#include "Types.h"

#include <cstddef>

namespace featurehex
{
/// One side of a triangle. Side 3 t + k of triangle t goes from its corner k to corner k + 1.
struct EdgeUse
{
  std::uint64_t Edge; ///< lower point id in the high 32 bits, higher one in the low 32 bits
  std::uint32_t Side;

  Index Low() const { return static_cast<Index>(this->Edge >> 32); }
  Index High() const { return static_cast<Index>(this->Edge & 0xffffffffU); }
  Index Triangle() const { return static_cast<Index>(this->Side / 3); }
};

/// Key of the undirected edge u v.
inline std::uint64_t EdgeKey(Index u, Index v)
{
  const std::uint64_t low = static_cast<std::uint32_t>(u < v ? u : v);
  const std::uint64_t high = static_cast<std::uint32_t>(u < v ? v : u);
  return low << 32 | high;
}

/// All sides of all triangles, sorted by edge, then by side.
/// Precondition: point ids are not negative, no triangle has a repeated id.
class EdgeTable
{
public:
  explicit EdgeTable(const std::vector<Triangle>& triangles);

  const std::vector<EdgeUse>& Uses() const { return this->Sides; }

  /// visit(first, last): the sides at one edge; edges ascending.
  template <typename Visitor>
  void VisitEdges(const Visitor& visit) const
  {
    const EdgeUse* const end = this->Sides.data() + this->Sides.size();
    for (const EdgeUse* first = this->Sides.data(); first != end;)
    {
      const EdgeUse* last = first;
      while (last != end && last->Edge == first->Edge)
      {
        ++last;
      }
      visit(first, last);
      first = last;
    }
  }

  std::size_t NumberOfFaces(Index u, Index v) const;

private:
  std::vector<EdgeUse> Sides;
};

/// For each triangle the lowest triangle id with the same three points, in any order.
std::vector<Index> FirstDuplicates(const std::vector<Triangle>& triangles);

/// For each side the other side at its edge, -1 where the edge has not exactly two faces.
std::vector<Index> OppositeSides(const EdgeTable& edges);

/// For each point the number of fans of triangles round it: 0 unused, 1 manifold.
/// Precondition: every side has an opposite one. Orientation may be inconsistent.
std::vector<Index> CountFans(const std::vector<Triangle>& triangles,
  const std::vector<Index>& opposite, std::size_t numberOfPoints);

/// Outcome of FlipCollinearTriangles().
struct CollinearFlips
{
  Index NumberOfFlips = 0;
  std::vector<Index> Remaining; ///< triangles with collinear corners that can't be flipped
};

/// Removes triangles with three distinct collinear corners: the longest edge, which contains the
/// third corner, is flipped, so that the neighbour is split there. The shape, the number of
/// triangles and the topology don't change; triangles keep the orientation of that neighbour.
/// Exact; @a points within the range of ExactPredicates.h.
/// Precondition: every side has an opposite one; both are kept up to date.
CollinearFlips FlipCollinearTriangles(
  const std::vector<Vec3>& points, std::vector<Triangle>& triangles, std::vector<Index>& opposite);

/// True when the ray from @a p to infinity along x crosses the triangle. With p moved
/// infinitesimally in y and z (simulation of simplicity), so that every ray crosses a closed
/// surface an odd number of times exactly when p is inside; p must not be on the surface. Exact;
/// points within the range of ExactPredicates.h.
bool RayCrosses(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);
} // namespace featurehex

#endif

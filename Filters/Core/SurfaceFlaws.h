// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Finds what keeps a triangle surface from being a closed manifold and says it in sentences: how
/// many, the first one with ids and coordinates, what to do.

#ifndef featurehex_SurfaceFlaws_h
#define featurehex_SurfaceFlaws_h

#include "SelfIntersection.h"
#include "Status.h"
#include "SurfaceTopology.h"

#include <string>

namespace featurehex
{
/// Coordinates beyond this, and surfaces smaller than its inverse, overflow or underflow when
/// distances and volumes are computed.
constexpr double LargestCoordinate = 1e100;

/// EmptySurface or IndexOutOfRange, else Ok.
Status CheckIndices(const SurfaceMesh& surface);

/// NonFinite, else Ok. Unused points count too.
Status CheckCoordinates(const SurfaceMesh& surface);

/// The surface as it is being checked: some input triangles were dropped.
struct CheckedSurface
{
  const std::vector<Vec3>& Points;
  const std::vector<Triangle>& Triangles;
  const std::vector<Index>& Source;  ///< input id of each triangle, for messages
  std::size_t MaximumNumberOfPlaces; ///< at most this many entries in Status::Where

  Vec3 Center(Index triangle) const;
  std::string Name(Index triangle) const { return std::to_string(this->Source[triangle]); }
  void AddPlace(std::vector<Vec3>& places, const Vec3& p) const;
};

/// Edges have two faces each, else: SelfIntersection where triangles with the same corners are at
/// an edge with more than two, NonManifold, OpenBoundary; in this order, because an inner face or
/// fin also has open edges.
/// @param twin of each triangle another one with the same three points, or -1
Status CheckEdges(
  const CheckedSurface& surface, const EdgeTable& edges, const std::vector<Index>& twin);

/// Every used point has one fan of triangles, else NonManifold.
/// Precondition: every side has an opposite one.
Status CheckFans(const CheckedSurface& surface, const std::vector<Index>& opposite);

/// SelfIntersection for @a pairs, which isn't empty. @a limited: there may be more.
Status DescribeIntersections(
  const CheckedSurface& surface, const std::vector<TrianglePair>& pairs, bool limited);
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Checks that a triangle soup bounds a body, repairs what can be repaired without guessing, and
/// says precisely what is wrong otherwise.

#ifndef featurehex_SurfaceCheck_h
#define featurehex_SurfaceCheck_h

#include "Monitor.h"
#include "Types.h"

#include <cstddef>
#include <string>

namespace featurehex
{
/// Of the check of a surface.
struct SurfaceCheckOptions
{
  /// At most this many places (Status::Where) of one error.
  std::size_t MaximumNumberOfPlaces = 100;
};

/// A connected closed piece of the surface.
struct SurfaceComponent
{
  bool Cavity = false; ///< bounds a hole in the material: oriented inwards
  Index Parent = -1;   ///< innermost component around it; -1: outermost
  Index Depth = 0;     ///< number of components around it: even solid, odd cavity
  Index Genus = 0;     ///< number of handles (tunnels)
  Index NumberOfTriangles = 0;
  double Volume = 0.0; ///< enclosed by this piece alone, positive, model units cubed
};

/// What was found and done. Complete when the Status is Ok; else as far as the check came.
struct SurfaceCheckReport
{
  Index NumberOfMergedPoints = 0;        ///< coincident with a point of lower id
  Index NumberOfUnusedPoints = 0;        ///< dropped
  Index NumberOfCollapsedTriangles = 0;  ///< dropped: two corners are the same point
  Index NumberOfDuplicateTriangles = 0;  ///< dropped: same corners as a triangle of lower id
  Index NumberOfFlippedEdges = 0;        ///< flips that removed triangles with collinear corners
  Index NumberOfReorientedTriangles = 0; ///< order of corners reversed

  std::vector<std::string> Warnings;        ///< a sentence for each kind of repair
  std::vector<SurfaceComponent> Components; ///< by lowest triangle id
  std::vector<Index> ComponentOfTriangle;   ///< of each triangle of the result

  std::vector<Index> Points;    ///< result id of each input point, -1: unused
  std::vector<Index> Triangles; ///< result id of each input triangle, -1: dropped

  double Diagonal = 0.0; ///< of the bounding box, model units
  double Volume = 0.0;   ///< of the material: solids minus cavities
};

/// Makes @a surface a closed, manifold, consistently oriented boundary whose normals point out of
/// the material, or returns one error.
///
/// Repairs, each with a warning: merges points of equal coordinates (without a warning: STL files
/// have nothing else); drops unused points, triangles with two equal corners, and duplicate
/// triangles when the surface is closed without them; removes triangles with three distinct
/// collinear corners by flipping their longest edge, which doesn't change the shape; reverses
/// triangles. Each component becomes a solid or a cavity by its nesting depth, whatever its
/// orientation was. Order of points and triangles is kept; needles are kept.
///
/// Errors: EmptySurface (no points, no faces), IndexOutOfRange, NonFinite (also beyond 1e100),
/// NonManifold (edges with more than two faces, vertices with several fans), OpenBoundary,
/// Degenerate (zero volume, or collinear triangles that can't be flipped away), NotOrientable,
/// SelfIntersection (exact: SelfIntersection.h), and what @a monitor says. The messages say how
/// many, the first ids (0-based, of the input), coordinates, and what to do.
///
/// All tests are exact or relative to the size of the surface: no absolute tolerance. (Where
/// coordinates span more than 90 orders of magnitude, those below 1e-90 of the largest are zero.)
/// Unless the Status is Ok, @a surface is unchanged.
/// Cost: n log n; about 0.5 s for 100,000 triangles on one core, most of it for self-intersections
/// (parallel).
Status CheckSurface(SurfaceMesh& surface, const SurfaceCheckOptions& options,
  SurfaceCheckReport& report, Monitor& monitor);
} // namespace featurehex

#endif

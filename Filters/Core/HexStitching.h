// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Untangling by stitching: hexes are taken apart into cubes and sewn together again (design 3.7).

#ifndef featurehex_HexStitching_h
#define featurehex_HexStitching_h

#include "HexOptimizer.h"
#include "Monitor.h"

namespace featurehex
{
/// Untangles the pieces of @a mesh round hexes with a scaled Jacobian below 1e-4: those hexes, two
/// rings of hexes round them, the outer vertices of the piece fixed.
///
/// Every hex of a piece becomes a cube of its volume at its place, with own copies of its vertices.
/// Minimised is
///
///   E_D + lambda E_S + surface terms,   E_D = sum of MIPS over hexes and corners,
///   E_S = sum over copies |copy - m|^2 / size^2
///
/// over the copies and the merged positions m. One vertex at a time takes a Newton step for all its
/// copies and m together: given m, each copy is a 3 x 3 problem in its own hex, and eliminating the
/// copies leaves a 3 x 3 problem for m, so that a large lambda doesn't slow the descent. After each
/// sweep lambda rises to 1e4 E_D / E_S, and a piece is finished as soon as its merged hexes have
/// positive corners.
///
/// Reference: Gao, Shen, Panozzo, Feature preserving octree-based hexahedral meshing, Computer
/// Graphics Forum 38(5), 2019, doi:10.1111/cgf.13795.
///
/// @a terms gives the vertices that are fixed and the surface terms of those on the boundary.
/// Pieces that can't be freed in @a maximumSweeps take the merged positions when these have fewer
/// inverted hexes.
/// @a sweeps: what the slowest piece took.
Status StitchHexes(HexMesh& mesh, const HexStars& stars, const HexOptimizer& terms,
  int maximumSweeps, int& sweeps, Monitor& monitor);
}

#endif

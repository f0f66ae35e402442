// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Untangling: moves points until no hex is inverted (design 3.7).

#ifndef featurehex_HexUntangling_h
#define featurehex_HexUntangling_h

#include "HexStars.h"
#include "Monitor.h"
#include "SurfaceGeometry.h"

namespace featurehex
{
enum class UntangleMethod
{
  Regularized, ///< the mesh stays connected; the determinant is regularised (Garanzha et al. 2021)
  Stitching    ///< hexes are taken apart and sewn together (the paper's)
};

struct UntangleOptions
{
  UntangleMethod Method = UntangleMethod::Regularized;
  int MaximumSweeps = 60;
  /// Of the terms that hold the boundary near the surface; without a surface the boundary is fixed.
  double SurfaceWeight = 1.0;
};

struct UntangleReport
{
  Index InvertedBefore = 0;
  Index InvertedAfter = 0;
  int Sweeps = 0;
};

/// Hexes with a corner determinant <= 0, ascending.
std::vector<Index> InvertedHexes(const HexMesh& mesh);

/// Moves points until no corner determinant is <= 0. @a surface may be null: then boundary vertices don't move.
Status UntangleHexes(HexMesh& mesh, const HexStars& stars, const SurfaceGeometry* surface,
  const UntangleOptions& options, UntangleReport& report, Monitor& monitor);
}

#endif

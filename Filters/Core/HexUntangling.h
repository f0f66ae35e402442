// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Untangling: moves points until no hex is inverted (design 3.7).

#ifndef featurehex_HexUntangling_h
#define featurehex_HexUntangling_h

#include "FeatureTargets.h"
#include "HexStars.h"
#include "Monitor.h"
#include "SurfaceGeometry.h"

namespace featurehex
{
/// How hexes are untangled.
enum class UntangleMethod
{
  Regularized, ///< the mesh stays connected; the determinant is regularised (Garanzha et al. 2021)
  Stitching    ///< hexes are taken apart and sewn together (the paper's)
};

/// Which method, and how long it tries.
struct UntangleOptions
{
  UntangleMethod Method = UntangleMethod::Regularized;
  int MaximumSweeps = 60;
  /// Of the terms that hold the boundary near the surface; without a surface the boundary is fixed.
  double SurfaceWeight = 1.0;
  /// With a surface: where boundary vertices belong; may be null. Those at features are put there
  /// first (BoundarySpreading.h).
  const FeatureTargets* Features = nullptr;
  /// 1 for vertices that may move; null: all. The others are in place (CarriedPositions.h).
  const std::vector<char>* Changed = nullptr;
};

/// What is left inverted.
struct UntangleReport
{
  Index InvertedBefore = 0;
  Index InvertedAfter = 0;
  /// Inverted at a corner whose four vertices are fixed: no move of the others helps.
  Index Hopeless = 0;
  Index Folded = 0;   ///< boundary quads that had to be unfolded in the last attempt
  int Sweeps = 0;
};

/// Hexes with a corner determinant <= 0, ascending.
std::vector<Index> InvertedHexes(const HexMesh& mesh);

/// Moves points until no corner determinant is <= 0, or MaximumSweeps is reached: look at the
/// report. @a surface may be null: then boundary vertices don't move.
///
/// Regularized: determinants are replaced by (det + sqrt(det^2 + delta^2)) / 2, delta follows the
/// worst one (Garanzha et al., Foldover-free maps in 50 lines of code, ACM TOG 40(4), 2021,
/// doi:10.1145/3450626.3459847). Stitching: see HexStitching.h. Documentation/untangling.md
/// compares them.
Status UntangleHexes(HexMesh& mesh, const HexStars& stars, const SurfaceGeometry* surface,
  const UntangleOptions& options, UntangleReport& report, Monitor& monitor);
}

#endif

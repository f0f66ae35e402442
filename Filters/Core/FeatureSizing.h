// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How small the cells have to be at sharp features so that each gets its own mesh edges
/// (design 3.2).

#ifndef featurehex_FeatureSizing_h
#define featurehex_FeatureSizing_h

#include "BlockOctree.h"
#include "FeatureGeometry.h"

namespace featurehex
{
/// Cell sizes that features ask for.
struct FeatureSizingOptions
{
  double TargetEdgeLength = 0.0; ///< model units, edge length of cells of level 0
  int MaximumLevel = 4;          ///< at most this many halvings for loops
  int MaximumSizingLevel = 3;    ///< at most this many for curves near each other and short ones
  double CellsBetween = 0.7;     ///< between two curves that don't meet
  double CellsPerCurve = 0.7;    ///< along a curve from corner to corner
  double CellsPerLoop = 6.0;     ///< along a loop without corner
};

/// Refinement points where curves are short, or close to others that they don't meet, with the
/// level they need; by curve, along each. Cost: O(length / edge length).
std::vector<RefinementPoint> ComputeFeatureSizing(
  const FeatureGeometry& geometry, const FeatureSizingOptions& options);

/// Cells of @a size (model units) are too large to tell a curve from others that it doesn't meet:
/// CellsBetween of them don't fit between the two.
bool TooCloseForCells(const FeatureGeometry& geometry, Index curve, double size);
} // namespace featurehex

#endif

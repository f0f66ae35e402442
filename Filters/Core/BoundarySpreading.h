// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Puts the boundary of a padded mesh onto matched corners, curves and patches before the hexes are
/// untangled.

#ifndef featurehex_BoundarySpreading_h
#define featurehex_BoundarySpreading_h

#include "FeatureTargets.h"

namespace featurehex
{
/// Puts the boundary vertices of the quads at feature edges, and of two rings of quads round those,
/// on their corners, curves and patches, spread evenly: means of neighbours, projected, in several
/// passes. Hexes below are inverted afterwards; untangling cures that. A boundary that starts where
/// it belongs needs no drawing past each other: measured on 16 turned cubes, the least scaled
/// Jacobian before the improvement is 0.2-0.4 with it, 0.01-0.1 without, and no vertex is trapped
/// beside its feature. @a changed: 1 for those that may move; null: all.
void SpreadAtFeatures(HexMesh& mesh, const HexStars& stars, const FeatureTargets& features,
  const std::vector<char>* changed = nullptr);

/// The normal of a boundary quad points against that of its patch at the closest point: a fold of
/// the boundary. Its hexes may all be positive, but the boundary intersects itself.
bool IsFolded(
  const HexMesh& mesh, const HexStars& stars, const FeatureTargets& features, Index quad);

/// Spreads the vertices of folded quads, and of two rings of quads round them. Returns the number
/// of folded quads.
Index UnfoldBoundary(HexMesh& mesh, const HexStars& stars, const FeatureTargets& features);
} // namespace featurehex

#endif

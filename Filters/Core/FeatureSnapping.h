// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Puts the corner and curve vertices of a fitted mesh exactly on their features (design 3.8).

#ifndef featurehex_FeatureSnapping_h
#define featurehex_FeatureSnapping_h

#include "Monitor.h"
#include "SurfaceTerms.h"

namespace featurehex
{
/// Weight of corners and curves against that of the surface during the fit.
constexpr double FeatureShare = 4.0;

/// Draws feature vertices with a rising weight, puts those that have come near on their features
/// and locks them there; what doesn't come near by itself is forced, and its neighbourhood
/// untangled round it. A vertex stays unlocked only where all that fails. The mesh is valid and
/// stays valid. @a weight: of the surface terms.
Status SnapFeatures(HexMesh& mesh, const HexStars& stars, FeatureTargets& features,
  SurfaceTerms& terms, HexOptimizer& optimizer, double weight, Monitor& monitor);
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which patches share a padding layer, and so how many hexes meet along each crease.

#ifndef featurehex_PaddingGroups_h
#define featurehex_PaddingGroups_h

#include "FeatureGeometry.h"

namespace featurehex
{
/// Group of each patch of the surface, 0 and up: patches of one group get one layer in common.
///
/// A crease inside a group has two hexes, each with half its dihedral angle. Where two groups meet
/// their layers cross, and the crease has one hex with the whole angle: right for convex creases up
/// to about 120 degrees, and the layers leave no quad with two edges on that crease. At a corner at
/// most three layers can cross, each into a patch or along one curve; patches of corners where they
/// can't, or would leave flat quads, share a group.
std::vector<int> GroupPatches(const FeatureGeometry& geometry);
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Small handles that labelling makes at sharp edges and thin sheets: close or cut them.

#ifndef featurehex_HandleRepair_h
#define featurehex_HandleRepair_h

#include "IslandRepair.h"

#include <functional>

namespace featurehex
{
/// Flip single hexes, then pairs, then triples next to each other, the nearest to the surface
/// first, where that removes a handle of the interface: fill a window in a sheet of hexes or cut a
/// bridge between two. A flip never makes a non-manifold vertex, nor another component, and the
/// hexes' centres lie at most about one cell on the wrong side afterwards. Handles that the surface
/// has, beams and tunnels of few hexes whose centres are on its side and see those before and
/// after, come last. @a excess: per shell of the surface how many handles the interface has too
/// many; counted down. @a seesOther: the surface doesn't pass between the centres of two hexes.
/// Returns the number of flipped hexes.
Index RepairHandles(const HexGraph& graph, const HexDistances& distances, const Shells& surface,
  const std::function<bool(Index, Index)>& seesOther, std::vector<Index>& excess,
  std::vector<char>& inside);
}

#endif

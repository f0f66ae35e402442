// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Small handles that labelling makes at sharp edges and thin sheets: close or cut them.

#ifndef featurehex_HandleRepair_h
#define featurehex_HandleRepair_h

#include "IslandRepair.h"

namespace featurehex
{
/// Flip single hexes, then pairs, then triples next to each other, the nearest to the surface
/// first, where that removes a handle of the interface: fill a window in a sheet of hexes or cut a
/// bridge between two. A flip never makes a non-manifold vertex, nor another component, and the
/// hexes' centres lie at most about one cell on the wrong side afterwards. @a excess: per shell of
/// the surface how many handles the interface has too many; counted down. Returns the number of
/// flipped hexes.
Index RepairHandles(const HexGraph& graph, const HexDistances& distances, const Shells& surface,
  std::vector<Index>& excess, std::vector<char>& inside);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Pieces of a body that coarse hexes tear off: join them again along the cheapest path, or drop
/// them.

#ifndef featurehex_IslandRepair_h
#define featurehex_IslandRepair_h

#include "InterfaceRepair.h"
#include "ShellTopology.h"

namespace featurehex
{
/// What labelling knows about the hex centres.
struct HexDistances
{
  std::vector<double> Signed;    ///< in local cell sizes, negative inside; far away a lower bound
  std::vector<Index> Triangles;  ///< closest triangle of the surface; -1: far
};

/// Every solid shell of the surface should have one face-connected set of inside hexes, every
/// cavity one of outside hexes, and all others outside belong to the exterior. Where there are
/// more (the end of a limb thinner than the cells, a pocket between two fingers) the smaller sets
/// are islands: the hexes of the cheapest path to the largest one are flipped, where a hex costs
/// as much as its centre lies on the wrong side, in cells. Islands of few hexes that are too far
/// away are flipped themselves. Returns the number of flipped hexes. The interface may need
/// RepairInterface() afterwards.
Index RepairIslands(const HexGraph& graph, const HexDistances& distances, const Shells& surface,
  std::vector<char>& inside);
}

#endif

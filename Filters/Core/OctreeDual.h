// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The dual of a balanced block octree as a conforming all-hex mesh.

#ifndef featurehex_OctreeDual_h
#define featurehex_OctreeDual_h

#include "BlockOctree.h"
#include "Monitor.h"
#include "Status.h"
#include "Types.h"

#include <array>
#include <cstdint>
#include <vector>

namespace featurehex
{
/// Where a hex of the dual comes from. All but Regular are transition elements.
enum class DualHexKind : std::uint8_t
{
  Regular,     ///< a cube: the eight cells round it have one level
  MixedCorner, ///< block corner between cells of two levels
  Frustum,     ///< block face between a coarse and four fine blocks
  MixedEdge    ///< block edge between coarse and fine blocks
};

/// What the dual knows about its hexes and vertices.
struct OctreeDualArrays
{
  std::vector<int> HexLevel; ///< octree level of the finest cells at the hex, 0 = root
  std::vector<DualHexKind> HexKind;
  /// Lowest corner of the octree cell of each vertex, in units of the finest cell. Several
  /// vertices have the same one: those that split a transition belong to the nearest coarse cell.
  std::vector<std::array<int, 3>> PointOctreeIndex;
};

/// Convert the octree. Vertices are the cell centres and the new vertices of
/// Tables/DualTemplates.h; the mesh ends half a cell inside the border of the root grid.
/// Conforming, every corner of every hex positive (smallest scaled Jacobian 0.439). Points and
/// hexes are numbered along the Z curve of the leaves. @a arrays may be null.
///
/// Precondition: @a octree is balanced, as BuildBlockOctree() and RebuildBlockOctree() leave it.
///
/// Each block writes its own vertices and hexes to places counted before: the same bits for any
/// number of threads. Cost: O(blocks), 27 neighbour look-ups each; 108 bytes a block for the
/// neighbours. Errors: CellLimit when ids don't fit in 32 bits, InvalidMesh for an empty octree,
/// what
/// @a monitor says. Method: the dual of Gao,
/// Shen, Panozzo 2019 (BlockOctree.h) on blocks, where every case is local.
Status ConvertOctreeToHexes(
  const BlockOctree& octree, HexMesh& mesh, OctreeDualArrays* arrays, Monitor& monitor);

/// Number of hexes that ConvertOctreeToHexes() makes of a balanced octree.
std::int64_t CountDualHexes(const BlockOctree& octree);
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Templates of the dual between coarse and fine blocks, and where their new vertices go.
///
/// A coarse block has 2x2x2 cells of edge 2s, its fine neighbours have cells of edge s; all lengths
/// here are in units of s. The dual of an octree with leaf blocks has four kinds of cell: inside a
/// block, at a block corner (both one hex whatever the levels), at a block face, at a block edge.
/// Only the last two need new vertices, and only when levels differ.
///
/// Derivation. Across a face one coarse block meets 4 fine ones: 2x2 coarse centres ("tips") above
/// 4x4 fine centres. A second 4x4 grid U is put over the fine centres B: its corners are the tips,
/// the two middle positions of each side are *split vertices*, the four others new interior
/// vertices. 9 hexes stand between B and U, 3 fill the valley over U lengthwise, 1 closes it: the
/// 3D frustum of X. Gao, H. Shen, D. Panozzo, "Feature Preserving Octree-Based Hexahedral Meshing",
/// Computer Graphics Forum 38(5), 2019, doi:10.1111/cgf.13795. Split vertices belong to the *tip
/// edge* (a block and one of its twelve edges), so that all templates round that edge share them.
/// Then every coarse column at a block edge reads tip, split, split, tip: four entries, like a fine
/// column, and three stacked hexes join the columns.
///
/// With the coordinates below the smallest scaled Jacobian over all two-level neighbourhoods is
/// 0.4386 (TestOctreeDual enumerates them).

#ifndef featurehex_Tables_DualTemplates_h
#define featurehex_Tables_DualTemplates_h

namespace featurehex
{
namespace dual
{
/// Vertices of the frustum: 0 to 15 the fine centres B(i, j) at i + 4 j, 16 to 31 the grid U(i, j)
/// at 16 + i + 4 j. Right-handed local frame: x along i, y along j, z from the fine to the coarse
/// side.
constexpr int FrustumVertices = 32;
constexpr int FrustumHexCount = 13;

constexpr int B(int i, int j)
{
  return i + 4 * j;
}
constexpr int U(int i, int j)
{
  return 16 + i + 4 * j;
}

/// All positive in the local frame.
constexpr int FrustumHexes[FrustumHexCount][8] = {
  // between the two grids
  { B(0, 0), B(1, 0), B(1, 1), B(0, 1), U(0, 0), U(1, 0), U(1, 1), U(0, 1) },
  { B(1, 0), B(2, 0), B(2, 1), B(1, 1), U(1, 0), U(2, 0), U(2, 1), U(1, 1) },
  { B(2, 0), B(3, 0), B(3, 1), B(2, 1), U(2, 0), U(3, 0), U(3, 1), U(2, 1) },
  { B(0, 1), B(1, 1), B(1, 2), B(0, 2), U(0, 1), U(1, 1), U(1, 2), U(0, 2) },
  { B(1, 1), B(2, 1), B(2, 2), B(1, 2), U(1, 1), U(2, 1), U(2, 2), U(1, 2) },
  { B(2, 1), B(3, 1), B(3, 2), B(2, 2), U(2, 1), U(3, 1), U(3, 2), U(2, 2) },
  { B(0, 2), B(1, 2), B(1, 3), B(0, 3), U(0, 2), U(1, 2), U(1, 3), U(0, 3) },
  { B(1, 2), B(2, 2), B(2, 3), B(1, 3), U(1, 2), U(2, 2), U(2, 3), U(1, 3) },
  { B(2, 2), B(3, 2), B(3, 3), B(2, 3), U(2, 2), U(3, 2), U(3, 3), U(2, 3) },
  // along x in the valley of the upper grid
  { U(0, 0), U(0, 1), U(0, 2), U(0, 3), U(1, 0), U(1, 1), U(1, 2), U(1, 3) },
  { U(1, 0), U(1, 1), U(1, 2), U(1, 3), U(2, 0), U(2, 1), U(2, 2), U(2, 3) },
  { U(2, 0), U(2, 1), U(2, 2), U(2, 3), U(3, 0), U(3, 1), U(3, 2), U(3, 3) },
  // on top
  { U(0, 3), U(1, 3), U(2, 3), U(3, 3), U(0, 0), U(1, 0), U(2, 0), U(3, 0) }
};

/// Interior vertices of the frustum: (+-Across, +-Across) from the middle of the face, Depth
/// from the face into the *fine* side.
constexpr double InteriorAcross = 0.499;
constexpr double InteriorDepth = 0.35;

/// Place of the two split vertices of a tip edge: distance from the two faces of the coarse block
/// that meet in the edge, and +-Along from the middle of the edge.
struct SplitPlacement
{
  double FromFirst;
  double FromSecond;
  double Along;
};

/// Fine blocks across the first face only: 0.510 from it, 2 - 1.412 from the other.
constexpr SplitPlacement SplitFirstFine = { 0.510, 0.588, 0.336 };
/// Fine blocks across the second face only.
constexpr SplitPlacement SplitSecondFine = { 0.588, 0.510, 0.336 };
/// Fine blocks across both faces (convex and diagonal edges).
constexpr SplitPlacement SplitBothFine = { 0.514, 0.514, 0.344 };
/// Concave edge: both face neighbours are coarse and the block diagonally opposite is fine.
constexpr SplitPlacement SplitConcave = { 0.473, 0.473, 0.386 };

/// The four columns round a block edge, counter-clockwise about its axis: whether the column lies
/// on the low (0) or high (1) side of the edge along the first and the second axis after the
/// edge's.
constexpr int EdgeColumns[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };

/// Hexes at a block edge with coarse columns @a mask (bit q: column q): one when all are coarse,
/// else three stacked and one more for each pair of neighbouring coarse columns.
constexpr int EdgeHexCount(unsigned mask)
{
  int count = mask == 15u ? 1 : 3;
  for (int q = 0; mask != 15u && q < 4; ++q)
  {
    const unsigned pair = 1u << q | 1u << (q + 1) % 4;
    count += (mask & pair) == pair ? 1 : 0;
  }
  return count;
}

static_assert(EdgeHexCount(0b0011) == 4, "flat: 3 stacked and 1 closing");
static_assert(EdgeHexCount(0b0001) == 3, "convex: 3 stacked");
static_assert(EdgeHexCount(0b0101) == 3, "diagonal: 3 stacked");
static_assert(EdgeHexCount(0b0111) == 5, "concave: 3 stacked and 2 closing");
} // namespace dual
} // namespace featurehex

#endif

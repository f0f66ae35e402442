// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Strongly balanced octree around a surface whose leaves are blocks of 2x2x2 equal cells.
///
/// Splitting whole blocks only is the *pairing* rule of X. Gao, H. Shen, D. Panozzo, "Feature
/// Preserving Octree-Based Hexahedral Meshing", Computer Graphics Forum 38(5), 2019,
/// doi:10.1111/cgf.13795: with it the dual of the octree needs four local cases only
/// (OctreeDual.h).

#ifndef featurehex_BlockOctree_h
#define featurehex_BlockOctree_h

#include "Monitor.h"
#include "Status.h"
#include "Types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace featurehex
{
/// A block: its level (0 = root blocks) and its position in the grid of blocks of that level.
struct Block
{
  int Level = 0;
  std::array<int, 3> Index = { 0, 0, 0 };
};

/// Packed block: Morton code (x in the lowest bit) of its lowest corner in units of the finest
/// block, then five bits of level. Sorted keys are the leaves along the Z curve, and the
/// leaf that contains a point is the last one whose key isn't beyond the point's.
using BlockKey = std::uint64_t;

/// A grid may have at most 2^19 finest blocks along an axis: three of them and the level fill a
/// key.
constexpr int MaximumBlockBits = 19;

BlockKey PackBlock(const Block& block, int depth);
Block UnpackBlock(BlockKey key, int depth);

/// The octree. Local coordinates are counted in finest cells from Origin along Axes.
struct BlockOctree
{
  Vec3 Origin = Vec3::Zero();   ///< lowest corner of the root grid, model space
  Mat3 Axes = Mat3::Identity(); ///< columns: unit axes of the grid in model space, right-handed
  double FinestCellSize = 1.0;  ///< edge of a cell at level Depth, model units
  int Depth = 0;                ///< level of the finest leaves
  int BaseLevel = 0;            ///< level whose cells have the target edge length
  std::array<int, 3> RootBlocks = { 0, 0, 0 };
  std::vector<BlockKey> Leaves; ///< sorted; together they tile the root grid

  Block Leaf(std::size_t leaf) const { return UnpackBlock(this->Leaves[leaf], this->Depth); }

  /// Edge of a cell (half a block) of @a level, model units.
  double CellSize(int level) const
  {
    return this->FinestCellSize * static_cast<double>(std::int64_t(1) << (this->Depth - level));
  }
  Vec3 ToModel(const Vec3& local) const
  {
    return this->Origin + this->Axes * (this->FinestCellSize * local);
  }
  Vec3 ToLocal(const Vec3& position) const
  {
    return this->Axes.transpose() * (position - this->Origin) / this->FinestCellSize;
  }

  /// Leaf that contains @a position; the nearest one when it is outside the root grid.
  std::size_t LeafAt(const Vec3& position) const;
  /// Level of that leaf relative to the target: 0 = target edge length, 1 = half of it, -1 = twice.
  int LeafLevelAt(const Vec3& position) const;
  /// Edge length of the cells at @a position, model units.
  double CellSizeAt(const Vec3& position) const;
};

/// Size, depth and axes of the grid.
struct OctreeOptions
{
  /// Edge length of the cells that meet the surface, model units. Must be positive.
  double TargetEdgeLength = 0.0;
  /// Refinement points may ask for cells at most this many levels finer than the target, 0 to 12.
  int MaximumLevel = 3;
  /// BuildBlockOctree() stops with CellLimit before it makes more cells than this, 1 to 10^9.
  std::int64_t MaximumNumberOfCells = 20000000;
  /// Turn the grid into the principal axes of the surface when its box is at least 1 % smaller
  /// there.
  bool AlignToPrincipalAxes = false;
  /// Shift the grid by up to half a cell so that flat faces lie between layers of hexes (GridFit.h).
  bool FitToFlatFaces = true;
  /// Target cells between the surface's box and the border of the root grid, at least 2.
  int MarginCells = 2;
  /// Cells of the root blocks are this many levels coarser than the target, 0 to 12.
  int CoarseLevels = 3;
};

/// A place where the octree has to be finer.
struct RefinementPoint
{
  Vec3 Position = Vec3::Zero();
  /// Cells at the point, and within two such cells of it, are at least this many levels finer than
  /// the target (limited by OctreeOptions::MaximumLevel).
  int Level = 0;
};

/// Size of an octree and of its dual.
struct OctreePrediction
{
  /// Estimate from projected areas before the octree exists; exact when it was built.
  std::int64_t Cells = 0;
  /// Hexes of the dual of the whole grid, outside included; always an estimate
  /// (CountDualHexes() in OctreeDual.h counts them exactly).
  std::int64_t Hexes = 0;
};

/// Columns: unit axes of the octree's grid, those of model space or, where that is asked for and gives
/// a smaller box, the principal axes of the surface.
Mat3 GridAxes(const SurfaceMesh& surface, bool alignToPrincipalAxes);

/// Estimate the size without building anything: O(triangles + refinement points). A block of edge s
/// that is one of a grid is met by a smooth surface (|n_x| + |n_y| + |n_z|) dA / s^2 times.
/// Overlaps of refinement points are not known, so that their share is an upper bound.
OctreePrediction PredictOctree(const SurfaceMesh& surface,
  const std::vector<RefinementPoint>& points, const OctreeOptions& options);

/// Build the octree: root grid centred on the surface, blocks that meet the surface split until
/// their cells have the target edge length, then refinement points, then strong balance (blocks
/// that share a face, an edge or a vertex differ by at most one level). The result doesn't depend
/// on the order of triangles or points. @a prediction may be null.
///
/// Errors: InvalidOption, EmptySurface, NonFinite, IndexOutOfRange, CellLimit; what @a monitor
/// says. Cost: O(triangles x levels + blocks); 12 bytes of memory a block while building, 8 after.
Status BuildBlockOctree(const SurfaceMesh& surface, const std::vector<RefinementPoint>& points,
  const OctreeOptions& options, BlockOctree& octree, OctreePrediction* prediction,
  Monitor& monitor);

/// Neighbours of leaves by their grid position: open-addressing hash table over the sorted leaves.
class BlockLocator
{
public:
  explicit BlockLocator(const BlockOctree& octree);

  /// Results of Find() that are not an equal leaf.
  static constexpr std::int32_t Outside = -1; ///< beyond the root grid
  static constexpr std::int32_t Finer = -2;   ///< the position is split further
  static constexpr std::int32_t Coarser =
    -3; ///< Coarser - n: part of the leaf n, one level coarser

  /// What is at a block position of a balanced octree next to a leaf of the same level.
  std::int32_t Find(const Block& block) const;
  /// Index of the leaf that is exactly @a block, or -1.
  std::int32_t FindExact(const Block& block) const;
  /// All 27 positions around a leaf, x fastest, with itself in the middle.
  void FindNeighbors(std::size_t leaf, std::int32_t neighbors[27]) const;

private:
  std::int32_t Lookup(BlockKey key) const;
  std::int32_t FindKey(BlockKey key, int level) const;

  const BlockOctree& Octree;
  std::vector<std::int32_t> Slots;
  int Shift = 0;
};

/// True when leaves that touch differ by at most one level. The leaves must tile the root grid.
bool IsBalanced(const BlockOctree& octree);

/// The octree as a list of cells, eight per leaf, in the order of Leaves and along the Z curve.
struct OctreeCells
{
  std::vector<std::array<int, 3>> OctreeIndex; ///< lowest corner in units of the finest cell
  std::vector<int> Level;                      ///< 0 = root; a cell spans 2^(Depth - Level) units
};

OctreeCells ListOctreeCells(const BlockOctree& octree);

/// Rebuild RootBlocks and Leaves from cells in any order. The caller has set Origin, Axes,
/// FinestCellSize, Depth and BaseLevel. InvalidMesh when the cells aren't a balanced block octree.
Status RebuildBlockOctree(const OctreeCells& cells, BlockOctree& octree);
} // namespace featurehex

#endif

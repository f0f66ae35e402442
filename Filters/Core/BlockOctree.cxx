// SPDX-License-Identifier: BSD-3-Clause
#include "BlockOctree.h"

#include "MortonCode.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace featurehex
{
namespace
{
constexpr int LevelBits = 5;
constexpr BlockKey LevelMask = (1 << LevelBits) - 1;
/// 2^64 / golden ratio: spreads neighbouring keys over the table (D. Knuth, TAOCP 3, 6.4).
constexpr std::uint64_t HashFactor = 0x9E3779B97F4A7C15ULL;
using BlockIndex = std::array<int, 3>;

/// Keep every third bit.
std::uint64_t Compact(std::uint64_t x)
{
  x &= 0x1249249249249249ULL;
  x = (x | x >> 2) & 0x10c30c30c30c30c3ULL;
  x = (x | x >> 4) & 0x100f00f00f00f00fULL;
  x = (x | x >> 8) & 0x1f0000ff0000ffULL;
  x = (x | x >> 16) & 0x1f00000000ffffULL;
  x = (x | x >> 32) & 0x1fffffULL;
  return x;
}

/// Key of the block one level coarser around @a key.
BlockKey ParentKey(BlockKey key, int level, int depth)
{
  const std::uint64_t inside = (std::uint64_t(1) << 3 * (depth - level + 1)) - 1;
  return ((key >> LevelBits) & ~inside) << LevelBits | static_cast<std::uint64_t>(level - 1);
}

int LevelOf(BlockKey key)
{
  return static_cast<int>(key & LevelMask);
}

/// Leaf that contains the lowest corner of the block @a key, which lies in the root grid.
std::size_t LastLeafUpTo(const std::vector<BlockKey>& leaves, BlockKey key)
{
  const BlockKey last = key | LevelMask;
  return std::upper_bound(leaves.begin(), leaves.end(), last) - leaves.begin() - 1;
}
} // namespace

BlockKey PackBlock(const Block& block, int depth)
{
  const std::uint64_t code = MortonCode(block.Index[0], block.Index[1], block.Index[2]);
  return code << (3 * (depth - block.Level) + LevelBits) | static_cast<std::uint64_t>(block.Level);
}

Block UnpackBlock(BlockKey key, int depth)
{
  Block block;
  block.Level = LevelOf(key);
  const std::uint64_t code = key >> (LevelBits + 3 * (depth - block.Level));
  block.Index = { static_cast<int>(Compact(code)), static_cast<int>(Compact(code >> 1)),
    static_cast<int>(Compact(code >> 2)) };
  return block;
}

std::size_t BlockOctree::LeafAt(const Vec3& position) const
{
  const Vec3 local = this->ToLocal(position) / 2;
  BlockIndex at;
  for (int k = 0; k < 3; ++k)
  {
    const double last = static_cast<double>((this->RootBlocks[k] << this->Depth) - 1);
    at[k] = static_cast<int>(std::clamp(std::floor(local[k]), 0.0, last));
  }
  const BlockKey key = MortonCode(at[0], at[1], at[2]) << LevelBits;
  return LastLeafUpTo(this->Leaves, key);
}

int BlockOctree::LeafLevelAt(const Vec3& position) const
{
  return this->Leaf(this->LeafAt(position)).Level - this->BaseLevel;
}

double BlockOctree::CellSizeAt(const Vec3& position) const
{
  return this->CellSize(this->Leaf(this->LeafAt(position)).Level);
}

BlockLocator::BlockLocator(const BlockOctree& octree)
  : Octree(octree)
{
  int bits = 4;
  while ((std::size_t(1) << bits) < 2 * octree.Leaves.size())
  {
    ++bits;
  }
  this->Shift = 64 - bits;
  this->Slots.assign(std::size_t(1) << bits, -1);
  const std::size_t mask = this->Slots.size() - 1;
  for (std::size_t n = 0; n < octree.Leaves.size(); ++n)
  {
    std::size_t slot = octree.Leaves[n] * HashFactor >> this->Shift;
    while (this->Slots[slot] >= 0)
    {
      slot = (slot + 1) & mask;
    }
    this->Slots[slot] = static_cast<std::int32_t>(n);
  }
}

std::int32_t BlockLocator::Lookup(BlockKey key) const
{
  const std::size_t mask = this->Slots.size() - 1;
  std::size_t slot = key * HashFactor >> this->Shift;
  while (this->Slots[slot] >= 0 && this->Octree.Leaves[this->Slots[slot]] != key)
  {
    slot = (slot + 1) & mask;
  }
  return this->Slots[slot];
}

std::int32_t BlockLocator::FindKey(BlockKey key, int level) const
{
  const std::int32_t equal = this->Lookup(key);
  if (equal >= 0)
  {
    return equal;
  }
  if (level > 0)
  {
    const std::int32_t coarser = this->Lookup(ParentKey(key, level, this->Octree.Depth));
    if (coarser >= 0)
    {
      return Coarser - coarser;
    }
  }
  return Finer;
}

std::int32_t BlockLocator::Find(const Block& block) const
{
  for (int k = 0; k < 3; ++k)
  {
    if (block.Index[k] < 0 || block.Index[k] >= this->Octree.RootBlocks[k] << block.Level)
    {
      return Outside;
    }
  }
  return this->FindKey(PackBlock(block, this->Octree.Depth), block.Level);
}

std::int32_t BlockLocator::FindExact(const Block& block) const
{
  return this->Lookup(PackBlock(block, this->Octree.Depth));
}

void BlockLocator::FindNeighbors(std::size_t leaf, std::int32_t neighbors[27]) const
{
  const Block block = this->Octree.Leaf(leaf);
  const int shift = 3 * (this->Octree.Depth - block.Level) + LevelBits;
  std::uint64_t part[3][3];
  bool inside[3][3];
  for (int k = 0; k < 3; ++k)
  {
    for (int d = 0; d < 3; ++d)
    {
      const int x = block.Index[k] + d - 1;
      inside[k][d] = x >= 0 && x < this->Octree.RootBlocks[k] << block.Level;
      part[k][d] = inside[k][d] ? SpreadBits(static_cast<std::uint64_t>(x)) << k : 0;
    }
  }
  for (int n = 0; n < 27; ++n)
  {
    const int d[3] = { n % 3, n / 3 % 3, n / 9 };
    if (n == 13)
    {
      neighbors[n] = static_cast<std::int32_t>(leaf);
    }
    else if (inside[0][d[0]] && inside[1][d[1]] && inside[2][d[2]])
    {
      const std::uint64_t code = part[0][d[0]] | part[1][d[1]] | part[2][d[2]];
      neighbors[n] =
        this->FindKey(code << shift | static_cast<std::uint64_t>(block.Level), block.Level);
    }
    else
    {
      neighbors[n] = Outside;
    }
  }
}

bool IsBalanced(const BlockOctree& octree)
{
  const BlockLocator locator(octree);
  for (std::size_t leaf = 0; leaf < octree.Leaves.size(); ++leaf)
  {
    const Block block = octree.Leaf(leaf);
    std::int32_t neighbors[27];
    locator.FindNeighbors(leaf, neighbors);
    for (int n = 0; n < 27; ++n)
    {
      if (neighbors[n] != BlockLocator::Finer)
      {
        continue;
      }
      // Neither equal nor one level coarser: finer, unless the leaf there is coarser still.
      const BlockIndex at = { block.Index[0] + n % 3 - 1, block.Index[1] + n / 3 % 3 - 1,
        block.Index[2] + n / 9 - 1 };
      const BlockKey key = PackBlock({ block.Level, at }, octree.Depth);
      if (LevelOf(octree.Leaves[LastLeafUpTo(octree.Leaves, key)]) < block.Level)
      {
        return false;
      }
    }
  }
  return true;
}

OctreeCells ListOctreeCells(const BlockOctree& octree)
{
  OctreeCells cells;
  cells.OctreeIndex.reserve(8 * octree.Leaves.size());
  cells.Level.reserve(8 * octree.Leaves.size());
  for (std::size_t leaf = 0; leaf < octree.Leaves.size(); ++leaf)
  {
    const Block block = octree.Leaf(leaf);
    const int unit = 1 << (octree.Depth - block.Level);
    for (int cell = 0; cell < 8; ++cell)
    {
      cells.OctreeIndex.push_back({ (2 * block.Index[0] + (cell & 1)) * unit,
        (2 * block.Index[1] + (cell >> 1 & 1)) * unit, (2 * block.Index[2] + (cell >> 2)) * unit });
      cells.Level.push_back(block.Level);
    }
  }
  return cells;
}

namespace
{
Status NotAnOctree(const std::string& why)
{
  return Status(StatusCode::InvalidMesh, "The cells are not a balanced block octree: " + why +
                                           ". Pass the output of the octree stage unchanged.");
}

/// The block of each cell, and which of its eight cells it is.
Status CollectCells(const OctreeCells& cells, const BlockOctree& octree,
  std::vector<std::pair<BlockKey, int>>& blocks)
{
  blocks.reserve(cells.Level.size());
  for (std::size_t n = 0; n < cells.Level.size(); ++n)
  {
    const int level = cells.Level[n];
    if (level < 0 || level > octree.Depth)
    {
      return NotAnOctree("cell " + std::to_string(n) + " has level " + std::to_string(level) +
                         ", the depth is " + std::to_string(octree.Depth));
    }
    const int shift = octree.Depth - level;
    Block block;
    block.Level = level;
    int cell = 0;
    for (int k = 0; k < 3; ++k)
    {
      const int x = cells.OctreeIndex[n][k];
      if (x < 0 || x >= 2 << MaximumBlockBits || (x & ((1 << shift) - 1)) != 0)
      {
        return NotAnOctree("cell " + std::to_string(n) + " has OctreeIndex " + std::to_string(x) +
                           ", which isn't a multiple of its size inside the grid");
      }
      block.Index[k] = x >> (shift + 1);
      cell |= (x >> shift & 1) << k;
    }
    blocks.emplace_back(PackBlock(block, octree.Depth), cell);
  }
  std::sort(blocks.begin(), blocks.end());
  return Status();
}

/// Fill RootBlocks and check that the leaves tile the root grid without overlap.
Status CheckTiling(BlockOctree& octree)
{
  octree.RootBlocks = { 0, 0, 0 };
  std::uint64_t volume = 0;
  std::uint64_t next = 0;
  for (std::size_t leaf = 0; leaf < octree.Leaves.size(); ++leaf)
  {
    const std::uint64_t code = octree.Leaves[leaf] >> LevelBits;
    const Block block = octree.Leaf(leaf);
    if (code < next)
    {
      return NotAnOctree("two of them overlap");
    }
    const std::uint64_t own = std::uint64_t(1) << 3 * (octree.Depth - block.Level);
    next = code + own;
    volume += own;
    for (int k = 0; k < 3; ++k)
    {
      octree.RootBlocks[k] = std::max(octree.RootBlocks[k], (block.Index[k] >> block.Level) + 1);
    }
  }
  std::uint64_t whole = std::uint64_t(1) << 3 * octree.Depth;
  for (int k = 0; k < 3; ++k)
  {
    whole *= static_cast<std::uint64_t>(octree.RootBlocks[k]);
  }
  return volume == whole ? Status() : NotAnOctree("there are holes between them");
}
} // namespace

Status RebuildBlockOctree(const OctreeCells& cells, BlockOctree& octree)
{
  octree.Leaves.clear();
  if (cells.Level.empty() || cells.Level.size() != cells.OctreeIndex.size())
  {
    return NotAnOctree(std::to_string(cells.Level.size()) + " levels for " +
                       std::to_string(cells.OctreeIndex.size()) + " cells");
  }
  if (octree.Depth < 0 || octree.Depth > MaximumBlockBits || !(octree.FinestCellSize > 0) ||
      !std::isfinite(octree.FinestCellSize) || !octree.Origin.allFinite() ||
      !((octree.Axes.transpose() * octree.Axes - Mat3::Identity()).norm() < 1e-9) ||
      !(octree.Axes.determinant() > 0))
  {
    return NotAnOctree("origin, axes, finest cell size or depth are out of range");
  }
  std::vector<std::pair<BlockKey, int>> blocks;
  Status status = CollectCells(cells, octree, blocks);
  if (!status.Ok())
  {
    return status;
  }
  for (std::size_t n = 0; n < blocks.size(); ++n)
  {
    const std::size_t first = n - n % 8;
    if (first + 8 > blocks.size() || blocks[n].second != static_cast<int>(n % 8) ||
        blocks[n].first != blocks[first].first)
    {
      return NotAnOctree("a block of 2x2x2 cells lacks one or has one twice");
    }
  }
  for (std::size_t n = 0; n < blocks.size(); n += 8)
  {
    octree.Leaves.push_back(blocks[n].first);
  }
  status = CheckTiling(octree);
  if (status.Ok() && !IsBalanced(octree))
  {
    status = NotAnOctree("blocks that touch differ by more than one level");
  }
  if (!status.Ok())
  {
    octree.Leaves.clear();
  }
  return status;
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A block octree while it grows; internal to BuildBlockOctree.cxx.

#ifndef featurehex_BlockTree_h
#define featurehex_BlockTree_h

#include "BlockOctree.h"

#include <algorithm>
#include <utility>

namespace featurehex
{
using BlockIndex = std::array<int, 3>;

inline Block ChildBlock(const Block& block, int child)
{
  return { block.Level + 1,
    { 2 * block.Index[0] + (child & 1), 2 * block.Index[1] + (child >> 1 & 1),
      2 * block.Index[2] + (child >> 2) } };
}

/// Nodes with eight consecutive children and no other links; positions are known on the way down.
class BlockTree
{
public:
  BlockTree(const BlockIndex& roots, std::int64_t maximumLeaves)
    : Roots(roots)
    , FirstChild(static_cast<std::size_t>(roots[0]) * roots[1] * roots[2], -1)
    , Leaves(static_cast<std::int64_t>(FirstChild.size()))
    , MaximumLeaves(maximumLeaves)
  {
  }

  /// False as soon as a split was refused; the tree is then incomplete.
  bool WithinLimit() const { return this->Leaves <= this->MaximumLeaves; }
  std::int64_t NumberOfLeaves() const { return this->Leaves; }

  /// Number of levels that hold split blocks = level of the finest leaves.
  int Depth() const { return static_cast<int>(this->SplitBlocks.size()); }

  std::int32_t Root(const BlockIndex& index) const
  {
    return index[0] + this->Roots[0] * (index[1] + this->Roots[1] * index[2]);
  }
  std::int32_t Child(std::int32_t node) const { return this->FirstChild[node]; }

  /// First of the eight children of a block, made if necessary; -1 beyond the limit.
  std::int32_t Split(std::int32_t node, int level, const BlockIndex& index)
  {
    if (this->FirstChild[node] < 0)
    {
      this->Leaves += 7;
      if (!this->WithinLimit())
      {
        return -1;
      }
      this->FirstChild[node] = static_cast<std::int32_t>(this->FirstChild.size());
      this->FirstChild.resize(this->FirstChild.size() + 8, -1);
      if (level >= this->Depth())
      {
        this->SplitBlocks.resize(level + 1);
      }
      this->SplitBlocks[level].push_back(index);
    }
    return this->FirstChild[node];
  }

  /// Node of a block inside the root grid, made by splitting its ancestors; -1 beyond the limit.
  std::int32_t Ensure(int level, const BlockIndex& index)
  {
    BlockIndex at = { index[0] >> level, index[1] >> level, index[2] >> level };
    std::int32_t node = this->Root(at);
    for (int l = 0; l < level; ++l)
    {
      node = this->Split(node, l, at);
      if (node < 0)
      {
        return -1;
      }
      const int down = level - l - 1;
      at = { index[0] >> down, index[1] >> down, index[2] >> down };
      node += (at[0] & 1) | (at[1] & 1) << 1 | (at[2] & 1) << 2;
    }
    return node;
  }

  bool Inside(int level, const BlockIndex& index) const
  {
    return index[0] >= 0 && index[1] >= 0 && index[2] >= 0 && index[0] < this->Roots[0] << level &&
           index[1] < this->Roots[1] << level && index[2] < this->Roots[2] << level;
  }

  /// Strong balance. Two leaves that touch differ by two levels exactly when some split block has a
  /// neighbour position of its own size that doesn't exist as a block, so it is enough to make
  /// the 26 neighbours of all split blocks, from the finest level to the coarsest.
  bool Balance(Monitor& monitor)
  {
    for (int level = this->Depth() - 1; level > 0; --level)
    {
      for (std::size_t n = 0; n < this->SplitBlocks[level].size(); ++n)
      {
        if (n % 65536 == 0 && !monitor.Update(0.9))
        {
          return false;
        }
        const BlockIndex c = this->SplitBlocks[level][n];
        for (int d = 0; d < 27; ++d)
        {
          const BlockIndex at = { c[0] + d % 3 - 1, c[1] + d / 3 % 3 - 1, c[2] + d / 9 - 1 };
          if (this->Inside(level, at) && this->Ensure(level, at) < 0)
          {
            return false;
          }
        }
      }
    }
    return true;
  }

  std::vector<BlockKey> SortedLeaves(int depth) const
  {
    std::vector<std::pair<BlockKey, BlockIndex>> roots; // along the Z curve
    for (int z = 0; z < this->Roots[2]; ++z)
    {
      for (int y = 0; y < this->Roots[1]; ++y)
      {
        for (int x = 0; x < this->Roots[0]; ++x)
        {
          roots.emplace_back(PackBlock({ 0, { x, y, z } }, depth), BlockIndex{ x, y, z });
        }
      }
    }
    std::sort(roots.begin(), roots.end());
    std::vector<BlockKey> leaves;
    leaves.reserve(static_cast<std::size_t>(this->Leaves));
    for (const auto& root : roots)
    {
      this->Append(this->Root(root.second), { 0, root.second }, depth, leaves);
    }
    return leaves;
  }

private:
  void Append(std::int32_t node, const Block& block, int depth, std::vector<BlockKey>& leaves) const
  {
    const std::int32_t first = this->FirstChild[node];
    if (first < 0)
    {
      leaves.push_back(PackBlock(block, depth));
      return;
    }
    for (int child = 0; child < 8; ++child)
    {
      this->Append(first + child, ChildBlock(block, child), depth, leaves);
    }
  }

  BlockIndex Roots;
  std::vector<std::int32_t> FirstChild;
  std::int64_t Leaves;
  std::int64_t MaximumLeaves;
  std::vector<std::vector<BlockIndex>> SplitBlocks;
};
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bounding-box tree over triangles in double precision: pairs that may touch, triangles at a box.

#ifndef featurehex_BoxTree_h
#define featurehex_BoxTree_h

#include "Types.h"

#include <algorithm>
#include <cstddef>

namespace featurehex
{
/// True when the closed boxes have a point in common.
inline bool BoxesMeet(const Box& a, const Box& b)
{
  return a.Low[0] <= b.High[0] && b.Low[0] <= a.High[0] && a.Low[1] <= b.High[1] &&
         b.Low[1] <= a.High[1] && a.Low[2] <= b.High[2] && b.Low[2] <= a.High[2];
}

inline Box TriangleBox(const std::vector<Vec3>& points, const Triangle& t)
{
  Box box;
  for (Index v : t)
  {
    box.Extend(points[v]);
  }
  return box;
}

/// Complete binary tree over the triangles in Morton order, a few in each leaf. Boxes aren't
/// rounded. The order of visits depends on the input only. Queries are const and may run in
/// parallel.
class BoxTree
{
public:
  BoxTree(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);

  std::size_t NumberOfLeaves() const { return this->Leaves; }

  /// visit(first, second), triangle ids, for every pair with overlapping boxes of which one is in
  /// @a leaf and the other in the same or a later one, until visit returns false.
  template <typename Visitor>
  void VisitPairs(std::size_t leaf, const Visitor& visit) const
  {
    this->VisitLeaves(leaf, this->Nodes[this->FirstLeaf + leaf],
      [&](std::size_t other)
      {
        const std::size_t end = this->End(leaf);
        const std::size_t otherEnd = this->End(other);
        for (std::size_t i = leaf * LeafSize; i < end; ++i)
        {
          for (std::size_t j = leaf == other ? i + 1 : other * LeafSize; j < otherEnd; ++j)
          {
            if (BoxesMeet(this->Boxes[i], this->Boxes[j]) && !visit(this->Order[i], this->Order[j]))
            {
              return false;
            }
          }
        }
        return true;
      });
  }

  /// visit(id) for every triangle whose box meets @a box.
  template <typename Visitor>
  void VisitBox(const Box& box, const Visitor& visit) const
  {
    this->VisitLeaves(0, box,
      [&](std::size_t leaf)
      {
        for (std::size_t i = leaf * LeafSize; i < this->End(leaf); ++i)
        {
          if (BoxesMeet(this->Boxes[i], box))
          {
            visit(this->Order[i]);
          }
        }
        return true;
      });
  }

private:
  static constexpr std::size_t LeafSize = 4;

  std::size_t End(std::size_t leaf) const
  {
    return std::min((leaf + 1) * LeafSize, this->Order.size());
  }

  /// visit(leaf) for leaves from @a firstLeaf on that meet @a box, until visit returns false.
  template <typename Visitor>
  void VisitLeaves(std::size_t firstLeaf, const Box& box, const Visitor& visit) const
  {
    std::size_t stack[128];
    int size = 0;
    stack[size++] = 1;
    while (size > 0)
    {
      const std::size_t node = stack[--size];
      if (!BoxesMeet(this->Nodes[node], box))
      {
        continue;
      }
      if (node >= this->FirstLeaf)
      {
        if (!visit(node - this->FirstLeaf))
        {
          return;
        }
        continue;
      }
      for (std::size_t child : { 2 * node + 1, 2 * node })
      {
        // The last leaf under a node is found by always going right.
        std::size_t last = child;
        while (last < this->FirstLeaf)
        {
          last = 2 * last + 1;
        }
        if (last - this->FirstLeaf >= firstLeaf)
        {
          stack[size++] = child;
        }
      }
    }
  }

  std::vector<Index> Order; ///< triangle ids, along the Morton curve
  std::vector<Box> Boxes;   ///< in the same order
  std::vector<Box> Nodes;   ///< heap: children of n are 2n and 2n + 1, root 1
  std::size_t Leaves = 0;
  std::size_t FirstLeaf = 1;
};
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "BoxTree.h"

#include "MortonCode.h"

namespace featurehex
{
namespace
{
void Join(Box& box, const Box& other)
{
  box.Low = box.Low.cwiseMin(other.Low);
  box.High = box.High.cwiseMax(other.High);
}
} // namespace

BoxTree::BoxTree(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
{
  std::vector<Box> boxes(triangles.size());
  Box whole;
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    boxes[t] = TriangleBox(points, triangles[t]);
    Join(whole, boxes[t]);
  }
  constexpr double cells = 2097151.0; // 2^21 - 1
  const Vec3 scale = cells * whole.Size().cwiseMax(1e-290).cwiseInverse();
  std::vector<std::pair<std::uint64_t, Index>> codes(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    const Vec3 cell = (boxes[t].Center() - whole.Low).cwiseProduct(scale);
    std::uint64_t code = 0;
    for (int k = 0; k < 3; ++k)
    {
      code |= SpreadBits(static_cast<std::uint64_t>(std::clamp(cell[k], 0.0, cells))) << k;
    }
    codes[t] = { code, static_cast<Index>(t) };
  }
  std::sort(codes.begin(), codes.end());
  this->Order.resize(triangles.size());
  this->Boxes.resize(triangles.size());
  for (std::size_t k = 0; k < codes.size(); ++k)
  {
    this->Order[k] = codes[k].second;
    this->Boxes[k] = boxes[codes[k].second];
  }
  this->Leaves = (triangles.size() + LeafSize - 1) / LeafSize;
  while (this->FirstLeaf < this->Leaves)
  {
    this->FirstLeaf *= 2;
  }
  this->Nodes.resize(2 * this->FirstLeaf);
  for (std::size_t k = 0; k < this->Order.size(); ++k)
  {
    Join(this->Nodes[this->FirstLeaf + k / LeafSize], this->Boxes[k]);
  }
  for (std::size_t node = this->FirstLeaf - 1; node > 0; --node)
  {
    Join(this->Nodes[node], this->Nodes[2 * node]);
    Join(this->Nodes[node], this->Nodes[2 * node + 1]);
  }
}
} // namespace featurehex

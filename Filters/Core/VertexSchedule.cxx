// SPDX-License-Identifier: BSD-3-Clause
#include "VertexSchedule.h"

#include <algorithm>

namespace featurehex
{
namespace
{
/// Blocks with a vertex within @a rings hexes of block @a block, itself excluded, ascending.
std::vector<Index> NeighborBlocks(const std::vector<Hex>& hexes, const IdLists& hexesOfVertex,
  Index block, Index blockSize, int rings, std::vector<Index>& visited)
{
  const Index vertexCount = hexesOfVertex.size();
  std::vector<Index> front;
  for (Index v = block * blockSize; v < std::min((block + 1) * blockSize, vertexCount); ++v)
  {
    visited[v] = block;
    front.push_back(v);
  }
  std::vector<Index> found;
  for (int ring = 0; ring < rings; ++ring)
  {
    std::vector<Index> next;
    for (Index v : front)
    {
      for (Index h : hexesOfVertex[v])
      {
        for (Index u : hexes[h])
        {
          if (visited[u] != block)
          {
            visited[u] = block;
            next.push_back(u);
            found.push_back(u / blockSize);
          }
        }
      }
    }
    front.swap(next);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}
}

VertexSchedule::VertexSchedule(
  const std::vector<Hex>& hexes, const IdLists& hexesOfVertex, int rings)
{
  const Index vertexCount = hexesOfVertex.size();
  const Index blockSize = std::clamp(vertexCount / 64, 32, 512);
  const Index blockCount = (vertexCount + blockSize - 1) / blockSize;
  std::vector<Index> color(blockCount, -1);
  std::vector<Index> visited(vertexCount, -1);
  for (Index block = 0; block < blockCount; ++block)
  {
    std::vector<bool> used(this->Colors.size() + 1, false);
    for (Index other : NeighborBlocks(hexes, hexesOfVertex, block, blockSize, rings, visited))
    {
      if (other != block && color[other] >= 0)
      {
        used[color[other]] = true;
      }
    }
    const auto free = std::find(used.begin(), used.end(), false) - used.begin();
    if (free == static_cast<std::ptrdiff_t>(this->Colors.size()))
    {
      this->Colors.emplace_back();
    }
    color[block] = static_cast<Index>(free);
    this->Colors[free].push_back(
      { block * blockSize, std::min((block + 1) * blockSize, vertexCount) });
  }
}
}

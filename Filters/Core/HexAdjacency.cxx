// SPDX-License-Identifier: BSD-3-Clause
#include "HexAdjacency.h"

#include "Parallel.h"

#include <algorithm>

namespace featurehex
{
namespace
{
bool Contains(const Hex& hex, Index vertex)
{
  return std::find(hex.begin(), hex.end(), vertex) != hex.end();
}
}

std::vector<std::array<Index, 6>> FaceNeighbors(
  const std::vector<Hex>& hexes, const IdLists& hexesOfVertex)
{
  std::vector<std::array<Index, 6>> neighbors(hexes.size());
  ParallelFor(hexes.size(), 4096, [&](std::size_t h) {
    for (int f = 0; f < 6; ++f)
    {
      const Index a = hexes[h][HexFaces[f][0]];
      const Index b = hexes[h][HexFaces[f][1]];
      const Index c = hexes[h][HexFaces[f][2]];
      const Index d = hexes[h][HexFaces[f][3]];
      neighbors[h][f] = -1;
      for (Index other : hexesOfVertex[a])
      {
        if (other != static_cast<Index>(h) && Contains(hexes[other], c) &&
          Contains(hexes[other], b) && Contains(hexes[other], d))
        {
          neighbors[h][f] = other;
          break;
        }
      }
    }
  });
  return neighbors;
}

std::vector<BoundaryQuad> BoundaryQuads(
  const std::vector<Hex>& hexes, const std::vector<std::array<Index, 6>>& neighbors)
{
  std::vector<BoundaryQuad> quads;
  for (std::size_t h = 0; h < hexes.size(); ++h)
  {
    for (int f = 0; f < 6; ++f)
    {
      if (neighbors[h][f] < 0)
      {
        Quad q;
        for (int k = 0; k < 4; ++k)
        {
          q[k] = hexes[h][HexFaces[f][k]];
        }
        quads.push_back({ q, static_cast<Index>(h), f });
      }
    }
  }
  return quads;
}
}

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What surrounds each vertex of a hex mesh while its points move and its connectivity stays.

#ifndef featurehex_HexStars_h
#define featurehex_HexStars_h

#include "HexAdjacency.h"

namespace featurehex
{
/// For corner c of a hex and its r-th neighbour n: the other two neighbours of n, so that
/// (c, First, Second) seen from n is positively oriented.
struct NeighborCorner
{
  int Vertex, First, Second;
};

constexpr std::array<std::array<NeighborCorner, 3>, 8> MakeNeighborCorners()
{
  std::array<std::array<NeighborCorner, 3>, 8> table{};
  for (int c = 0; c < 8; ++c)
  {
    for (int r = 0; r < 3; ++r)
    {
      const int n = HexCornerNeighbors[c][r];
      int slot = 0;
      while (HexCornerNeighbors[n][slot] != c)
      {
        ++slot;
      }
      table[c][r] = { n, HexCornerNeighbors[n][(slot + 1) % 3],
        HexCornerNeighbors[n][(slot + 2) % 3] };
    }
  }
  return table;
}

constexpr std::array<std::array<NeighborCorner, 3>, 8> NeighborCorners = MakeNeighborCorners();

/// Stars of the vertices of a hex mesh: incident hexes with the vertex's corner in each, boundary
/// quads.
struct HexStars
{
  IdLists Hexes;                     ///< hexes of each vertex
  std::vector<std::uint8_t> Corners; ///< parallel to Hexes.Ids: which corner the vertex is
  std::vector<Quad> Quads;           ///< boundary quads, outward
  std::vector<Index> QuadOwners;     ///< hex of each boundary quad
  IdLists QuadsOfVertex;             ///< boundary quads of each vertex
  IdLists QuadNeighbors;             ///< boundary quads that share a vertex with each boundary quad

  HexStars() = default;
  explicit HexStars(const HexMesh& mesh);

  bool OnBoundary(Index v) const { return this->QuadsOfVertex[v].size() > 0; }
};

/// Marks the vertices of the hexes round marked vertices, this many times.
void MarkRings(const HexMesh& mesh, int rings, std::vector<char>& marked);
}

#endif

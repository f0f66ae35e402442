// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Who is next to whom in a hex mesh: hexes of a vertex, hex across a face, boundary quads.

#ifndef featurehex_HexAdjacency_h
#define featurehex_HexAdjacency_h

#include "Types.h"

namespace featurehex
{
/// Lists of ids of varying length, stored one after another (compressed rows).
struct IdLists
{
  std::vector<Index> Offsets; ///< size() + 1 entries
  std::vector<Index> Ids;

  /// The ids of one list.
  struct Range
  {
    const Index* First;
    const Index* Last;
    const Index* begin() const { return this->First; }
    const Index* end() const { return this->Last; }
    Index size() const { return static_cast<Index>(this->Last - this->First); }
    Index operator[](Index i) const { return this->First[i]; }
  };
  Range operator[](Index i) const
  {
    return { this->Ids.data() + this->Offsets[i], this->Ids.data() + this->Offsets[i + 1] };
  }
  Index size() const { return static_cast<Index>(this->Offsets.size()) - 1; }
};

/// For each vertex the cells (hexes, quads) that use it, ascending.
template <typename Cell>
IdLists CellsOfVertices(const std::vector<Cell>& cells, std::size_t vertexCount)
{
  IdLists lists;
  lists.Offsets.assign(vertexCount + 1, 0);
  for (const Cell& cell : cells)
  {
    for (Index v : cell)
    {
      ++lists.Offsets[v + 1];
    }
  }
  for (std::size_t v = 0; v < vertexCount; ++v)
  {
    lists.Offsets[v + 1] += lists.Offsets[v];
  }
  lists.Ids.resize(lists.Offsets.back());
  std::vector<Index> next(lists.Offsets.begin(), lists.Offsets.end() - 1);
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    for (Index v : cells[c])
    {
      lists.Ids[next[v]++] = static_cast<Index>(c);
    }
  }
  return lists;
}

/// For each hex the hex across each of its faces (order of HexFaces), -1 on the boundary.
/// Precondition: no face belongs to more than two hexes.
std::vector<std::array<Index, 6>> FaceNeighbors(
  const std::vector<Hex>& hexes, const IdLists& hexesOfVertex);

/// A face of exactly one hex, seen counter-clockwise from outside.
struct BoundaryQuad
{
  Quad Vertices;
  Index Owner; ///< the hex
  int Face;    ///< row of HexFaces
};

/// Boundary quads in the order of their hexes.
std::vector<BoundaryQuad> BoundaryQuads(
  const std::vector<Hex>& hexes, const std::vector<std::array<Index, 6>>& neighbors);
}

#endif

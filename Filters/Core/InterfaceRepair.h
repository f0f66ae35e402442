// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Make the interface between inside and outside hexes a manifold by flipping few hexes.

#ifndef featurehex_InterfaceRepair_h
#define featurehex_InterfaceRepair_h

#include "HexAdjacency.h"
#include "Status.h"
#include "Types.h"

#include <vector>

namespace featurehex
{
/// A quad between the solid and the outside, seen counter-clockwise from outside the solid.
struct InterfaceQuad
{
  Quad Vertices;
  Index Inside; ///< the hex in the solid
};

/// A hex mesh with who is next to whom, computed once for labelling, repair and comparison.
struct HexGraph
{
  const HexMesh& Mesh;
  IdLists HexesOfVertex;
  std::vector<std::array<Index, 6>> Neighbors;

  explicit HexGraph(const HexMesh& mesh)
    : Mesh(mesh)
    , HexesOfVertex(CellsOfVertices(mesh.Hexes, mesh.Points.size()))
    , Neighbors(FaceNeighbors(mesh.Hexes, this->HexesOfVertex))
  {
  }
};

/// InvalidMesh unless there are hexes, all ids exist and all points they use are finite.
Status CheckHexInput(const HexMesh& mesh);

/// Quads between hexes with a label > 0 and others or the border of the mesh, in the order of their
/// inside hexes.
template <typename Label>
std::vector<InterfaceQuad> InterfaceQuads(const HexMesh& mesh,
  const std::vector<std::array<Index, 6>>& neighbors, const std::vector<Label>& labels)
{
  std::vector<InterfaceQuad> quads;
  for (std::size_t h = 0; h < mesh.Hexes.size(); ++h)
  {
    for (int f = 0; labels[h] > 0 && f < 6; ++f)
    {
      const Index other = neighbors[h][f];
      if (other < 0 || !(labels[other] > 0))
      {
        const Hex& hex = mesh.Hexes[h];
        const int* face = HexFaces[f];
        quads.push_back({ { hex[face[0]], hex[face[1]], hex[face[2]], hex[face[3]] },
          static_cast<Index>(h) });
      }
    }
  }
  return quads;
}

/// True when the hexes inside, or the hexes outside, are more than one face-connected group at the
/// vertex. @a inside: 0 or 1 per hex.
bool IsNonManifold(const HexGraph& graph, const std::vector<char>& inside, Index vertex);

/// All such vertices, ascending. Without any the interface is a manifold: an edge with four
/// interface quads has such vertices too.
std::vector<Index> NonManifoldVertices(const HexGraph& graph, const std::vector<char>& inside);

/// What the repair of the interface did.
struct RepairResult
{
  Index Flips = 0;
  std::vector<Index> NonManifoldVertices; ///< left; none unless the bound on the flips was reached
};

/// Flip hexes, adding and removing, until no vertex is non-manifold: at the lowest bad vertex the
/// hex whose flip makes the fewest bad vertices, then the hex whose centre is nearest to the
/// surface, never the same hex over and over. Hexes with a vertex on the border of the mesh stay
/// outside. @a signedDistance: of the hex centres in local cell sizes, negative inside.
RepairResult RepairInterface(const HexGraph& graph, const std::vector<double>& signedDistance,
  Index maximumFlips, std::vector<char>& inside);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "HexStars.h"

#include <algorithm>

namespace featurehex
{
HexStars::HexStars(const HexMesh& mesh)
  : Hexes(CellsOfVertices(mesh.Hexes, mesh.Points.size()))
{
  this->Corners.resize(this->Hexes.Ids.size());
  for (Index v = 0; v < this->Hexes.size(); ++v)
  {
    for (Index i = this->Hexes.Offsets[v]; i < this->Hexes.Offsets[v + 1]; ++i)
    {
      const Hex& hex = mesh.Hexes[this->Hexes.Ids[i]];
      this->Corners[i] =
        static_cast<std::uint8_t>(std::find(hex.begin(), hex.end(), v) - hex.begin());
    }
  }
  for (const BoundaryQuad& quad :
    BoundaryQuads(mesh.Hexes, FaceNeighbors(mesh.Hexes, this->Hexes)))
  {
    this->Quads.push_back(quad.Vertices);
    this->QuadOwners.push_back(quad.Owner);
  }
  this->QuadsOfVertex = CellsOfVertices(this->Quads, mesh.Points.size());

  this->QuadNeighbors.Offsets.push_back(0);
  std::vector<Index> around;
  for (std::size_t q = 0; q < this->Quads.size(); ++q)
  {
    around.clear();
    for (Index v : this->Quads[q])
    {
      for (Index other : this->QuadsOfVertex[v])
      {
        around.push_back(other);
      }
    }
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
    around.erase(std::find(around.begin(), around.end(), static_cast<Index>(q)));
    this->QuadNeighbors.Ids.insert(this->QuadNeighbors.Ids.end(), around.begin(), around.end());
    this->QuadNeighbors.Offsets.push_back(static_cast<Index>(this->QuadNeighbors.Ids.size()));
  }
}

void MarkRings(const HexMesh& mesh, int rings, std::vector<char>& marked)
{
  for (int ring = 0; ring < rings; ++ring)
  {
    const std::vector<char> before = marked;
    for (const Hex& hex : mesh.Hexes)
    {
      if (std::any_of(hex.begin(), hex.end(), [&before](Index v) { return before[v] != 0; }))
      {
        for (Index v : hex)
        {
          marked[v] = 1;
        }
      }
    }
  }
}
}

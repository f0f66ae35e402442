// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Regular grids of unit hexes with labels that a function of the position gives.

#ifndef featurehex_HexGrids_h
#define featurehex_HexGrids_h

#include "InterfaceRepair.h"
#include "IslandRepair.h"

#include <functional>

namespace hexgrids
{
using namespace featurehex;

/// n x n x n unit hexes, x fastest.
inline HexMesh Grid(int n)
{
  HexMesh mesh;
  const int p = n + 1;
  for (int z = 0; z < p; ++z)
  {
    for (int y = 0; y < p; ++y)
    {
      for (int x = 0; x < p; ++x)
      {
        mesh.Points.push_back(Vec3(x, y, z));
        if (x < n && y < n && z < n)
        {
          const Index v = x + p * (y + p * z);
          mesh.Hexes.push_back({ v, v + 1, v + p + 1, v + p, v + p * p, v + p * p + 1,
            v + p * p + p + 1, v + p * p + p });
        }
      }
    }
  }
  return mesh;
}

/// 1 where @a solid is true at the hex's integer position.
inline std::vector<char> Labels(int n, const std::function<bool(int, int, int)>& solid)
{
  std::vector<char> inside;
  for (int h = 0; h < n * n * n; ++h)
  {
    inside.push_back(solid(h % n, h / n % n, h / n / n));
  }
  return inside;
}

/// Every hex is @a distance from triangle 0, on the side of its label.
inline HexDistances Distances(const std::vector<char>& inside, double distance)
{
  HexDistances distances;
  for (char label : inside)
  {
    distances.Signed.push_back(label ? -distance : distance);
    distances.Triangles.push_back(0);
  }
  return distances;
}

/// Shells of the interface of the labels.
inline Shells InterfaceShells(const HexGraph& graph, const std::vector<char>& inside)
{
  std::vector<Quad> quads;
  for (const InterfaceQuad& quad : InterfaceQuads(graph.Mesh, graph.Neighbors, inside))
  {
    quads.push_back(quad.Vertices);
  }
  return FindShells(graph.Mesh.Points, quads);
}

/// One solid shell to which triangle 0 belongs.
inline Shells OneShell()
{
  Shells shells;
  shells.List.push_back({ 2, 1.0, 1, Vec3::Zero() });
  shells.OfFace.push_back(0);
  return shells;
}
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The tangled hex meshes of the shared test data, and tangled grids made on the spot.

#ifndef featurehex_Testing_TangledMesh_h
#define featurehex_Testing_TangledMesh_h

#include "ValidationShapes.h"

#include <fstream>
#include <random>
#include <string>

namespace featurehex
{
/// Reads an ASCII legacy VTK file that holds hexes only; false when there is none at @a path.
inline bool ReadTangledMesh(const std::string& path, HexMesh& mesh)
{
  std::ifstream file(path);
  std::string word;
  std::size_t count = 0;
  while (file >> word && word != "POINTS")
  {
  }
  file >> count >> word;
  mesh.Points.assign(count, Vec3::Zero());
  for (Vec3& p : mesh.Points)
  {
    file >> p[0] >> p[1] >> p[2];
  }
  file >> word >> count >> word;
  mesh.Hexes.assign(file ? count : 0, Hex());
  for (Hex& hex : mesh.Hexes)
  {
    file >> count;
    for (Index& v : hex)
    {
      file >> v;
    }
  }
  return static_cast<bool>(file) && !mesh.Hexes.empty();
}

/// n x n x n unit cubes; the points inside are displaced by up to @a reach in each direction.
inline HexMesh TangledGrid(int n, double reach, unsigned seed = 1)
{
  HexMesh mesh = CubeMesh(n);
  std::mt19937 random(seed);
  // Not a standard distribution: their bits differ between libraries.
  const auto displacement = [&] { return reach * (2.0 * random() / 4294967295.0 - 1.0); };
  for (Vec3& p : mesh.Points)
  {
    if (p.minCoeff() > 0 && p.maxCoeff() < n)
    {
      p[0] += displacement();
      p[1] += displacement();
      p[2] += displacement();
    }
  }
  return mesh;
}
}

#endif

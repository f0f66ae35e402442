// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Small meshes with known truths for the tests of the validation.

#ifndef featurehex_Testing_ValidationShapes_h
#define featurehex_Testing_ValidationShapes_h

#include "Types.h"

#include <cmath>
#include <functional>
#include <map>

namespace featurehex
{
/// Unit cubes of an n[0] x n[1] x n[2] lattice that @a inside(i, j, k) keeps; no orphan points.
inline HexMesh LatticeMesh(
  const std::array<int, 3>& n, const std::function<bool(int, int, int)>& inside)
{
  HexMesh mesh;
  std::map<std::array<int, 3>, Index> ids;
  const auto point = [&](int i, int j, int k) {
    const auto [it, fresh] = ids.insert({ { i, j, k }, static_cast<Index>(mesh.Points.size()) });
    if (fresh)
    {
      mesh.Points.emplace_back(i, j, k);
    }
    return it->second;
  };
  for (int k = 0; k < n[2]; ++k)
  {
    for (int j = 0; j < n[1]; ++j)
    {
      for (int i = 0; i < n[0]; ++i)
      {
        if (inside(i, j, k))
        {
          mesh.Hexes.push_back({ point(i, j, k), point(i + 1, j, k), point(i + 1, j + 1, k),
            point(i, j + 1, k), point(i, j, k + 1), point(i + 1, j, k + 1),
            point(i + 1, j + 1, k + 1), point(i, j + 1, k + 1) });
        }
      }
    }
  }
  return mesh;
}

/// n x n x n cubes of a lattice.
inline HexMesh CubeMesh(int n)
{
  return LatticeMesh({ n, n, n }, [](int, int, int) { return true; });
}

/// Ball of radius 1: the lattice cube [-1, 1]^3 mapped smoothly onto it.
inline HexMesh BallMesh(int n, double radius = 1.0)
{
  HexMesh mesh = CubeMesh(n);
  for (Vec3& p : mesh.Points)
  {
    const Vec3 c = (2.0 / n) * p - Vec3::Ones();
    const Vec3 q = c.cwiseProduct(c);
    p = radius *
      Vec3(c.x() * std::sqrt(1 - q.y() / 2 - q.z() / 2 + q.y() * q.z() / 3),
        c.y() * std::sqrt(1 - q.z() / 2 - q.x() / 2 + q.z() * q.x() / 3),
        c.z() * std::sqrt(1 - q.x() / 2 - q.y() / 2 + q.x() * q.y() / 3));
  }
  return mesh;
}

/// Sphere of latitudes and longitudes, outward.
inline SurfaceMesh SphereSurface(int rings, double radius = 1.0, const Vec3& center = Vec3::Zero())
{
  SurfaceMesh s;
  const int sectors = 2 * rings;
  const double pi = std::acos(-1.0);
  s.Points.push_back(center + Vec3(0, 0, radius));
  for (int i = 1; i < rings; ++i)
  {
    for (int j = 0; j < sectors; ++j)
    {
      const double a = pi * i / rings, b = 2 * pi * j / sectors;
      s.Points.push_back(
        center + radius * Vec3(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)));
    }
  }
  s.Points.push_back(center - Vec3(0, 0, radius));
  const Index last = static_cast<Index>(s.Points.size()) - 1;
  const auto at = [&](int i, int j)
  { return static_cast<Index>(1 + (i - 1) * sectors + j % sectors); };
  for (int j = 0; j < sectors; ++j)
  {
    s.Triangles.push_back({ 0, at(1, j), at(1, j + 1) });
    s.Triangles.push_back({ last, at(rings - 1, j + 1), at(rings - 1, j) });
    for (int i = 1; i + 1 < rings; ++i)
    {
      s.Triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      s.Triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return s;
}

/// Torus around the z axis, outward.
inline SurfaceMesh TorusSurface(int around, int tube, double large = 1.0, double small = 0.4)
{
  SurfaceMesh s;
  const double tau = 2 * std::acos(-1.0);
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < tube; ++j)
    {
      const double a = tau * i / around, b = tau * j / tube, r = large + small * std::cos(b);
      s.Points.emplace_back(r * std::cos(a), r * std::sin(a), small * std::sin(b));
    }
  }
  const auto at = [&](int i, int j) { return static_cast<Index>((i % around) * tube + j % tube); };
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < tube; ++j)
    {
      s.Triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      s.Triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return s;
}

/// The unit cube; points by bits of their id: 1 x, 2 y, 4 z. Each face is cut by one diagonal.
inline SurfaceMesh CubeSurface()
{
  SurfaceMesh cube;
  for (int i = 0; i < 8; ++i)
  {
    cube.Points.push_back(Vec3(i & 1, i >> 1 & 1, i >> 2));
  }
  cube.Triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  return cube;
}

/// Quads as triangles, both halves of the diagonal 0-2, on the same points.
inline SurfaceMesh SplitQuads(const std::vector<Vec3>& points, const std::vector<Quad>& quads)
{
  SurfaceMesh s;
  s.Points = points;
  for (const Quad& q : quads)
  {
    s.Triangles.push_back({ q[0], q[1], q[2] });
    s.Triangles.push_back({ q[0], q[2], q[3] });
  }
  return s;
}
}

#endif

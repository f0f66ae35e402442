// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Plain data that the core algorithms exchange: points, triangles, quads and hexahedra by index.

#ifndef featurehex_Types_h
#define featurehex_Types_h

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <vector>

namespace featurehex
{
using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Id of a point, triangle, quad or hex. 32 bits: halves the memory of the connectivity.
using Index = std::int32_t;

using Triangle = std::array<Index, 3>;
using Quad = std::array<Index, 4>;
using Hex = std::array<Index, 8>;

/// Triangle surface in model units. Closed and outward oriented once it has passed CheckSurface().
struct SurfaceMesh
{
  std::vector<Vec3> Points;
  std::vector<Triangle> Triangles;
};

/// Hexahedral mesh, vertex order of VTK_HEXAHEDRON.
struct HexMesh
{
  std::vector<Vec3> Points;
  std::vector<Hex> Hexes;
};

/// Axis-aligned box; empty until the first Extend().
struct Box
{
  Vec3 Low = Vec3::Constant(1e300);
  Vec3 High = Vec3::Constant(-1e300);

  void Extend(const Vec3& p)
  {
    this->Low = this->Low.cwiseMin(p);
    this->High = this->High.cwiseMax(p);
  }
  bool Empty() const { return (this->Low.array() > this->High.array()).any(); }
  Vec3 Size() const { return this->High - this->Low; }
  Vec3 Center() const { return 0.5 * (this->Low + this->High); }
  double Diagonal() const { return this->Empty() ? 0.0 : this->Size().norm(); }
};

/// Box of the points that the triangles use.
inline Box BoundingBox(const SurfaceMesh& surface)
{
  Box box;
  for (const Triangle& t : surface.Triangles)
  {
    for (Index v : t)
    {
      box.Extend(surface.Points[v]);
    }
  }
  return box;
}

/// The three edge neighbours of each hex corner, ordered so that det(e0, e1, e2) > 0 for a valid
/// hex.
constexpr int HexCornerNeighbors[8][3] = { { 1, 3, 4 }, { 2, 0, 5 }, { 3, 1, 6 }, { 0, 2, 7 },
  { 7, 5, 0 }, { 4, 6, 1 }, { 5, 7, 2 }, { 6, 4, 3 } };

/// The six faces of a hex, each seen counter-clockwise from outside.
constexpr int HexFaces[6][4] = { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 }, { 1, 2, 6, 5 },
  { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };

/// The twelve edges of a hex.
constexpr int HexEdges[12][2] = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 },
  { 6, 7 }, { 7, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Closed surfaces of known topology and hex grids round them, for the tests of stages 4 and 6.

#ifndef featurehex_DomainShapes_h
#define featurehex_DomainShapes_h

#include "MeshTopology.h"
#include "OctreeDual.h"
#include "SharedData.h"
#include "SurfaceReader.h"
#include "TriangleSearch.h"
#include "WindingNumber.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <map>
#include <string>

namespace domainshapes
{
using namespace featurehex;

constexpr double Pi = 3.14159265358979323846;

/// Grid of n x m quads cut in triangles; @a position(i, j) for i in [0, n), j in [0, m), both
/// periodic.
inline SurfaceMesh PeriodicGrid(int n, int m, const std::function<Vec3(double, double)>& position)
{
  SurfaceMesh mesh;
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < m; ++j)
    {
      mesh.Points.push_back(position(2 * Pi * i / n, 2 * Pi * j / m));
      const Index a = i * m + j;
      const Index b = (i + 1) % n * m + j;
      const Index c = (i + 1) % n * m + (j + 1) % m;
      const Index d = i * m + (j + 1) % m;
      mesh.Triangles.push_back({ a, b, c });
      mesh.Triangles.push_back({ a, c, d });
    }
  }
  return mesh;
}

inline SurfaceMesh Torus(double radius, double tube, int n = 48, int m = 24)
{
  return PeriodicGrid(n, m, [=](double u, double v) {
    const double r = radius + tube * std::cos(v);
    return Vec3(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
  });
}

/// A cube of divisions x divisions quads a side, blown up.
inline SurfaceMesh Ellipsoid(const Vec3& center, const Vec3& radii, int divisions = 12)
{
  SurfaceMesh mesh;
  std::map<std::array<int, 3>, Index> ids;
  const auto point = [&](int axis, int side, int u, int v) {
    std::array<int, 3> key;
    key[axis] = side;
    key[(axis + 1) % 3] = u;
    key[(axis + 2) % 3] = v;
    const auto [entry, fresh] = ids.insert({ key, static_cast<Index>(mesh.Points.size()) });
    if (fresh)
    {
      Vec3 direction;
      for (int k = 0; k < 3; ++k)
      {
        direction[k] = std::tan(Pi / 4 * key[k] / divisions);
      }
      mesh.Points.push_back(center + radii.cwiseProduct(direction.normalized()));
    }
    return entry->second;
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side : { -divisions, divisions })
    {
      for (int u = -divisions; u < divisions; u += 2)
      {
        for (int v = -divisions; v < divisions; v += 2)
        {
          const Index a = point(axis, side, u, v);
          const Index b = point(axis, side, u + 2, v);
          const Index c = point(axis, side, u + 2, v + 2);
          const Index d = point(axis, side, u, v + 2);
          mesh.Triangles.push_back(side > 0 ? Triangle{ a, b, c } : Triangle{ a, c, b });
          mesh.Triangles.push_back(side > 0 ? Triangle{ a, c, d } : Triangle{ a, d, c });
        }
      }
    }
  }
  return mesh;
}

inline SurfaceMesh Sphere(const Vec3& center, double radius, int divisions = 12)
{
  return Ellipsoid(center, Vec3::Constant(radius), divisions);
}

/// Axis-aligned box of two triangles a side.
inline SurfaceMesh BoxSurface(const Vec3& low, const Vec3& high)
{
  SurfaceMesh mesh;
  for (int i = 0; i < 8; ++i)
  {
    mesh.Points.push_back(Vec3((i & 1 ? high : low)[0], (i & 2 ? high : low)[1],
      (i & 4 ? high : low)[2]));
  }
  for (const Quad& q : std::vector<Quad>{ { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 1, 5, 4 },
         { 2, 6, 7, 3 }, { 0, 4, 6, 2 }, { 1, 3, 7, 5 } })
  {
    mesh.Triangles.push_back({ q[0], q[1], q[2] });
    mesh.Triangles.push_back({ q[0], q[2], q[3] });
  }
  return mesh;
}

inline SurfaceMesh Flipped(SurfaceMesh mesh)
{
  for (Triangle& t : mesh.Triangles)
  {
    std::swap(t[1], t[2]);
  }
  return mesh;
}

inline SurfaceMesh Together(SurfaceMesh a, const SurfaceMesh& b)
{
  const Index offset = static_cast<Index>(a.Points.size());
  a.Points.insert(a.Points.end(), b.Points.begin(), b.Points.end());
  for (const Triangle& t : b.Triangles)
  {
    a.Triangles.push_back({ t[0] + offset, t[1] + offset, t[2] + offset });
  }
  return a;
}

/// Surface, search and winding number of one shape.
struct Shape
{
  SurfaceMesh Surface;
  TriangleSearch Search;
  WindingNumber Winding;

  explicit Shape(SurfaceMesh surface)
    : Surface(std::move(surface))
    , Search(this->Surface.Points, this->Surface.Triangles)
    , Winding(this->Surface)
  {
  }
  double Diagonal() const { return BoundingBox(this->Surface).Diagonal(); }
};

/// Dual of the octree round a surface.
inline HexMesh DualMesh(const SurfaceMesh& surface, double edgeLength,
  const std::vector<RefinementPoint>& points = {})
{
  Monitor monitor;
  OctreeOptions options;
  options.TargetEdgeLength = edgeLength;
  BlockOctree octree;
  HexMesh mesh;
  const Status built = BuildBlockOctree(surface, points, options, octree, nullptr, monitor);
  EXPECT_TRUE(built.Ok()) << built.Message;
  const Status converted = ConvertOctreeToHexes(octree, mesh, nullptr, monitor);
  EXPECT_TRUE(converted.Ok()) << converted.Message;
  return mesh;
}

/// A real scan; no points when the test data isn't there.
inline SurfaceMesh Scan(const std::string& name)
{
  const std::string path = SharedData() / "surfaces/organic" / (name + ".obj");
  SurfaceMesh mesh;
  if (std::filesystem::exists(path))
  {
    const Status status = ReadSurface(path, mesh);
    EXPECT_TRUE(status.Ok()) << status.Message;
  }
  return mesh;
}
}

#endif

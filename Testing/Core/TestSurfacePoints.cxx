// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePoints.h"

#include <gtest/gtest.h>

using namespace featurehex;

namespace
{
/// A tetrahedron; point 1 is used by no triangle and lies where point 3 does.
SurfaceMesh Tetrahedron()
{
  SurfaceMesh mesh;
  mesh.Points = { Vec3(0, 0, 0), Vec3(0, 3, 0), Vec3(3, 0, 0), Vec3(0, 3, 0), Vec3(0, 0, 3) };
  mesh.Triangles = { { 0, 3, 2 }, { 0, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } };
  return mesh;
}
using Ids = std::vector<Index>;
} // namespace

TEST(SurfacePoints, ByPlace)
{
  const SurfaceMesh mesh = Tetrahedron();
  const std::vector<Vec3> places = { Vec3(0, 3, 0), Vec3(3 + 2e-6, 0, 0), Vec3(3 + 2e-5, 0, 0) };
  EXPECT_EQ(RecognizeSurfacePoints(mesh, places, {}), (Ids{ 3, 2, -1 }));
  EXPECT_TRUE(RecognizeSurfacePoints(mesh, {}, {}).empty());
  // Names that disagree with a place are not believed.
  EXPECT_EQ(RecognizeSurfacePoints(mesh, places, { 3, 0, 4 }), (Ids{ 3, 2, -1 }));
  EXPECT_EQ(RecognizeSurfacePoints(mesh, { Vec3(0, 0, 3) }, { 2 }), (Ids{ 4 }));
}

TEST(SurfacePoints, ByName)
{
  const SurfaceMesh mesh = Tetrahedron();
  EXPECT_EQ(
    RecognizeSurfacePoints(mesh, { Vec3(0, 3, 0), Vec3(0, 0, 0) }, { 1, 0 }), (Ids{ 1, 0 }));
  // Without coordinates.
  EXPECT_EQ(
    RecognizeSurfacePoints(mesh, { Vec3(0, 0, 0), Vec3(0, 0, 0), Vec3(0, 0, 0) }, { 2, 4, 5 }),
    (Ids{ 2, 4, -1 }));
}

TEST(SurfacePoints, Errors)
{
  const std::vector<Vec3> places = { Vec3(1, 2, 3) };
  const Status status = UnknownSurfacePoint(0, places);
  EXPECT_EQ(status.Code, StatusCode::IndexOutOfRange);
  EXPECT_NE(status.Message.find("at (1, 2, 3), is no point of the surface"), std::string::npos);
  EXPECT_EQ(status.Where.size(), 1u);
  EXPECT_NE(UnknownSurfacePoint(7, places).Message.find("point 7 of 1"), std::string::npos);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "GridFit.h"

#include "DomainShapes.h"

#include <gtest/gtest.h>

using namespace domainshapes;

namespace
{
constexpr double Nowhere = 99.0; // what the caller would take

/// How far the position is from a plane of cell centres, in cells.
double CellsOff(double position, double plane, double size)
{
  return std::abs(std::remainder(position - plane, size)) / size;
}

/// A tetrahedron with one face at a height.
SurfaceMesh Tetrahedron(double height)
{
  SurfaceMesh mesh;
  mesh.Points = { { 0, 0, height }, { 1, 0, height }, { 0, 1, height }, { 0.2, 0.3, height - 1 } };
  mesh.Triangles = { { 0, 1, 2 }, { 0, 3, 1 }, { 1, 3, 2 }, { 2, 3, 0 } };
  return mesh;
}

/// Four sloping sides between two squares at 0 and at a height.
SurfaceMesh Frustum(double bottom, double top, double height)
{
  SurfaceMesh mesh = BoxSurface(Vec3(-1, -1, 0), Vec3(1, 1, height));
  for (Vec3& p : mesh.Points)
  {
    p.head<2>() *= 0.5 * (p.z() > 0 ? top : bottom);
  }
  return mesh;
}

Mat3 Rotation(double degrees, const Vec3& axis)
{
  return Eigen::AngleAxisd(degrees * Pi / 180, axis.normalized()).matrix();
}
} // namespace

TEST(GridFit, OnePlane)
{
  for (double height : { 0.3, -17.04, 1e5 + 0.01 })
  {
    const GridFit fit(Tetrahedron(height), Mat3::Identity());
    for (double size : { 0.25, 0.07, 3.0 })
    {
      EXPECT_LT(CellsOff(height, fit.CenterPlane(2, size, Nowhere), size), 0.01)
        << height << " " << size;
    }
    EXPECT_EQ(fit.CenterPlane(0, 0.25, Nowhere), fit.CenterPlane(0, 0.25, 1.0) + 98);
  }
}

TEST(GridFit, FacesAcrossNoAxisCountForNone)
{
  // The tetrahedron also has a face across x and one across y.
  SurfaceMesh mesh = Tetrahedron(0.3);
  mesh.Points[3] = Vec3(0.2, 0.3, -1);
  const GridFit fit(mesh, Mat3::Identity());
  EXPECT_EQ(fit.CenterPlane(0, 0.25, Nowhere), Nowhere);
  EXPECT_EQ(fit.CenterPlane(1, 0.25, Nowhere), Nowhere);
}

TEST(GridFit, TwoFacesALittleMoreThanACellApartAreMetHalfWay)
{
  const GridFit fit(BoxSurface(Vec3(0, 0, 0.2), Vec3(1, 1, 5.3)), Mat3::Identity());
  const double plane = fit.CenterPlane(2, 1.0, Nowhere);
  EXPECT_LT(CellsOff(0.2, plane, 1.0), 0.11);
  EXPECT_LT(CellsOff(5.3, plane, 1.0), 0.11);
}

TEST(GridFit, OfFacesThatDoNotFitTheLargerOneWins)
{
  for (double height : { 5.1, 5.2, 5.3, 5.5, 5.9 })
  {
    const SurfaceMesh larger = Frustum(3, 4, height);
    const double top = GridFit(larger, Mat3::Identity()).CenterPlane(2, 1.0, Nowhere);
    EXPECT_LT(CellsOff(height, top, 1.0), 0.01) << height;
    const SurfaceMesh smaller = Frustum(4, 3, height);
    const double bottom = GridFit(smaller, Mat3::Identity()).CenterPlane(2, 1.0, Nowhere);
    EXPECT_LT(CellsOff(0, bottom, 1.0), 0.01) << height;
  }
}

TEST(GridFit, NothingFlat)
{
  const SurfaceMesh sphere = Sphere(Vec3::Zero(), 10);
  // A small box beside it is no reason either.
  for (const SurfaceMesh& mesh :
    { sphere, Together(sphere, BoxSurface(Vec3(11, 0, 0), Vec3(13, 2, 2.3))), SurfaceMesh() })
  {
    const GridFit fit(mesh, Mat3::Identity());
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_EQ(fit.CenterPlane(axis, 0.7, Nowhere), Nowhere);
    }
    EXPECT_EQ(fit.BestSize(0.7), 0.7);
  }
}

TEST(GridFit, DegenerateTrianglesAreNoFaces)
{
  SurfaceMesh mesh = Sphere(Vec3::Zero(), 1);
  mesh.Triangles.push_back({ 0, 0, 1 });
  mesh.Triangles.push_back({ 2, 2, 2 });
  EXPECT_EQ(GridFit(mesh, Mat3::Identity()).CenterPlane(0, 0.1, Nowhere), Nowhere);
}

TEST(GridFit, BestSizeOfABoxWithACommonDivisor)
{
  const Vec3 sides(3, 2, 1);
  const GridFit fit(BoxSurface(Vec3(0.3, -7, 2), Vec3(0.3, -7, 2) + sides), Mat3::Identity());
  for (double wanted : { 0.3, 0.28, 0.25, 0.125, 1.1 })
  {
    const double size = fit.BestSize(wanted);
    EXPECT_GE(size, 0.8 * wanted - 1e-12);
    EXPECT_LE(size, 1.3 * wanted + 1e-12);
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_LT(CellsOff(sides[axis], 0, size), 0.15) << wanted << ", axis " << axis;
    }
  }
}

TEST(GridFit, BestSizeOfABoxWithoutOneSuitsTheLargestFaces)
{
  const Vec3 sides(3.1, 2, 0.9);
  const GridFit fit(BoxSurface(Vec3::Zero(), sides), Mat3::Identity());
  for (double wanted : { 0.34, 0.31, 0.2, 0.1 })
  {
    const double size = fit.BestSize(wanted);
    EXPECT_GE(size, 0.8 * wanted - 1e-12);
    EXPECT_LE(size, 1.3 * wanted + 1e-12);
    EXPECT_LT(CellsOff(sides[2], 0, size), 0.2) << wanted;
  }
}

TEST(GridFit, SizesThatFitStay)
{
  const GridFit fit(BoxSurface(Vec3::Zero(), Vec3(3, 2, 1)), Mat3::Identity());
  EXPECT_EQ(fit.BestSize(0.25), 0.25);
  EXPECT_EQ(fit.BestSize(0.5), 0.5);
}

TEST(GridFit, AxesMayBeTurned)
{
  const Vec3 sides(3, 2, 1);
  SurfaceMesh box = BoxSurface(Vec3(0.4, 0.1, -0.3), Vec3(0.4, 0.1, -0.3) + sides);
  const GridFit straight(box, Mat3::Identity());
  const Mat3 turn = Rotation(30, Vec3(0, 0, 1));
  for (Vec3& p : box.Points)
  {
    p = turn * p;
  }
  const GridFit turned(box, turn);
  EXPECT_NEAR(turned.BestSize(0.3), straight.BestSize(0.3), 1e-12);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_LT(CellsOff(straight.CenterPlane(axis, 0.25, Nowhere),
                turned.CenterPlane(axis, 0.25, Nowhere), 0.25),
      0.03);
  }
  const GridFit unaware(box, Mat3::Identity());
  EXPECT_EQ(unaware.CenterPlane(0, 0.25, Nowhere), Nowhere);
  EXPECT_EQ(unaware.CenterPlane(1, 0.25, Nowhere), Nowhere);
  EXPECT_NE(unaware.CenterPlane(2, 0.25, Nowhere), Nowhere);
  // Half a degree is as good as none, two are not.
  EXPECT_NE(GridFit(box, Rotation(30.3, Vec3(0, 0, 1))).CenterPlane(0, 0.25, Nowhere), Nowhere);
  EXPECT_EQ(GridFit(box, Rotation(32, Vec3(0, 0, 1))).CenterPlane(0, 0.25, Nowhere), Nowhere);
}

TEST(GridFit, OrderOfTheTrianglesChangesNothing)
{
  SurfaceMesh mesh = Frustum(3, 4, 5.37);
  const GridFit first(mesh, Mat3::Identity());
  std::reverse(mesh.Triangles.begin(), mesh.Triangles.end());
  const GridFit second(mesh, Mat3::Identity());
  EXPECT_NEAR(first.CenterPlane(2, 0.7, Nowhere), second.CenterPlane(2, 0.7, Nowhere), 1e-12);
  EXPECT_NEAR(first.BestSize(0.7), second.BestSize(0.7), 1e-12);
}

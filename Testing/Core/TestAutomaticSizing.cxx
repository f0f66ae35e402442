// SPDX-License-Identifier: BSD-3-Clause
#include "AutomaticSizing.h"

#include "BlockOctree.h"
#include "DomainShapes.h"
#include "FeatureExtraction.h"

#include <gtest/gtest.h>

using namespace domainshapes;

namespace
{
SurfaceFeatures FeaturesByAngle(const SurfaceMesh& surface)
{
  SurfaceFeatures features;
  FeatureExtractionReport report;
  const Status status =
    ExtractFeatures(surface, nullptr, FeatureExtractionOptions(), features, report);
  EXPECT_TRUE(status.Ok()) << status.Message;
  return features;
}

/// @a tolerance: fraction of the diagonal.
double EdgeLength(
  const SurfaceMesh& mesh, const SurfaceFeatures& features, double tolerance = 0.005)
{
  Monitor monitor;
  const SurfaceGeometry surface{ SurfaceMesh(mesh) };
  return AutomaticEdgeLength(
    surface, features, Mat3::Identity(), tolerance * surface.Diagonal(), monitor);
}

double EdgeLengthWithFeatures(const SurfaceMesh& mesh, double tolerance = 0.005)
{
  return EdgeLength(mesh, FeaturesByAngle(mesh), tolerance);
}

/// 1 x 1 x height with a round hole.
SurfaceMesh PlateWithHole(double height, double radius)
{
  return PeriodicGrid(64, 4,
    [=](double u, double v)
    {
      const Vec3 round(std::cos(u), std::sin(u), 0);
      const int corner = static_cast<int>(std::lround(v / (Pi / 2))); // of the cross-section
      const Vec3 flat =
        corner < 2 ? Vec3(0.5 * round / round.cwiseAbs().maxCoeff()) : Vec3(radius * round);
      return Vec3(flat + (corner == 1 || corner == 2 ? height : 0) * Vec3::UnitZ());
    });
}

double CellsOff(double length, double size)
{
  return std::abs(std::remainder(length, size)) / size;
}
} // namespace

TEST(AutomaticSizing, CubeHasTenCellsASide)
{
  for (double side : { 1.0, 0.003, 4000.0 })
  {
    const SurfaceMesh cube = BoxSurface(Vec3(1, 2, 3) * side, Vec3(2, 3, 4) * side);
    EXPECT_NEAR(EdgeLengthWithFeatures(cube), side / 10, 1e-6 * side);
  }
}

TEST(AutomaticSizing, SidesOfABoxAreWholeCells)
{
  const SurfaceMesh box = BoxSurface(Vec3::Zero(), Vec3(3, 2, 1));
  const double size = EdgeLengthWithFeatures(box);
  EXPECT_GT(3 / size, 9);
  EXPECT_LT(3 / size, 14);
  for (double side : { 1, 2, 3 })
  {
    EXPECT_LT(CellsOff(side, size), 0.15);
  }
}

TEST(AutomaticSizing, HoleNeedsSmallerCells)
{
  const double plain = EdgeLengthWithFeatures(BoxSurface(Vec3::Zero(), Vec3(1, 1, 0.3)));
  const SurfaceMesh plate = PlateWithHole(0.3, 0.1);
  ASSERT_EQ(FeaturesByAngle(plate).Curves.size(), 14u);
  const double withHole = EdgeLengthWithFeatures(plate);
  EXPECT_LT(withHole, 0.8 * plain);
  EXPECT_GE(withHole, 0.8 / AutomaticSizingFor(true).CellsPerSide);
  // Not where so much is tolerated that the hole may have few sides.
  EXPECT_GT(EdgeLengthWithFeatures(plate, 0.05), 1.2 * withHole);
}

TEST(AutomaticSizing, ThinPlateNeedsSmallerCells)
{
  const double thick = EdgeLengthWithFeatures(BoxSurface(Vec3::Zero(), Vec3(1, 1, 0.3)));
  const double thin = EdgeLengthWithFeatures(BoxSurface(Vec3::Zero(), Vec3(1, 1, 0.04)));
  EXPECT_LT(thin, 0.8 * thick);
}

TEST(AutomaticSizing, WithoutFeaturesAFractionOfTheSide)
{
  const SurfaceMesh sphere = Sphere(Vec3::Zero(), 1.5);
  const double usual =
    BoundingBox(sphere).Size().maxCoeff() / AutomaticSizingFor(false).CellsPerSide;
  EXPECT_EQ(EdgeLength(sphere, SurfaceFeatures(), 0.002), usual);
  // Larger where even larger quads follow the curvature.
  EXPECT_DOUBLE_EQ(EdgeLength(sphere, SurfaceFeatures(), 0.005), std::pow(2, 0.25) * usual);
  EXPECT_DOUBLE_EQ(EdgeLength(sphere, SurfaceFeatures(), 0.1), std::pow(2, 0.25) * usual);
}

TEST(AutomaticSizing, StoppedItTakesTheUsualSize)
{
  class Stopper : public Monitor
  {
    bool AbortRequested() override { return true; }
  };
  Stopper monitor;
  const SurfaceGeometry cube(BoxSurface(Vec3::Zero(), Vec3::Ones()));
  const double size = AutomaticEdgeLength(
    cube, FeaturesByAngle(cube.Mesh()), Mat3::Identity(), 0.01, monitor);
  EXPECT_GT(size, 0.0);
  EXPECT_LE(size, 0.1 + 1e-9);
}

TEST(AutomaticSizing, SmallVolumesGetNoCoarserCells)
{
  const SurfaceGeometry cube(BoxSurface(Vec3(5, 5, 5), Vec3(15, 15, 15)));
  const int usual = OctreeOptions().CoarseLevels;
  ASSERT_GT(usual, 0);
  for (bool features : { false, true })
  {
    const double limit = std::cbrt(1000 / AutomaticSizingFor(features).UniformHexes);
    EXPECT_EQ(AutomaticCoarseLevels(cube, 2 * limit, features), 0);
    EXPECT_EQ(AutomaticCoarseLevels(cube, 1.01 * limit, features), 0);
    EXPECT_EQ(AutomaticCoarseLevels(cube, 0.99 * limit, features), usual);
  }
  // The volume, not the box: a cube with a cavity.
  const SurfaceGeometry hollow(Together(BoxSurface(Vec3::Zero(), Vec3::Constant(10)),
    Flipped(BoxSurface(Vec3::Ones(), Vec3::Constant(9)))));
  EXPECT_EQ(AutomaticCoarseLevels(
              hollow, std::cbrt(0.7 * 1000 / AutomaticSizingFor(true).UniformHexes), true),
    0);
}

TEST(AutomaticSizing, EdgesFollowASmallToleranceOnCurvedSurfaces)
{
  const SurfaceMesh sphere = Sphere(Vec3::Zero(), 1, 60);
  const double usual = EdgeLength(sphere, SurfaceFeatures());
  const double fine = EdgeLength(sphere, SurfaceFeatures(), 0.001);
  const double finest = EdgeLength(sphere, SurfaceFeatures(), 0.0002);
  EXPECT_GT(usual, 1.99 / AutomaticSizingFor(false).CellsPerSide);
  EXPECT_LT(fine, 0.75 * usual);
  EXPECT_LT(finest, 0.6 * fine);
  // Its sag is within the tolerance, at least.
  EXPECT_LT(fine * fine / 8, 0.001 * 2 * std::sqrt(3.0));
}

TEST(AutomaticSizing, FlatFacesNeedNoSmallerEdgesForASmallTolerance)
{
  const SurfaceMesh cube = BoxSurface(Vec3::Zero(), Vec3::Ones());
  EXPECT_DOUBLE_EQ(EdgeLengthWithFeatures(cube, 0.0002), EdgeLengthWithFeatures(cube));
}

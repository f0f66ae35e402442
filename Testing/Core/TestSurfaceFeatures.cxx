// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFeatures.h"

#include "SurfaceCheck.h"
#include "ValidationShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace featurehex;

namespace
{
std::vector<PointPair> CubeEdges()
{
  std::vector<PointPair> edges;
  for (Index i = 0; i < 8; ++i)
  {
    for (Index bit : { 1, 2, 4 })
    {
      if (!(i & bit))
      {
        edges.push_back({ i, i | bit });
      }
    }
  }
  return edges;
}

/// A cone or cylinder: rings of points at heights, closed by a tip below and one above.
SurfaceMesh Turned(int sides, const std::vector<std::array<double, 2>>& radiusAndHeight)
{
  SurfaceMesh mesh;
  const int rings = static_cast<int>(radiusAndHeight.size()) - 2;
  for (int r = 1; r <= rings; ++r)
  {
    for (int i = 0; i < sides; ++i)
    {
      const double a = 2 * 3.14159265358979 * i / sides;
      const auto& ring = radiusAndHeight[r];
      mesh.Points.push_back(Vec3(ring[0] * std::cos(a), ring[0] * std::sin(a), ring[1]));
    }
  }
  const Index bottom = rings * sides, top = bottom + 1;
  mesh.Points.push_back(Vec3(0, 0, radiusAndHeight.front()[1]));
  mesh.Points.push_back(Vec3(0, 0, radiusAndHeight.back()[1]));
  for (Index i = 0; i < sides; ++i)
  {
    const Index j = (i + 1) % sides;
    mesh.Triangles.push_back({ bottom, j, i });
    for (Index r = 0; r + 1 < rings; ++r)
    {
      const Index low = r * sides, high = low + sides;
      mesh.Triangles.push_back({ low + i, low + j, high + j });
      mesh.Triangles.push_back({ low + i, high + j, high + i });
    }
    mesh.Triangles.push_back({ (rings - 1) * sides + i, (rings - 1) * sides + j, top });
  }
  return mesh;
}

SurfaceFeatures Build(const SurfaceMesh& surface, const std::vector<PointPair>& edges,
  const std::vector<Index>& corners = {}, FeatureGraphReport* report = nullptr)
{
  SurfaceFeatures features;
  FeatureGraphReport local;
  const Status status = BuildSurfaceFeatures(
    surface, edges, corners, FeatureGraphOptions(), features, report ? *report : local);
  EXPECT_TRUE(status.Ok()) << status.Message;
  return features;
}

/// Pyramid over a polygon whose edges from the tip are the features.
SurfaceMesh Pyramid(const std::vector<double>& degrees, double height)
{
  SurfaceMesh mesh;
  for (double a : degrees)
  {
    mesh.Points.push_back(
      Vec3(std::cos(a / 57.29577951308232), std::sin(a / 57.29577951308232), 0));
  }
  const Index count = static_cast<Index>(degrees.size()), tip = count, base = count + 1;
  mesh.Points.push_back(Vec3(0, 0, height));
  mesh.Points.push_back(Vec3(0, 0, -height));
  for (Index i = 0; i < count; ++i)
  {
    mesh.Triangles.push_back({ i, (i + 1) % count, tip });
    mesh.Triangles.push_back({ (i + 1) % count, i, base });
  }
  return mesh;
}

std::vector<PointPair> Spokes(Index count)
{
  std::vector<PointPair> edges;
  for (Index i = 0; i < count; ++i)
  {
    edges.push_back({ count, i });
  }
  return edges;
}

CornerFlaw FlawAt(const SurfaceFeatures& features, Index point)
{
  for (const FeatureCorner& corner : features.Corners)
  {
    if (corner.Point == point)
    {
      return corner.Flaw;
    }
  }
  ADD_FAILURE() << "no corner at " << point;
  return CornerFlaw::None;
}

void ExpectSame(const SurfaceFeatures& a, const SurfaceFeatures& b)
{
  ASSERT_EQ(a.Corners.size(), b.Corners.size());
  ASSERT_EQ(a.Curves.size(), b.Curves.size());
  for (std::size_t c = 0; c < a.Corners.size(); ++c)
  {
    EXPECT_EQ(a.Corners[c].Point, b.Corners[c].Point);
  }
  for (std::size_t c = 0; c < a.Curves.size(); ++c)
  {
    EXPECT_EQ(a.Curves[c].Points, b.Curves[c].Points);
    EXPECT_EQ(a.Curves[c].LeftPatch, b.Curves[c].LeftPatch);
    EXPECT_EQ(a.Curves[c].RightPatch, b.Curves[c].RightPatch);
  }
  EXPECT_EQ(a.PatchOfTriangle, b.PatchOfTriangle);
}
} // namespace

TEST(SurfaceFeatures, Cube)
{
  const SurfaceMesh cube = CubeSurface();
  const SurfaceFeatures features = Build(cube, CubeEdges());
  ASSERT_EQ(features.Corners.size(), 8u);
  ASSERT_EQ(features.Curves.size(), 12u);
  EXPECT_EQ(features.NumberOfPatches, 6);
  EXPECT_EQ(features.PatchOfTriangle, (std::vector<int>{ 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5 }));
  for (Index i = 0; i < 8; ++i)
  {
    EXPECT_EQ(features.Corners[i].Point, i);
    EXPECT_TRUE(features.Corners[i].Valid());
  }
  // From 0 along x: the face z = 0 is on the right, seen from outside; y = 0 on the left.
  const FeatureCurve& x = features.Curves[0];
  EXPECT_EQ(x.Points, (std::vector<Index>{ 0, 1 }));
  EXPECT_EQ(x.LeftPatch, 2);
  EXPECT_EQ(x.RightPatch, 0);
  EXPECT_EQ(x.FirstCorner, 0);
  EXPECT_EQ(x.LastCorner, 1);
  EXPECT_EQ(FeatureEdges(features).size(), 12u);
  EXPECT_EQ(CornersOfPoints(features, 9)[8], -1);
}

TEST(SurfaceFeatures, OrderOfTheInputDoesNotMatter)
{
  const SurfaceMesh cube = CubeSurface();
  std::vector<PointPair> edges = CubeEdges();
  const SurfaceFeatures first = Build(cube, edges);
  std::mt19937 random(3);
  for (int round = 0; round < 5; ++round)
  {
    std::shuffle(edges.begin(), edges.end(), random);
    std::swap(edges[0][0], edges[0][1]);
    edges.push_back({ edges[1][1], edges[1][0] });
    FeatureGraphReport report;
    ExpectSame(first, Build(cube, edges, {}, &report));
    EXPECT_EQ(report.NumberOfDuplicateEdges, round + 1);
  }
}

TEST(SurfaceFeatures, LoopsAndTips)
{
  // A cylinder: two loops without corner, three patches.
  const SurfaceMesh cylinder = Turned(12, { { 0, 0 }, { 1, 0 }, { 1, 2 }, { 0, 2 } });
  std::vector<PointPair> loops;
  for (Index i = 0; i < 12; ++i)
  {
    loops.push_back({ (i + 1) % 12, i });
    loops.push_back({ 12 + i, 12 + (i + 1) % 12 });
  }
  SurfaceFeatures features = Build(cylinder, loops);
  EXPECT_TRUE(features.Corners.empty());
  ASSERT_EQ(features.Curves.size(), 2u);
  EXPECT_EQ(features.NumberOfPatches, 3);
  for (const FeatureCurve& curve : features.Curves)
  {
    EXPECT_TRUE(curve.Closed());
    EXPECT_EQ(curve.Points.size(), 13u);
    EXPECT_EQ(curve.FirstCorner, -1);
    EXPECT_NE(curve.LeftPatch, curve.RightPatch);
  }
  EXPECT_EQ(features.Curves[0].Points[0], 0);
  EXPECT_EQ(features.Curves[0].Points[1], 1);

  // An explicit corner on a loop, and one on no edge.
  features = Build(cylinder, loops, { 5, 24, 5 });
  ASSERT_EQ(features.Corners.size(), 2u);
  ASSERT_EQ(features.Curves.size(), 2u);
  EXPECT_EQ(features.Curves[0].FirstCorner, 0);
  EXPECT_EQ(features.Curves[0].LastCorner, 0);
  EXPECT_EQ(features.Curves[0].Points.front(), 5);
  EXPECT_EQ(features.Curves[0].Points[1], 4);
  EXPECT_EQ(features.Curves[0].Points.back(), 5);
  EXPECT_EQ(features.Corners[1].Point, 24);

  FeatureGraphOptions options;
  options.KeepIsolatedCorners = false;
  FeatureGraphReport report;
  ASSERT_TRUE(BuildSurfaceFeatures(cylinder, loops, { 24 }, options, features, report).Ok());
  EXPECT_TRUE(features.Corners.empty());
  EXPECT_EQ(report.NumberOfDroppedCorners, 1);
}

TEST(SurfaceFeatures, KinksAndDanglingCurves)
{
  // A square prism of eight sides: every second point of the loop is straight or a kink.
  SurfaceMesh prism = Turned(8, { { 0, 0 }, { 1, 0 }, { 1, 2 }, { 0, 2 } });
  for (Index i = 0; i < 16; i += 2)
  {
    prism.Points[i].head<2>() *= std::sqrt(0.5); // onto the sides of the square
  }
  std::vector<PointPair> loop;
  for (Index i = 0; i < 8; ++i)
  {
    loop.push_back({ i, (i + 1) % 8 });
  }
  SurfaceFeatures features = Build(prism, loop);
  EXPECT_EQ(features.Corners.size(), 4u);
  EXPECT_EQ(features.Curves.size(), 4u);
  EXPECT_EQ(features.NumberOfPatches, 2);

  features = Build(prism, { { 1, 9 } });
  EXPECT_EQ(features.Corners.size(), 2u);
  ASSERT_EQ(features.Curves.size(), 1u);
  EXPECT_EQ(features.NumberOfPatches, 1);
  EXPECT_EQ(features.Curves[0].LeftPatch, features.Curves[0].RightPatch);

  features = Build(prism, {});
  EXPECT_TRUE(features.Curves.empty());
  EXPECT_EQ(features.NumberOfPatches, 1);
}

TEST(SurfaceFeatures, FlawsAtCorners)
{
  const std::vector<double> six = { 0, 60, 120, 180, 240, 300 };
  EXPECT_EQ(FlawAt(Build(Pyramid(six, 0.3), Spokes(6)), 6), CornerFlaw::None);
  const std::vector<double> seven = { 0, 50, 100, 150, 200, 250, 300 };
  FeatureGraphReport report;
  EXPECT_EQ(FlawAt(Build(Pyramid(seven, 0.3), Spokes(7), {}, &report), 7), CornerFlaw::ManyCurves);
  EXPECT_EQ(report.NumberOfManyCurveCorners, 1);
  EXPECT_EQ(report.Flawed.size(), 1u);
  for (double angle : { 12.0, 20.0, 25.0, 29.0, 31.0, 40.0 })
  {
    const SurfaceMesh acute = Pyramid({ 0, angle, 120, 240 }, 0.01);
    EXPECT_EQ(FlawAt(Build(acute, Spokes(4), {}, &report), 4),
      angle < 30 ? CornerFlaw::AcuteCurves : CornerFlaw::None);
    EXPECT_EQ(report.NumberOfAcuteCorners, angle < 30 ? 1 : 0);
  }
  SurfaceFeatures features;
  FeatureGraphOptions all;
  all.EnforceAll = true;
  ASSERT_TRUE(BuildSurfaceFeatures(Pyramid(seven, 0.3), Spokes(7), {}, all, features, report).Ok());
  EXPECT_EQ(FlawAt(features, 7), CornerFlaw::None);
  EXPECT_EQ(report.NumberOfManyCurveCorners, 1);
}

TEST(SurfaceFeatures, VeryShortFirstEdgesHaveNoDirection)
{
  // One spoke starts with an edge of 1e-4 that points along its neighbour.
  SurfaceMesh mesh = Pyramid({ 0, 60, 180, 270 }, 0.01);
  const Index extra = static_cast<Index>(mesh.Points.size());
  const Vec3 tip = mesh.Points[4];
  mesh.Points.push_back(tip + 1e-4 * (0.6 * (mesh.Points[0] - tip) + 0.4 * (mesh.Points[1] - tip)));
  // Splits the triangles at the edge tip - 1.
  std::vector<Triangle> triangles;
  for (const Triangle& t : mesh.Triangles)
  {
    if (t == Triangle{ 0, 1, 4 })
    {
      triangles.push_back({ 0, 1, extra });
      triangles.push_back({ 0, extra, 4 });
    }
    else if (t == Triangle{ 1, 2, 4 })
    {
      triangles.push_back({ 1, 2, extra });
      triangles.push_back({ extra, 2, 4 });
    }
    else
    {
      triangles.push_back(t);
    }
  }
  mesh.Triangles = triangles;
  const SurfaceFeatures features =
    Build(mesh, { { 4, 0 }, { 4, extra }, { extra, 1 }, { 4, 2 }, { 4, 3 } });
  EXPECT_EQ(FlawAt(features, 4), CornerFlaw::None);
}

TEST(SurfaceFeatures, EdgesThatTheCheckFlippedAway)
{
  // The edge 0 1 of a cube's face z = 0 carries a point on the other face only: a collinear
  // triangle.
  SurfaceMesh cube = CubeSurface();
  cube.Points.push_back(Vec3(0.5, 0, 0));
  cube.Points.push_back(Vec3(0.25, 0, 0));
  cube.Triangles[4] = { 8, 1, 5 };
  cube.Triangles.push_back({ 9, 8, 5 });
  cube.Triangles.push_back({ 0, 9, 5 });
  cube.Triangles.push_back({ 0, 1, 8 });
  cube.Triangles.push_back({ 0, 8, 9 });
  SurfaceCheckReport check;
  Monitor monitor;
  ASSERT_TRUE(CheckSurface(cube, SurfaceCheckOptions(), check, monitor).Ok());
  ASSERT_GT(check.NumberOfFlippedEdges, 0);
  FeatureGraphReport report;
  const SurfaceFeatures features = Build(cube, CubeEdges(), {}, &report);
  EXPECT_EQ(report.NumberOfSplitEdges, 1);
  EXPECT_EQ(features.Corners.size(), 8u);
  EXPECT_EQ(features.Curves.size(), 12u);
  EXPECT_EQ(features.NumberOfPatches, 6);
  EXPECT_TRUE(std::any_of(features.Curves.begin(), features.Curves.end(),
    [](const FeatureCurve& c) {
      return c.Points == std::vector<Index>{ 0, 9, 8, 1 };
    }));
}

TEST(SurfaceFeatures, Errors)
{
  const SurfaceMesh cube = CubeSurface();
  SurfaceFeatures features;
  FeatureGraphReport report;
  const auto error = [&](const std::vector<PointPair>& edges, const std::vector<Index>& corners)
  { return BuildSurfaceFeatures(cube, edges, corners, FeatureGraphOptions(), features, report); };
  Status status = error({ { 0, 1 }, { 1, 8 } }, {});
  EXPECT_EQ(status.Code, StatusCode::IndexOutOfRange);
  EXPECT_NE(status.Message.find("edge 1 goes to point 8"), std::string::npos) << status.Message;
  EXPECT_EQ(error({ { -1, 1 } }, {}).Code, StatusCode::IndexOutOfRange);
  EXPECT_EQ(error({}, { 8 }).Code, StatusCode::IndexOutOfRange);
  EXPECT_EQ(error({ { 2, 2 } }, {}).Code, StatusCode::Degenerate);
  status = error({ { 0, 1 }, { 0, 7 }, { 1, 6 } }, {});
  EXPECT_EQ(status.Code, StatusCode::IndexOutOfRange);
  EXPECT_NE(status.Message.find("2 feature edges are not in the surface"), std::string::npos)
    << status.Message;
  EXPECT_NE(status.Message.find("point 7 at (1, 1, 1)"), std::string::npos) << status.Message;
  EXPECT_EQ(status.Where.size(), 2u);
  EXPECT_TRUE(features.Corners.empty());
}

TEST(SurfaceFeatures, MapToTheCheckedSurface)
{
  std::vector<PointPair> edges = { { 0, 1 }, { 1, 2 }, { 2, 3 } };
  std::vector<Index> corners = { 3, 0 };
  // Point 2 was merged with point 1; point 4 is used by no triangle.
  const std::vector<Index> points = { 0, 1, 1, 2, -1 };
  ASSERT_TRUE(MapFeatures(points, edges, corners).Ok());
  EXPECT_EQ(edges, (std::vector<PointPair>{ { 0, 1 }, { 1, 2 } }));
  EXPECT_EQ(corners, (std::vector<Index>{ 2, 0 }));
  edges = { { 0, 4 } };
  Status status = MapFeatures(points, edges, corners);
  EXPECT_EQ(status.Code, StatusCode::IndexOutOfRange);
  EXPECT_NE(status.Message.find("no triangle uses"), std::string::npos);
  edges = { { 0, 5 } };
  EXPECT_EQ(MapFeatures(points, edges, corners).Code, StatusCode::IndexOutOfRange);
  edges.clear();
  corners = { -1 };
  EXPECT_EQ(MapFeatures(points, edges, corners).Code, StatusCode::IndexOutOfRange);
}

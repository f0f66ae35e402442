// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceSizing.h"

#include "DomainShapes.h"

#include <vtkSMPTools.h>

#include <chrono>
#include <random>

using namespace domainshapes;

namespace
{
std::vector<RefinementPoint> Sizing(const SurfaceMesh& surface, double edgeLength, double slack)
{
  Monitor monitor;
  SizingOptions options;
  options.TargetEdgeLength = edgeLength;
  options.Slack = slack;
  return ComputeSizing(
    surface, TriangleSearch(surface.Points, surface.Triangles), options, monitor);
}

int HighestLevel(const std::vector<RefinementPoint>& points)
{
  int level = 0;
  for (const RefinementPoint& point : points)
  {
    level = std::max(level, point.Level);
  }
  return level;
}

double Clearance(const TriangleSearch& search, const Vec3& p, SurfaceSide side, double radius,
  double slack, double relative)
{
  const TrianglePoint closest = search.Closest(p);
  ClearanceOptions options;
  options.MaximumRadius = radius;
  options.Slack = slack;
  options.RelativeSlack = relative;
  return ClearanceRadius(search, { closest.Point, closest.Triangle }, side, options);
}
}

TEST(SurfaceSizing, SamplesLieOnTheSurfaceAndCoverIt)
{
  const SurfaceMesh box = BoxSurface(Vec3(-1, -2, -3), Vec3(1, 2, 3));
  const TriangleSearch search(box.Points, box.Triangles);
  const std::vector<SurfaceSample> samples = SampleSurface(box, 0.25);
  std::vector<Vec3> points;
  std::vector<Triangle> dots;
  for (const SurfaceSample& sample : samples)
  {
    EXPECT_LT(search.ClosestOn(sample.Position, sample.Triangle).Distance, 1e-12);
    const Index id = static_cast<Index>(points.size());
    points.push_back(sample.Position);
    dots.push_back({ id, id, id });
  }
  const TriangleSearch near(points, dots);
  double farthest = 0.0;
  for (const SurfaceSample& probe : SampleSurface(box, 0.05))
  {
    farthest = std::max(farthest, near.Closest(probe.Position).Distance);
  }
  EXPECT_LT(farthest, 0.5);
  EXPECT_LT(samples.size(), 88 / (0.25 * 0.25) * 2);
}

TEST(SurfaceSizing, FineTrianglesAreThinnedOut)
{
  const SurfaceMesh sphere = Sphere(Vec3::Zero(), 1.0, 40);
  EXPECT_LT(SampleSurface(sphere, 0.5).size(), sphere.Triangles.size() / 10);
}

TEST(SurfaceSizing, BallsOfAPlate)
{
  const SurfaceMesh plate = BoxSurface(Vec3(-2, -2, -0.1), Vec3(2, 2, 0.1));
  const TriangleSearch search(plate.Points, plate.Triangles);
  EXPECT_NEAR(
    Clearance(search, Vec3(0.3, 0.2, 0.1), SurfaceSide::Inside, 1.0, 0.0, 0.0), 0.1, 2e-3);
  EXPECT_EQ(Clearance(search, Vec3(0.3, 0.2, 0.1), SurfaceSide::Inside, 0.09, 0.0, 0.0), 0.09);
  EXPECT_EQ(Clearance(search, Vec3(0.3, 0.2, 0.1), SurfaceSide::Outside, 5.0, 0.0, 0.0), 5.0);
}

TEST(SurfaceSizing, SlackReachesIntoCorners)
{
  const SurfaceMesh box = BoxSurface(Vec3(-1, -1, -1), Vec3(1, 1, 1));
  const TriangleSearch search(box.Points, box.Triangles);
  const Vec3 nearEdge(0.98, 0.1, 1.0);
  EXPECT_NEAR(Clearance(search, nearEdge, SurfaceSide::Inside, 0.5, 0.0, 0.0), 0.025, 6e-3);
  // sqrt(2) - 1 = 0.414 of the radius away from the edge; a little less from this place.
  EXPECT_GT(Clearance(search, nearEdge, SurfaceSide::Inside, 0.5, 0.0, 0.42), 0.49);
  EXPECT_GT(Clearance(search, nearEdge, SurfaceSide::Inside, 0.5, 0.21, 0.0), 0.49);
}

TEST(SurfaceSizing, BallsStayOnTheirSide)
{
  // A gap of 0.02 between two large boxes, less than the slack.
  const SurfaceMesh boxes = Together(BoxSurface(Vec3(-2, -2, 0.02), Vec3(2, 2, 2)),
    BoxSurface(Vec3(-2, -2, -2), Vec3(2, 2, 0)));
  const TriangleSearch search(boxes.Points, boxes.Triangles);
  const double radius =
    Clearance(search, Vec3(0.3, 0.2, 0.0), SurfaceSide::Outside, 0.5, 0.1, 0.4);
  EXPECT_NEAR(radius, 0.01, 1e-3);
}

TEST(SurfaceSizing, RoundShapesNeedNothing)
{
  EXPECT_TRUE(Sizing(Sphere(Vec3::Zero(), 1.0), 2.0 / 26, 0.01).empty());
  EXPECT_TRUE(Sizing(Torus(1.0, 0.3), 2.6 / 26, 0.01).empty());
}

TEST(SurfaceSizing, SagOfAPlaneIsNone)
{
  const SurfaceMesh box = BoxSurface(Vec3::Zero(), Vec3(10, 10, 10));
  const TriangleSearch search(box.Points, box.Triangles);
  for (const Vec3& p : { Vec3(5, 4, 10), Vec3(0, 3, 7), Vec3(9.9, 9.8, 0) }) // also near edges
  {
    const TrianglePoint at = search.Closest(p);
    EXPECT_NEAR(QuadSag(search, { at.Point, at.Triangle }, 1.0), 0, 1e-12);
  }
}

TEST(SurfaceSizing, SagOfASphereAndACylinder)
{
  // Corners of a square of edge h are h / sqrt(2) from its centre, and the surface r^2 / (2 R)
  // below the tangent plane at r; the best plane halves it: h^2 / (8 R).
  const double radius = 3.0;
  const SurfaceMesh sphere = Sphere(Vec3::Zero(), radius, 80);
  const SurfaceMesh ring = Torus(1000, radius, 4000, 160);
  const std::vector<std::pair<SurfaceMesh, Vec3>> places = { { sphere, Vec3(1, 2, 2) },
    { sphere, Vec3(0.1, 0.2, 3) }, { ring, Vec3(1000 + radius, 0, 0) } };
  for (const auto& [mesh, place] : places)
  {
    const TriangleSearch search(mesh.Points, mesh.Triangles);
    const TrianglePoint at = search.Closest(place);
    for (double size : { 0.5, 1.0 })
    {
      const double sag = size * size / (8 * radius);
      EXPECT_NEAR(QuadSag(search, { at.Point, at.Triangle }, size), sag, 0.12 * sag) << size;
    }
  }
}

TEST(SurfaceSizing, SagIsNotTheTiltOfTheTriangle)
{
  // A plane of fine triangles, one of them raised at one end: its normal says little.
  SurfaceMesh plane;
  constexpr int n = 40;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      plane.Points.emplace_back(i, j, 0);
      if (i < n && j < n)
      {
        const Index a = i * (n + 1) + j;
        plane.Triangles.push_back({ a, a + n + 1, a + n + 2 });
        plane.Triangles.push_back({ a, a + n + 2, a + 1 });
      }
    }
  }
  const double bump = 0.3;
  plane.Points[20 * (n + 1) + 20].z() = bump;
  const TriangleSearch search(plane.Points, plane.Triangles);
  const TrianglePoint at = search.Closest(Vec3(20.3, 20.1, 0.1));
  ASSERT_LT(search.Normal(at.Triangle).z(), 0.99);
  EXPECT_LT(QuadSag(search, { at.Point, at.Triangle }, 10.0), bump);
}

TEST(SurfaceSizing, NoiseSagsByItsHeight)
{
  SurfaceMesh sphere = Sphere(Vec3::Zero(), 1000, 40);
  std::mt19937 random(3);
  const double noise = 2.0;
  for (Vec3& p : sphere.Points)
  {
    p += p.normalized() * noise * (2.0 * random() / 4294967295.0 - 1.0);
  }
  const TriangleSearch search(sphere.Points, sphere.Triangles);
  for (const SurfaceSample& sample : SampleSurface(sphere, 300))
  {
    const double sag = QuadSag(search, sample, 150);
    EXPECT_GT(sag, 0);
    EXPECT_LT(sag, 2 * noise + 150.0 * 150 / 8000);
  }
}

TEST(SurfaceSizing, SagDecidesTheLevel)
{
  const SurfaceMesh sphere = Sphere(Vec3::Zero(), 3.0, 40);
  const TriangleSearch search(sphere.Points, sphere.Triangles);
  const auto level = [&](double sag, int maximum) {
    Monitor monitor;
    SizingOptions options;
    options.TargetEdgeLength = 1.0; // sag 1 / 24, after halving 1 / 96
    options.Sag = sag;
    options.MaximumCurvatureLevel = maximum;
    return HighestLevel(ComputeSizing(sphere, search, options, monitor));
  };
  EXPECT_EQ(level(0.0, 1), 0);
  EXPECT_EQ(level(0.06, 1), 0);
  EXPECT_EQ(level(0.02, 1), 1);
  EXPECT_EQ(level(0.02, 2), 1);
  EXPECT_EQ(level(0.005, 1), 1);
  EXPECT_EQ(level(0.005, 2), 2);
  EXPECT_EQ(level(0.005, 0), 0);
}

TEST(SurfaceSizing, RightAnglesNeedNothing)
{
  EXPECT_TRUE(Sizing(BoxSurface(Vec3::Zero(), Vec3(3, 2, 2)), 3.0 / 26, 0.02).empty());
}

TEST(SurfaceSizing, ThicknessDecidesTheLevel)
{
  const double edge = 1.0;
  EXPECT_TRUE(Sizing(BoxSurface(Vec3::Zero(), Vec3(20, 20, 2.2)), edge, 0.1).empty());
  const std::vector<RefinementPoint> once =
    Sizing(BoxSurface(Vec3::Zero(), Vec3(20, 20, 1.0)), edge, 0.1);
  EXPECT_EQ(HighestLevel(once), 1);
  EXPECT_EQ(HighestLevel(Sizing(BoxSurface(Vec3::Zero(), Vec3(20, 20, 0.5)), edge, 0.1)), 2);
  // Everywhere: a point in each 3 x 3 square of both faces.
  for (int i = 0; i < 6; ++i)
  {
    for (int j = 0; j < 6; ++j)
    {
      int count = 0;
      for (const RefinementPoint& point : once)
      {
        count += std::abs(point.Position[0] - 3 * i - 2.5) < 1.5 &&
          std::abs(point.Position[1] - 3 * j - 2.5) < 1.5;
      }
      EXPECT_GT(count, 4);
    }
  }
}

TEST(SurfaceSizing, GapDecidesTheLevel)
{
  const auto boxes = [](double gap) {
    return Together(BoxSurface(Vec3(0, 0, gap), Vec3(20, 20, 10 + gap)),
      BoxSurface(Vec3(0, 0, -10), Vec3(20, 20, 0)));
  };
  EXPECT_TRUE(Sizing(boxes(1.1), 1.0, 0.1).empty());
  EXPECT_EQ(HighestLevel(Sizing(boxes(0.8), 1.0, 0.1)), 1);
  EXPECT_EQ(HighestLevel(Sizing(boxes(0.3), 1.0, 0.1)), 2);
}

TEST(SurfaceSizing, StopsWhenAsked)
{
  class Stopper : public Monitor
  {
    bool AbortRequested() override { return true; }
  };
  Stopper monitor;
  const SurfaceMesh plate = BoxSurface(Vec3::Zero(), Vec3(20, 20, 0.5));
  SizingOptions options;
  options.TargetEdgeLength = 1.0;
  EXPECT_TRUE(
    ComputeSizing(plate, TriangleSearch(plate.Points, plate.Triangles), options, monitor).empty());
  EXPECT_EQ(monitor.StopStatus().Code, StatusCode::Aborted);
}

TEST(SurfaceSizing, SameForAnyNumberOfThreads)
{
  SurfaceMesh surface = Scan("bunny");
  if (surface.Points.empty())
  {
    surface = Ellipsoid(Vec3::Zero(), Vec3(2, 1, 0.1), 30);
  }
  const double edge = BoundingBox(surface).Size().maxCoeff() / 26;
  const std::vector<RefinementPoint> many = Sizing(surface, edge, 0.2 * edge);
  vtkSMPTools::Initialize(1);
  const std::vector<RefinementPoint> one = Sizing(surface, edge, 0.2 * edge);
  vtkSMPTools::Initialize();
  ASSERT_EQ(one.size(), many.size());
  EXPECT_GT(one.size(), 0u);
  for (std::size_t i = 0; i < one.size(); ++i)
  {
    EXPECT_EQ(one[i].Position, many[i].Position);
    EXPECT_EQ(one[i].Level, many[i].Level);
  }
}

TEST(SurfaceSizing, SaggingShareCountsSmoothPlacesOnly)
{
  const double radius = 3.0;
  const SurfaceMesh sphere = Sphere(Vec3::Zero(), radius, 80);
  const TriangleSearch search(sphere.Points, sphere.Triangles);
  const std::vector<SurfaceSample> samples = SampleSurface(sphere, 0.3);
  Monitor monitor;
  SizingOptions options;
  options.TargetEdgeLength = 1.0;
  options.Sag = 1.3 / (8 * radius);
  EXPECT_EQ(SaggingShare(samples, search, options, monitor), 0);
  options.Sag = 0.7 / (8 * radius);
  EXPECT_EQ(SaggingShare(samples, search, options, monitor), 1);

  // Edges of a box are sharp, its faces flat: nothing sags.
  const SurfaceMesh box = BoxSurface(Vec3::Zero(), Vec3(4, 4, 4));
  const TriangleSearch boxSearch(box.Points, box.Triangles);
  options.Sag = 1e-3;
  EXPECT_EQ(SaggingShare(SampleSurface(box, 0.3), boxSearch, options, monitor), 0);
}

TEST(SurfaceSizing, WantedLengthsRefineWhereTheyAreSmaller)
{
  const SurfaceMesh box = BoxSurface(Vec3::Zero(), Vec3::Constant(8));
  const TriangleSearch search(box.Points, box.Triangles);
  Monitor monitor;
  const auto sizing = [&](const std::vector<double>& lengths, int maximumLevel) {
    return ComputeWantedSizing(box, search, lengths, 1.0, maximumLevel, monitor);
  };
  std::vector<double> lengths(box.Points.size(), 0.0);
  EXPECT_TRUE(sizing(lengths, 4).empty()); // no wish
  lengths.assign(box.Points.size(), 1.5);
  EXPECT_TRUE(sizing(lengths, 4).empty()); // larger ones are none
  lengths.assign(box.Points.size(), 0.5);
  for (const RefinementPoint& point : sizing(lengths, 4))
  {
    EXPECT_EQ(point.Level, 1);
  }
  // From 0.2 at x = 0, which takes three halvings, to 1.4 at x = 8.
  for (std::size_t p = 0; p < box.Points.size(); ++p)
  {
    lengths[p] = 0.2 + 0.15 * box.Points[p][0];
  }
  const std::vector<RefinementPoint> points = sizing(lengths, 4);
  EXPECT_EQ(HighestLevel(points), 3);
  EXPECT_EQ(HighestLevel(sizing(lengths, 2)), 2);
  double farthest = 0;
  for (const RefinementPoint& point : points)
  {
    const double wanted = 0.2 + 0.15 * point.Position[0];
    EXPECT_LT(0.96 * std::ldexp(1.0, -point.Level), wanted);
    EXPECT_GT(std::ldexp(2.0, -point.Level), wanted);
    farthest = std::max(farthest, point.Position[0]);
  }
  EXPECT_NEAR(farthest, (0.97 - 0.2) / 0.15, 0.2);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureDetection.h"

#include "SharedData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

using namespace featurehex;

namespace
{
constexpr double Radians = 0.017453292519943295;

/// A tent over the strip |y| < 1 along x: at x = i the ridge deviates by degrees[i]. Point 3 i + 1
/// is on the ridge, 3 i and 3 i + 2 at its foot.
SurfaceMesh Tent(const std::vector<double>& degrees)
{
  SurfaceMesh tent;
  const Index count = static_cast<Index>(degrees.size());
  for (Index i = 0; i < count; ++i)
  {
    tent.Points.push_back(Vec3(i, -1, 0));
    tent.Points.push_back(Vec3(i, 0, std::tan(0.5 * Radians * degrees[i])));
    tent.Points.push_back(Vec3(i, 1, 0));
  }
  for (Index i = 0; i + 1 < count; ++i)
  {
    const Index a = 3 * i, b = a + 3;
    tent.Triangles.push_back({ a, b, b + 1 });
    tent.Triangles.push_back({ a, b + 1, a + 1 });
    tent.Triangles.push_back({ a + 1, b + 1, b + 2 });
    tent.Triangles.push_back({ a + 1, b + 2, a + 2 });
    tent.Triangles.push_back({ a, a + 2, b + 2 });
    tent.Triangles.push_back({ a, b + 2, b });
  }
  tent.Triangles.push_back({ 0, 1, 2 });
  const Index last = 3 * count - 3;
  tent.Triangles.push_back({ last, last + 2, last + 1 });
  return tent;
}

Index RidgeEdges(const std::vector<PointPair>& edges)
{
  return static_cast<Index>(std::count_if(edges.begin(), edges.end(),
    [](const PointPair& edge) { return edge[0] % 3 == 1 && edge[1] % 3 == 1; }));
}

/// A square plate of n x n squares in the plane z = 0, closed by one point far below.
SurfaceMesh Plate(Index n)
{
  SurfaceMesh plate;
  for (Index y = 0; y <= n; ++y)
  {
    for (Index x = 0; x <= n; ++x)
    {
      plate.Points.push_back(Vec3(x, y, 0));
    }
  }
  const auto at = [n](Index x, Index y) { return y * (n + 1) + x; };
  const Index bottom = static_cast<Index>(plate.Points.size());
  plate.Points.push_back(Vec3(0.5 * n, 0.5 * n, -n));
  for (Index y = 0; y < n; ++y)
  {
    for (Index x = 0; x < n; ++x)
    {
      plate.Triangles.push_back({ at(x, y), at(x + 1, y), at(x + 1, y + 1) });
      plate.Triangles.push_back({ at(x, y), at(x + 1, y + 1), at(x, y + 1) });
    }
  }
  for (Index i = 0; i < n; ++i)
  {
    plate.Triangles.push_back({ at(i + 1, 0), at(i, 0), bottom });
    plate.Triangles.push_back({ at(i, n), at(i + 1, n), bottom });
    plate.Triangles.push_back({ at(0, i), at(0, i + 1), bottom });
    plate.Triangles.push_back({ at(n, i + 1), at(n, i), bottom });
  }
  return plate;
}

std::vector<PointPair> Find(const SurfaceMesh& surface,
  const FeatureDetectionOptions& options = FeatureDetectionOptions(),
  FeatureDetectionReport* report = nullptr)
{
  FeatureDetectionReport local;
  return FindSharpEdges(surface, options, report ? *report : local);
}
} // namespace

TEST(FeatureDetection, Deviations)
{
  const std::vector<SurfaceEdge> edges = MeasureEdges(Tent({ 44, 44, 44 }));
  for (const SurfaceEdge& edge : edges)
  {
    if (edge.Low % 3 == 1 && edge.High % 3 == 1)
    {
      EXPECT_NEAR(edge.Deviation, 44.0, 1e-9);
    }
    else if (edge.Low == 1 && edge.High == 2)
    {
      EXPECT_NEAR(edge.Deviation, 90.0, 1e-9);
    }
  }
  // Concave edges count as much.
  SurfaceMesh inside = Tent({ 44, 44, 44 });
  for (Triangle& t : inside.Triangles)
  {
    std::swap(t[0], t[1]);
  }
  EXPECT_EQ(Find(inside), Find(Tent({ 44, 44, 44 })));
}

TEST(FeatureDetection, AngleDecides)
{
  const SurfaceMesh tent = Tent({ 44, 44, 44, 44 });
  FeatureDetectionOptions options;
  FeatureDetectionReport report;
  EXPECT_EQ(RidgeEdges(Find(tent, options, &report)), 3);
  EXPECT_EQ(report.NumberOfSharpEdges, 3 + 2 * 3 + 2 * 3);
  EXPECT_EQ(report.NumberOfContinuedEdges + report.NumberOfGapEdges + report.NumberOfSpurEdges, 0);
  options.FeatureAngle = 130; // and no less sharp edge beside a sharp one
  options.Hysteresis = 0;
  EXPECT_EQ(RidgeEdges(Find(tent, options)), 0);
  EXPECT_EQ(Find(tent, options).size(), 12u);
}

TEST(FeatureDetection, RidgeThatHoversAroundTheAngle)
{
  const SurfaceMesh tent = Tent({ 46, 46, 46, 34, 34, 34, 46, 46, 30, 46, 46, 46 });
  FeatureDetectionOptions options;
  options.Hysteresis = 0;
  options.MaximumGap = 0;
  options.MinimumLength = 0;
  const Index plain = RidgeEdges(Find(tent, options));
  EXPECT_LT(plain, 9);
  options.Hysteresis = 15;
  FeatureDetectionReport report;
  EXPECT_EQ(RidgeEdges(Find(tent, options, &report)), 11);
  EXPECT_EQ(report.NumberOfContinuedEdges, 11 - plain);
  EXPECT_EQ(static_cast<Index>(report.Continued.size()), 11 - plain);
  // What leads nowhere is not sharp.
  const SurfaceMesh fading = Tent({ 50, 50, 50, 50, 45, 35, 30, 26, 22, 18, 14, 10 });
  const Index sharp = RidgeEdges(Find(fading));
  EXPECT_GE(sharp, 3);
  EXPECT_LE(sharp, 5);
}

TEST(FeatureDetection, ChainsThatFadeTowardsEachOtherMeet)
{
  const SurfaceMesh tent = Tent({ 60, 50, 45, 35, 30, 27, 30, 35, 45, 50, 60 });
  EXPECT_EQ(RidgeEdges(Find(tent)), 10);
}

TEST(FeatureDetection, OrderAndPositionDoNotMatter)
{
  SurfaceMesh tent = Tent({ 46, 46, 46, 34, 34, 34, 46, 46, 30, 46, 46, 46 });
  const std::vector<PointPair> edges = Find(tent);
  std::mt19937 random(5);
  std::shuffle(tent.Triangles.begin(), tent.Triangles.end(), random);
  EXPECT_EQ(Find(tent), edges);
  const Mat3 turn = (Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized())).toRotationMatrix();
  for (Vec3& p : tent.Points)
  {
    p = 1e-3 * (turn * p) + Vec3(5, -7, 2);
  }
  EXPECT_EQ(Find(tent), edges);
}

TEST(FeatureDetection, GapsOfGivenEdges)
{
  const SurfaceMesh plate = Plate(12);
  const auto at = [](Index x, Index y) { return y * 13 + x; };
  std::vector<PointPair> line;
  for (Index x = 1; x < 11; ++x)
  {
    line.push_back({ at(x, 6), at(x + 1, 6) });
  }
  std::vector<PointPair> broken = line;
  broken.erase(broken.begin() + 4, broken.begin() + 6);
  FeatureDetectionOptions options;
  FeatureDetectionReport report;
  CleanFeatureEdges(plate, options, broken, report);
  EXPECT_EQ(broken, line);
  EXPECT_EQ(report.NumberOfGaps, 1);
  EXPECT_EQ(report.NumberOfGapEdges, 2);
  EXPECT_EQ(report.Gaps[0], Vec3(5.5, 6, 0));

  broken.erase(broken.begin() + 4, broken.begin() + 7);
  const std::vector<PointPair> wide = broken;
  CleanFeatureEdges(plate, options, broken, report);
  EXPECT_EQ(broken, wide); // three edges are too many
  options.MaximumGap = 3;
  CleanFeatureEdges(plate, options, broken, report);
  EXPECT_EQ(broken, line);
  options.MaximumGap = 0;
  broken = wide;
  CleanFeatureEdges(plate, options, broken, report);
  EXPECT_EQ(broken, wide);

  // Ends that are side by side aren't joined.
  std::vector<PointPair> parallel;
  for (Index x = 2; x < 6; ++x)
  {
    parallel.push_back({ at(x, 3), at(x + 1, 3) });
    parallel.push_back({ at(x, 4), at(x + 1, 4) });
  }
  std::sort(parallel.begin(), parallel.end());
  std::vector<PointPair> cleaned = parallel;
  CleanFeatureEdges(plate, FeatureDetectionOptions(), cleaned, report);
  EXPECT_EQ(cleaned, parallel);
}

TEST(FeatureDetection, SpursAndCrumbs)
{
  const SurfaceMesh plate = Plate(12);
  const auto at = [](Index x, Index y) { return y * 13 + x; };
  std::vector<PointPair> line;
  for (Index x = 1; x < 11; ++x)
  {
    line.push_back({ at(x, 6), at(x + 1, 6) });
  }
  std::vector<PointPair> loop = { { at(2, 2), at(3, 2) }, { at(2, 2), at(2, 3) },
    { at(3, 2), at(3, 3) }, { at(2, 3), at(3, 3) } };
  std::vector<PointPair> edges = line;
  edges.insert(edges.end(), loop.begin(), loop.end());
  const std::vector<PointPair> clean = [&]
  {
    std::vector<PointPair> sorted = edges;
    std::sort(sorted.begin(), sorted.end());
    return sorted;
  }();
  edges.push_back({ at(5, 6), at(5, 7) }); // spur
  edges.push_back({ at(8, 6), at(8, 5) }); // forked spur
  edges.push_back({ at(8, 5), at(7, 4) });
  edges.push_back({ at(8, 5), at(8, 4) });
  edges.push_back({ at(9, 10), at(10, 10) }); // crumb
  FeatureDetectionOptions options;
  options.MaximumGap = 0;
  options.MinimumLength = 0.12; // 2.5 of 21
  FeatureDetectionReport report;
  CleanFeatureEdges(plate, options, edges, report);
  EXPECT_EQ(edges, clean);
  EXPECT_EQ(report.NumberOfSpurEdges, 5);
  EXPECT_EQ(report.Spurs.size(), 5u);
}

TEST(FeatureDetection, NormalsOfSliversAreNotBelieved)
{
  // The edge 0 4 is cut at x = 0.5; the new point is off by 1e-9 upwards: two slivers stand
  // upright.
  SurfaceMesh plate = Plate(4);
  const auto at = [](Index x, Index y) { return y * 5 + x; };
  const Index extra = static_cast<Index>(plate.Points.size());
  plate.Points.push_back(Vec3(2.5, 2, 1e-9));
  for (std::size_t i = 0; i < plate.Triangles.size(); ++i)
  {
    const Triangle t = plate.Triangles[i];
    if (t == Triangle{ at(2, 2), at(3, 2), at(3, 3) })
    {
      plate.Triangles[i] = { extra, at(3, 2), at(3, 3) };
      plate.Triangles.push_back({ at(2, 2), extra, at(3, 3) });
      plate.Triangles.push_back({ at(2, 2), at(3, 2), extra });
    }
  }
  for (const SurfaceEdge& edge : MeasureEdges(plate))
  {
    if (edge.High == extra || (edge.Low == at(2, 2) && edge.High == at(3, 2)))
    {
      EXPECT_LT(edge.Deviation, 1e-3) << edge.Low << " " << edge.High;
    }
  }
}

/// The closed creases of real parts are found exactly; the rule says no more than the file.
TEST(FeatureDetection, RealParts)
{
  if (!std::filesystem::exists(SharedData() / "surfaces/cad"))
  {
    GTEST_SKIP() << "no surfaces in " << SharedData();
  }
  for (const char* name : { "fandisk", "g01_block_through_hole", "g05_spur_gear", "joint", "rod" })
  {
    SurfaceMesh surface;
    FeatureGraph file;
    const Status status = ReadPart(name, surface, file);
    ASSERT_TRUE(status.Ok()) << status.Message;
    for (PointPair& edge : file.Edges)
    {
      edge = { std::min(edge[0], edge[1]), std::max(edge[0], edge[1]) };
    }
    std::sort(file.Edges.begin(), file.Edges.end());
    EXPECT_EQ(Find(surface), file.Edges) << name;
    SurfaceFeatures features;
    FeatureGraphReport report;
    ASSERT_TRUE(
      BuildSurfaceFeatures(surface, file.Edges, {}, FeatureGraphOptions(), features, report).Ok());
    EXPECT_EQ(features.Corners.size(), file.Corners.size()) << name;
  }
}

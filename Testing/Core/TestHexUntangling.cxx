// SPDX-License-Identifier: BSD-3-Clause
#include "HexUntangling.h"

#include "SharedData.h"
#include "TangledMesh.h"

#include <gtest/gtest.h>

#include <vtkSMPTools.h>

#include <algorithm>

using namespace featurehex;

namespace
{
constexpr UntangleMethod Methods[] = { UntangleMethod::Regularized, UntangleMethod::Stitching };

UntangleReport Untangle(HexMesh& mesh, UntangleMethod method,
  const SurfaceGeometry* surface = nullptr, int maximumSweeps = 100)
{
  UntangleOptions options;
  options.Method = method;
  options.MaximumSweeps = maximumSweeps;
  UntangleReport report;
  Monitor monitor;
  const Status status =
    UntangleHexes(mesh, HexStars(mesh), surface, options, report, monitor);
  EXPECT_TRUE(status.Ok()) << status.Message;
  EXPECT_EQ(report.InvertedAfter, static_cast<Index>(InvertedHexes(mesh).size()));
  return report;
}

/// A ball whose outer layer is thin, with points pushed through it.
HexMesh TangledBall(int n)
{
  HexMesh mesh = BallMesh(n);
  const HexStars stars(mesh);
  std::mt19937 random(3);
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    Vec3& p = mesh.Points[v];
    const bool boundary = stars.OnBoundary(static_cast<Index>(v));
    const double share = random() / 4294967295.0;
    if (boundary)
    {
      p *= 1 - 0.03 * share;
    }
    else if (p.norm() > 1 - 2.5 / n)
    {
      p *= 1 + 0.35 * share;
    }
  }
  return mesh;
}

class AbortAtOnce : public Monitor
{
  bool AbortRequested() override { return true; }
};
}

TEST(HexUntangling, InvertedHexesAreFoundByTheirCorners)
{
  HexMesh mesh = CubeMesh(3);
  EXPECT_TRUE(InvertedHexes(mesh).empty());
  std::swap(mesh.Hexes[5][0], mesh.Hexes[5][1]);
  EXPECT_EQ(InvertedHexes(mesh), std::vector<Index>{ 5 });
}

TEST(HexUntangling, ValidMeshStaysAsItIs)
{
  for (UntangleMethod method : Methods)
  {
    HexMesh mesh = CubeMesh(4);
    const std::vector<Vec3> before = mesh.Points;
    const UntangleReport report = Untangle(mesh, method);
    EXPECT_EQ(report.InvertedBefore, 0);
    EXPECT_EQ(report.Sweeps, 0);
    EXPECT_EQ(mesh.Points, before);
  }
}

TEST(HexUntangling, RandomGridsBecomeValidWithinTheirBoundary)
{
  for (UntangleMethod method : Methods)
  {
    for (double reach : { 0.7, 2.0, 6.0 })
    {
      HexMesh mesh = TangledGrid(8, reach);
      const std::vector<Vec3> before = mesh.Points;
      const HexStars stars(mesh);
      const UntangleReport report = Untangle(mesh, method);
      EXPECT_GT(report.InvertedBefore, 50);
      EXPECT_EQ(report.InvertedAfter, 0)
        << "reach " << reach << ", method " << static_cast<int>(method);
      for (std::size_t v = 0; v < before.size(); ++v)
      {
        if (stars.OnBoundary(static_cast<Index>(v)))
        {
          ASSERT_EQ(mesh.Points[v], before[v]);
        }
      }
    }
  }
}

TEST(HexUntangling, StitchingLeavesFarHexesAlone)
{
  HexMesh mesh = CubeMesh(12);
  const auto id = [&](const Vec3& p) {
    return std::find(mesh.Points.begin(), mesh.Points.end(), p) - mesh.Points.begin();
  };
  mesh.Points[id(Vec3(3, 3, 3))] += Vec3(1.6, 0, 0);
  const std::vector<Vec3> before = mesh.Points;
  const UntangleReport report = Untangle(mesh, UntangleMethod::Stitching);
  EXPECT_GT(report.InvertedBefore, 0);
  EXPECT_EQ(report.InvertedAfter, 0);
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    if ((before[v] - Vec3(3, 3, 3)).lpNorm<Eigen::Infinity>() >= 4)
    {
      EXPECT_EQ(mesh.Points[v], before[v]);
    }
  }
}

TEST(HexUntangling, BoundaryStaysNearTheSurface)
{
  const SurfaceGeometry sphere(SphereSurface(40));
  for (UntangleMethod method : Methods)
  {
    HexMesh mesh = TangledBall(8);
    const HexStars stars(mesh);
    const UntangleReport report = Untangle(mesh, method, &sphere);
    EXPECT_GT(report.InvertedBefore, 10);
    EXPECT_EQ(report.InvertedAfter, 0);
    EXPECT_EQ(report.Hopeless, 0);
    for (std::size_t v = 0; v < mesh.Points.size(); ++v)
    {
      if (stars.OnBoundary(static_cast<Index>(v)))
      {
        EXPECT_NEAR(mesh.Points[v].norm(), 1.0, 2.0 / 8) << "farther than a hex is long";
      }
    }
  }
}

TEST(HexUntangling, HopelessHexesAreCounted)
{
  for (UntangleMethod method : Methods)
  {
    HexMesh mesh = TangledGrid(6, 2.0);
    // A corner of the whole, its edges all on the boundary, is turned inside out.
    const auto corner = std::find(mesh.Points.begin(), mesh.Points.end(), Vec3(0, 0, 0));
    *corner = Vec3(1.5, 1.5, 1.5);
    const UntangleReport report = Untangle(mesh, method);
    EXPECT_EQ(report.Hopeless, 1);
    EXPECT_EQ(report.InvertedAfter, 1);
    EXPECT_LT(report.Sweeps, 100);
  }
}

TEST(HexUntangling, SameBitsForAnyNumberOfThreads)
{
  for (UntangleMethod method : Methods)
  {
    std::vector<std::vector<Vec3>> results;
    for (int threads : { 1, 2 })
    {
      HexMesh mesh = TangledGrid(14, 2.0);
      vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads }, [&] { Untangle(mesh, method); });
      results.push_back(mesh.Points);
    }
    EXPECT_EQ(results[0], results[1]);
  }
}

TEST(HexUntangling, ScaleAndPlaceDoNotMatter)
{
  for (UntangleMethod method : Methods)
  {
    for (double scale : { 1e-6, 1e6 })
    {
      HexMesh mesh = TangledGrid(8, 2.0);
      for (Vec3& p : mesh.Points)
      {
        p = scale * (p + Vec3(100, -50, 20));
      }
      EXPECT_EQ(Untangle(mesh, method).InvertedAfter, 0);
    }
  }
}

TEST(HexUntangling, OnlyChangedVerticesMove)
{
  HexMesh mesh = BallMesh(8);
  const std::vector<Vec3> start = mesh.Points;
  std::vector<char> changed;
  for (Index v = 0; v < static_cast<Index>(start.size()); ++v)
  {
    changed.push_back(start[v][0] > 0);
  }
  const auto center = std::find_if(start.begin(), start.end(),
    [](const Vec3& p) { return p[0] > 0.1 && p.norm() < 0.5; });
  mesh.Points[center - start.begin()] *= -1.5; // into the others
  ASSERT_FALSE(InvertedHexes(mesh).empty());
  UntangleOptions options;
  options.Changed = &changed;
  UntangleReport report;
  Monitor monitor;
  EXPECT_TRUE(UntangleHexes(mesh, HexStars(mesh), nullptr, options, report, monitor).Ok());
  EXPECT_EQ(report.InvertedAfter, 0);
  for (Index v = 0; v < static_cast<Index>(start.size()); ++v)
  {
    EXPECT_TRUE(changed[v] || mesh.Points[v] == start[v]) << v;
  }
}

TEST(HexUntangling, StopsWhenAsked)
{
  for (UntangleMethod method : Methods)
  {
    HexMesh mesh = TangledGrid(6, 2.0);
    UntangleOptions options;
    options.Method = method;
    UntangleReport report;
    AbortAtOnce monitor;
    EXPECT_EQ(UntangleHexes(mesh, HexStars(mesh), nullptr, options, report, monitor).Code,
      StatusCode::Aborted);
  }
}

namespace
{
struct SharedTangle
{
  const char* Name;
  Index Regularized, Stitching; // hexes left inverted, at most
};

// In the list of tests.
void PrintTo(const SharedTangle& tangle, std::ostream* stream)
{
  *stream << tangle.Name;
}

// A test for each mesh: under AddressSanitizer each takes up to a minute.
class SharedTangles : public testing::TestWithParam<SharedTangle>
{
};
}

TEST_P(SharedTangles, AreUntangled)
{
  const SharedTangle& expected = GetParam();
  HexMesh mesh;
  if (!ReadTangledMesh(SharedData() / "tangled" / (std::string(expected.Name) + ".vtk"), mesh))
  {
    GTEST_SKIP() << "no tangled meshes in " << SharedData() << " (set FEATUREHEX_SHARED)";
  }
  HexMesh other = mesh;
  EXPECT_LE(
    Untangle(mesh, UntangleMethod::Regularized, nullptr, 60).InvertedAfter, expected.Regularized);
  EXPECT_LE(
    Untangle(other, UntangleMethod::Stitching, nullptr, 60).InvertedAfter, expected.Stitching);
}

// The 44 and the 1 are inverted at corners that lie wholly on the fixed boundary.
INSTANTIATE_TEST_SUITE_P(HexUntangling, SharedTangles,
  testing::Values(SharedTangle{ "CAD4Per", 0, 160 }, SharedTangle{ "bunnyPer", 44, 44 },
    SharedTangle{ "impellerPer", 0, 0 }, SharedTangle{ "mid2FemPer", 1, 1 },
    SharedTangle{ "mount2Per", 0, 0 }),
  [](const testing::TestParamInfo<SharedTangle>& info) { return std::string(info.param.Name); });

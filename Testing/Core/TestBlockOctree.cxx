// SPDX-License-Identifier: BSD-3-Clause
#include "OctreeChecks.h"

#include "TriangleBoxOverlap.h"

#include <chrono>
#include <iostream>
#include <limits>

using namespace featurehex;
using namespace octreechecks;

namespace
{
OctreeOptions Target(double length, int coarseLevels = 3)
{
  OctreeOptions options;
  options.TargetEdgeLength = length;
  options.CoarseLevels = coarseLevels;
  return options;
}

BlockOctree Build(const SurfaceMesh& surface, const OctreeOptions& options,
  const std::vector<RefinementPoint>& points = {}, OctreePrediction* prediction = nullptr)
{
  BlockOctree octree;
  Monitor monitor;
  const Status status = BuildBlockOctree(surface, points, options, octree, prediction, monitor);
  EXPECT_TRUE(status.Ok()) << status.Message;
  return octree;
}

Status TryBuild(const SurfaceMesh& surface, const OctreeOptions& options,
  const std::vector<RefinementPoint>& points = {})
{
  BlockOctree octree;
  Monitor monitor;
  Status status = BuildBlockOctree(surface, points, options, octree, nullptr, monitor);
  EXPECT_EQ(octree.Leaves.empty(), !status.Ok());
  return status;
}

std::set<BlockSet::Key> LeafSet(const BlockOctree& octree)
{
  std::set<BlockSet::Key> set;
  for (std::size_t n = 0; n < octree.Leaves.size(); ++n)
  {
    const Block b = octree.Leaf(n);
    set.insert({ b.Level, b.Index[0], b.Index[1], b.Index[2] });
  }
  return set;
}

bool BlockMeets(const BlockOctree& octree, const BlockSet::Key& b, const SurfaceMesh& surface)
{
  const double half = octree.CellSize(b[0]);
  const Vec3 center = octree.Origin + half * Vec3(2 * b[1] + 1, 2 * b[2] + 1, 2 * b[3] + 1);
  return std::any_of(surface.Triangles.begin(), surface.Triangles.end(),
    [&](const Triangle& t)
    {
      return TriangleBoxOverlap(center, Vec3::Constant(half), surface.Points[t[0]],
        surface.Points[t[1]], surface.Points[t[2]]);
    });
}

/// Long box, rotated.
SurfaceMesh Bar(const Vec3& half, const Mat3& rotation)
{
  SurfaceMesh mesh;
  for (int n = 0; n < 8; ++n)
  {
    mesh.Points.push_back(rotation * Vec3(n & 1 ? half[0] : -half[0], n & 2 ? half[1] : -half[1],
                                       n & 4 ? half[2] : -half[2]));
  }
  mesh.Triangles = { { 0, 2, 1 }, { 1, 2, 3 }, { 4, 5, 6 }, { 5, 7, 6 }, { 0, 1, 4 }, { 1, 5, 4 },
    { 2, 6, 3 }, { 3, 6, 7 }, { 0, 4, 2 }, { 2, 4, 6 }, { 1, 3, 5 }, { 3, 7, 5 } };
  return mesh;
}
} // namespace

TEST(BlockOctree, KeysRoundTripAndSortAlongTheZCurve)
{
  std::mt19937 random(7);
  const int depth = 11;
  for (int n = 0; n < 10000; ++n)
  {
    Block block;
    block.Level = static_cast<int>(random() % (depth + 1));
    for (int& x : block.Index)
    {
      x = static_cast<int>(random() % (200u << block.Level));
    }
    const Block back = UnpackBlock(PackBlock(block, depth), depth);
    ASSERT_EQ(back.Level, block.Level);
    ASSERT_EQ(back.Index, block.Index);
  }
  EXPECT_LT(PackBlock({ 1, { 1, 0, 0 } }, 3), PackBlock({ 1, { 0, 1, 0 } }, 3));
  EXPECT_LT(PackBlock({ 1, { 0, 1, 0 } }, 3), PackBlock({ 1, { 0, 0, 1 } }, 3));
  const int last = (1 << MaximumBlockBits) - 1;
  const Block corner{ 10, { last, last, last } };
  EXPECT_EQ(UnpackBlock(PackBlock(corner, 10), 10).Index, corner.Index);
}

/// The same octree by brute force: split what meets the surface, balance pair by pair.
TEST(BlockOctree, SameAsBruteForce)
{
  const SurfaceMesh surface = Sphere(Vec3(3, -2, 1), 1, 9);
  const BlockOctree octree = Build(surface, Target(0.13, 3));
  ASSERT_EQ(octree.RootBlocks, (std::array<int, 3>{ 2, 2, 2 }));
  BlockSet blocks(2);
  for (int level = 0; level < octree.BaseLevel; ++level)
  {
    const std::set<BlockSet::Key> leaves = blocks.Leaves;
    for (const BlockSet::Key& b : leaves)
    {
      if (b[0] == level && BlockMeets(octree, b, surface))
      {
        blocks.Split(b);
      }
    }
  }
  blocks.Balance(octree.Depth);
  EXPECT_EQ(LeafSet(octree), blocks.Leaves);
  EXPECT_TRUE(std::is_sorted(octree.Leaves.begin(), octree.Leaves.end()));
  EXPECT_TRUE(IsBalanced(octree));
}

TEST(BlockOctree, ExactSizesMarginAndCentre)
{
  const SurfaceMesh surface = Sphere(Vec3(10, 20, 30), 2, 12);
  for (double length : { 0.3, 0.17, 1.0 / 7 })
  {
    const BlockOctree octree = Build(surface, Target(length));
    EXPECT_EQ(octree.CellSize(octree.BaseLevel), length);
    EXPECT_TRUE(octree.Axes == Mat3::Identity());
    for (const Vec3& p : surface.Points)
    {
      ASSERT_EQ(octree.CellSizeAt(p), length);
      ASSERT_EQ(octree.LeafLevelAt(p), 0);
    }
    const Box box = BoundingBox(surface);
    Vec3 size;
    for (int k = 0; k < 3; ++k)
    {
      size[k] = octree.RootBlocks[k] * 2 * octree.CellSize(0);
    }
    const double rounding = 1e-13; // of coordinates up to 32; the root grid may fit exactly
    EXPECT_GE((box.Low - octree.Origin).minCoeff(), 2 * length - rounding);
    EXPECT_GE((octree.Origin + size - box.High).minCoeff(), 2 * length - rounding);
    EXPECT_LT((octree.Origin + 0.5 * size - box.Center()).norm(), 1e-12);
  }
}

TEST(BlockOctree, LeafAtFindsTheContainingLeaf)
{
  const BlockOctree octree = Build(Sphere(Vec3::Zero(), 1, 8), Target(0.1), { { { 1, 0, 0 }, 2 } });
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int n = 0; n < 20000; ++n)
  {
    Vec3 local;
    for (int k = 0; k < 3; ++k)
    {
      local[k] = uniform(random) * octree.RootBlocks[k] * (2 << octree.Depth);
    }
    const Block b = octree.Leaf(octree.LeafAt(octree.ToModel(local)));
    const double size = 2 << (octree.Depth - b.Level);
    for (int k = 0; k < 3; ++k)
    {
      ASSERT_LE(b.Index[k] * size, local[k] + 1e-9);
      ASSERT_GE((b.Index[k] + 1) * size, local[k] - 1e-9);
    }
  }
  EXPECT_EQ(octree.LeafAt(Vec3::Constant(-1e30)), 0u);
  EXPECT_EQ(octree.LeafAt(Vec3::Constant(1e30)), octree.Leaves.size() - 1);
}

TEST(BlockOctree, LocatorKnowsAllNeighbours)
{
  const BlockOctree octree =
    Build(Sphere(Vec3::Zero(), 1, 8), Target(0.15), { { { 0, 0.3, 0 }, 2 } });
  const std::set<BlockSet::Key> leaves = LeafSet(octree);
  const BlockLocator locator(octree);
  for (std::size_t n = 0; n < octree.Leaves.size(); ++n)
  {
    const Block b = octree.Leaf(n);
    std::int32_t neighbors[27];
    locator.FindNeighbors(n, neighbors);
    for (int d = 0; d < 27; ++d)
    {
      const Block at = { b.Level,
        { b.Index[0] + d % 3 - 1, b.Index[1] + d / 3 % 3 - 1, b.Index[2] + d / 9 - 1 } };
      const auto& i = at.Index;
      std::int32_t expected = BlockLocator::Finer;
      bool inside = true;
      for (int k = 0; k < 3; ++k)
      {
        inside = inside && i[k] >= 0 && i[k] < octree.RootBlocks[k] << b.Level;
      }
      const Block parent = { b.Level - 1, { i[0] >> 1, i[1] >> 1, i[2] >> 1 } };
      if (!inside)
      {
        expected = BlockLocator::Outside;
      }
      else if (leaves.count({ b.Level, i[0], i[1], i[2] }))
      {
        expected = locator.FindExact(at);
        ASSERT_EQ(octree.Leaf(static_cast<std::size_t>(expected)).Index, i);
      }
      else if (b.Level > 0 &&
               leaves.count({ parent.Level, parent.Index[0], parent.Index[1], parent.Index[2] }))
      {
        expected = BlockLocator::Coarser - locator.FindExact(parent);
      }
      ASSERT_EQ(neighbors[d], expected);
      ASSERT_EQ(locator.Find(at), expected);
    }
  }
}

TEST(BlockOctree, RefinementPoints)
{
  const SurfaceMesh surface = Sphere(Vec3::Zero(), 1, 12);
  OctreeOptions options = Target(0.1);
  options.MaximumLevel = 2;
  std::vector<RefinementPoint> points = { { { 1, 0, 0 }, 1 }, { { 0, 0.4, 0.1 }, 2 },
    { { 0, 0, 0 }, 0 }, { { 0, 0, -1 }, 9 }, { { 100, 0, 0 }, 2 }, { { 0.99, 0.01, 0 }, 2 } };
  const BlockOctree octree = Build(surface, options, points);
  EXPECT_EQ(octree.Depth, octree.BaseLevel + 2);
  EXPECT_EQ(octree.FinestCellSize, 0.1 / 4);
  EXPECT_EQ(octree.CellSize(octree.BaseLevel), 0.1);
  EXPECT_TRUE(IsBalanced(octree));
  for (const RefinementPoint& point : points)
  {
    if (point.Position.norm() < 2)
    {
      const int level = std::min(point.Level, options.MaximumLevel);
      EXPECT_GE(octree.LeafLevelAt(point.Position), level);
      for (int n = 0; n < 27; ++n)
      {
        const Vec3 step(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
        EXPECT_GE(octree.LeafLevelAt(point.Position + 1.99 * 0.1 / (1 << level) * step), level);
      }
    }
  }
  EXPECT_LT(octree.LeafLevelAt({ 0, -0.5, 0 }), 0);

  // The order of points and of triangles has no effect.
  std::reverse(points.begin(), points.end());
  SurfaceMesh shuffled = surface;
  std::reverse(shuffled.Triangles.begin(), shuffled.Triangles.end());
  EXPECT_EQ(Build(shuffled, options, points).Leaves, octree.Leaves);
  points.insert(points.end(), points.begin(), points.end());
  EXPECT_EQ(Build(surface, options, points).Leaves, octree.Leaves);
}

TEST(BlockOctree, BalancedOnRandomRefinement)
{
  const unsigned seed = std::random_device()();
  std::cout << "seed " << seed << std::endl;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int round = 0; round < 5; ++round)
  {
    std::vector<RefinementPoint> points(5);
    for (RefinementPoint& p : points)
    {
      p = { { uniform(random), uniform(random), uniform(random) }, static_cast<int>(random() % 4) };
    }
    OctreeOptions options = Target(0.3, 1);
    const BlockOctree octree = Build(Sphere(Vec3::Zero(), 1, 6), options, points);
    EXPECT_TRUE(IsBalanced(octree));
    Monitor monitor;
    HexMesh mesh;
    OctreeDualArrays arrays;
    ASSERT_TRUE(ConvertOctreeToHexes(octree, mesh, &arrays, monitor).Ok());
    ExpectConforming(octree, mesh, arrays);
    EXPECT_GE(SmallestScaledJacobian(mesh), 0.43) << "seed " << seed;
  }
}

TEST(BlockOctree, PredictionAndCellLimit)
{
  const SurfaceMesh surface = Sphere(Vec3::Zero(), 1, 20);
  for (double length : { 0.1, 0.03 })
  {
    const OctreePrediction before = PredictOctree(surface, {}, Target(length));
    OctreePrediction after;
    const BlockOctree octree = Build(surface, Target(length), {}, &after);
    EXPECT_EQ(after.Cells, static_cast<std::int64_t>(8 * octree.Leaves.size()));
    std::cout << "predicted " << before.Cells << " cells, built " << after.Cells << std::endl;
    EXPECT_NEAR(static_cast<double>(before.Cells) / after.Cells, 1.0, 0.25);
    EXPECT_NEAR(static_cast<double>(after.Hexes) / CountDualHexes(octree), 1.0, 0.25);

    OctreeOptions options = Target(length);
    options.MaximumNumberOfCells = after.Cells;
    EXPECT_TRUE(TryBuild(surface, options).Ok());
    options.MaximumNumberOfCells = after.Cells - 1;
    const Status status = TryBuild(surface, options);
    EXPECT_EQ(status.Code, StatusCode::CellLimit);
    EXPECT_NE(status.Message.find(std::to_string(after.Cells - 1)), std::string::npos);
    EXPECT_NE(status.Message.find("Raise TargetEdgeLength"), std::string::npos);
  }
  // Absurd sizes end at once, whatever overflows.
  for (double length : { 1e-4, 1e-9, 1e-300 })
  {
    EXPECT_EQ(TryBuild(surface, Target(length)).Code, StatusCode::CellLimit);
  }
  EXPECT_EQ(TryBuild(surface, Target(1e-5, 12)).Code, StatusCode::CellLimit);
  EXPECT_TRUE(TryBuild(surface, Target(100)).Ok());
}

TEST(BlockOctree, PrincipalAxes)
{
  const Mat3 rotation = Eigen::AngleAxisd(0.6, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  const SurfaceMesh bar = Bar(Vec3(3, 0.4, 0.3), rotation);
  OctreeOptions options = Target(0.1, 2);
  const BlockOctree straight = Build(bar, options);
  options.AlignToPrincipalAxes = true;
  const BlockOctree turned = Build(bar, options);
  const auto blocks = [](const BlockOctree& o)
  { return o.RootBlocks[0] * o.RootBlocks[1] * o.RootBlocks[2]; };
  EXPECT_LT(blocks(turned), blocks(straight));
  EXPECT_LT((turned.Axes.transpose() * turned.Axes - Mat3::Identity()).norm(), 1e-12);
  EXPECT_GT(turned.Axes.determinant(), 0);
  EXPECT_NEAR(std::abs(turned.Axes.col(0).dot(rotation.col(0))), 1, 1e-9);
  for (const Vec3& p : bar.Points)
  {
    EXPECT_EQ(turned.LeafLevelAt(p), 0);
    EXPECT_LT((turned.ToModel(turned.ToLocal(p)) - p).norm(), 1e-12);
  }
  // A body that is aligned already keeps the model's axes.
  const BlockOctree kept = Build(Bar(Vec3(3, 0.4, 0.3), Mat3::Identity()), options);
  EXPECT_TRUE(kept.Axes == Mat3::Identity());
}

TEST(BlockOctree, PlanesOfCellCentresGoThroughFlatFaces)
{
  const Mat3 turn = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (bool turned : { false, true })
  {
    for (int coarseLevels : { 0, 3 })
    {
      const Vec3 half(1.2, 0.9, 0.3); // 24, 18 and 6 cells
      SurfaceMesh bar = Bar(half, turned ? turn : Mat3(Mat3::Identity()));
      for (Vec3& p : bar.Points)
      {
        p += Vec3(0.123, -4.567, 8.91);
      }
      OctreeOptions options = Target(0.1, coarseLevels);
      options.AlignToPrincipalAxes = turned;
      const BlockOctree octree = Build(bar, options);
      for (const Vec3& p : bar.Points)
      {
        const Vec3 cells = octree.ToLocal(p); // whole numbers between cells, centres half-way
        for (int k = 0; k < 3; ++k)
        {
          EXPECT_NEAR(cells[k] - std::floor(cells[k]), 0.5, 0.02)
            << "turned " << turned << ", coarse levels " << coarseLevels << ", axis " << k;
          const double end = octree.RootBlocks[k] * 2.0 * (1 << octree.Depth);
          EXPECT_GE(cells[k], options.MarginCells - 1e-9);
          EXPECT_LE(cells[k], end - options.MarginCells + 1e-9);
        }
      }
    }
  }
}

TEST(BlockOctree, CellsRoundTrip)
{
  const BlockOctree octree =
    Build(Sphere(Vec3(1, 2, 3), 1, 10), Target(0.12), { { { 1, 2, 4 }, 2 } });
  OctreeCells cells = ListOctreeCells(octree);
  ASSERT_EQ(cells.Level.size(), 8 * octree.Leaves.size());
  // any order
  std::mt19937 random(5);
  for (std::size_t n = cells.Level.size() - 1; n > 0; --n)
  {
    const std::size_t m = random() % (n + 1);
    std::swap(cells.Level[n], cells.Level[m]);
    std::swap(cells.OctreeIndex[n], cells.OctreeIndex[m]);
  }
  BlockOctree back = octree;
  back.Leaves.clear();
  back.RootBlocks = { 0, 0, 0 };
  const Status status = RebuildBlockOctree(cells, back);
  ASSERT_TRUE(status.Ok()) << status.Message;
  EXPECT_EQ(back.Leaves, octree.Leaves);
  EXPECT_EQ(back.RootBlocks, octree.RootBlocks);
}

TEST(BlockOctree, RebuildRejectsWhatIsNotAnOctree)
{
  const BlockOctree octree = Build(Sphere(Vec3::Zero(), 1, 6), Target(0.2));
  const OctreeCells good = ListOctreeCells(octree);
  const auto code = [&](const OctreeCells& cells, BlockOctree frame)
  {
    const Status status = RebuildBlockOctree(cells, frame);
    EXPECT_EQ(status.Ok(), !frame.Leaves.empty());
    EXPECT_TRUE(status.Ok() || status.Message.size() > 40);
    return status.Code;
  };
  EXPECT_EQ(code(good, octree), StatusCode::Ok);
  EXPECT_EQ(code(OctreeCells(), octree), StatusCode::InvalidMesh);
  OctreeCells bad = good;
  bad.Level.pop_back();
  EXPECT_EQ(code(bad, octree), StatusCode::InvalidMesh) << "sizes differ";
  bad.OctreeIndex.pop_back();
  EXPECT_EQ(code(bad, octree), StatusCode::InvalidMesh) << "a cell is missing";
  bad = good;
  bad.OctreeIndex[0] = bad.OctreeIndex[1];
  EXPECT_EQ(code(bad, octree), StatusCode::InvalidMesh) << "a cell is there twice";
  for (int value : { -1, 1, std::numeric_limits<int>::max(), std::numeric_limits<int>::min() })
  {
    bad = good;
    bad.OctreeIndex[0][1] = value;
    bad.Level[0] = octree.Depth - 1;
    EXPECT_EQ(code(bad, octree), StatusCode::InvalidMesh) << "index " << value;
  }
  for (int level : { -1, octree.Depth + 1, 1 << 30 })
  {
    bad = good;
    bad.Level[3] = level;
    EXPECT_EQ(code(bad, octree), StatusCode::InvalidMesh) << "level " << level;
  }
  bad = good;
  bad.Level.erase(bad.Level.begin() + 8, bad.Level.begin() + 16);
  bad.OctreeIndex.erase(bad.OctreeIndex.begin() + 8, bad.OctreeIndex.begin() + 16);
  EXPECT_EQ(code(bad, octree), StatusCode::InvalidMesh) << "a hole";
  BlockSet blocks(2);
  blocks.Split({ 0, 0, 0, 0 });
  blocks.Split({ 1, 1, 1, 1 });
  BlockOctree frame;
  frame.Depth = 2;
  EXPECT_EQ(code(blocks.Cells(2), frame), StatusCode::InvalidMesh) << "not balanced";
  blocks.Balance(2);
  EXPECT_EQ(code(blocks.Cells(2), frame), StatusCode::Ok);
  frame.FinestCellSize = -1;
  EXPECT_EQ(code(blocks.Cells(2), frame), StatusCode::InvalidMesh);
  frame.FinestCellSize = 1;
  frame.Axes.col(0) *= 2;
  EXPECT_EQ(code(blocks.Cells(2), frame), StatusCode::InvalidMesh);
  frame.Axes = Mat3::Identity();
  frame.Depth = 40;
  EXPECT_EQ(code(blocks.Cells(2), frame), StatusCode::InvalidMesh);
}

TEST(BlockOctree, BadInput)
{
  SurfaceMesh surface = Sphere(Vec3::Zero(), 1, 4);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (double length : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
  {
    EXPECT_EQ(TryBuild(surface, Target(length)).Code, StatusCode::InvalidOption);
  }
  OctreeOptions options = Target(0.2);
  options.MarginCells = 1;
  EXPECT_EQ(TryBuild(surface, options).Code, StatusCode::InvalidOption);
  EXPECT_EQ(TryBuild(SurfaceMesh(), Target(0.2)).Code, StatusCode::EmptySurface);
  EXPECT_EQ(TryBuild(surface, Target(0.2), { { { nan, 0, 0 }, 1 } }).Code, StatusCode::NonFinite);
  surface.Points[3][1] = nan;
  EXPECT_EQ(TryBuild(surface, Target(0.2)).Code, StatusCode::NonFinite);
  surface.Points[3][1] = 0;
  surface.Triangles[0][0] = -1;
  EXPECT_EQ(TryBuild(surface, Target(0.2)).Code, StatusCode::IndexOutOfRange);
}

TEST(BlockOctree, StopsAtTimeLimit)
{
  BlockOctree octree;
  Monitor monitor;
  monitor.SetTimeLimit(1e-9);
  EXPECT_EQ(
    BuildBlockOctree(Sphere(Vec3::Zero(), 1, 4), {}, Target(0.2), octree, nullptr, monitor).Code,
    StatusCode::TimeLimit);
  EXPECT_TRUE(octree.Leaves.empty());
}

/// Timing on scans with many refinement points; printed, not asserted.
TEST(BlockOctree, ScansAndTiming)
{
  for (const std::string name : { "bunny", "gargoyle" })
  {
    const std::string path = ScanPath(name);
    if (path.empty())
    {
      GTEST_SKIP() << "the scans of the test data are not here";
    }
    SurfaceMesh surface;
    ASSERT_TRUE(ReadSurface(path, surface).Ok());
    std::vector<RefinementPoint> points;
    for (std::size_t n = 0; n < surface.Points.size(); n += 10)
    {
      points.push_back({ surface.Points[n], static_cast<int>(n / 10 % 3) });
    }
    const double length = BoundingBox(surface).Size().maxCoeff() / 26;
    const auto start = std::chrono::steady_clock::now();
    const BlockOctree octree = Build(surface, Target(length), points);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    std::cout << name << ": " << surface.Triangles.size() << " triangles, " << points.size()
              << " refinement points, " << 8 * octree.Leaves.size() << " cells in " << time.count()
              << " s" << std::endl;
    EXPECT_TRUE(IsBalanced(octree));
  }
}

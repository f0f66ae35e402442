// SPDX-License-Identifier: BSD-3-Clause
#include "InterfaceRepair.h"

#include "HexGrids.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace hexgrids;

TEST(InterfaceRepair, FindsTouchingEdgesAndVertices)
{
  const HexMesh mesh = Grid(6);
  const HexGraph graph(mesh);
  // Two hexes that share an edge, two that share a vertex, in both labels.
  const std::vector<char> edge = Labels(6, [](int x, int y, int z) {
    return z == 2 && ((x == 2 && y == 2) || (x == 3 && y == 3));
  });
  EXPECT_EQ(NonManifoldVertices(graph, edge).size(), 2u);
  const std::vector<char> corner = Labels(6, [](int x, int y, int z) {
    return (x == 2 && y == 2 && z == 2) || (x == 3 && y == 3 && z == 3);
  });
  EXPECT_EQ(NonManifoldVertices(graph, corner).size(), 1u);
  std::vector<char> inverse = corner;
  for (char& label : inverse)
  {
    label ^= 1;
  }
  EXPECT_EQ(NonManifoldVertices(graph, inverse).size(), 1u);
  const std::vector<char> box =
    Labels(6, [](int x, int y, int z) { return x > 0 && x < 4 && y > 1 && y < 5 && z == 3; });
  EXPECT_TRUE(NonManifoldVertices(graph, box).empty());
}

TEST(InterfaceRepair, FlipsTheHexNearestToTheSurface)
{
  const HexMesh mesh = Grid(6);
  const HexGraph graph(mesh);
  std::vector<char> inside = Labels(6, [](int x, int y, int z) {
    return z == 2 && ((x == 2 && y == 2) || (x == 3 && y == 3));
  });
  std::vector<double> distances;
  for (char label : inside)
  {
    distances.push_back(label ? -1.0 : 1.0);
  }
  const Index nearest = 3 + 6 * (2 + 6 * 2);
  distances[nearest] = 0.1;
  const RepairResult result = RepairInterface(graph, distances, 100, inside);
  EXPECT_TRUE(result.NonManifoldVertices.empty());
  EXPECT_EQ(result.Flips, 1);
  EXPECT_EQ(inside[nearest], 1);
}

TEST(InterfaceRepair, NoiseBecomesAManifold)
{
  const int n = 12;
  const HexMesh mesh = Grid(n);
  const HexGraph graph(mesh);
  for (unsigned seed = 1; seed <= 8; ++seed)
  {
    std::mt19937 random(seed);
    std::vector<char> inside = Labels(n, [&](int x, int y, int z) {
      const auto inner = [](int i) { return i > 0 && i < n - 1; };
      return inner(x) && inner(y) && inner(z) && random() % 3 == 0;
    });
    const std::vector<double> distances(inside.size(), 0.5);
    const std::size_t bad = NonManifoldVertices(graph, inside).size();
    const RepairResult result = RepairInterface(graph, distances, 20000, inside);
    std::printf("seed %u: %zu bad vertices, %d flips, %zu left\n", seed, bad, result.Flips,
      result.NonManifoldVertices.size());
    EXPECT_TRUE(result.NonManifoldVertices.empty());
    for (int h = 0; h < n * n * n; ++h)
    {
      const bool border = h % n == 0 || h % n == n - 1 || h < n * n || h >= n * n * (n - 1);
      EXPECT_FALSE(border && inside[h]);
    }
  }
}

TEST(InterfaceRepair, TheBoundOnFlipsHolds)
{
  const HexMesh mesh = Grid(8);
  const HexGraph graph(mesh);
  std::vector<char> inside = Labels(8, [](int x, int y, int z) {
    return x > 0 && x < 7 && y > 0 && y < 7 && z > 0 && z < 7 && (x + y + z) % 2 == 0;
  });
  const RepairResult result =
    RepairInterface(graph, std::vector<double>(inside.size(), 1.0), 3, inside);
  EXPECT_EQ(result.Flips, 3);
  EXPECT_FALSE(result.NonManifoldVertices.empty());
}

TEST(InterfaceRepair, ChecksItsInput)
{
  EXPECT_EQ(CheckHexInput(HexMesh()).Code, StatusCode::InvalidMesh);
  HexMesh mesh = Grid(2);
  EXPECT_TRUE(CheckHexInput(mesh).Ok());
  mesh.Points[13][1] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(CheckHexInput(mesh).Code, StatusCode::InvalidMesh);
  mesh = Grid(2);
  mesh.Hexes[3][4] = 27;
  EXPECT_EQ(CheckHexInput(mesh).Code, StatusCode::InvalidMesh);
}

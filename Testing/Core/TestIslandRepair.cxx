// SPDX-License-Identifier: BSD-3-Clause
#include "IslandRepair.h"

#include "HexGrids.h"

#include <gtest/gtest.h>

using namespace hexgrids;

namespace
{
bool Inner(int n, int x, int y, int z)
{
  return x > 0 && x < n - 1 && y > 0 && y < n - 1 && z > 0 && z < n - 1;
}
}

TEST(IslandRepair, JoinsAlongTheCheapestPath)
{
  const int n = 10;
  const HexMesh mesh = Grid(n);
  const HexGraph graph(mesh);
  // A limb of single hexes with a gap at x = 5 and x = 6.
  std::vector<char> inside = Labels(n, [](int x, int y, int z) {
    return x > 0 && x < 9 && (x < 4 ? y > 2 && y < 7 && z > 2 && z < 7 : y == 4 && z == 4) &&
      x != 5 && x != 6;
  });
  HexDistances distances = Distances(inside, 2.0);
  for (int x = 4; x < 9; ++x)
  {
    distances.Signed[x + n * (4 + n * 4)] = 0.3;
  }
  EXPECT_EQ(RepairIslands(graph, distances, OneShell(), inside), 2);
  EXPECT_EQ(inside[5 + n * (4 + n * 4)], 1);
  EXPECT_EQ(inside[6 + n * (4 + n * 4)], 1);
  EXPECT_EQ(InterfaceShells(graph, inside).List.size(), 1u);
  EXPECT_EQ(RepairIslands(graph, distances, OneShell(), inside), 0);
}

TEST(IslandRepair, DropsSmallPiecesFarAwayAndKeepsLargeOnes)
{
  const int n = 14;
  const HexMesh mesh = Grid(n);
  const HexGraph graph(mesh);
  const auto block = [](int x, int low, int high) { return x >= low && x < high; };
  std::vector<char> inside = Labels(n, [&](int x, int y, int z) {
    const bool main = block(x, 1, 5) && block(y, 1, 5) && block(z, 1, 5);
    const bool crumb = x == 12 && y == 12 && z == 12;
    const bool large = block(x, 9, 12) && block(y, 1, 4) && block(z, 8, 11);
    return main || crumb || large;
  });
  const HexDistances distances = Distances(inside, 2.0);
  EXPECT_EQ(RepairIslands(graph, distances, OneShell(), inside), 1);
  EXPECT_EQ(inside[12 + n * (12 + n * 12)], 0);
  EXPECT_EQ(InterfaceShells(graph, inside).List.size(), 2u);
}

TEST(IslandRepair, OpensPocketsThatAreNoCavities)
{
  const int n = 9;
  const HexMesh mesh = Grid(n);
  const HexGraph graph(mesh);
  std::vector<char> inside = Labels(n, [&](int x, int y, int z) {
    return Inner(n, x, y, z) && !(x == 4 && y == 4 && z > 2 && z < 7);
  });
  HexDistances distances = Distances(inside, 2.0);
  distances.Signed[4 + n * (4 + n * 7)] = -0.1;
  EXPECT_EQ(RepairIslands(graph, distances, OneShell(), inside), 1);
  EXPECT_EQ(inside[4 + n * (4 + n * 7)], 0);
  EXPECT_EQ(InterfaceShells(graph, inside).List.size(), 1u);
}

TEST(IslandRepair, LeavesCavitiesAndSeveralBodiesAlone)
{
  const int n = 12;
  const HexMesh mesh = Grid(n);
  const HexGraph graph(mesh);
  // A hollow box and a second body beside it.
  const auto cavity = [](int x, int y, int z) {
    return x > 2 && x < 5 && y > 2 && y < 9 && z > 2 && z < 9;
  };
  std::vector<char> inside = Labels(n, [&](int x, int y, int z) {
    return Inner(n, x, y, z) && x != 7 && !cavity(x, y, z);
  });
  const std::vector<char> before = inside;
  Shells shells;
  shells.List.push_back({ 2, 1.0, 1, Vec3::Zero() });
  shells.List.push_back({ 2, -1.0, 1, Vec3::Zero() });
  shells.List.push_back({ 2, 1.0, 1, Vec3::Zero() });
  shells.OfFace = { 0, 1, 2 };
  HexDistances distances = Distances(inside, 1.0);
  for (int h = 0; h < n * n * n; ++h)
  {
    const int x = h % n;
    distances.Triangles[h] = x > 7 ? 2 : cavity(x, h / n % n, h / n / n) ? 1 : 0;
  }
  EXPECT_EQ(RepairIslands(graph, distances, shells, inside), 0);
  EXPECT_EQ(inside, before);
}

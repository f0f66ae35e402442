// SPDX-License-Identifier: BSD-3-Clause
#include "HandleRepair.h"

#include "HexGrids.h"

#include <gtest/gtest.h>

using namespace hexgrids;

namespace
{
constexpr int N = 10;

/// A sheet of hexes, one thick.
bool Sheet(int x, int y, int z) { return z == 4 && x > 0 && x < N - 1 && y > 0 && y < N - 1; }

/// The surface passes between all hexes.
bool SeesNone(Index, Index) { return false; }

Index TotalGenus(const HexGraph& graph, const std::vector<char>& inside)
{
  Index genus = 0;
  for (const ShellTopology& shell : InterfaceShells(graph, inside).List)
  {
    genus += shell.Genus();
  }
  return genus;
}
}

TEST(HandleRepair, FillsWindowsOfOneTwoAndThreeHexes)
{
  const HexMesh mesh = Grid(N);
  const HexGraph graph(mesh);
  std::vector<char> inside = Labels(N, [](int x, int y, int z) {
    const bool one = x == 2 && y == 2;
    const bool two = y == 5 && (x == 2 || x == 3);
    const bool three = x == 6 && y > 3 && y < 7;
    return Sheet(x, y, z) && !one && !two && !three;
  });
  EXPECT_EQ(TotalGenus(graph, inside), 3);
  std::vector<Index> excess = { 3 };
  // Where that is as cheap, a window near the border may be opened into a notch instead.
  EXPECT_LE(RepairHandles(graph, Distances(inside, 0.4), OneShell(), SeesNone, excess, inside), 6);
  EXPECT_EQ(excess[0], 0);
  EXPECT_EQ(TotalGenus(graph, inside), 0);
  EXPECT_TRUE(NonManifoldVertices(graph, inside).empty());
}

TEST(HandleRepair, CutsBridges)
{
  const HexMesh mesh = Grid(N);
  const HexGraph graph(mesh);
  // Two plates that a wall joins on one side and a bridge of one hex on the other.
  std::vector<char> inside = Labels(N, [](int x, int y, int z) {
    const bool plates = (z == 3 || z == 5) && x > 0 && x < N - 1 && y > 0 && y < N - 1;
    const bool between = z == 4 && (x == 1 ? y > 0 && y < N - 1 : x == 7 && y == 5);
    return plates || between;
  });
  EXPECT_EQ(TotalGenus(graph, inside), 1);
  std::vector<Index> excess = { 1 };
  EXPECT_EQ(RepairHandles(graph, Distances(inside, 0.4), OneShell(), SeesNone, excess, inside), 1);
  EXPECT_EQ(inside[7 + N * (5 + N * 4)], 0);
  EXPECT_EQ(TotalGenus(graph, inside), 0);
}

TEST(HandleRepair, NeverTearsOffAComponent)
{
  const HexMesh mesh = Grid(N);
  const HexGraph graph(mesh);
  // Two plates joined by a single hex: no handle, though flipping it raises the Euler
  // characteristic too.
  std::vector<char> inside = Labels(N, [](int x, int y, int z) {
    const bool plates = (z == 3 || z == 5) && x > 0 && x < N - 1 && y > 0 && y < N - 1;
    return plates || (z == 4 && x == 7 && y == 5);
  });
  const std::vector<char> before = inside;
  std::vector<Index> excess = { 1 };
  EXPECT_EQ(RepairHandles(graph, Distances(inside, 0.4), OneShell(), SeesNone, excess, inside), 0);
  EXPECT_EQ(inside, before);
  EXPECT_EQ(excess[0], 1);
}

TEST(HandleRepair, KeepsWantedAndFarHandles)
{
  const HexMesh mesh = Grid(N);
  const HexGraph graph(mesh);
  const std::vector<char> holed =
    Labels(N, [](int x, int y, int z) { return Sheet(x, y, z) && !(x == 4 && y == 4); });
  std::vector<char> inside = holed;
  std::vector<Index> none = { 0 };
  EXPECT_EQ(RepairHandles(graph, Distances(inside, 0.4), OneShell(), SeesNone, none, inside), 0);
  std::vector<Index> one = { 1 };
  EXPECT_EQ(RepairHandles(graph, Distances(inside, 1.5), OneShell(), SeesNone, one, inside), 0);
  EXPECT_EQ(inside, holed);
}

TEST(HandleRepair, HandlesOfTheSurfaceComeLast)
{
  const HexMesh mesh = Grid(N);
  const HexGraph graph(mesh);
  // Two plates that a wall joins on one side; on the other a beam of the surface, one hex long, and
  // a bridge of two that it doesn't have.
  const auto isBeam = [](int x, int y, int z) { return z == 4 && x == 7 && y == 3; };
  const auto isBridge = [](int x, int y, int z) { return z == 4 && (x == 6 || x == 7) && y == 6; };
  const std::vector<char> joined = Labels(N, [&](int x, int y, int z) {
    const bool plates = (z == 3 || z == 5) && x > 0 && x < N - 1 && y > 0 && y < N - 1;
    return plates || (z == 4 && x == 1 && y > 0 && y < N - 1) || isBeam(x, y, z) ||
      isBridge(x, y, z);
  });
  const std::vector<char> bridge = Labels(N, isBridge);
  const auto seesOther = [&](Index a, Index b) { return !bridge[a] && !bridge[b]; };
  std::vector<char> inside = joined;
  EXPECT_EQ(TotalGenus(graph, inside), 2);
  std::vector<Index> excess = { 1 };
  EXPECT_EQ(
    RepairHandles(graph, Distances(inside, 0.4), OneShell(), seesOther, excess, inside), 2);
  EXPECT_EQ(inside, Labels(N, [&](int x, int y, int z) {
    return joined[x + N * (y + N * z)] && !isBridge(x, y, z);
  }));
  // With nothing else to cut the number of handles counts.
  excess = { 1 };
  EXPECT_EQ(
    RepairHandles(graph, Distances(inside, 0.4), OneShell(), seesOther, excess, inside), 1);
  EXPECT_EQ(TotalGenus(graph, inside), 0);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceTopology.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace featurehex;

namespace
{
const std::vector<Triangle> Tetrahedron = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
}

TEST(SurfaceTopology, EdgeTable)
{
  const EdgeTable edges(Tetrahedron);
  int count = 0;
  std::uint64_t previous = 0;
  edges.VisitEdges(
    [&](const EdgeUse* first, const EdgeUse* last)
    {
      EXPECT_EQ(last - first, 2);
      EXPECT_LT(first->Low(), first->High());
      EXPECT_TRUE(count == 0 || first->Edge > previous);
      previous = first->Edge;
      ++count;
    });
  EXPECT_EQ(count, 6);
  EXPECT_EQ(edges.NumberOfFaces(3, 1), 2u);
  EXPECT_EQ(edges.NumberOfFaces(3, 4), 0u);
  const EdgeTable none((std::vector<Triangle>()));
  none.VisitEdges([](const EdgeUse*, const EdgeUse*) { FAIL(); });
}

TEST(SurfaceTopology, OppositeSidesAndFans)
{
  const std::vector<Index> opposite = OppositeSides(EdgeTable(Tetrahedron));
  for (std::size_t side = 0; side < opposite.size(); ++side)
  {
    ASSERT_GE(opposite[side], 0);
    EXPECT_EQ(opposite[opposite[side]], static_cast<Index>(side));
  }
  EXPECT_EQ(CountFans(Tetrahedron, opposite, 5), (std::vector<Index>{ 1, 1, 1, 1, 0 }));
  // Two that share point 0; one of them has a triangle turned round.
  std::vector<Triangle> two = Tetrahedron;
  for (Triangle t : Tetrahedron)
  {
    for (Index& v : t)
    {
      v = v == 0 ? 0 : v + 3;
    }
    two.push_back(t);
  }
  std::swap(two[5][0], two[5][1]);
  EXPECT_EQ(
    CountFans(two, OppositeSides(EdgeTable(two)), 7), (std::vector<Index>{ 2, 1, 1, 1, 1, 1, 1 }));
  std::vector<Triangle> open = Tetrahedron;
  open.pop_back();
  const std::vector<Index> sides = OppositeSides(EdgeTable(open));
  EXPECT_EQ(std::count(sides.begin(), sides.end(), -1), 3);
}

TEST(SurfaceTopology, FirstDuplicates)
{
  EXPECT_EQ(FirstDuplicates({ { 4, 5, 6 }, { 1, 2, 3 }, { 6, 4, 5 }, { 3, 2, 1 }, { 6, 5, 4 } }),
    (std::vector<Index>{ 0, 1, 0, 1, 0 }));
}

/// Chains of triangles on one line, filled in four ways.
TEST(SurfaceTopology, FlipsKeepTheTableOfSides)
{
  // A tetrahedron whose edge 0 1 carries points 4, 5, 6 on the side of triangle 0 2 1 only.
  const std::vector<Vec3> points = { Vec3(0, 0, 0), Vec3(4, 4, 4), Vec3(0, 4, 0), Vec3(0, 0, 4),
    Vec3(1, 1, 1), Vec3(2, 2, 2), Vec3(3, 3, 3) };
  const std::vector<std::vector<Triangle>> fillings = {
    { { 0, 4, 1 }, { 4, 5, 1 }, { 5, 6, 1 } }, // fan at 1
    { { 0, 6, 1 }, { 0, 5, 6 }, { 0, 4, 5 } }, // fan at 0
    { { 0, 5, 1 }, { 0, 4, 5 }, { 5, 6, 1 } }, // balanced
    { { 0, 4, 1 }, { 4, 6, 1 }, { 4, 5, 6 } }  // zigzag
  };
  for (const std::vector<Triangle>& filling : fillings)
  {
    std::vector<Triangle> triangles = { { 0, 2, 4 }, { 4, 2, 5 }, { 5, 2, 6 }, { 6, 2, 1 },
      { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
    triangles.insert(triangles.end(), filling.begin(), filling.end());
    std::vector<Index> opposite = OppositeSides(EdgeTable(triangles));
    ASSERT_EQ(std::count(opposite.begin(), opposite.end(), -1), 0);
    const CollinearFlips flips = FlipCollinearTriangles(points, triangles, opposite);
    EXPECT_EQ(flips.NumberOfFlips, 3);
    EXPECT_TRUE(flips.Remaining.empty());
    EXPECT_TRUE(opposite == OppositeSides(EdgeTable(triangles)));
    double volume = 0;
    for (const Triangle& t : triangles)
    {
      const Vec3 normal = (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
      EXPECT_GT(normal.norm(), 0);
      volume += points[t[0]].dot(normal) / 6;
    }
    EXPECT_NEAR(std::abs(volume), 64.0 / 6, 1e-12);
  }
}

TEST(SurfaceTopology, RayCrossesInSpecialPositions)
{
  // A box of 2 x 2 x 2 around the origin: rays through corners, along edges and faces.
  std::vector<Vec3> points;
  for (int i = 0; i < 8; ++i)
  {
    points.push_back(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1));
  }
  const std::vector<Triangle> box = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 },
    { 0, 1, 5 }, { 0, 5, 4 }, { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 },
    { 1, 7, 5 } };
  for (double y : { -2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0 })
  {
    for (double z : { -2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0 })
    {
      for (double x : { -2.0, 0.0, 2.0 })
      {
        const bool inside = std::abs(x) < 1 && std::abs(y) < 1 && std::abs(z) < 1;
        const bool onSurface = std::abs(x) <= 1 && std::abs(y) <= 1 && std::abs(z) <= 1 && !inside;
        int crossings = 0;
        for (const Triangle& t : box)
        {
          crossings += RayCrosses(Vec3(x, y, z), points[t[0]], points[t[1]], points[t[2]]) ? 1 : 0;
        }
        EXPECT_TRUE(onSurface || crossings % 2 == (inside ? 1 : 0)) << x << " " << y << " " << z;
      }
    }
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "PolylineDistance.h"

#include <gtest/gtest.h>

using namespace featurehex;

TEST(PolylineDistance, ClosestPoints)
{
  const Polyline line({ { 0, 0, 0 }, { 2, 0, 0 }, { 2, 0, 0 }, { 2, 3, 0 } });
  EXPECT_DOUBLE_EQ(line.Length(), 5.0);
  const PolylinePoint p = line.Closest({ 1, 0, 2 });
  EXPECT_DOUBLE_EQ(p.Distance, 2.0);
  EXPECT_DOUBLE_EQ(p.Arc, 1.0);
  EXPECT_DOUBLE_EQ(line.Closest({ 5, 1, 0 }).Arc, 3.0);
  EXPECT_DOUBLE_EQ(line.Closest({ 2, 9, 0 }).Distance, 6.0);
  EXPECT_DOUBLE_EQ(Polyline({ { 1, 1, 1 } }).Closest({ 1, 1, 4 }).Distance, 3.0);
  EXPECT_DOUBLE_EQ(Polyline({}).Closest({ 0, 0, 0 }).Distance, 1e300);
}

TEST(PolylineDistance, Pieces)
{
  const Polyline line({ { 0, 0, 0 }, { 2, 0, 0 }, { 2, 3, 0 } });
  const Polyline piece = line.Between(1.0, 3.0);
  EXPECT_DOUBLE_EQ(piece.Length(), 2.0);
  EXPECT_TRUE(piece.Points().front().isApprox(Vec3(1, 0, 0)));
  EXPECT_TRUE(piece.Points().back().isApprox(Vec3(2, 1, 0)));
  EXPECT_DOUBLE_EQ(line.Between(0.0, 5.0).Length(), 5.0);
}

TEST(PolylineDistance, BoundsEncloseTheTruth)
{
  // A half circle and its diameter: 1 one way, 1 the other.
  std::vector<Vec3> circle;
  const int n = 200;
  for (int i = 0; i <= n; ++i)
  {
    const double a = std::acos(-1.0) * i / n;
    circle.emplace_back(std::cos(a), std::sin(a), 0);
  }
  const Polyline arc(circle), chord({ { 1, 0, 0 }, { -1, 0, 0 } });
  for (const LengthBounds& bounds :
    { LargestDistance(arc, chord, 1e-6), LargestDistance(chord, arc, 1e-6) })
  {
    EXPECT_LE(bounds.Lower, 1.0 + 1e-12);
    EXPECT_GE(bounds.Upper, std::cos(0.5 * std::acos(-1.0) / n));
    EXPECT_LE(bounds.Upper, 1.011);
  }
  // A piece of a line and the whole line: nothing one way, the rest the other.
  const Polyline half({ { 0, 0, 0 }, { 1, 0, 0 } });
  EXPECT_NEAR(LargestDistance(half, chord, 1e-6).Upper, 0.0, 1e-6);
  EXPECT_NEAR(LargestDistance(chord, half, 1e-6).Upper, 1.0, 0.01);
}

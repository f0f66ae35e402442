// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleBoxOverlap.h"

#include <gtest/gtest.h>

#include <iostream>
#include <random>
#include <vector>

using namespace featurehex;

namespace
{
/// Independent truth: clip the triangle by the six planes of the box; what remains overlaps.
bool ClippedTriangleRemains(const Vec3& center, const Vec3& half, std::vector<Vec3> polygon)
{
  for (int plane = 0; plane < 6 && !polygon.empty(); ++plane)
  {
    const int k = plane / 2;
    const double sign = plane % 2 ? -1 : 1;
    const auto inside = [&](const Vec3& p) { return half[k] - sign * (p[k] - center[k]); };
    std::vector<Vec3> kept;
    for (std::size_t n = 0; n < polygon.size(); ++n)
    {
      const Vec3& a = polygon[n];
      const Vec3& b = polygon[(n + 1) % polygon.size()];
      const double da = inside(a);
      const double db = inside(b);
      if (da >= 0)
      {
        kept.push_back(a);
      }
      if ((da > 0 && db < 0) || (da < 0 && db > 0))
      {
        kept.push_back(a + da / (da - db) * (b - a));
      }
    }
    polygon = kept;
  }
  return !polygon.empty();
}
} // namespace

TEST(TriangleBoxOverlap, AgreesWithClipping)
{
  const unsigned seed = std::random_device()();
  std::cout << "seed " << seed << std::endl;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&](double scale)
  { return Vec3(scale * Vec3(uniform(random), uniform(random), uniform(random))); };
  int overlaps = 0;
  constexpr int count = 200000;
  for (int n = 0; n < count; ++n)
  {
    const Vec3 center = vector(1);
    const Vec3 half = vector(0.5).cwiseAbs();
    const Vec3 a = vector(2);
    const Vec3 b = n % 3 ? vector(2) : Vec3(a + vector(0.3)); // slivers too
    const Vec3 c = n % 5 ? vector(2) : Vec3(b + vector(0.01));
    const bool expected = ClippedTriangleRemains(center, half, { a, b, c });
    ASSERT_EQ(TriangleBoxOverlap(center, half, a, b, c), expected) << "seed " << seed;
    overlaps += expected;
  }
  EXPECT_GT(overlaps, count / 20);
  EXPECT_LT(overlaps, count - count / 20);
}

TEST(TriangleBoxOverlap, TouchingCounts)
{
  const Vec3 center(0.5, 0.5, 0.5);
  const Vec3 half(0.5, 0.5, 0.5);
  // in the plane of a face, at an edge, at a corner
  EXPECT_TRUE(TriangleBoxOverlap(center, half, { 1, 0, 0 }, { 1, 2, 0 }, { 1, 0, 2 }));
  EXPECT_TRUE(TriangleBoxOverlap(center, half, { 1, 1, 0 }, { 2, 2, 0 }, { 2, 2, 1 }));
  EXPECT_TRUE(TriangleBoxOverlap(center, half, { 1, 1, 1 }, { 2, 1, 2 }, { 1, 2, 2 }));
  EXPECT_FALSE(TriangleBoxOverlap(center, half, { 1.0001, 0, 0 }, { 2, 2, 0 }, { 2, 0, 2 }));
  // across a corner: boxes overlap, the plane passes
  EXPECT_FALSE(TriangleBoxOverlap(center, half, { 3.1, 0, 0 }, { 0, 3.1, 0 }, { 0, 0, 3.1 }));
  EXPECT_TRUE(TriangleBoxOverlap(center, half, { 3, 0, 0 }, { 0, 3, 0 }, { 0, 0, 3 }));
}

TEST(TriangleBoxOverlap, DegenerateTriangles)
{
  const Vec3 center = Vec3::Zero();
  const Vec3 half = Vec3::Ones();
  const Vec3 point(0.3, 0.2, 0.1);
  EXPECT_TRUE(TriangleBoxOverlap(center, half, point, point, point));
  EXPECT_FALSE(TriangleBoxOverlap(center, half, 9 * point, 9 * point, 9 * point));
  EXPECT_TRUE(TriangleBoxOverlap(center, half, { -3, 0, 0 }, { 3, 0, 0 }, { 0, 0, 0 }));
  EXPECT_FALSE(TriangleBoxOverlap(center, half, { -3, 2.5, 0 }, { 3, -0.5, 3 }, { 0, 1, 1.5 }));
}

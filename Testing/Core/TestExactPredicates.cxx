// SPDX-License-Identifier: BSD-3-Clause
#include "ExactPredicates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace featurehex;

namespace
{
using Wide = __int128;
using WidePoint = std::array<long long, 3>;

int Sign(Wide value)
{
  return value > 0 ? 1 : (value < 0 ? -1 : 0);
}

Vec3 ToDouble(const WidePoint& p)
{
  return Vec3(static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]));
}

int Reference3D(const WidePoint& a, const WidePoint& b, const WidePoint& c, const WidePoint& d)
{
  Wide u[3], v[3], w[3];
  for (int k = 0; k < 3; ++k)
  {
    u[k] = b[k] - a[k];
    v[k] = c[k] - a[k];
    w[k] = d[k] - a[k];
  }
  return Sign(w[0] * (u[1] * v[2] - u[2] * v[1]) + w[1] * (u[2] * v[0] - u[0] * v[2]) +
              w[2] * (u[0] * v[1] - u[1] * v[0]));
}

/// Integers below 2^38: the determinant fits into 128 bits.
class NearlyCoplanar
{
public:
  explicit NearlyCoplanar(unsigned seed)
    : Generator(seed)
  {
  }

  WidePoint Random()
  {
    std::uniform_int_distribution<long long> coordinate(-(1LL << 36), 1LL << 36);
    return { coordinate(this->Generator), coordinate(this->Generator),
      coordinate(this->Generator) };
  }

  /// a + i (b - a) + j (c - a), moved by at most @a noise in each coordinate.
  WidePoint Combination(const WidePoint& a, const WidePoint& b, const WidePoint& c, int noise)
  {
    std::uniform_int_distribution<int> factor(-2, 2);
    std::uniform_int_distribution<int> move(-noise, noise);
    const int i = factor(this->Generator), j = factor(this->Generator);
    WidePoint p;
    for (int k = 0; k < 3; ++k)
    {
      p[k] = a[k] + i * (b[k] - a[k]) / 4 + j * (c[k] - a[k]) / 4 + move(this->Generator);
    }
    return p;
  }

private:
  std::mt19937 Generator;
};
} // namespace

TEST(ExactPredicates, SignConvention)
{
  const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
  EXPECT_EQ(Orient3D(a, b, c, Vec3(0, 0, 1)), 1);
  EXPECT_EQ(Orient3D(a, b, c, Vec3(0, 0, -1)), -1);
  EXPECT_EQ(Orient3D(a, b, c, Vec3(5, -3, 0)), 0);
  EXPECT_EQ(Orient2D(a, b, c, 0, 1), 1);
  EXPECT_EQ(Orient2D(a, c, b, 0, 1), -1);
  EXPECT_EQ(Orient2D(a, b, Vec3(7, 0, 3), 0, 1), 0);
}

TEST(ExactPredicates, AgreesWithIntegersNearTheBoundary)
{
  NearlyCoplanar points(1);
  int zeros = 0;
  for (int i = 0; i < 100000; ++i)
  {
    const WidePoint a = points.Random(), b = points.Random(), c = points.Random();
    const WidePoint d = points.Combination(a, b, c, i % 3);
    const int expected = Reference3D(a, b, c, d);
    zeros += expected == 0 ? 1 : 0;
    ASSERT_EQ(Orient3D(ToDouble(a), ToDouble(b), ToDouble(c), ToDouble(d)), expected) << i;
    ASSERT_EQ(Orient3DExact(ToDouble(a), ToDouble(b), ToDouble(c), ToDouble(d)), expected) << i;
    for (int k = 0; k < 3; ++k)
    {
      const int m = (k + 1) % 3;
      const Wide turn = static_cast<Wide>(b[k] - a[k]) * (d[m] - a[m]) -
                        static_cast<Wide>(b[m] - a[m]) * (d[k] - a[k]);
      ASSERT_EQ(Orient2D(ToDouble(a), ToDouble(b), ToDouble(d), k, m), Sign(turn)) << i;
      ASSERT_EQ(Orient2DExact(ToDouble(a), ToDouble(b), ToDouble(d), k, m), Sign(turn)) << i;
    }
  }
  // Otherwise the exact path has not been tested.
  EXPECT_GT(zeros, 100);
}

TEST(ExactPredicates, OneUnitInTheLastPlaceDecides)
{
  // Three points on the line x = y, z = 0.25 - 2 x.
  const Vec3 a(12, 12, -23.75), b(24, 24, -47.75), c(0.5, 0.5, -0.75);
  ASSERT_TRUE(Collinear(a, b, c));
  Vec3 moved = c;
  moved[0] = std::nextafter(moved[0], 1.0);
  EXPECT_FALSE(Collinear(a, b, moved));
  EXPECT_EQ(Orient2D(a, b, moved, 0, 1), -1);
  moved[0] = std::nextafter(0.5, 0.0);
  EXPECT_EQ(Orient2D(a, b, moved, 0, 1), 1);
}

TEST(ExactPredicates, DifferencesThatAreNotDoubles)
{
  // b - a and c - a round, with tails; swapping two points must change the sign exactly.
  std::mt19937 generator(3);
  std::uniform_real_distribution<double> small(0, 1e-12);
  for (int i = 0; i < 20000; ++i)
  {
    Vec3 p[4];
    for (int k = 0; k < 4; ++k)
    {
      const double big = 0.1 * k;
      p[k] = Vec3(big + small(generator), 3 * big + small(generator), small(generator) + (k == 2));
    }
    const int sign = Orient3D(p[0], p[1], p[2], p[3]);
    ASSERT_EQ(Orient3DExact(p[0], p[1], p[2], p[3]), sign);
    ASSERT_EQ(Orient3D(p[1], p[0], p[2], p[3]), -sign);
    ASSERT_EQ(Orient3D(p[1], p[2], p[0], p[3]), sign);
    ASSERT_EQ(Orient3D(p[3], p[1], p[2], p[0]), -sign);
    ASSERT_EQ(Orient3D(p[0], p[1], p[3], p[2]), -sign);
  }
}

TEST(ExactPredicates, ScalesThatWouldUnderflowOrOverflow)
{
  const std::vector<Vec3> base = { Vec3(0, 0, 0), Vec3(1, 0.3, 0.1), Vec3(0.2, 1, 0.7),
    Vec3(1.2, 1.3, std::nextafter(0.1 + 0.7, 1.0)) };
  const int expected = Orient3DExact(base[0], base[1], base[2], base[3]);
  ASSERT_NE(expected, 0);
  for (int exponent : { -900, -400, -200, 0, 200, 400, 900 })
  {
    std::vector<Vec3> points = base;
    for (Vec3& p : points)
    {
      p *= std::ldexp(1.0, exponent);
    }
    const std::vector<Vec3> safe = PointsForPredicates(points);
    EXPECT_EQ(Orient3D(safe[0], safe[1], safe[2], safe[3]), expected) << exponent;
  }
  // Within the range nothing is touched.
  const std::vector<Vec3> given = { Vec3(1e-60, -1e60, 0), Vec3(1e9 + 0.1, 0.1, 3) };
  EXPECT_TRUE(PointsForPredicates(given) == given);
  const std::vector<Vec3> zero = { Vec3::Zero() };
  EXPECT_TRUE(PointsForPredicates(zero) == zero);
}

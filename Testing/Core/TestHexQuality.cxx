// SPDX-License-Identifier: BSD-3-Clause

#include "HexQuality.h"
#include "ValidationShapes.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

using namespace featurehex;

TEST(HexQuality, CubeIsOneAtEveryScale)
{
  for (double scale : { 1e-200, 1e-9, 1.0, 1e9, 1e200 })
  {
    HexMesh mesh = CubeMesh(1);
    for (Vec3& p : mesh.Points)
    {
      p *= scale;
    }
    for (double c : CornerScaledJacobians(mesh, 0))
    {
      EXPECT_DOUBLE_EQ(c, 1.0) << scale;
    }
  }
}

TEST(HexQuality, ShearedCornersHaveTheSineOfTheAngle)
{
  HexMesh mesh = CubeMesh(1);
  for (Vec3& p : mesh.Points)
  {
    p.x() += p.y(); // 45 degrees
  }
  EXPECT_NEAR(ScaledJacobian(mesh, 0), std::sqrt(0.5), 1e-15);
}

TEST(HexQuality, MirroredHexIsMinusOne)
{
  HexMesh mesh = CubeMesh(1);
  for (Vec3& p : mesh.Points)
  {
    p.z() = -p.z();
  }
  EXPECT_DOUBLE_EQ(ScaledJacobian(mesh, 0), -1.0);
}

TEST(HexQuality, BrokenHexesNeverLookGood)
{
  const double inf = std::numeric_limits<double>::infinity();
  for (double bad : { std::numeric_limits<double>::quiet_NaN(), inf, -inf })
  {
    HexMesh mesh = CubeMesh(1);
    mesh.Points[3].y() = bad;
    EXPECT_EQ(ScaledJacobian(mesh, 0), -1.0);
  }
  HexMesh repeated = CubeMesh(1);
  repeated.Hexes[0][6] = repeated.Hexes[0][2];
  EXPECT_EQ(ScaledJacobian(repeated, 0), -1.0);
  HexMesh missing = CubeMesh(1);
  missing.Hexes[0][6] = 8;
  EXPECT_EQ(ScaledJacobian(missing, 0), -1.0);
  missing.Hexes[0][6] = -1;
  EXPECT_EQ(ScaledJacobian(missing, 0), -1.0);
  HexMesh collapsed = CubeMesh(1);
  collapsed.Points[1] = collapsed.Points[0];
  EXPECT_EQ(ScaledJacobian(collapsed, 0), -1.0);
  HexMesh flat = CubeMesh(1);
  for (Vec3& p : flat.Points)
  {
    p.z() = 0;
  }
  EXPECT_EQ(ScaledJacobian(flat, 0), -1.0);
}

TEST(HexQuality, Statistics)
{
  const QualityStatistics s = SummarizeQuality({ 1.0, 0.5, 0.02, -0.5, 0.0 });
  EXPECT_EQ(s.Minimum, -0.5);
  EXPECT_EQ(s.Maximum, 1.0);
  EXPECT_DOUBLE_EQ(s.Mean, 1.02 / 5);
  EXPECT_NEAR(s.StandardDeviation, std::sqrt(1.29232 / 5), 1e-12);
  EXPECT_EQ(s.NonPositive, 2);
  EXPECT_EQ(s.Histogram[19], 1);
  EXPECT_EQ(s.Histogram[10], 1);
  EXPECT_EQ(s.Histogram[0], 1);
  EXPECT_EQ(std::accumulate(s.Histogram.begin(), s.Histogram.end(), 0), 3);
  EXPECT_EQ(SummarizeQuality({}).Mean, 0.0);
}

TEST(HexQuality, AllHexesOfABall)
{
  const HexMesh ball = BallMesh(8);
  const std::vector<double> sj = ScaledJacobians(ball);
  ASSERT_EQ(sj.size(), ball.Hexes.size());
  for (std::size_t i = 0; i < sj.size(); ++i)
  {
    EXPECT_EQ(sj[i], ScaledJacobian(ball, static_cast<Index>(i)));
    EXPECT_GT(sj[i], 0.1);
  }
}

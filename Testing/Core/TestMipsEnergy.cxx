// SPDX-License-Identifier: BSD-3-Clause
#include "MipsEnergy.h"

#include "TangledMesh.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

using namespace featurehex;

namespace
{
/// One lattice cube with every vertex displaced by up to a quarter of its edge.
std::array<Vec3, 8> BentCube(unsigned seed)
{
  std::mt19937 random(seed);
  const HexMesh cube = CubeMesh(1);
  std::array<Vec3, 8> points;
  for (int c = 0; c < 8; ++c)
  {
    points[c] = cube.Points[cube.Hexes[0][c]];
    for (int k = 0; k < 3; ++k)
    {
      points[c][k] += 0.25 * (2.0 * random() / 4294967295.0 - 1.0);
    }
  }
  return points;
}

MipsSum SumAt(const std::array<Vec3, 8>& points, int c)
{
  MipsSum sum;
  for (const MipsCorner& corner : MipsCornersAt([&](int i) -> const Vec3& { return points[i]; }, c))
  {
    sum.Add(corner, corner.D, 1.0);
  }
  return sum;
}
}

TEST(MipsEnergy, IsOneAtTheCornersOfACubeOfAnySize)
{
  for (double scale : { 1e-5, 1.0, 1e5 })
  {
    std::array<Vec3, 8> points;
    const HexMesh cube = CubeMesh(1);
    for (int c = 0; c < 8; ++c)
    {
      points[c] = scale * cube.Points[cube.Hexes[0][c]];
    }
    for (int c = 0; c < 8; ++c)
    {
      for (const MipsCorner& corner :
        MipsCornersAt([&](int i) -> const Vec3& { return points[i]; }, c))
      {
        EXPECT_NEAR(MipsValue(corner.S, corner.D), 1.0, 1e-12);
      }
      EXPECT_LT(SumAt(points, c).Gradient.norm() * scale, 1e-10);
    }
  }
}

TEST(MipsEnergy, DerivativesAreThoseOfFiniteDifferences)
{
  constexpr double step = 1e-5;
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    const std::array<Vec3, 8> points = BentCube(seed);
    for (int c = 0; c < 8; ++c)
    {
      const MipsSum here = SumAt(points, c);
      for (int k = 0; k < 3; ++k)
      {
        std::array<Vec3, 8> up = points, down = points;
        up[c][k] += step;
        down[c][k] -= step;
        const MipsSum above = SumAt(up, c), below = SumAt(down, c);
        EXPECT_NEAR((above.Value - below.Value) / (2 * step), here.Gradient[k],
          1e-6 * (1 + here.Gradient.norm()));
        const Vec3 column = (above.Gradient - below.Gradient) / (2 * step);
        EXPECT_LT((column - here.Hessian.col(k)).norm(), 1e-5 * here.Hessian.norm());
      }
    }
  }
}

TEST(MipsEnergy, HessianIsPositiveDefiniteWhereTheHexIsValid)
{
  for (unsigned seed = 1; seed <= 50; ++seed)
  {
    for (int c = 0; c < 8; ++c)
    {
      const Eigen::SelfAdjointEigenSolver<Mat3> solver(SumAt(BentCube(seed), c).Hessian);
      EXPECT_GT(solver.eigenvalues()[0], 0);
    }
  }
}

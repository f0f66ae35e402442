// SPDX-License-Identifier: BSD-3-Clause
#include "QuadraticCertificate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

using namespace featurehex;

namespace
{
HexGrid27 Cube()
{
  HexGrid27 nodes;
  for (int i = 0; i < 27; ++i)
  {
    nodes[i] = 0.5 * Vec3(i % 3, i / 3 % 3, i / 9);
  }
  return nodes;
}

/// Determinant at a place of the unit cube, from Lagrange's polynomials.
double Determinant(const HexGrid27& nodes, const Vec3& at)
{
  double value[3][3], slope[3][3];
  for (int k = 0; k < 3; ++k)
  {
    const double t = at[k];
    value[k][0] = (1 - t) * (1 - 2 * t);
    value[k][1] = 4 * t * (1 - t);
    value[k][2] = t * (2 * t - 1);
    slope[k][0] = 4 * t - 3;
    slope[k][1] = 4 - 8 * t;
    slope[k][2] = 4 * t - 1;
  }
  Mat3 jacobian = Mat3::Zero();
  for (int i = 0; i < 27; ++i)
  {
    const int p[3] = { i % 3, i / 3 % 3, i / 9 };
    for (int d = 0; d < 3; ++d)
    {
      double weight = 1.0;
      for (int k = 0; k < 3; ++k)
      {
        weight *= k == d ? slope[k][p[k]] : value[k][p[k]];
      }
      jacobian.col(d) += weight * nodes[i];
    }
  }
  return jacobian.determinant();
}
} // namespace

TEST(QuadraticCertificate, PlacesAreBetweenTheirCorners)
{
  const auto& places = GridPlaces();
  const HexGrid27 cube = Cube();
  for (int e = 0; e < 12; ++e)
  {
    EXPECT_EQ(cube[places[8 + e]],
      Vec3(0.5 * (cube[places[HexEdges[e][0]]] + cube[places[HexEdges[e][1]]])));
  }
  for (int f = 0; f < 6; ++f)
  {
    EXPECT_EQ(cube[places[20 + f]],
      Vec3(0.5 * (cube[places[HexFaces[f][0]]] + cube[places[HexFaces[f][2]]])));
  }
  HexGrid27 filled = cube;
  FillSerendipity(filled);
  for (int i = 0; i < 27; ++i)
  {
    EXPECT_LT((filled[i] - cube[i]).norm(), 1e-15);
  }
}

TEST(QuadraticCertificate, ABoxIsPerfect)
{
  HexGrid27 nodes = Cube();
  EXPECT_NEAR(QuadraticHexRatio(nodes), 1.0, 1e-9);
  for (Vec3& node : nodes)
  {
    node = Vec3(1e6 + 3 * node.x() + node.y(), 2 * node.y(), -node.z() * 0.1);
  }
  EXPECT_EQ(QuadraticHexRatio(nodes), -1.0); // a mirror image
  nodes[5].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(QuadraticHexRatio(nodes), -1.0);
}

TEST(QuadraticCertificate, KnowsWhenANodeMovedTooFar)
{
  // The map of an edge with its node at a fraction a: slope 4 a - 1 at the start.
  for (double a : { 0.251, 0.3, 0.5, 0.7, 0.749 })
  {
    HexGrid27 nodes = Cube();
    for (int i = 1; i < 27; i += 3)
    {
      nodes[i].x() = a;
    }
    const double slope = std::min(4 * a - 1, 3 - 4 * a);
    EXPECT_NEAR(QuadraticHexRatio(nodes), slope / (2 - slope), 1e-9) << a;
  }
  for (double a : { 0.1, 0.249, 0.25, 0.75, 0.8 })
  {
    HexGrid27 nodes = Cube();
    for (int i = 1; i < 27; i += 3)
    {
      nodes[i].x() = a;
    }
    EXPECT_EQ(QuadraticHexRatio(nodes), -1.0) << a;
  }
}

TEST(QuadraticCertificate, BoundsAllValues)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shift(-0.12, 0.12), unit(0.0, 1.0);
  int proven = 0, negative = 0;
  for (int round = 0; round < 300; ++round)
  {
    HexGrid27 nodes = Cube();
    for (Vec3& node : nodes)
    {
      node += Vec3(shift(random), shift(random), shift(random));
    }
    if (round % 2)
    {
      FillSerendipity(nodes);
    }
    double smallest = 1e300, largest = -1e300;
    for (int sample = 0; sample < 400; ++sample)
    {
      Vec3 at(unit(random), unit(random), unit(random));
      at = sample % 2 ? at : Vec3(at.array().round());
      const double value = Determinant(nodes, at);
      smallest = std::min(smallest, value);
      largest = std::max(largest, value);
    }
    const double ratio = QuadraticHexRatio(nodes);
    proven += ratio > 0.0;
    negative += smallest <= 0.0;
    EXPECT_FALSE(ratio > 0.0 && smallest / largest < ratio - 1e-12) << round;
  }
  EXPECT_GT(proven, 20);
  EXPECT_GT(negative, 20);
  // Few are neither.
  EXPECT_GT(proven + negative, 250);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "ClusterPlacement.h"

#include "MappingShapes.h"

#include <gtest/gtest.h>

using namespace featurehex;

namespace
{
/// A box with lines, and hexes three times as large as the spacing of its points.
MappingShape CoarseBox(const std::vector<std::vector<Vec3>>& lines)
{
  MappingShape shape({ 24, 24, 6 }, lines);
  shape.Mesh = LatticeMesh({ 8, 8, 2 }, [](int, int, int) { return true; });
  for (Vec3& p : shape.Mesh.Points)
  {
    p *= 3;
  }
  shape.UseMesh();
  return shape;
}

/// A straight line of points.
std::vector<Vec3> Line(const Vec3& from, const Vec3& to)
{
  std::vector<Vec3> points;
  const int count = static_cast<int>((to - from).lpNorm<Eigen::Infinity>() + 0.5);
  for (int i = 0; i <= count; ++i)
  {
    points.push_back(from + (to - from) * i / count);
  }
  return points;
}

/// Edges of the path of the curve between two points of the surface; -1: there is none.
int EdgesBetween(const MappingShape& shape, const Vec3& a, const Vec3& b)
{
  for (std::size_t c = 0; c < shape.Geometry->Curves().size(); ++c)
  {
    const EnforcedCurve& curve = shape.Geometry->Curves()[c];
    const Vec3& first = curve.Points.front();
    const Vec3& last = curve.Points.back();
    if (((first - a).norm() < 1e-9 && (last - b).norm() < 1e-9) ||
      ((first - b).norm() < 1e-9 && (last - a).norm() < 1e-9))
    {
      return static_cast<int>(shape.Mapping.Features.CurvePaths[c].size()) - 1;
    }
  }
  return -1;
}
}

TEST(ClusterPlacement, TwoCornersAThirdOfAnEdgeApart)
{
  // Lines from west and south meet in one corner, those from east and north in the other.
  MappingShape shape = CoarseBox({ Line({ 0, 11, 6 }, { 12, 11, 6 }),
    Line({ 12, 0, 6 }, { 12, 24, 6 }), Line({ 12, 12, 6 }, { 24, 12, 6 }) });
  shape.Map();
  EXPECT_TRUE(shape.Mapping.Complete()) << shape.Reasons();
  EXPECT_EQ(EdgesBetween(shape, { 12, 11, 6 }, { 12, 12, 6 }), 1);
}

TEST(ClusterPlacement, SmallTriangle)
{
  // Three lines end at the corners of a triangle of half a unit square.
  for (const bool mirrored : { false, true })
  {
    const auto at = [mirrored](double x, double y) {
      return mirrored ? Vec3(y, x, 6) : Vec3(x, y, 6);
    };
    const Vec3 a = at(11, 11);
    const Vec3 b = at(12, 11);
    const Vec3 c = at(12, 12);
    MappingShape shape = CoarseBox({ Line(a, b), Line(b, c), Line(a, c), Line(at(0, 11), a),
      Line(at(12, 0), b), Line(c, at(12, 24)) });
    shape.Map();
    EXPECT_TRUE(shape.Mapping.Complete()) << shape.Reasons();
    const int edges =
      EdgesBetween(shape, a, b) + EdgesBetween(shape, b, c) + EdgesBetween(shape, a, c);
    EXPECT_GE(edges, 4); // at least one quad
    EXPECT_LE(edges, 6);
  }
}

TEST(ClusterPlacement, RootHasTheMostNeighbors)
{
  const std::vector<std::vector<Index>> neighbors = { { 2 }, { 2 }, { 0, 1 }, {} };
  EXPECT_EQ(ClusterPlacement::RootOf({ 0, 1, 2 }, neighbors), 2);
}

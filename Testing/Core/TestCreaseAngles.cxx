// SPDX-License-Identifier: BSD-3-Clause
#include "CreaseAngles.h"

#include "LatticeBody.h"

#include <gtest/gtest.h>

#include <random>

using namespace featurehex;

namespace
{
constexpr double Pi = 3.14159265358979323846;
}

TEST(CreaseAngles, EdgesOfACubeAreRight)
{
  const FeatureShape cube = CubeWithFeatures(3);
  const FeatureGeometry geometry(cube.Surface, cube.Graph, 1.0);
  const CreaseAngles creases(geometry);
  for (Index c = 0; c < 12; ++c)
  {
    const std::vector<CreaseAngles::Piece> pieces = creases.Pieces(c);
    ASSERT_EQ(pieces.size(), 1u);
    EXPECT_NEAR(pieces[0].Angle, Pi / 2, 1e-12);
    EXPECT_NEAR(pieces[0].Length, 3, 1e-12);
  }
}

TEST(CreaseAngles, ConcaveEdge)
{
  const LatticeBody body = AngleBody();
  const CreaseAngles creases(*body.Geometry);
  const Index concave = body.CurveThrough({ 2, 3, 1 });
  for (Index c = 0; c < static_cast<Index>(body.Graph.Curves.size()); ++c)
  {
    double length = 0;
    for (const CreaseAngles::Piece& piece : creases.Pieces(c))
    {
      EXPECT_NEAR(piece.Angle, c == concave ? 1.5 * Pi : 0.5 * Pi, 1e-12);
      length += piece.Length;
    }
    EXPECT_NEAR(length, body.Geometry->Curves()[c].Length(), 1e-12);
  }
}

TEST(CreaseAngles, BluntAndAcuteEdges)
{
  // A prism over a parallelogram of 60 and 120 degrees.
  FeatureShape prism = CubeWithFeatures(1);
  for (Vec3& p : prism.Surface.Points)
  {
    p = Vec3(p.x() + 0.5 * p.y(), std::sqrt(0.75) * p.y(), p.z());
  }
  const FeatureGeometry geometry(prism.Surface, prism.Graph, 1.0);
  const CreaseAngles creases(geometry);
  std::map<int, int> counts;
  for (Index c = 0; c < 12; ++c)
  {
    ++counts[static_cast<int>(std::lround(creases.Pieces(c)[0].Angle * 180 / Pi))];
  }
  EXPECT_EQ(counts, (std::map<int, int>{ { 60, 2 }, { 90, 8 }, { 120, 2 } }));
}

TEST(CreaseAngles, FlatCurve)
{
  const LatticeBody box =
    BoxBody({ 4, 3, 2 }, { { 2, 0, 2 }, { 2, 1, 2 }, { 2, 2, 2 }, { 2, 3, 2 } });
  const CreaseAngles creases(*box.Geometry);
  for (const CreaseAngles::Piece& piece : creases.Pieces(box.CurveThrough({ 2, 1, 2 })))
  {
    EXPECT_NEAR(piece.Angle, Pi, 1e-12);
  }
}

TEST(CreaseAngles, SliversDoNotMatter)
{
  // A sliver along an edge of the top stands at 45 degrees, as CAD exports have them.
  FeatureShape cube = CubeWithFeatures(1);
  const Index at = static_cast<Index>(cube.Surface.Points.size());
  Index split = -1;
  Index curve = -1;
  for (std::size_t t = 0; t < cube.Surface.Triangles.size() && split < 0; ++t)
  {
    Vec3 low = Vec3::Constant(2);
    int onEdge = 0;
    for (Index v : cube.Surface.Triangles[t])
    {
      low = low.cwiseMin(cube.Surface.Points[v]);
      onEdge += cube.Surface.Points[v].y() == 0;
    }
    split = low.z() == 1 && onEdge == 2 ? static_cast<Index>(t) : -1;
  }
  ASSERT_GE(split, 0);
  cube.Surface.Points.push_back({ 0.5, 1e-5, 1 + 1e-5 });
  const Triangle old = cube.Surface.Triangles[split];
  const int patch = cube.Graph.PatchOfTriangle[split];
  for (int k = 0; k < 3; ++k)
  {
    const Triangle piece = { old[k], old[(k + 1) % 3], at };
    if (k == 0)
    {
      cube.Surface.Triangles[split] = piece;
      continue;
    }
    cube.Surface.Triangles.push_back(piece);
    cube.Graph.PatchOfTriangle.push_back(patch);
  }
  for (std::size_t c = 0; c < 12; ++c)
  {
    const Vec3 middle = 0.5 * (cube.Surface.Points[cube.Graph.Curves[c].Points[0]] +
                                cube.Surface.Points[cube.Graph.Curves[c].Points[1]]);
    curve = (middle - Vec3(0.5, 0, 1)).norm() < 1e-9 ? static_cast<Index>(c) : curve;
  }
  const FeatureGeometry geometry(cube.Surface, cube.Graph, 1.0);
  EXPECT_NEAR(CreaseAngles(geometry).Pieces(curve)[0].Angle, Pi / 2, 1e-3);
}

TEST(CreaseAngles, PiecesAscendAndAddUp)
{
  LatticeBody body = BoxBody({ 5, 4, 3 });
  std::mt19937 random(5);
  for (Vec3& p : body.Surface.Points)
  {
    for (double& x : p)
    {
      x += 0.2 * (2.0 * random() / 4294967295.0 - 1.0);
    }
  }
  const FeatureGeometry geometry(body.Surface, body.Graph, 1.0);
  const CreaseAngles creases(geometry);
  for (Index c = 0; c < 12; ++c)
  {
    double before = 0;
    double length = 0;
    for (const CreaseAngles::Piece& piece : creases.Pieces(c))
    {
      EXPECT_GE(piece.Angle, before);
      EXPECT_LT(piece.Angle, Pi);
      before = piece.Angle;
      length += piece.Length;
    }
    EXPECT_GT(before, 0.3 * Pi);
    EXPECT_NEAR(length, geometry.Curves()[c].Length(), 1e-12);
  }
}

TEST(CreaseAngles, RightAnglesIn)
{
  const auto count = [](double degrees) { return RightAnglesIn(degrees * Pi / 180); };
  EXPECT_EQ(count(0), 1); // never none
  EXPECT_EQ(count(20), 1);
  EXPECT_EQ(count(90), 1);
  EXPECT_EQ(count(120), 1);
  EXPECT_EQ(count(134), 1);
  EXPECT_EQ(count(136), 2);
  EXPECT_EQ(count(180), 2);
  EXPECT_EQ(count(224), 2);
  EXPECT_EQ(count(226), 3);
  EXPECT_EQ(count(270), 3);
  EXPECT_EQ(count(316), 4);
  EXPECT_EQ(count(360), 4);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "CurveRouter.h"

#include "MappingShapes.h"

#include <gtest/gtest.h>

using namespace featurehex;

namespace
{
/// Vertices of a shape's mesh at the corners of its surface.
std::vector<Index> CornersOf(const MappingShape& shape)
{
  std::vector<Index> corners;
  for (const FeatureCorner& corner : shape.Graph.Corners)
  {
    corners.push_back(shape.PointAt(shape.Surface.Points[corner.Point]));
  }
  return corners;
}

/// A box of hexes on a surface of the same points, with a router.
struct Routed
{
  MappingShape Shape;
  FeatureGeometry Geometry;
  QuadGraph Graph;
  std::vector<Index> Corners;
  CurveRouter Router;

  explicit Routed(const std::array<int, 3>& n, const std::vector<std::vector<Vec3>>& lines = {})
    : Shape(n, lines)
    , Geometry(Shape.Surface, Shape.Graph, 1.0)
    , Graph(ExtractBoundary(Shape.Mesh).Quads, Shape.Mesh.Points.size())
    , Corners(CornersOf(Shape))
    , Router(Shape.Mesh.Points, Graph, Geometry, Corners, 2.5)
  {
  }
  Vec3 Direction(Index dart) const
  {
    return (this->Shape.Mesh.Points[this->Graph.Head(dart)] -
      this->Shape.Mesh.Points[this->Graph.Tail(dart)])
      .normalized();
  }
};
}

TEST(CurveRouter, SizeIsTheMeanEdgeLength)
{
  const Routed box({ 3, 3, 3 });
  for (Index v = 0; v < static_cast<Index>(box.Shape.Mesh.Points.size()); ++v)
  {
    EXPECT_NEAR(box.Router.SizeAt(v), box.Graph.Valence(v) > 0 ? 1.0 : 0.0, 1e-14);
  }
}

TEST(CurveRouter, SpokesOfACornerFitItsVertex)
{
  const Routed box({ 3, 3, 3 });
  for (Index corner = 0; corner < 8; ++corner)
  {
    double cost = -1;
    const std::vector<Index> darts =
      box.Router.ArrangeSpokes(corner, box.Corners[corner], cost);
    EXPECT_NEAR(cost, 0, 1e-12);
    ASSERT_EQ(darts.size(), 3u);
    const CornerFan& fan = box.Geometry.Fans()[corner];
    for (int i = 0; i < 3; ++i)
    {
      const CornerFan::Spoke& spoke = fan.Spokes[i];
      const EnforcedCurve& curve = box.Geometry.Curves()[spoke.Curve];
      const Vec3 along = curve.At(spoke.AtEnd ? curve.Length() - 1 : 1.0) -
        box.Geometry.CornerPoint(corner);
      EXPECT_GT(along.dot(box.Direction(darts[i])), 0.99);
      EXPECT_EQ(box.Graph.Steps(darts[i], darts[(i + 1) % 3]), 1); // the order of the fan
    }
  }
}

TEST(CurveRouter, SpokesNeedAsManyEdges)
{
  // The diagonal gives the T-junction at its end three curves, the corner of the box four.
  const Routed box({ 3, 3, 1 }, { { { 0, 0, 1 }, { 1, 1, 1 }, { 2, 2, 1 }, { 3, 3, 1 } } });
  const Index corner = CornersOfPoints(
    box.Shape.Graph, box.Shape.Surface.Points.size())[box.Shape.PointAt({ 0, 0, 1 })];
  ASSERT_EQ(box.Geometry.Fans()[corner].Spokes.size(), 4u);
  double cost = 0;
  EXPECT_TRUE(box.Router.ArrangeSpokes(corner, box.Corners[corner], cost).empty());
  EXPECT_EQ(cost, 1e300);
  // The vertex beside it has four edges; no order is turned round.
  const std::vector<Index> darts =
    box.Router.ArrangeSpokes(corner, box.Shape.PointAt({ 1, 0, 1 }), cost);
  ASSERT_EQ(darts.size(), 4u);
  EXPECT_LT(cost, 1e300);
  for (int i = 0; i < 4; ++i)
  {
    EXPECT_EQ(box.Graph.Steps(darts[i], darts[(i + 1) % 4]), 1);
  }
}

TEST(CurveRouter, PathsRunAlongTheirCurves)
{
  Routed box({ 4, 3, 2 });
  EXPECT_TRUE(box.Router.RouteAll(6).empty());
  EXPECT_EQ(box.Router.Reroutes(), 0);
  for (std::size_t c = 0; c < 12; ++c)
  {
    const EnforcedCurve& curve = box.Geometry.Curves()[c];
    const std::vector<Index>& path = box.Router.Paths()[c];
    ASSERT_EQ(path.size(), std::llround(curve.Length()));
    EXPECT_EQ(box.Graph.Tail(path.front()), box.Corners[curve.FirstCorner]);
    EXPECT_EQ(box.Graph.Head(path.back()), box.Corners[curve.LastCorner]);
    for (std::size_t i = 0; i < path.size(); ++i)
    {
      EXPECT_NEAR(
        curve.Closest(box.Shape.Mesh.Points[box.Graph.Head(path[i])]).Arc, i + 1.0, 1e-12);
      EXPECT_TRUE(i == 0 || box.Graph.Head(path[i - 1]) == box.Graph.Tail(path[i]));
    }
    EXPECT_TRUE(box.Router.ContestedPlaces(static_cast<Index>(c)).empty());
  }
}

TEST(CurveRouter, CurveWithoutCornerVertexFindsNoWay)
{
  const MappingShape shape({ 3, 3, 3 });
  const FeatureGeometry geometry(shape.Surface, shape.Graph, 1.0);
  const QuadGraph graph(ExtractBoundary(shape.Mesh).Quads, shape.Mesh.Points.size());
  std::vector<Index> corners = CornersOf(shape);
  corners[4] = -1;
  CurveRouter router(shape.Mesh.Points, graph, geometry, corners, 2.5);
  const std::vector<Index> failed = router.RouteAll(6);
  EXPECT_EQ(failed.size(), 3u);
  EXPECT_TRUE(std::is_sorted(failed.begin(), failed.end()));
  for (Index c : failed)
  {
    const EnforcedCurve& curve = geometry.Curves()[c];
    EXPECT_TRUE(curve.FirstCorner == 4 || curve.LastCorner == 4);
    EXPECT_TRUE(router.Paths()[c].empty());
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "QuadGraph.h"

#include "MeshTopology.h"
#include "ValidationShapes.h"

#include <gtest/gtest.h>

using namespace featurehex;

namespace
{
/// The surface of n x n x n unit cubes.
struct CubeGrid
{
  HexMesh Mesh;
  QuadGraph Graph;

  explicit CubeGrid(int n)
    : Mesh(CubeMesh(n))
    , Graph(ExtractBoundary(Mesh).Quads, Mesh.Points.size())
  {
  }

  Index At(const Vec3& p) const
  {
    for (std::size_t v = 0; v < this->Mesh.Points.size(); ++v)
    {
      if (this->Mesh.Points[v] == p)
      {
        return static_cast<Index>(v);
      }
    }
    return -1;
  }
  Index Dart(const Vec3& from, const Vec3& to) const
  {
    return this->Graph.Find(this->At(from), this->At(to));
  }
  Vec3 Direction(Index dart) const
  {
    return this->Mesh.Points[this->Graph.Head(dart)] - this->Mesh.Points[this->Graph.Tail(dart)];
  }
};
}

TEST(QuadGraph, OppositeDartsRunBackwards)
{
  const CubeGrid grid(3);
  EXPECT_EQ(grid.Graph.NumberOfDarts(), 4 * 6 * 9);
  for (Index d = 0; d < grid.Graph.NumberOfDarts(); ++d)
  {
    const Index other = grid.Graph.Opposite(d);
    ASSERT_GE(other, 0);
    EXPECT_NE(other / 4, d / 4);
    EXPECT_EQ(grid.Graph.Opposite(other), d);
    EXPECT_EQ(grid.Graph.Tail(other), grid.Graph.Head(d));
    EXPECT_EQ(grid.Graph.Head(other), grid.Graph.Tail(d));
  }
}

TEST(QuadGraph, RotatesCounterClockwiseSeenFromOutside)
{
  const CubeGrid grid(3);
  const Vec3 center = Vec3::Constant(1.5);
  for (Index d = 0; d < grid.Graph.NumberOfDarts(); ++d)
  {
    const Index v = grid.Graph.Tail(d);
    const Index next = grid.Graph.Rotate(d);
    ASSERT_EQ(grid.Graph.Tail(next), v);
    const Vec3 outward = grid.Mesh.Points[v] - center;
    EXPECT_GT(grid.Direction(d).cross(grid.Direction(next)).dot(outward), 0);
    // All darts of the vertex, then the first again.
    Index dart = next;
    int steps = 1;
    for (; dart != d && steps < 10; dart = grid.Graph.Rotate(dart))
    {
      ++steps;
    }
    EXPECT_EQ(steps, grid.Graph.Valence(v));
  }
}

TEST(QuadGraph, ValencesAndUnusedVertices)
{
  const CubeGrid grid(2);
  int three = 0, four = 0;
  for (Index v = 0; v < static_cast<Index>(grid.Mesh.Points.size()); ++v)
  {
    three += grid.Graph.Valence(v) == 3;
    four += grid.Graph.Valence(v) == 4;
    EXPECT_EQ(grid.Graph.Leaving(v) < 0, grid.Graph.Valence(v) == 0);
  }
  EXPECT_EQ(three, 8);
  EXPECT_EQ(four, 18);
  const Index inside = grid.At({ 1, 1, 1 });
  EXPECT_EQ(grid.Graph.Leaving(inside), -1);
  EXPECT_EQ(grid.Graph.Find(inside, grid.At({ 1, 1, 2 })), -1);
}

TEST(QuadGraph, FindsTheDartBetweenNeighborsOnly)
{
  const CubeGrid grid(2);
  for (Index d = 0; d < grid.Graph.NumberOfDarts(); ++d)
  {
    EXPECT_EQ(grid.Graph.Find(grid.Graph.Tail(d), grid.Graph.Head(d)), d);
  }
  EXPECT_EQ(grid.Dart({ 0, 0, 2 }, { 1, 1, 2 }), -1); // across a quad
  EXPECT_EQ(grid.Dart({ 0, 0, 2 }, { 2, 0, 2 }), -1); // two edges away
  EXPECT_EQ(grid.Dart({ 1, 1, 2 }, { 1, 1, 1 }), -1); // an edge inside the solid
  EXPECT_EQ(grid.Dart({ 0, 0, 0 }, { 0, 0, 0 }), -1);
}

TEST(QuadGraph, QuadsOnLeftOfTurns)
{
  const CubeGrid grid(2);
  // Seen from above, walking in x through the middle of the top.
  const Vec3 middle(1, 1, 2);
  const Index in = grid.Dart({ 0, 1, 2 }, middle);
  EXPECT_EQ(grid.Graph.QuadsOnLeft(in, grid.Dart(middle, { 2, 1, 2 })), 2); // straight on
  EXPECT_EQ(grid.Graph.QuadsOnLeft(in, grid.Dart(middle, { 1, 2, 2 })), 1); // to the left
  EXPECT_EQ(grid.Graph.QuadsOnLeft(in, grid.Dart(middle, { 1, 0, 2 })), 3); // to the right
  EXPECT_EQ(grid.Graph.QuadsOnLeft(in, grid.Graph.Opposite(in)), 0);        // back
  // Round the corner of the top; two other quads are on the sides.
  const Vec3 corner(2, 2, 2);
  const Index along = grid.Dart({ 2, 1, 2 }, corner);
  EXPECT_EQ(grid.Graph.QuadsOnLeft(along, grid.Dart(corner, { 1, 2, 2 })), 1);
  EXPECT_EQ(grid.Graph.QuadsOnLeft(along, grid.Dart(corner, { 2, 2, 1 })), 2);
}

TEST(QuadGraph, BothSidesOfATurnAreAllQuads)
{
  const CubeGrid grid(2);
  const QuadGraph& graph = grid.Graph;
  for (Index in = 0; in < graph.NumberOfDarts(); ++in)
  {
    const Index back = graph.Opposite(in);
    for (Index out = graph.Rotate(back); out != back; out = graph.Rotate(out))
    {
      EXPECT_EQ(graph.QuadsOnLeft(in, out) + graph.QuadsOnLeft(graph.Opposite(out), back),
        graph.Valence(graph.Head(in)));
      EXPECT_EQ(graph.Steps(out, back), graph.QuadsOnLeft(in, out));
      EXPECT_EQ(graph.Steps(back, out) + graph.Steps(out, back), graph.Valence(graph.Head(in)));
    }
    EXPECT_EQ(graph.Steps(back, back), 0);
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "HexFeatureMapping.h"

#include "MappingShapes.h"

#include <algorithm>
#include <gtest/gtest.h>

using namespace featurehex;

namespace
{
class AbortAtOnce : public Monitor
{
  bool AbortRequested() override { return true; }
};

/// Each curve has a path of grid edges from corner to corner, and no vertex serves twice.
void ExpectDisjointPaths(const MappingShape& shape)
{
  const HexFeatures& features = shape.Mapping.Features;
  std::map<Index, int> uses;
  for (std::size_t c = 0; c < features.CurvePaths.size(); ++c)
  {
    const std::vector<Index>& path = features.CurvePaths[c];
    const EnforcedCurve& curve = shape.Geometry->Curves()[c];
    ASSERT_GE(path.size(), 2u) << "curve " << c;
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      EXPECT_NEAR((shape.Mesh.Points[path[i]] - shape.Mesh.Points[path[i - 1]]).norm(), 1, 1e-12);
    }
    for (std::size_t i = 1; i + 1 < path.size(); ++i)
    {
      ++uses[path[i]];
    }
    if (curve.FirstCorner >= 0)
    {
      EXPECT_EQ(path.front(), features.CornerVertices[curve.FirstCorner]);
    }
    if (curve.LastCorner >= 0)
    {
      EXPECT_EQ(path.back(), features.CornerVertices[curve.LastCorner]);
    }
  }
  for (Index v : features.CornerVertices)
  {
    ++uses[v];
  }
  for (const auto& [v, count] : uses)
  {
    EXPECT_EQ(count, 1) << "vertex " << v;
  }
}

std::map<int, int> QuadsOfPatches(const MappingShape& shape)
{
  std::map<int, int> counts;
  for (int patch : shape.Mapping.Features.PatchOfQuad)
  {
    ++counts[patch];
  }
  return counts;
}

/// A quad lies in the plane of its patch.
void ExpectPatchesInPlace(const MappingShape& shape, double tolerance)
{
  ASSERT_EQ(shape.Mapping.Features.PatchOfQuad.size(), shape.Interface.size());
  for (std::size_t q = 0; q < shape.Interface.size(); ++q)
  {
    Vec3 center = Vec3::Zero();
    for (Index v : shape.Interface[q].Vertices)
    {
      center += 0.25 * shape.Mesh.Points[v];
    }
    const int patch = shape.Mapping.Features.PatchOfQuad[q];
    ASSERT_GE(patch, 0);
    EXPECT_LT(shape.Geometry->Patch(patch).Search().Closest(center).Distance, tolerance);
  }
}

const MappingFailure* Find(const FeatureMapping& mapping, FeatureKind kind)
{
  for (const MappingFailure& failure : mapping.Failures)
  {
    if (failure.Kind == kind)
    {
      return &failure;
    }
  }
  return nullptr;
}
}

TEST(HexFeatureMapping, CubeOnItsOwnGrid)
{
  for (int n : { 1, 2, 4 })
  {
    MappingShape shape({ n, n, n });
    shape.Map();
    ASSERT_TRUE(shape.Mapping.Complete()) << shape.Reasons();
    EXPECT_EQ(shape.Mapping.Reroutes, 0);
    ASSERT_EQ(shape.Graph.Corners.size(), 8u);
    for (Index c = 0; c < 8; ++c)
    {
      const Index v = shape.Mapping.Features.CornerVertices[c];
      EXPECT_EQ(shape.Mesh.Points[v], shape.Geometry->CornerPoint(c));
    }
    ExpectDisjointPaths(shape);
    for (std::size_t c = 0; c < 12; ++c)
    {
      const std::vector<Index>& path = shape.Mapping.Features.CurvePaths[c];
      EXPECT_EQ(path.size(), n + 1u);
      for (Index v : path)
      {
        EXPECT_LT(shape.Geometry->Curves()[c].Closest(shape.Mesh.Points[v]).Distance, 1e-12);
      }
    }
    ExpectPatchesInPlace(shape, 1e-12);
    const std::map<int, int> counts = QuadsOfPatches(shape);
    EXPECT_EQ(counts.size(), 6u);
    for (const auto& [patch, count] : counts)
    {
      EXPECT_EQ(count, n * n) << "patch " << patch;
    }
  }
}

TEST(HexFeatureMapping, ShiftedCubeTakesTheSamePaths)
{
  MappingShape straight({ 4, 4, 4 });
  straight.Map();
  for (const Vec3& shift : { Vec3(0.3, -0.3, 0.2), Vec3(-0.3, 0.1, 0.3), Vec3(0.3, 0.3, 0.3) })
  {
    MappingShape shape({ 4, 4, 4 });
    for (Vec3& p : shape.Surface.Points)
    {
      p += shift;
    }
    shape.Map();
    ASSERT_TRUE(shape.Mapping.Complete()) << shape.Reasons();
    EXPECT_EQ(shape.Mapping.Features.CornerVertices, straight.Mapping.Features.CornerVertices);
    EXPECT_EQ(shape.Mapping.Features.CurvePaths, straight.Mapping.Features.CurvePaths);
    EXPECT_EQ(shape.Mapping.Features.PatchOfQuad, straight.Mapping.Features.PatchOfQuad);
  }
}

TEST(HexFeatureMapping, LoopsWithoutCorners)
{
  MappingShape shape({ 6, 6, 6 });
  const FeatureShape cylinder = CylinderWithFeatures(6);
  shape.Surface = cylinder.Surface;
  for (Vec3& p : shape.Surface.Points)
  {
    p += Vec3(3, 3, 0);
  }
  shape.Graph = cylinder.Graph;
  shape.Map();
  ASSERT_TRUE(shape.Mapping.Complete()) << shape.Reasons();
  ASSERT_EQ(shape.Mapping.Features.CurvePaths.size(), 2u);
  for (const std::vector<Index>& path : shape.Mapping.Features.CurvePaths)
  {
    EXPECT_EQ(path.front(), path.back());
    EXPECT_EQ(std::set<Index>(path.begin(), path.end()).size(), path.size() - 1);
    EXPECT_GE(path.size(), 17u);
  }
  EXPECT_EQ(QuadsOfPatches(shape).size(), 3u);
}

TEST(HexFeatureMapping, DiagonalCurveBecomesAStaircase)
{
  std::vector<Vec3> diagonal;
  for (int i = 0; i <= 5; ++i)
  {
    diagonal.emplace_back(i, i + 1, 2);
  }
  MappingShape shape({ 6, 6, 2 }, { diagonal });
  shape.Map();
  ASSERT_TRUE(shape.Mapping.Complete()) << shape.Reasons();
  ASSERT_EQ(shape.Graph.Corners.size(), 10u);
  ExpectDisjointPaths(shape);
  const Index curve = shape.CurveThrough({ 2, 3, 2 });
  ASSERT_GE(curve, 0);
  EXPECT_EQ(shape.Mapping.Features.CurvePaths[curve].size(), 11u);
  EXPECT_EQ(QuadsOfPatches(shape).size(), 7u);
  ExpectPatchesInPlace(shape, 0.8); // those the staircase cuts off are half a quad away
}

TEST(HexFeatureMapping, NarrowHorseshoeIsNotCutShort)
{
  std::vector<Vec3> horseshoe;
  for (int y = 7; y >= 2; --y)
  {
    horseshoe.emplace_back(3, y, 2);
  }
  for (int y = 2; y <= 7; ++y)
  {
    horseshoe.emplace_back(4, y, 2);
  }
  MappingShape shape({ 8, 9, 2 }, { horseshoe }, 60.0); // its bends are no corners
  ASSERT_EQ(shape.Graph.Corners.size(), 10u);
  shape.Map();
  ASSERT_TRUE(shape.Mapping.Complete()) << shape.Reasons();
  const Index curve = shape.CurveThrough({ 3, 5, 2 });
  ASSERT_GE(curve, 0);
  double least = 9;
  for (Index v : shape.Mapping.Features.CurvePaths[curve])
  {
    least = std::min(least, shape.Mesh.Points[v].y());
  }
  EXPECT_LE(least, 2.5);
  EXPECT_GE(shape.Mapping.Features.CurvePaths[curve].size(), 11u);
  EXPECT_EQ(QuadsOfPatches(shape).size(), 6u); // it parts nothing
}

TEST(HexFeatureMapping, TwoCornersOfOneCellAreFailures)
{
  // A box with a post, 16 corners, and one hex.
  MappingShape shape({ 2, 2, 2 });
  const HexMesh post = LatticeMesh({ 3, 3, 2 }, [](int i, int j, int k) {
    return k == 0 || (i == 1 && j == 1);
  });
  shape.Surface = SplitQuads(post.Points, ExtractBoundary(post).Quads);
  std::set<PointPair> edges;
  std::map<PointPair, std::vector<Vec3>> normals;
  for (const Triangle& t : shape.Surface.Triangles)
  {
    const Vec3& a = shape.Surface.Points[t[0]];
    const Vec3 normal =
      (shape.Surface.Points[t[1]] - a).cross(shape.Surface.Points[t[2]] - a).normalized();
    for (int k = 0; k < 3; ++k)
    {
      const Index u = t[k], v = t[(k + 1) % 3];
      normals[{ std::min(u, v), std::max(u, v) }].push_back(normal);
    }
  }
  for (const auto& [edge, sides] : normals)
  {
    if (sides[0].dot(sides[1]) < 0.5)
    {
      edges.insert(edge);
    }
  }
  FeatureGraphReport report;
  ASSERT_TRUE(BuildSurfaceFeatures(shape.Surface, { edges.begin(), edges.end() }, {},
    FeatureGraphOptions(), shape.Graph, report)
                .Ok());
  ASSERT_EQ(shape.Graph.Corners.size(), 16u);
  shape.Mesh = CubeMesh(1);
  for (Vec3& p : shape.Mesh.Points)
  {
    p = p.cwiseProduct(Vec3(3, 3, 2));
  }
  shape.UseMesh();
  shape.Map();
  EXPECT_FALSE(shape.Mapping.Complete());
  int corners = 0;
  for (const MappingFailure& failure : shape.Mapping.Failures)
  {
    EXPECT_FALSE(failure.Reason.empty());
    EXPECT_FALSE(failure.Places.empty());
    EXPECT_GE(failure.Id, 0);
    if (failure.Kind == FeatureKind::Corner)
    {
      ++corners;
      EXPECT_EQ(shape.Mapping.Features.CornerVertices[failure.Id], -1);
      EXPECT_EQ(failure.Places[0], shape.Geometry->CornerPoint(failure.Id));
      EXPECT_NE(failure.Reason.find("Corner " + std::to_string(failure.Id)), std::string::npos);
    }
  }
  EXPECT_EQ(corners, 8);
  EXPECT_TRUE(shape.Mapping.Features.PatchOfQuad.empty());
}

TEST(HexFeatureMapping, CornerWithMoreCurvesThanAnyVertexHasEdges)
{
  // Four curves meet at each corner of an octahedron, three edges at each vertex of a hex.
  MappingShape shape({ 1, 1, 1 });
  shape.Surface = SurfaceMesh();
  for (int axis = 0; axis < 3; ++axis)
  {
    for (double side : { -1.0, 1.0 })
    {
      shape.Surface.Points.push_back(Vec3::Constant(0.5) + side * Vec3::Unit(axis));
    }
  }
  std::vector<PointPair> edges;
  for (Index a = 0; a < 6; ++a)
  {
    for (Index b = a + 1; b < 6; ++b)
    {
      if (a / 2 != b / 2)
      {
        edges.push_back({ a, b });
      }
    }
  }
  for (Index x : { 0, 1 })
  {
    for (Index y : { 2, 3 })
    {
      for (Index z : { 4, 5 })
      {
        const bool outward = (x + y + z) % 2 == 1; // + + + has odd ids
        shape.Surface.Triangles.push_back(outward ? Triangle{ x, y, z } : Triangle{ x, z, y });
      }
    }
  }
  FeatureGraphReport report;
  ASSERT_TRUE(BuildSurfaceFeatures(
    shape.Surface, edges, {}, FeatureGraphOptions(), shape.Graph, report)
                .Ok());
  shape.Map();
  ASSERT_EQ(shape.Mapping.Failures.size(), 6u) << shape.Reasons();
  for (Index c = 0; c < 6; ++c)
  {
    EXPECT_EQ(shape.Mapping.Failures[c].Kind, FeatureKind::Corner);
    EXPECT_EQ(shape.Mapping.Failures[c].Id, c);
    EXPECT_NE(shape.Mapping.Failures[c].Reason.find("with 4 curves"), std::string::npos);
  }
}

TEST(HexFeatureMapping, CurveWithoutWayBetweenTheOthers)
{
  // A cylinder with a ring between its rims, and a body that is one hex high.
  const FeatureShape cylinder = CylinderWithFeatures(4);
  MappingShape shape({ 2, 2, 1 });
  shape.Surface = cylinder.Surface;
  std::vector<PointPair> edges;
  for (const Triangle& t : shape.Surface.Triangles)
  {
    for (int k = 0; k < 3; ++k)
    {
      const PointPair edge = { t[k], t[(k + 1) % 3] };
      const Vec3& a = shape.Surface.Points[edge[0]];
      const Vec3& b = shape.Surface.Points[edge[1]];
      if (a.head<2>().norm() > 1.99 && b.head<2>().norm() > 1.99 && a.z() == b.z() &&
        static_cast<int>(a.z()) % 2 == 0 && (a - b).norm() < 1) // no chords of the caps
      {
        edges.push_back(edge);
      }
    }
  }
  FeatureGraphReport report;
  ASSERT_TRUE(BuildSurfaceFeatures(
    shape.Surface, edges, {}, FeatureGraphOptions(), shape.Graph, report)
                .Ok());
  ASSERT_EQ(shape.Graph.Curves.size(), 3u);
  for (Vec3& p : shape.Mesh.Points)
  {
    p = p.cwiseProduct(Vec3(2, 2, 4)) - Vec3(2, 2, 0);
  }
  shape.Map();
  ASSERT_FALSE(shape.Mapping.Complete());
  for (const MappingFailure& failure : shape.Mapping.Failures)
  {
    EXPECT_EQ(failure.Kind, FeatureKind::Curve);
    ASSERT_GE(failure.Id, 0);
    EXPECT_TRUE(shape.Mapping.Features.CurvePaths[failure.Id].empty());
    EXPECT_FALSE(failure.Places.empty());
    EXPECT_NE(failure.Reason.find("finds no way"), std::string::npos);
  }
}

TEST(HexFeatureMapping, PatchesThatHangTogetherFailWhereTheyDo)
{
  // A plate of hexes with a tunnel from its upper to its lower side, which the surface hasn't.
  MappingShape shape({ 7, 7, 1 });
  shape.Mesh = LatticeMesh({ 7, 7, 1 }, [](int i, int j, int) { return i != 3 || j != 3; });
  shape.UseMesh();
  shape.Map();
  ASSERT_FALSE(shape.Mapping.Complete());
  int leaks = 0;
  for (const MappingFailure& failure : shape.Mapping.Failures)
  {
    if (failure.Kind == FeatureKind::Curve)
    {
      ++leaks;
      // From a side through the tunnel to the other: three quads each, and the wall.
      EXPECT_EQ(failure.Places.size(), 7u);
      EXPECT_TRUE(std::any_of(failure.Places.begin(), failure.Places.end(), [](const Vec3& p) {
        return std::abs(p.x() - 3.5) <= 0.5 && std::abs(p.y() - 3.5) <= 0.5 && p.z() == 0.5;
      }));
    }
    else
    {
      EXPECT_NE(failure.Reason.find("no quads"), std::string::npos);
      EXPECT_TRUE(failure.Places.empty());
    }
  }
  EXPECT_EQ(leaks, 1);
}

TEST(HexFeatureMapping, PatchesWithoutQuadsAndQuadsWithoutPatch)
{
  // Two cubes of hexes, one of the surface.
  MappingShape lonely({ 2, 2, 2 });
  lonely.Mesh =
    LatticeMesh({ 6, 2, 2 }, [](int i, int, int) { return i < 2 || i > 3; });
  lonely.UseMesh();
  lonely.Map();
  ASSERT_FALSE(lonely.Mapping.Complete());
  const MappingFailure* failure = Find(lonely.Mapping, FeatureKind::Surface);
  ASSERT_TRUE(failure);
  EXPECT_EQ(failure->Id, -1);
  EXPECT_FALSE(failure->Places.empty());
  // And the other way round: a sphere far away that no curve bounds.
  MappingShape missing({ 2, 2, 2 });
  const SurfaceMesh sphere = SphereSurface(4, 0.5, { 9, 9, 9 });
  const Index offset = static_cast<Index>(missing.Surface.Points.size());
  missing.Surface.Points.insert(
    missing.Surface.Points.end(), sphere.Points.begin(), sphere.Points.end());
  for (const Triangle& t : sphere.Triangles)
  {
    missing.Surface.Triangles.push_back({ t[0] + offset, t[1] + offset, t[2] + offset });
    missing.Graph.PatchOfTriangle.push_back(6);
  }
  missing.Graph.NumberOfPatches = 7;
  missing.Map();
  ASSERT_EQ(missing.Mapping.Failures.size(), 1u) << missing.Reasons();
  EXPECT_EQ(missing.Mapping.Failures[0].Kind, FeatureKind::Surface);
  EXPECT_EQ(missing.Mapping.Failures[0].Id, 6);
  EXPECT_NE(missing.Mapping.Failures[0].Reason.find("no quads"), std::string::npos);
  EXPECT_FALSE(missing.Mapping.Failures[0].Places.empty());
}

TEST(HexFeatureMapping, GivenUpCurveIsLeftOut)
{
  MappingShape shape({ 3, 3, 3 });
  shape.GivenUp.Curves = { 5 };
  shape.Map();
  ASSERT_TRUE(shape.Mapping.Complete()) << shape.Reasons();
  for (std::size_t c = 0; c < 12; ++c)
  {
    EXPECT_EQ(shape.Mapping.Features.CurvePaths[c].empty(), c == 5);
  }
  // The quads beside it keep the patch that they are nearest to.
  ExpectPatchesInPlace(shape, 1e-9);
  EXPECT_EQ(QuadsOfPatches(shape).size(), 6u);
}

TEST(HexFeatureMapping, GivenUpCornerIsLeftOut)
{
  MappingShape shape({ 6, 6, 6 });
  shape.GivenUp.Corners = { 0 };
  shape.Map();
  ASSERT_TRUE(shape.Mapping.Complete()) << shape.Reasons();
  EXPECT_EQ(shape.Mapping.Features.CornerVertices[0], -1);
  for (std::size_t c = 0; c < 12; ++c)
  {
    const FeatureCurve& curve = shape.Graph.Curves[c];
    const bool cut = curve.FirstCorner == 0 || curve.LastCorner == 0;
    EXPECT_EQ(shape.Mapping.Features.CurvePaths[c].size(), cut ? 6u : 7u);
  }
  ExpectPatchesInPlace(shape, 1e-9);
}

TEST(HexFeatureMapping, StopsWhenAsked)
{
  AbortAtOnce monitor;
  MappingShape shape({ 2, 2, 2 });
  EXPECT_EQ(shape.Map(monitor).Code, StatusCode::Aborted);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "LayerNeed.h"

#include "HexPadding.h"
#include "LatticeBody.h"
#include "QuadGraph.h"

#include <gtest/gtest.h>

#include <set>

using namespace featurehex;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// Groups that need a layer, before any is made.
std::set<int> Needs(const LatticeBody& body)
{
  HexMesh inside{ body.Mesh.Points, {} };
  for (std::size_t h = 0; h < body.Mesh.Hexes.size(); ++h)
  {
    if (body.Region[h] > 0)
    {
      inside.Hexes.push_back(body.Mesh.Hexes[h]);
    }
  }
  std::vector<Quad> quads;
  for (const InterfaceQuad& quad :
    InterfaceQuads(body.Mesh, HexGraph(body.Mesh).Neighbors, body.Region))
  {
    quads.push_back(quad.Vertices);
  }
  const std::vector<char> needs =
    GroupsThatNeedLayers(inside, quads, body.Features, *body.Geometry, body.Groups);
  EXPECT_EQ(needs.size(), std::set<int>(body.Groups.begin(), body.Groups.end()).size());
  std::set<int> groups;
  for (std::size_t group = 0; group < needs.size(); ++group)
  {
    if (needs[group])
    {
      groups.insert(static_cast<int>(group));
    }
  }
  return groups;
}

/// The same for a mesh that is its body.
std::vector<char> Needs(const FeatureShape& shape)
{
  const FeatureGeometry geometry(shape.Surface, shape.Graph, 1.0);
  return GroupsThatNeedLayers(
    shape.Mesh, shape.Boundary.Quads, shape.Features, geometry, GroupPatches(geometry));
}

/// Group of the patch that looks up or down.
int CapGroup(const FeatureShape& shape, double up)
{
  const FeatureGeometry geometry(shape.Surface, shape.Graph, 1.0);
  const std::vector<int> groups = GroupPatches(geometry);
  for (int patch = 0; patch < shape.Graph.NumberOfPatches; ++patch)
  {
    if ((geometry.Patch(patch).Search().Normal(0) - Vec3(0, 0, up)).norm() < 1e-9)
    {
      return groups[patch];
    }
  }
  ADD_FAILURE() << "no cap";
  return 0;
}

/// Two layers of hexes over rhombs round a vertex; its rims are the features.
FeatureShape Star(int rhombs)
{
  FeatureShape shape;
  const int ring = 2 * rhombs + 1;
  for (int z = 0; z < 3; ++z)
  {
    shape.Mesh.Points.push_back(Vec3(0, 0, z));
    for (int i = 0; i < 2 * rhombs; ++i)
    {
      const double angle = Pi * i / rhombs;
      const double radius = i % 2 == 0 ? 1.0 : 1.5; // joints, tips
      shape.Mesh.Points.push_back(Vec3(radius * std::cos(angle), radius * std::sin(angle), z));
    }
  }
  std::vector<PointPair> rims;
  for (int z = 0; z < 2; ++z)
  {
    for (int i = 0; i < rhombs; ++i)
    {
      const Index low = z * ring;
      const Index a = 1 + 2 * i, b = 2 + 2 * i, c = 1 + 2 * ((i + 1) % rhombs);
      shape.Mesh.Hexes.push_back({ low, low + a, low + b, low + c, low + ring, low + ring + a,
        low + ring + b, low + ring + c });
      rims.push_back({ 2 * z * ring + a, 2 * z * ring + b });
      rims.push_back({ 2 * z * ring + b, 2 * z * ring + c });
    }
  }
  shape.Surface = SplitQuads(shape.Mesh.Points, ExtractBoundary(shape.Mesh).Quads);
  shape.Finish(rims);
  return shape;
}
} // namespace

TEST(LayerNeed, BoxesOnTheirGridNeedNone)
{
  for (const std::array<int, 3>& n :
    { std::array<int, 3>{ 4, 3, 2 }, std::array<int, 3>{ 1, 1, 1 }, std::array<int, 3>{ 5, 1, 2 } })
  {
    EXPECT_EQ(Needs(BoxBody(n)), std::set<int>());
  }
}

TEST(LayerNeed, ConcaveEdgeWithThreeHexesNeedsNone)
{
  EXPECT_EQ(Needs(AngleBody()), std::set<int>());
}

TEST(LayerNeed, FlatCurveWithTwoHexesNeedsNone)
{
  EXPECT_EQ(Needs(BoxBody({ 4, 3, 2 }, { { 2, 0, 2 }, { 2, 1, 2 }, { 2, 2, 2 }, { 2, 3, 2 } })),
    std::set<int>());
}

TEST(LayerNeed, OneStairNeedsALayerUnderItsFaceAlone)
{
  const LatticeBody body = StairBody();
  ASSERT_EQ(std::set<int>(body.Groups.begin(), body.Groups.end()).size(), 6u);
  const int top = body.PatchAt({ 2, 2, 3 }, Vec3::UnitZ());
  EXPECT_EQ(Needs(body), std::set<int>{ body.Groups[top] });
}

TEST(LayerNeed, StairAlongACurveIsOneOfBothSides)
{
  // A curve across the top runs along the stair: one hex where it is convex, three where not.
  LatticeBody box =
    BoxBody({ 4, 4, 3 }, { { 2, 0, 3 }, { 2, 1, 3 }, { 2, 2, 3 }, { 2, 3, 3 }, { 2, 4, 3 } });
  const LatticeBody body(
    { 4, 4, 3 }, [](int i, int, int k) { return i >= 2 || k < 2; }, std::move(box.Surface),
    std::move(box.Graph));
  ASSERT_EQ(body.Graph.NumberOfPatches, 7);
  const int left = body.PatchAt({ 0.5, 2, 3 }, Vec3::UnitZ());
  const int right = body.PatchAt({ 3.5, 2, 3 }, Vec3::UnitZ());
  EXPECT_EQ(body.Groups[left], body.Groups[right]);
  EXPECT_EQ(Needs(body), std::set<int>{ body.Groups[left] });
}

TEST(LayerNeed, ZigzagOfACurveOnAFlatFaceNeedsALayerUnderItsFace)
{
  std::vector<Vec3> diagonal;
  for (int i = 0; i < 6; ++i)
  {
    diagonal.emplace_back(i, i + 1, 2);
  }
  const LatticeBody box = BoxBody({ 6, 6, 2 }, diagonal);
  const int top = box.PatchAt({ 5, 1, 2 }, Vec3::UnitZ());
  EXPECT_EQ(Needs(box), std::set<int>{ box.Groups[top] });
}

TEST(LayerNeed, StairsRoundACylinderLeaveItsCapsAlone)
{
  FeatureShape cylinder = CylinderWithFeatures(8);
  for (Vec3& p : cylinder.Surface.Points)
  {
    p += Vec3(4, 4, 0);
  }
  const LatticeBody body(
    { 8, 8, 8 }, [](int i, int j, int) { return std::hypot(i - 3.5, j - 3.5) < 4; },
    std::move(cylinder.Surface), std::move(cylinder.Graph));
  ASSERT_EQ(body.Graph.NumberOfPatches, 3);
  const int bottom = body.PatchAt({ 4, 4, 0 }, -Vec3::UnitZ());
  const int top = body.PatchAt({ 4, 4, 8 }, Vec3::UnitZ());
  const int side = 3 - top - bottom;
  EXPECT_EQ(Needs(body), std::set<int>{ body.Groups[side] });

  // With it the rims have one hex, and the caps are regular: three to five quads round a vertex.
  PaddedMesh padded;
  HexFeatures features = body.Features;
  ASSERT_TRUE(
    PadInterface(body.Mesh, body.Region, PaddingOptions(), padded, &features, body.Geometry.get())
      .Ok());
  const HexStars stars(padded.Mesh);
  const QuadGraph graph(stars.Quads, padded.Mesh.Points.size());
  const FeatureLabels labels(features, stars);
  for (const std::vector<Index>& path : features.CurvePaths)
  {
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      const Index dart = graph.Find(path[i - 1], path[i]);
      ASSERT_GE(dart, 0);
      EXPECT_EQ(stars.QuadOwners[dart / 4], stars.QuadOwners[graph.Opposite(dart) / 4]);
      EXPECT_EQ(graph.Valence(path[i]), 4);
    }
  }
  for (std::size_t v = 0; v < labels.Kind.size(); ++v)
  {
    if (labels.Kind[v] == FeatureKind::Surface && labels.Id[v] != side)
    {
      EXPECT_GE(graph.Valence(static_cast<Index>(v)), 3);
      EXPECT_LE(graph.Valence(static_cast<Index>(v)), 5);
    }
  }
}

TEST(LayerNeed, RoundGridNeedsALayerWhereItsSideHasCorners)
{
  const FeatureShape cylinder = CylinderWithFeatures(4);
  const std::vector<char> needs = Needs(cylinder);
  EXPECT_EQ(std::count(needs.begin(), needs.end(), 1), 1);
  EXPECT_FALSE(needs[CapGroup(cylinder, 1)]);
  EXPECT_FALSE(needs[CapGroup(cylinder, -1)]);
}

TEST(LayerNeed, SixQuadsRoundAVertexNeedALayer)
{
  for (int rhombs : { 3, 4, 5, 6, 8 })
  {
    const FeatureShape star = Star(rhombs);
    ASSERT_EQ(star.Graph.NumberOfPatches, 3);
    const std::vector<char> needs = Needs(star);
    ASSERT_EQ(needs.size(), 3u);
    EXPECT_EQ(needs[CapGroup(star, 1)] != 0, rhombs > 5) << rhombs;
    EXPECT_EQ(needs[CapGroup(star, -1)] != 0, rhombs > 5) << rhombs;
    EXPECT_EQ(std::count(needs.begin(), needs.end(), 1), rhombs > 5 ? 3 : 1) << rhombs;
  }
}

TEST(LayerNeed, CornerWithTheWrongNumberOfQuads)
{
  // A prism over a parallelogram: at 140 degrees two quads fit best, and two hexes along the edge.
  // Layers under the sides make both; the caps need none.
  FeatureShape prism = CubeWithFeatures(3);
  const double angle = 40 * Pi / 180;
  const auto shear = [angle](const Vec3& p)
  { return Vec3(p.x() + std::cos(angle) * p.y(), std::sin(angle) * p.y(), p.z()); };
  for (Vec3& p : prism.Surface.Points)
  {
    p = shear(p);
  }
  for (Vec3& p : prism.Mesh.Points)
  {
    p = shear(p);
  }
  const std::vector<char> needs = Needs(prism);
  EXPECT_EQ(needs.size(), 4u); // sides that meet bluntly share a layer
  EXPECT_FALSE(needs[CapGroup(prism, 1)]);
  EXPECT_FALSE(needs[CapGroup(prism, -1)]);
  EXPECT_EQ(std::count(needs.begin(), needs.end(), 1), 2);
}

TEST(LayerNeed, LayersBesideAFlatFaceMayLeaveAVertexWithFiveQuadsInIt)
{
  // A notch along the edge between top and one side: three quads round its inner edge on the faces
  // that it crosses.
  LatticeBody box = BoxBody({ 4, 4, 4 });
  const LatticeBody body(
    { 4, 4, 4 }, [](int i, int, int k) { return i > 0 || k < 3; }, std::move(box.Surface),
    std::move(box.Graph));
  const std::set<int> needs = Needs(body);
  for (double y : { 0.0, 4.0 })
  {
    const int cut = body.PatchAt({ 2, y, 2 }, Vec3(0, y - 2, 0) / 2);
    EXPECT_EQ(needs.count(body.Groups[cut]), 0u);
  }
  EXPECT_GE(needs.size(), 1u);
  EXPECT_LE(needs.size(), 2u);
}

TEST(LayerNeed, GivenUpCurves)
{
  LatticeBody box = BoxBody({ 4, 3, 2 }, { { 2, 0, 2 }, { 2, 1, 2 }, { 2, 2, 2 }, { 2, 3, 2 } });
  GivenUpFeatures flat;
  flat.Curves = { box.CurveThrough({ 2, 1, 2 }) };
  box.Map(flat);
  EXPECT_EQ(Needs(box), std::set<int>());

  // One hex along an edge that is no crease any more.
  LatticeBody cube = BoxBody({ 3, 3, 3 });
  GivenUpFeatures edge;
  edge.Curves = { cube.CurveThrough({ 1, 0, 3 }) };
  cube.Map(edge);
  EXPECT_EQ(Needs(cube), std::set<int>{ cube.Groups[cube.PatchAt({ 1, 1, 3 }, Vec3::UnitZ())] });
}

TEST(LayerNeed, WithoutCurvesOneGroupThatNeedsOne)
{
  LatticeBody box = BoxBody({ 3, 2, 2 });
  GivenUpFeatures all;
  for (Index c = 0; c < 12; ++c)
  {
    all.Curves.insert(c);
  }
  box.Map(all);
  EXPECT_EQ(Needs(box), std::set<int>{ 0 });
}

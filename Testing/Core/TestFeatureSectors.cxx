// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureSectors.h"

#include "LatticeBody.h"
#include "MappingShapes.h"

#include <gtest/gtest.h>

using namespace featurehex;

namespace
{
constexpr double Pi = 3.14159265358979323846;

/// Sectors of a mesh with mapped features.
struct Setting
{
  const HexMesh& Mesh;
  const HexFeatures& Features;
  const FeatureGeometry& Geometry;
  QuadGraph Graph;
  FeatureSectors Sectors;

  Setting(const HexMesh& mesh, const std::vector<Quad>& quads, const HexFeatures& features,
    const FeatureGeometry& geometry)
    : Mesh(mesh)
    , Features(features)
    , Geometry(geometry)
    , Graph(quads, mesh.Points.size())
    , Sectors(this->Graph, features)
  {
  }
  explicit Setting(const MappingShape& shape)
    : Setting(shape.Mesh, QuadsOf(shape.Interface), shape.Mapping.Features, *shape.Geometry)
  {
  }
  explicit Setting(const LatticeBody& body)
    : Setting(body.Mesh,
        QuadsOf(InterfaceQuads(body.Mesh, HexGraph(body.Mesh).Neighbors, body.Region)),
        body.Features, *body.Geometry)
  {
  }

  static std::vector<Quad> QuadsOf(const std::vector<InterfaceQuad>& interface)
  {
    std::vector<Quad> quads;
    for (const InterfaceQuad& quad : interface)
    {
      quads.push_back(quad.Vertices);
    }
    return quads;
  }

  Index DartAt(const Vec3& tail, const Vec3& head) const
  {
    for (Index d = 0; d < this->Graph.NumberOfDarts(); ++d)
    {
      if ((this->Mesh.Points[this->Graph.Tail(d)] - tail).norm() < 1e-9 &&
          (this->Mesh.Points[this->Graph.Head(d)] - head).norm() < 1e-9)
      {
        return d;
      }
    }
    ADD_FAILURE() << "no edge at " << tail.transpose();
    return 0;
  }
  std::size_t QuadsAt(const Vec3& tail, const Vec3& head) const
  {
    return this->Sectors.QuadsOf(this->DartAt(tail, head)).size();
  }
  Index CornerAt(const Vec3& p) const
  {
    for (std::size_t c = 0; c < this->Features.CornerVertices.size(); ++c)
    {
      if ((this->Mesh.Points[this->Features.CornerVertices[c]] - p).norm() < 1e-9)
      {
        return static_cast<Index>(c);
      }
    }
    ADD_FAILURE() << "no corner at " << p.transpose();
    return 0;
  }
  double AngleAt(const Vec3& tail, const Vec3& head) const
  {
    return this->Sectors.AngleAt(this->CornerAt(tail), this->DartAt(tail, head), this->Geometry);
  }
};
} // namespace

TEST(FeatureSectors, CurvesOfTheDarts)
{
  MappingShape shape({ 3, 2, 2 });
  shape.Map();
  const Setting cube(shape);
  std::vector<int> counts(12, 0);
  for (Index d = 0; d < cube.Graph.NumberOfDarts(); ++d)
  {
    const Index curve = cube.Sectors.CurveOf(d);
    EXPECT_EQ(curve, cube.Sectors.CurveOf(cube.Graph.Opposite(d)));
    if (curve >= 0)
    {
      ++counts[curve];
    }
  }
  for (std::size_t c = 0; c < 12; ++c)
  {
    EXPECT_EQ(counts[c], 2 * static_cast<int>(cube.Features.CurvePaths[c].size() - 1));
  }
}

TEST(FeatureSectors, CubeHasOneQuadAtCornersAndTwoAtCurves)
{
  MappingShape shape({ 3, 3, 3 });
  shape.Map();
  const Setting cube(shape);
  const FeatureLabels labels(cube.Features, cube.Graph.Quads(), cube.Mesh.Points.size());
  for (Index d = 0; d < cube.Graph.NumberOfDarts(); ++d)
  {
    if (cube.Sectors.CurveOf(d) < 0)
    {
      continue;
    }
    const Index v = cube.Graph.Tail(d);
    const std::vector<Index> quads = cube.Sectors.QuadsOf(d);
    ASSERT_FALSE(quads.empty());
    EXPECT_EQ(quads[0], d / 4);
    if (labels.Kind[v] == FeatureKind::Corner)
    {
      EXPECT_EQ(quads.size(), 1u);
      EXPECT_NEAR(cube.Sectors.AngleAt(labels.Id[v], d, cube.Geometry), Pi / 2, 1e-12);
    }
    else
    {
      EXPECT_EQ(quads.size(), 2u);
    }
    for (Index q : quads)
    {
      EXPECT_EQ(cube.Features.PatchOfQuad[q], cube.Features.PatchOfQuad[d / 4]);
    }
  }
}

TEST(FeatureSectors, ConcaveCorner)
{
  const LatticeBody body = AngleBody();
  const Setting angle(body);
  // Counter-clockwise seen from above: the sector of the top begins at the wall along y.
  EXPECT_EQ(angle.QuadsAt({ 2, 3, 3 }, { 2, 4, 3 }), 3u);
  EXPECT_NEAR(angle.AngleAt({ 2, 3, 3 }, { 2, 4, 3 }), 1.5 * Pi, 1e-12);
  EXPECT_EQ(angle.QuadsAt({ 2, 3, 3 }, { 3, 3, 3 }), 1u);
  EXPECT_NEAR(angle.AngleAt({ 2, 3, 3 }, { 3, 3, 3 }), 0.5 * Pi, 1e-12);
  EXPECT_NEAR(angle.AngleAt({ 2, 3, 3 }, { 2, 3, 2 }), 0.5 * Pi, 1e-12);
}

TEST(FeatureSectors, CurveThatEndsAtAnother)
{
  const LatticeBody body =
    BoxBody({ 4, 3, 2 }, { { 2, 0, 2 }, { 2, 1, 2 }, { 2, 2, 2 }, { 2, 3, 2 } });
  const Setting box(body);
  EXPECT_EQ(box.QuadsAt({ 2, 0, 2 }, { 2, 1, 2 }), 1u);
  EXPECT_NEAR(box.AngleAt({ 2, 0, 2 }, { 2, 1, 2 }), 0.5 * Pi, 1e-12);
  EXPECT_EQ(box.QuadsAt({ 2, 0, 2 }, { 1, 0, 2 }), 2u); // on the side
  EXPECT_NEAR(box.AngleAt({ 2, 0, 2 }, { 1, 0, 2 }), Pi, 1e-12);
}

TEST(FeatureSectors, FreeEndsHaveNone)
{
  MappingShape shape({ 4, 4, 2 }, { { { 1, 2, 2 }, { 2, 2, 2 }, { 3, 2, 2 } } });
  shape.Map();
  const Setting box(shape);
  EXPECT_EQ(box.QuadsAt({ 1, 2, 2 }, { 2, 2, 2 }), 0u);
  EXPECT_EQ(box.QuadsAt({ 3, 2, 2 }, { 2, 2, 2 }), 0u);
  EXPECT_EQ(box.QuadsAt({ 2, 2, 2 }, { 1, 2, 2 }), 2u);
  EXPECT_EQ(box.QuadsAt({ 2, 2, 2 }, { 3, 2, 2 }), 2u);
}

TEST(FeatureSectors, NoAngleBetweenCurvesThatDoNotFollowEachOther)
{
  MappingShape shape({ 3, 3, 3 });
  shape.Map();
  const Setting cube(shape);
  const Index elsewhere = cube.CornerAt({ 3, 3, 3 });
  EXPECT_EQ(
    cube.Sectors.AngleAt(elsewhere, cube.DartAt({ 0, 0, 0 }, { 1, 0, 0 }), cube.Geometry), 0.0);
}

TEST(FeatureSectors, LoopWithOneCorner)
{
  // Its two ends are the same curve: inside a right angle, outside three.
  MappingShape shape({ 4, 4, 2 },
    { { { 1, 1, 2 }, { 2, 1, 2 }, { 3, 1, 2 }, { 3, 2, 2 }, { 3, 3, 2 }, { 2, 3, 2 }, { 1, 3, 2 },
      { 1, 2, 2 }, { 1, 1, 2 } } },
    60.0);
  FeatureGraphOptions options;
  options.CornerAngle = 60.0;
  FeatureGraphReport report;
  SurfaceFeatures graph;
  std::vector<Index> corners = { shape.PointAt({ 1, 1, 2 }) };
  for (const FeatureCorner& corner : shape.Graph.Corners)
  {
    corners.push_back(corner.Point);
  }
  ASSERT_TRUE(
    BuildSurfaceFeatures(shape.Surface, FeatureEdges(shape.Graph), corners, options, graph, report)
      .Ok());
  shape.Graph = graph;
  shape.Map();
  ASSERT_TRUE(shape.Mapping.Complete()) << shape.Reasons();
  const Setting box(shape);
  EXPECT_EQ(box.QuadsAt({ 1, 1, 2 }, { 2, 1, 2 }), 1u);
  EXPECT_EQ(box.QuadsAt({ 1, 1, 2 }, { 1, 2, 2 }), 3u);
  EXPECT_NEAR(box.AngleAt({ 1, 1, 2 }, { 2, 1, 2 }), 0.5 * Pi, 1e-12);
  EXPECT_NEAR(box.AngleAt({ 1, 1, 2 }, { 1, 2, 2 }), 1.5 * Pi, 1e-12);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "HexFeatures.h"

#include "FeatureShapes.h"

#include <gtest/gtest.h>

using namespace featurehex;

TEST(HexFeatures, LabelsOfACube)
{
  const FeatureShape cube = CubeWithFeatures(4);
  const FeatureLabels labels(cube.Features, HexStars(cube.Mesh));
  std::map<FeatureKind, int> counts;
  for (std::size_t v = 0; v < cube.Mesh.Points.size(); ++v)
  {
    ++counts[labels.Kind[v]];
    EXPECT_EQ(labels.Kind[v], cube.Labels.Kind[v]);
    EXPECT_EQ(labels.Id[v], cube.Labels.Id[v]);
  }
  EXPECT_EQ(counts[FeatureKind::Interior], 27);
  EXPECT_EQ(counts[FeatureKind::Surface], 6 * 9);
  EXPECT_EQ(counts[FeatureKind::Curve], 12 * 3);
  EXPECT_EQ(counts[FeatureKind::Corner], 8);
}

TEST(HexFeatures, VertexBetweenPatchesThatNoCurvePartsHasNoId)
{
  FeatureShape cube = CubeWithFeatures(4);
  const std::vector<Index> path = cube.Features.CurvePaths[2];
  cube.Features.CurvePaths[2].clear();
  const FeatureLabels labels(cube.Features, HexStars(cube.Mesh));
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
  {
    EXPECT_EQ(labels.Kind[path[i]], FeatureKind::Surface);
    EXPECT_EQ(labels.Id[path[i]], -1);
  }
}

TEST(HexFeatures, CornerWithoutVertexIsLeftOut)
{
  FeatureShape cube = CubeWithFeatures(2);
  const Index v = cube.Features.CornerVertices[5];
  cube.Features.CornerVertices[5] = -1;
  EXPECT_EQ(FeatureLabels(cube.Features, HexStars(cube.Mesh)).Kind[v], FeatureKind::Curve);
  EXPECT_FALSE(cube.Features.Empty());
  EXPECT_TRUE(HexFeatures().Empty());
}

TEST(HexFeatures, NewVertexIds)
{
  HexFeatures features;
  features.CornerVertices = { 3, -1, 0 };
  features.CurvePaths = { { 3, 1, 0 }, {}, { 2, 4, 2 } };
  features.PatchOfQuad = { 1, 0, 2 };
  RenumberFeatures({ 10, 11, 0, 13, 2 }, features);
  EXPECT_EQ(features.CornerVertices, (std::vector<Index>{ 13, -1, 10 }));
  EXPECT_EQ(
    features.CurvePaths, (std::vector<std::vector<Index>>{ { 13, 11, 10 }, {}, { 0, 2, 0 } }));
  EXPECT_EQ(features.PatchOfQuad, (std::vector<int>{ 1, 0, 2 }));
  HexFeatures none;
  RenumberFeatures({}, none);
  EXPECT_TRUE(none.Empty());
  EXPECT_TRUE(none.CornerVertices.empty());
}

TEST(HexFeatures, RenumberedMeshHasTheSameFeatures)
{
  FeatureShape cube = CubeWithFeatures(3);
  const HexStars before(cube.Mesh);
  QuadPatches patches;
  std::vector<Index> ids;
  const Index count = static_cast<Index>(cube.Mesh.Points.size());
  for (Index v = 0; v < count; ++v)
  {
    ids.push_back((5 * v + 2) % count); // 64 points: one to one
  }
  HexMesh mesh = cube.Mesh;
  for (Index v = 0; v < count; ++v)
  {
    mesh.Points[ids[v]] = cube.Mesh.Points[v];
  }
  for (Hex& hex : mesh.Hexes)
  {
    for (Index& v : hex)
    {
      v = ids[v];
    }
  }
  std::reverse(mesh.Hexes.begin(), mesh.Hexes.end());
  for (std::size_t q = 0; q < before.Quads.size(); ++q)
  {
    patches.Add(before.Quads[q], cube.Features.PatchOfQuad[q]);
  }
  patches.Renumber(ids);
  RenumberFeatures(ids, cube.Features);
  const HexBoundary boundary = ExtractBoundary(mesh);
  cube.Features.PatchOfQuad = patches.Of(boundary.Quads);
  const FeatureValidationReport report =
    ValidateFeatures(mesh, boundary, cube.Surface, { &cube.Graph, &cube.Features }, 1e-9);
  EXPECT_TRUE(report.AllCaptured()) << report.Complaint();
}

TEST(HexFeatures, QuadsAreKnownByTheirVertices)
{
  QuadPatches patches;
  EXPECT_EQ(patches.Of({ { 0, 1, 2, 3 } }), std::vector<int>{ -1 });
  patches.Add({ 0, 1, 2, 3 }, 4);
  patches.Add({ 3, 2, 5, 6 }, 0);
  EXPECT_EQ(patches.Of({ { 5, 6, 3, 2 }, { 2, 3, 0, 1 }, { 3, 2, 1, 0 }, { 0, 1, 2, 5 } }),
    (std::vector<int>{ 0, 4, 4, -1 }));
  patches.Add({ 1, 0, 3, 2 }, 7); // the last one counts
  EXPECT_EQ(patches.Of({ { 0, 1, 2, 3 } }), std::vector<int>{ 7 });
  EXPECT_TRUE(patches.Of({}).empty());
}

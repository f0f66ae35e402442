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

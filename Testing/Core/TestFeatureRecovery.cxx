// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureShapes.h"

using namespace featurehex;

TEST(FeatureRecovery, InverseOfTheLabels)
{
  for (const FeatureShape& shape : { CubeWithFeatures(1), CubeWithFeatures(2), CubeWithFeatures(5),
         CylinderWithFeatures(4), CylinderWithFeatures(5) })
  {
    EXPECT_TRUE(shape.Validate().AllCaptured()) << shape.Validate().Complaint();
    const FeatureLabels labels(shape.Features, HexStars(shape.Mesh));
    EXPECT_EQ(labels.Kind, shape.Labels.Kind);
    EXPECT_EQ(labels.Id, shape.Labels.Id);
  }
}

TEST(FeatureRecovery, LabelsThatTheSurfaceDoesNotHave)
{
  FeatureShape shape = CubeWithFeatures(3);
  for (std::size_t v = 0; v < shape.Labels.Id.size(); ++v)
  {
    shape.Labels.Id[v] = v % 2 ? -7 : 1000;
  }
  const HexFeatures found =
    RecoverFeatures(shape.Mesh, shape.Boundary, shape.Surface, shape.Graph, shape.Labels);
  EXPECT_EQ(found.CornerVertices, std::vector<Index>(8, -1));
  for (const std::vector<Index>& path : found.CurvePaths)
  {
    EXPECT_TRUE(path.empty());
  }
  EXPECT_EQ(found.PatchOfQuad, std::vector<int>(shape.Boundary.Quads.size(), -1));
}

TEST(FeatureRecovery, WrongLabelsAreFoundByTheValidation)
{
  FeatureShape shape = CubeWithFeatures(4);
  // A vertex of a curve is said to be one of its patch.
  const Index v = shape.Features.CurvePaths[5][2];
  shape.Labels.Kind[v] = FeatureKind::Surface;
  shape.Labels.Id[v] = shape.Graph.Curves[5].LeftPatch;
  shape.Features =
    RecoverFeatures(shape.Mesh, shape.Boundary, shape.Surface, shape.Graph, shape.Labels);
  const FeatureValidationReport report = shape.Validate();
  EXPECT_EQ(report.Curves[5].Outcome, FeatureOutcome::BrokenPath);
  EXPECT_EQ(report.CurveTotals().Captured, 11);
  EXPECT_LT(report.PatchTotals().Captured, 6);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureSizing.h"

#include "FeatureShapes.h"

#include <gtest/gtest.h>

using namespace featurehex;

namespace
{
std::vector<RefinementPoint> Sizing(const FeatureShape& shape, const FeatureSizingOptions& options)
{
  const FeatureGeometry geometry(shape.Surface, shape.Graph, 0.1);
  const std::vector<RefinementPoint> points = ComputeFeatureSizing(geometry, options);
  for (const RefinementPoint& point : points)
  {
    double nearest = 1e300;
    for (const EnforcedCurve& curve : geometry.Curves())
    {
      nearest = std::min(nearest, curve.Closest(point.Position).Distance);
    }
    EXPECT_LT(nearest, 1e-12);
  }
  return points;
}

FeatureShape BoxOf(const Vec3& size)
{
  FeatureShape shape = CubeWithFeatures(1);
  for (Vec3& p : shape.Surface.Points)
  {
    p = p.cwiseProduct(size);
  }
  return shape;
}

FeatureSizingOptions Options(double edgeLength)
{
  FeatureSizingOptions options;
  options.TargetEdgeLength = edgeLength;
  return options;
}
}

TEST(FeatureSizing, LongCurvesFarApartNeedNothing)
{
  EXPECT_TRUE(Sizing(BoxOf({ 4, 4, 4 }), Options(1)).empty());
  EXPECT_TRUE(Sizing(BoxOf({ 4, 4, 1 }), Options(1)).empty());
}

TEST(FeatureSizing, ShortAndCloseCurvesNeedSmallCells)
{
  // Along and across: 0.4 of a cell where 0.7 are wanted.
  const std::vector<RefinementPoint> points = Sizing(BoxOf({ 4, 4, 0.4 }), Options(1));
  ASSERT_FALSE(points.empty());
  int middle = 0;
  for (const RefinementPoint& point : points)
  {
    EXPECT_EQ(point.Level, 1);
    middle += point.Position.x() == 2;
  }
  EXPECT_EQ(middle, 4); // the long curves too
}

TEST(FeatureSizing, HalvingsAreLimited)
{
  for (int maximum : { 0, 1, 2, 4 })
  {
    FeatureSizingOptions options = Options(1);
    options.MaximumLevel = maximum;
    int highest = 0;
    for (const RefinementPoint& point : Sizing(BoxOf({ 4, 4, 0.02 }), options))
    {
      highest = std::max(highest, point.Level);
    }
    EXPECT_EQ(highest, std::min(maximum, options.MaximumSizingLevel));
  }
}

TEST(FeatureSizing, LoopsGetSixEdges)
{
  const FeatureShape cylinder = CylinderWithFeatures(4); // its loops are 12.5 long
  EXPECT_TRUE(Sizing(cylinder, Options(2)).empty());
  for (const auto& [edgeLength, level] :
    std::vector<std::pair<double, int>>{ { 4, 1 }, { 8, 2 }, { 16, 3 }, { 32, 4 }, { 64, 4 } })
  {
    const std::vector<RefinementPoint> points = Sizing(cylinder, Options(edgeLength));
    ASSERT_FALSE(points.empty());
    for (const RefinementPoint& point : points)
    {
      EXPECT_EQ(point.Level, level) << edgeLength;
    }
  }
}

TEST(FeatureSizing, GivenUpCurvesNeedNothing)
{
  const FeatureShape box = BoxOf({ 4, 4, 0.02 });
  GivenUpFeatures givenUp;
  for (Index c = 0; c < 12; ++c)
  {
    givenUp.Curves.insert(c);
  }
  const FeatureGeometry geometry(box.Surface, box.Graph, 0.1, givenUp);
  EXPECT_TRUE(ComputeFeatureSizing(geometry, Options(1)).empty());
}

TEST(FeatureSizing, SomeCurvesAreTooCloseForCells)
{
  // A cell of which 0.7 fit between the long edges of the box, which are 0.4 apart.
  const FeatureShape shape = BoxOf({ 4, 4, 0.4 });
  const FeatureGeometry geometry(shape.Surface, shape.Graph, 0.1);
  for (Index c = 0; c < static_cast<Index>(geometry.Curves().size()); ++c)
  {
    const bool across = geometry.Curves()[c].Length() < 1;
    EXPECT_EQ(TooCloseForCells(geometry, c, 0.6), !across);
    EXPECT_FALSE(TooCloseForCells(geometry, c, 0.55));
  }
}

// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureGeometry.h"

#include "FeatureShapes.h"

#include <gtest/gtest.h>

using namespace featurehex;

namespace
{
const double Degrees = 180 / std::acos(-1.0);

EnforcedCurve CurveOf(const std::vector<Vec3>& points, bool closed)
{
  EnforcedCurve curve;
  curve.Points = points;
  curve.Closed = closed;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    curve.Arcs.push_back(
      i == 0 ? 0.0 : curve.Arcs.back() + (points[i] - points[i - 1]).norm());
  }
  return curve;
}

/// 3 along x, 4 along y.
EnforcedCurve Bend()
{
  return CurveOf({ { 0, 0, 0 }, { 3, 0, 0 }, { 3, 4, 0 } }, false);
}

EnforcedCurve UnitSquare()
{
  return CurveOf({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 0 } }, true);
}

void ExpectAt(const CurvePoint& closest, const Vec3& point, double arc)
{
  EXPECT_NEAR((closest.Point - point).norm(), 0, 1e-14) << closest.Point.transpose();
  EXPECT_NEAR(closest.Arc, arc, 1e-14);
}

/// Patches at a corner of the surface.
std::set<int> PatchesAt(const FeatureShape& shape, Index corner)
{
  std::set<int> patches;
  for (std::size_t t = 0; t < shape.Surface.Triangles.size(); ++t)
  {
    for (Index v : shape.Surface.Triangles[t])
    {
      if (v == shape.Graph.Corners[corner].Point)
      {
        patches.insert(shape.Graph.PatchOfTriangle[t]);
      }
    }
  }
  return patches;
}

std::vector<Index> CurvesAt(const FeatureShape& shape, Index corner)
{
  std::vector<Index> curves;
  for (std::size_t c = 0; c < shape.Graph.Curves.size(); ++c)
  {
    if (shape.Graph.Curves[c].FirstCorner == corner || shape.Graph.Curves[c].LastCorner == corner)
    {
      curves.push_back(static_cast<Index>(c));
    }
  }
  return curves;
}
}

TEST(FeatureGeometry, ClosestPointOnAnOpenCurve)
{
  const EnforcedCurve curve = Bend();
  EXPECT_EQ(curve.Length(), 7);
  const CurvePoint first = curve.Closest({ 1, -2, 0 });
  ExpectAt(first, { 1, 0, 0 }, 1);
  EXPECT_EQ(first.Tangent, Vec3::UnitX());
  EXPECT_NEAR(first.Distance, 2, 1e-14);
  const CurvePoint second = curve.Closest({ 5, 3, 1 });
  ExpectAt(second, { 3, 3, 0 }, 6);
  EXPECT_EQ(second.Tangent, Vec3::UnitY());
  EXPECT_NEAR(second.Distance, std::sqrt(5.0), 1e-14);
  ExpectAt(curve.Closest({ -1, 1, 0 }), { 0, 0, 0 }, 0); // before the start
  ExpectAt(curve.Closest({ 3, 9, 0 }), { 3, 4, 0 }, 7);  // beyond the end
  ExpectAt(curve.Closest({ 4, -1, 0 }), { 3, 0, 0 }, 3); // at the bend
}

TEST(FeatureGeometry, ClosestPointInARange)
{
  const EnforcedCurve curve = Bend();
  ExpectAt(curve.Closest({ 1, 0, 0 }, 2, 7), { 2, 0, 0 }, 2);
  ExpectAt(curve.Closest({ 3, 4, 0 }, 0, 5), { 3, 2, 0 }, 5);
  ExpectAt(curve.Closest({ 0, 0, 0 }, 3.5, 4), { 3, 0.5, 0 }, 3.5);
  ExpectAt(curve.Closest({ 0, 0, 0 }, -5, 9), { 0, 0, 0 }, 0);
}

TEST(FeatureGeometry, ClosestPointOverTheEndOfALoop)
{
  const EnforcedCurve curve = UnitSquare();
  const Vec3 p(0.2, -0.1, 0);
  ExpectAt(curve.Closest(p), { 0.2, 0, 0 }, 0.2);
  ExpectAt(curve.Closest(p, 3.5, 4.5), { 0.2, 0, 0 }, 4.2);
  ExpectAt(curve.Closest(p, 3.5, 4.1), { 0.1, 0, 0 }, 4.1);
  ExpectAt(curve.Closest(p, 3.5, 4.0), { 0, 0, 0 }, 4);
  EXPECT_EQ(curve.Closest(p, 3.5, 4.5).Tangent, Vec3::UnitX());
  // The other side of the end.
  ExpectAt(curve.Closest({ -0.1, 0.3, 0 }, 3.5, 4.5), { 0, 0.3, 0 }, 3.7);
}

TEST(FeatureGeometry, PointAtAnArc)
{
  EXPECT_NEAR((Bend().At(5) - Vec3(3, 2, 0)).norm(), 0, 1e-14);
  EXPECT_EQ(Bend().At(-1), Vec3(0, 0, 0));
  EXPECT_EQ(Bend().At(8), Vec3(3, 4, 0));
  for (double turns : { -8.0, -4.0, 0.0, 4.0, 8.0 })
  {
    EXPECT_NEAR((UnitSquare().At(turns + 1.25) - Vec3(1, 0.25, 0)).norm(), 0, 1e-14);
  }
}

TEST(FeatureGeometry, CubeIsEnforcedAsItIs)
{
  const FeatureShape cube = CubeWithFeatures(4);
  const FeatureGeometry geometry(cube.Surface, cube.Graph, 0.5);
  ASSERT_EQ(geometry.Curves().size(), 12u);
  for (const EnforcedCurve& curve : geometry.Curves())
  {
    EXPECT_NEAR(curve.Length(), 4, 1e-14);
    EXPECT_GE(curve.FirstCorner, 0);
    EXPECT_GE(curve.LastCorner, 0);
    EXPECT_FALSE(curve.Closed);
    EXPECT_NE(curve.LeftPatch, curve.RightPatch);
  }
  for (int patch = 0; patch < 6; ++patch)
  {
    EXPECT_EQ(geometry.PatchOf(patch), patch);
    EXPECT_EQ(geometry.Patch(patch).Mesh().Triangles.size(), 2u);
    EXPECT_EQ(geometry.Patch(patch).Mesh().Points.size(), 4u);
  }
}

TEST(FeatureGeometry, FansOfACubeAreInOrderWithAngles)
{
  const FeatureShape cube = CubeWithFeatures(4);
  const FeatureGeometry geometry(cube.Surface, cube.Graph, 0.5);
  ASSERT_EQ(geometry.Fans().size(), 8u);
  for (Index c = 0; c < 8; ++c)
  {
    const CornerFan& fan = geometry.Fans()[c];
    ASSERT_EQ(fan.Spokes.size(), 3u);
    EXPECT_NEAR(fan.FullAngle * Degrees, 270, 1e-9);
    const Vec3 corner = geometry.CornerPoint(c);
    const Vec3 outward = corner - Vec3::Constant(2);
    std::vector<Vec3> directions;
    for (int i = 0; i < 3; ++i)
    {
      const CornerFan::Spoke& spoke = fan.Spokes[i];
      EXPECT_NEAR(spoke.Angle * Degrees, 90 * i, 1e-9);
      const EnforcedCurve& curve = geometry.Curves()[spoke.Curve];
      EXPECT_EQ(spoke.AtEnd ? curve.LastCorner : curve.FirstCorner, c);
      directions.push_back(curve.At(spoke.AtEnd ? curve.Length() - 1 : 1) - corner);
    }
    for (int i = 0; i < 3; ++i)
    {
      EXPECT_GT(directions[i].cross(directions[(i + 1) % 3]).dot(outward), 0);
    }
  }
}

TEST(FeatureGeometry, LoopWithACornerHasTwoSpokes)
{
  const FeatureShape cylinder = CylinderWithFeatures(4);
  SurfaceFeatures graph;
  FeatureGraphReport report;
  const Index corner = cylinder.Graph.Curves[0].Points[1];
  ASSERT_TRUE(BuildSurfaceFeatures(cylinder.Surface, FeatureEdges(cylinder.Graph), { corner },
    FeatureGraphOptions(), graph, report)
                .Ok());
  ASSERT_EQ(graph.Corners.size(), 1u);
  const FeatureGeometry geometry(cylinder.Surface, graph, 0.1);
  const CornerFan& fan = geometry.Fans()[0];
  ASSERT_EQ(fan.Spokes.size(), 2u);
  EXPECT_EQ(fan.Spokes[0].Curve, fan.Spokes[1].Curve);
  EXPECT_NE(fan.Spokes[0].AtEnd, fan.Spokes[1].AtEnd);
  EXPECT_FALSE(geometry.Curves()[fan.Spokes[0].Curve].Closed); // it has a start
  EXPECT_TRUE(geometry.Curves()[1 - fan.Spokes[0].Curve].Closed);
}

TEST(FeatureGeometry, FlawedCornerTrimsItsCurvesAndMergesItsPatches)
{
  FeatureShape cube = CubeWithFeatures(4);
  cube.Graph.Corners[3].Flaw = CornerFlaw::AcuteCurves;
  const FeatureGeometry geometry(cube.Surface, cube.Graph, 0.5);
  EXPECT_FALSE(geometry.Enforced(3));
  EXPECT_TRUE(geometry.Fans()[3].Spokes.empty());
  const std::vector<Index> cut = CurvesAt(cube, 3);
  ASSERT_EQ(cut.size(), 3u);
  for (Index c = 0; c < 12; ++c)
  {
    const EnforcedCurve& curve = geometry.Curves()[c];
    const FeatureCurve& whole = cube.Graph.Curves[c];
    if (std::find(cut.begin(), cut.end(), c) == cut.end())
    {
      EXPECT_NEAR(curve.Length(), 4, 1e-14);
      continue;
    }
    const bool first = whole.FirstCorner == 3;
    EXPECT_NEAR(curve.Length(), 3.5, 1e-14);
    EXPECT_EQ(curve.FirstCorner, first ? -1 : whole.FirstCorner);
    EXPECT_EQ(curve.LastCorner, first ? whole.LastCorner : -1);
    EXPECT_NEAR(
      ((first ? curve.Points.front() : curve.Points.back()) - geometry.CornerPoint(3)).norm(), 0.5,
      1e-14);
  }
  const std::set<int> merged = PatchesAt(cube, 3);
  ASSERT_EQ(merged.size(), 3u);
  for (int patch = 0; patch < 6; ++patch)
  {
    EXPECT_EQ(geometry.PatchOf(patch), merged.count(patch) ? *merged.begin() : patch);
  }
}

TEST(FeatureGeometry, NothingIsEnforcedOfACurveThatTrimmingLeavesTooShort)
{
  FeatureShape cube = CubeWithFeatures(4);
  cube.Graph.Corners[0].Flaw = CornerFlaw::ManyCurves;
  const FeatureGeometry geometry(cube.Surface, cube.Graph, 2.5);
  for (Index c : CurvesAt(cube, 0))
  {
    EXPECT_TRUE(geometry.Curves()[c].Points.empty());
    EXPECT_EQ(geometry.Curves()[c].Length(), 0);
    const FeatureCurve& whole = cube.Graph.Curves[c];
    const Index other = whole.FirstCorner == 0 ? whole.LastCorner : whole.FirstCorner;
    EXPECT_EQ(geometry.Fans()[other].Spokes.size(), 2u);
    EXPECT_NEAR(geometry.Fans()[other].FullAngle * Degrees, 270, 1e-9);
  }
}

TEST(FeatureGeometry, GivenUpCurveMergesThePatchesBesideIt)
{
  const FeatureShape cube = CubeWithFeatures(4);
  GivenUpFeatures givenUp;
  givenUp.Curves = { 7 };
  const FeatureGeometry geometry(cube.Surface, cube.Graph, 0.5, givenUp);
  const FeatureCurve& curve = cube.Graph.Curves[7];
  EXPECT_TRUE(geometry.Curves()[7].Points.empty());
  const int lower = std::min(curve.LeftPatch, curve.RightPatch);
  for (int patch = 0; patch < 6; ++patch)
  {
    const bool beside = patch == curve.LeftPatch || patch == curve.RightPatch;
    EXPECT_EQ(geometry.PatchOf(patch), beside ? lower : patch);
  }
  for (Index c = 0; c < 8; ++c)
  {
    EXPECT_TRUE(geometry.Enforced(c));
    EXPECT_EQ(geometry.Fans()[c].Spokes.size(),
      c == curve.FirstCorner || c == curve.LastCorner ? 2u : 3u);
  }
}

TEST(FeatureGeometry, GivenUpCornerIsAsOneWithAFlaw)
{
  FeatureShape cube = CubeWithFeatures(4);
  GivenUpFeatures givenUp;
  EXPECT_TRUE(givenUp.Empty());
  givenUp.Corners = { 3 };
  EXPECT_FALSE(givenUp.Empty());
  const FeatureGeometry given(cube.Surface, cube.Graph, 0.5, givenUp);
  SurfaceFeatures graph = cube.Graph;
  graph.Corners[3].Flaw = CornerFlaw::ManyCurves;
  const FeatureGeometry flawed(cube.Surface, graph, 0.5);
  EXPECT_FALSE(given.Enforced(3));
  for (std::size_t c = 0; c < 12; ++c)
  {
    EXPECT_EQ(given.Curves()[c].Points, flawed.Curves()[c].Points);
    EXPECT_EQ(given.Curves()[c].FirstCorner, flawed.Curves()[c].FirstCorner);
    EXPECT_EQ(given.Curves()[c].LastCorner, flawed.Curves()[c].LastCorner);
  }
  for (int patch = 0; patch < 6; ++patch)
  {
    EXPECT_EQ(given.PatchOf(patch), flawed.PatchOf(patch));
  }
}

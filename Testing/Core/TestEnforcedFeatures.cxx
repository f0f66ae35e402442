// SPDX-License-Identifier: BSD-3-Clause
#include "EnforcedFeatures.h"

#include "MappingShapes.h"

#include <gtest/gtest.h>

using namespace featurehex;

namespace
{
/// A box with its edges and a loose curve on top.
struct Setting
{
  MappingShape Shape{ { 4, 4, 2 }, { { { 1, 2, 2 }, { 2, 2, 2 }, { 3, 2, 2 } } } };
  Index Loose = this->Shape.CurveThrough({ 2, 2, 2 });
  Index Edge = this->Shape.CurveThrough({ 2, 0, 2 });
  Index Corner = 0;
  EnforcedFeatures Features;

  Setting() { this->Features.Build(this->Shape.Surface, this->Shape.Graph, 0.5); }
};
}

TEST(EnforcedFeatures, NothingBeforeItIsBuilt)
{
  EXPECT_EQ(EnforcedFeatures().Geometry(), nullptr);
}

TEST(EnforcedFeatures, PatienceCountsRoundsOfEachFeature)
{
  Setting setting;
  const FeatureGeometry* first = setting.Features.Geometry();
  const std::set<FeatureName> failed = { { FeatureKind::Curve, setting.Edge } };
  EXPECT_FALSE(setting.Features.GiveUp(failed, 3));
  EXPECT_FALSE(setting.Features.GiveUp({ { FeatureKind::Curve, setting.Loose } }, 3));
  EXPECT_FALSE(setting.Features.GiveUp(failed, 3));
  EXPECT_EQ(setting.Features.Geometry(), first);
  EXPECT_TRUE(setting.Features.GiveUp(failed, 3));
  const FeatureGeometry& geometry = *setting.Features.Geometry();
  EXPECT_TRUE(geometry.Curves()[setting.Edge].Points.empty());
  EXPECT_FALSE(geometry.Curves()[setting.Loose].Points.empty());
  const FeatureCurve& curve = setting.Shape.Graph.Curves[setting.Edge];
  EXPECT_EQ(geometry.PatchOf(curve.LeftPatch), geometry.PatchOf(curve.RightPatch));
  EXPECT_FALSE(setting.Features.GiveUp(failed, 3)) << "it is given up already";
}

TEST(EnforcedFeatures, CornersAndPatches)
{
  Setting setting;
  EXPECT_TRUE(setting.Features.GiveUp({ { FeatureKind::Corner, setting.Corner } }, 1));
  EXPECT_FALSE(setting.Features.Geometry()->Enforced(setting.Corner));
  EXPECT_TRUE(setting.Features.Geometry()->Enforced(setting.Corner + 1));
  EXPECT_TRUE(setting.Features.GiveUp({ { FeatureKind::Surface, 0 } }, 1));
  for (std::size_t c = 0; c < setting.Shape.Graph.Curves.size(); ++c)
  {
    const FeatureCurve& curve = setting.Shape.Graph.Curves[c];
    if (curve.LeftPatch == 0 || curve.RightPatch == 0)
    {
      EXPECT_TRUE(setting.Features.Geometry()->Curves()[c].Points.empty()) << c;
    }
  }
  EXPECT_FALSE(setting.Features.GiveUp({ { FeatureKind::Surface, -1 } }, 1));
}

TEST(EnforcedFeatures, OnlyLooseCurvesGoAtOnce)
{
  Setting setting;
  EXPECT_FALSE(setting.Features.GiveUpLoose(
    { { FeatureKind::Curve, setting.Edge }, { FeatureKind::Corner, setting.Corner } }));
  EXPECT_TRUE(setting.Features.GiveUpLoose({ { FeatureKind::Curve, setting.Loose } }));
  EXPECT_TRUE(setting.Features.Geometry()->Curves()[setting.Loose].Points.empty());

  Setting atCorner;
  const Index end = atCorner.Shape.Graph.Curves[atCorner.Loose].FirstCorner;
  EXPECT_TRUE(atCorner.Features.GiveUpLoose({ { FeatureKind::Corner, end } }));
  EXPECT_TRUE(atCorner.Features.Geometry()->Curves()[atCorner.Loose].Points.empty());
}

TEST(EnforcedFeatures, FeaturesOfHexes)
{
  Setting setting;
  setting.Shape.Map();
  HexFeatures features = setting.Shape.Mapping.Features;
  const HexStars stars(setting.Shape.Mesh);
  const FeatureLabels labels(features, stars);
  const Index vertex = features.CornerVertices[setting.Corner];
  std::vector<Index> hexes(stars.Hexes[vertex].begin(), stars.Hexes[vertex].end());
  const std::set<FeatureName> found = FeaturesAt(setting.Shape.Mesh, hexes, labels);
  EXPECT_EQ(found.count({ FeatureKind::Corner, setting.Corner }), 1u);
  int curves = 0;
  for (const auto& [kind, id] : found)
  {
    curves += kind == FeatureKind::Curve;
    EXPECT_NE(kind, FeatureKind::Surface);
  }
  EXPECT_EQ(curves, 3);
  EXPECT_TRUE(FeaturesAt(setting.Shape.Mesh, {}, labels).empty());
}

TEST(EnforcedFeatures, PlacesWhereChainsAndQuadsLeaveTheirFeature)
{
  Setting setting;
  setting.Shape.Map();
  const HexFeatures& features = setting.Shape.Mapping.Features;
  HexMesh mesh = setting.Shape.Mesh;
  std::vector<Quad> quads;
  for (const InterfaceQuad& quad : setting.Shape.Interface)
  {
    quads.push_back(quad.Vertices);
  }
  FeatureValidationReport report;
  report.Curves.resize(setting.Shape.Graph.Curves.size());
  report.Patches.resize(setting.Shape.Graph.NumberOfPatches);
  report.Corners.resize(setting.Shape.Graph.Corners.size());
  const auto places = [&] {
    return MissedFeaturePlaces(
      mesh, quads, features, *setting.Features.Geometry(), report, 0.2);
  };
  const std::vector<Index>& path = features.CurvePaths[setting.Edge];
  const Vec3 moved = mesh.Points[path[path.size() / 2]] += Vec3(0, 0, 0.3);
  EXPECT_TRUE(places().empty()) << "nothing is reported";

  FeatureFinding& curve = report.Curves[setting.Edge];
  curve.Outcome = FeatureOutcome::OffPosition;
  curve.VertexDeviation = 0.3;
  ASSERT_EQ(places().size(), 1u);
  EXPECT_EQ(places()[0], moved);
  curve.Outcome = FeatureOutcome::BeyondTolerance;
  ASSERT_FALSE(places().empty());
  for (const Vec3& p : places())
  {
    EXPECT_LT((p - moved).norm(), 0.5);
  }
  curve.Outcome = FeatureOutcome::Captured;
  // The side face has the moved vertex above itself; on top it is above, too.
  report.Patches[setting.Shape.Graph.Curves[setting.Edge].LeftPatch].Outcome =
    FeatureOutcome::BeyondTolerance;
  EXPECT_FALSE(places().empty());
}

TEST(EnforcedFeatures, PlacesOfCornersWhoseVertexIsTrapped)
{
  Setting setting;
  setting.Shape.Map();
  FeatureValidationReport report;
  report.Corners.resize(setting.Shape.Graph.Corners.size());
  report.Corners[0].Outcome = FeatureOutcome::OffPosition;
  const std::vector<Vec3> places = MissedFeaturePlaces(setting.Shape.Mesh, {},
    setting.Shape.Mapping.Features, *setting.Features.Geometry(), report, 0.2);
  ASSERT_EQ(places.size(), 1u);
  EXPECT_EQ(places[0], setting.Features.Geometry()->CornerPoint(0));
}

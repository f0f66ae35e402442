// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureShapes.h"
#include "HexValidation.h"

using namespace featurehex;

namespace
{
/// A vertex in the middle of the chain of a curve.
Index MiddleOf(const FeatureShape& shape, std::size_t curve)
{
  const std::vector<Index>& path = shape.Features.CurvePaths[curve];
  return path[path.size() / 2];
}

/// Moves a vertex along the first edge of its curve's direction by @a step, sideways when asked.
Vec3 DirectionOf(const FeatureShape& shape, std::size_t curve)
{
  const FeatureCurve& c = shape.Graph.Curves[curve];
  return (shape.Surface.Points[c.Points.back()] - shape.Surface.Points[c.Points.front()])
    .normalized();
}

Vec3 Sideways(const FeatureShape& shape, std::size_t curve)
{
  const Vec3 d = DirectionOf(shape, curve);
  return Vec3(std::abs(d.x()) < 0.5, std::abs(d.x()) >= 0.5, 0);
}
}

TEST(FeatureValidation, EverythingOfACubeIsCaptured)
{
  for (int n : { 1, 2, 5 })
  {
    const FeatureValidationReport report = CubeWithFeatures(n).Validate();
    EXPECT_TRUE(report.AllCaptured()) << report.Complaint();
    EXPECT_EQ(report.Complaint(), "");
    EXPECT_EQ(report.CornerTotals().Captured, 8);
    EXPECT_EQ(report.CurveTotals().Captured, 12);
    EXPECT_EQ(report.PatchTotals().Captured, 6);
    EXPECT_EQ(report.CurveTotals().Found, 12);
    EXPECT_LT(report.CurveTotals().Deviation, 1e-12);
    EXPECT_LT(report.PatchTotals().Deviation, 1e-12);
  }
}

TEST(FeatureValidation, LoopsWithoutCornersAreCaptured)
{
  FeatureShape shape = CylinderWithFeatures(4);
  ASSERT_EQ(shape.Graph.Curves.size(), 2u);
  ASSERT_EQ(shape.Graph.Corners.size(), 0u);
  const FeatureValidationReport report = shape.Validate();
  EXPECT_TRUE(report.AllCaptured()) << report.Complaint();
  EXPECT_EQ(report.CurveTotals().Captured, 2);
  EXPECT_EQ(report.PatchTotals().Captured, 3);
  // The direction and the start of a loop are free.
  for (std::vector<Index>& path : shape.Features.CurvePaths)
  {
    std::reverse(path.begin(), path.end());
    path.pop_back();
    std::rotate(path.begin(), path.begin() + 3, path.end());
    path.push_back(path.front());
  }
  EXPECT_TRUE(shape.Validate().AllCaptured()) << shape.Validate().Complaint();
  shape.Features.CurvePaths[0].pop_back();
  EXPECT_EQ(shape.Validate().Curves[0].Outcome, FeatureOutcome::BrokenPath);
}

TEST(FeatureValidation, CornersOffTheirPlace)
{
  FeatureShape shape = CubeWithFeatures(4);
  const double diagonal = BoundingBox(shape.Surface).Diagonal();
  Vec3& p = shape.Mesh.Points[shape.Features.CornerVertices[3]];
  const Vec3 place = p;
  p += 0.5e-9 * diagonal * Vec3::UnitX();
  EXPECT_TRUE(shape.Validate().Corners[3].Captured());
  p = place + 2e-9 * diagonal * Vec3::UnitX();
  const FeatureValidationReport report = shape.Validate();
  EXPECT_EQ(report.Corners[3].Outcome, FeatureOutcome::OffPosition);
  EXPECT_NEAR(report.Corners[3].Deviation, 2e-9 * diagonal, 1e-14);
  EXPECT_EQ(report.CornerTotals().Captured, 7);
  EXPECT_EQ(report.CurveTotals().Captured, 12); // within their accuracy
  EXPECT_NE(report.Complaint().find("1 of 8 corners missed (corner 3 at"), std::string::npos)
    << report.Complaint();
}

TEST(FeatureValidation, CornersWithoutVertexOfTheirOwn)
{
  FeatureShape shape = CubeWithFeatures(3);
  shape.Features.CornerVertices[2] = -1;
  shape.Features.CornerVertices[4] = shape.Features.CornerVertices[5];
  const FeatureValidationReport report = shape.Validate();
  for (int corner : { 2, 4, 5 })
  {
    EXPECT_EQ(report.Corners[corner].Outcome, FeatureOutcome::NotMapped);
    EXPECT_FALSE(report.Corners[corner].Reason.empty());
  }
  EXPECT_EQ(report.CornerTotals().Captured, 5);
  for (std::size_t c = 0; c < report.Curves.size(); ++c)
  {
    const FeatureCurve& curve = shape.Graph.Curves[c];
    const bool touched = curve.FirstCorner == 2 || curve.LastCorner == 2 ||
                         curve.FirstCorner == 4 || curve.LastCorner == 4;
    EXPECT_EQ(report.Curves[c].Outcome,
      touched ? FeatureOutcome::WrongEnd : FeatureOutcome::Captured)
      << report.Curves[c].Reason;
  }
}

TEST(FeatureValidation, CurveVerticesOffTheirCurve)
{
  FeatureShape shape = CubeWithFeatures(4);
  const double diagonal = BoundingBox(shape.Surface).Diagonal();
  Vec3& p = shape.Mesh.Points[MiddleOf(shape, 7)];
  const Vec3 place = p;
  p = place + 0.3 * DirectionOf(shape, 7);
  EXPECT_TRUE(shape.Validate().AllCaptured()); // along the curve
  p = place + 0.5e-6 * diagonal * Sideways(shape, 7);
  EXPECT_TRUE(shape.Validate().AllCaptured());
  p = place + 1e-4 * diagonal * Sideways(shape, 7);
  const FeatureValidationReport report = shape.Validate();
  EXPECT_EQ(report.Curves[7].Outcome, FeatureOutcome::OffPosition);
  EXPECT_NEAR(report.Curves[7].VertexDeviation, 1e-4 * diagonal, 1e-9);
  EXPECT_NEAR(report.Curves[7].Deviation, 1e-4 * diagonal, 1e-4 * diagonal);
  EXPECT_EQ(report.CurveTotals().Captured, 11);
}

TEST(FeatureValidation, ChainsThatRunBack)
{
  FeatureShape shape = CubeWithFeatures(4);
  const std::vector<Index>& path = shape.Features.CurvePaths[0];
  std::swap(shape.Mesh.Points[path[1]], shape.Mesh.Points[path[2]]);
  const FeatureFinding finding = shape.Validate().Curves[0];
  EXPECT_EQ(finding.Outcome, FeatureOutcome::BrokenPath);
  EXPECT_NE(finding.Reason.find("runs back"), std::string::npos);
}

TEST(FeatureValidation, ChordsThatCutOffTheCurve)
{
  // One edge over a curve with a bulge that no vertex follows.
  FeatureShape shape = CylinderWithFeatures(4);
  std::vector<Index>& path = shape.Features.CurvePaths[0];
  const Vec3 middle = 0.5 * (shape.Mesh.Points[path[0]] + shape.Mesh.Points[path[2]]);
  // The vertex between moves along the curve to its neighbour: the chord spans two edges.
  shape.Mesh.Points[path[1]] =
    shape.Mesh.Points[path[0]] + 1e-3 * (shape.Mesh.Points[path[1]] - shape.Mesh.Points[path[0]]);
  const FeatureFinding finding = shape.Validate(0.005).Curves[0];
  EXPECT_EQ(finding.Outcome, FeatureOutcome::BeyondTolerance);
  const double sagitta = (middle - shape.Surface.Points[path[1]]).norm();
  EXPECT_NEAR(finding.Deviation, sagitta, 0.05 * sagitta);
  EXPECT_TRUE(shape.Validate(0.05).Curves[0].Captured()) << shape.Validate(0.05).Curves[0].Reason;
}

TEST(FeatureValidation, BrokenAndMissingChains)
{
  const FeatureShape cube = CubeWithFeatures(4);
  FeatureShape shape = cube;
  shape.Features.CurvePaths[3].erase(shape.Features.CurvePaths[3].begin() + 2);
  FeatureValidationReport report = shape.Validate();
  EXPECT_EQ(report.Curves[3].Outcome, FeatureOutcome::BrokenPath);
  EXPECT_EQ(report.CurveTotals().Captured, 11);
  EXPECT_EQ(report.PatchTotals().Captured, 4); // the two on its sides are parted by no curve

  shape = cube;
  shape.Features.CurvePaths[3].clear();
  report = shape.Validate();
  EXPECT_EQ(report.Curves[3].Outcome, FeatureOutcome::NotMapped);
  EXPECT_EQ(report.PatchTotals().Captured, 4);

  shape = cube;
  shape.Features.CurvePaths[3] = shape.Features.CurvePaths[4];
  report = shape.Validate();
  EXPECT_EQ(report.CurveTotals().Captured, 10);

  shape = cube;
  shape.Features.CurvePaths[3][1] = 99999;
  EXPECT_EQ(shape.Validate().Curves[3].Outcome, FeatureOutcome::BrokenPath);

  shape = cube;
  std::reverse(shape.Features.CurvePaths[3].begin(), shape.Features.CurvePaths[3].end());
  EXPECT_EQ(shape.Validate().Curves[3].Outcome, FeatureOutcome::WrongEnd);

  shape.Features = HexFeatures();
  report = shape.Validate();
  EXPECT_EQ(report.CornerTotals().Captured, 0);
  EXPECT_EQ(report.CurveTotals().Captured, 0);
  EXPECT_EQ(report.PatchTotals().Captured, 0);
  EXPECT_EQ(report.Patches[0].Outcome, FeatureOutcome::NotMapped);
}

TEST(FeatureValidation, PatchesOnTheWrongSideOrInPieces)
{
  const FeatureShape cube = CubeWithFeatures(4);
  FeatureShape shape = cube;
  for (int& patch : shape.Features.PatchOfQuad)
  {
    patch = patch == 0 ? 1 : patch == 1 ? 0 : patch;
  }
  FeatureValidationReport report = shape.Validate();
  EXPECT_EQ(report.Patches[0].Outcome, FeatureOutcome::WrongBoundary);
  EXPECT_EQ(report.Patches[1].Outcome, FeatureOutcome::WrongBoundary);

  // One quad in the middle of a patch goes to the opposite one.
  shape = cube;
  for (std::size_t q = 0; q < shape.Boundary.Quads.size(); ++q)
  {
    const Quad& quad = shape.Boundary.Quads[q];
    if (std::all_of(quad.begin(), quad.end(),
          [&](Index v) { return shape.Labels.Kind[v] == FeatureKind::Surface; }))
    {
      const int patch = shape.Features.PatchOfQuad[q];
      shape.Features.PatchOfQuad[q] = (patch + 1) % 6;
      report = shape.Validate();
      EXPECT_EQ(report.Patches[patch].Outcome, FeatureOutcome::WrongBoundary);
      EXPECT_EQ(report.Patches[(patch + 1) % 6].Outcome, FeatureOutcome::InPieces);
      EXPECT_EQ(report.PatchTotals().Captured, 4);
      break;
    }
  }
}

TEST(FeatureValidation, PatchesOffTheirSurface)
{
  FeatureShape shape = CubeWithFeatures(4);
  for (std::size_t v = 0; v < shape.Labels.Kind.size(); ++v)
  {
    if (shape.Labels.Kind[v] == FeatureKind::Surface && shape.Labels.Id[v] == 2)
    {
      shape.Mesh.Points[v] += 0.1 * Vec3(1, 1, 1);
      break;
    }
  }
  const FeatureFinding finding = shape.Validate().Patches[2];
  EXPECT_EQ(finding.Outcome, FeatureOutcome::BeyondTolerance);
  EXPECT_NEAR(finding.Deviation, 0.1, 1e-12);
}

TEST(FeatureValidation, FlawedCornersDontCount)
{
  FeatureShape shape = CubeWithFeatures(6);
  shape.Graph.Corners[0].Flaw = CornerFlaw::AcuteCurves;
  shape.Features.CornerVertices[0] = -1;
  std::vector<std::size_t> cut;
  for (std::size_t c = 0; c < shape.Graph.Curves.size(); ++c)
  {
    std::vector<Index>& path = shape.Features.CurvePaths[c];
    if (shape.Graph.Curves[c].FirstCorner == 0)
    {
      path.erase(path.begin(), path.begin() + 2);
      cut.push_back(c);
    }
    else if (shape.Graph.Curves[c].LastCorner == 0)
    {
      path.resize(path.size() - 2);
      cut.push_back(c);
    }
  }
  ASSERT_EQ(cut.size(), 3u);
  // The three patches round the corner are one, under the lowest of their ids.
  std::vector<bool> merged(6, false);
  for (std::size_t c : cut)
  {
    merged[shape.Graph.Curves[c].LeftPatch] = merged[shape.Graph.Curves[c].RightPatch] = true;
  }
  const int lowest =
    static_cast<int>(std::find(merged.begin(), merged.end(), true) - merged.begin());
  for (int& patch : shape.Features.PatchOfQuad)
  {
    patch = merged[patch] ? lowest : patch;
  }
  const FeatureValidationReport report = shape.Validate();
  EXPECT_TRUE(report.AllCaptured()) << report.Complaint();
  EXPECT_EQ(report.CornerTotals().Enforced, 7);
  EXPECT_EQ(report.CornerTotals().Captured, 7);
  EXPECT_EQ(report.CurveTotals().Enforced, 9);
  EXPECT_EQ(report.PatchTotals().Enforced, 3);
  EXPECT_EQ(report.CurveTotals().Found, 12);
  EXPECT_EQ(report.Corners[0].Outcome, FeatureOutcome::NotEnforced);
  EXPECT_EQ(report.Curves[cut[0]].Reason,
    "ends at corner 0, where two curves meet at less than 30 degrees; followed over 66.7 % of its "
    "length");
}

TEST(FeatureValidation, FiguresOfTheWholeReport)
{
  const FeatureShape shape = CubeWithFeatures(4);
  HexValidationOptions options;
  options.Features = { &shape.Graph, &shape.Features };
  Monitor monitor;
  const HexValidationReport report =
    ValidateHexMesh(shape.Mesh, &shape.Surface, options, monitor);
  ASSERT_TRUE(report.HasFeatures);
  EXPECT_TRUE(report.Valid());
  std::map<std::string, double> figures;
  for (const auto& [name, value] : report.Figures())
  {
    figures[name] = value;
  }
  EXPECT_EQ(figures.at("FeaturesCaptured"), 1.0);
  EXPECT_EQ(figures.at("CornersEnforced"), 8.0);
  EXPECT_EQ(figures.at("CornersCaptured"), 8.0);
  EXPECT_EQ(figures.at("CurvesCaptured"), 12.0);
  EXPECT_EQ(figures.at("PatchesCaptured"), 6.0);
  EXPECT_EQ(figures.count("CurveVertexDeviationMaximum"), 1u);
  // Without features there are no such figures.
  const HexValidationReport plain =
    ValidateHexMesh(shape.Mesh, &shape.Surface, HexValidationOptions(), monitor);
  for (const auto& figure : plain.Figures())
  {
    EXPECT_NE(figure.first, "CornersEnforced");
  }
}

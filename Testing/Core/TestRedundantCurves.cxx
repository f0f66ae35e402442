// SPDX-License-Identifier: BSD-3-Clause
#include "RedundantCurves.h"

#include "FeatureExtraction.h"
#include "MeshTopology.h"
#include "SharedData.h"
#include "ValidationShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

using namespace featurehex;

namespace
{
constexpr double Near = 0.01;  // the distance asked for
constexpr double Step = 0.006; // nearer than that
constexpr int High = 2;        // layer of the upper side of a plate

using Place = std::array<int, 3>; // position in the lattice of a plate
using Three = std::array<std::size_t, 3>;
using Curves = std::vector<Index>;

/// A box between lattice planes, with curves along edges of the lattice.
struct Plate
{
  SurfaceMesh Surface;
  std::vector<PointPair> Edges;
  std::map<Place, Index> Ids;

  Plate(const std::vector<double>& x, const std::vector<double>& y)
  {
    const std::vector<double> z = { 0, 3, 6 };
    const Place n = { int(x.size()) - 1, int(y.size()) - 1, High };
    const HexMesh mesh = LatticeMesh(n, [](int, int, int) { return true; });
    this->Surface = SplitQuads(mesh.Points, ExtractBoundary(mesh).Quads);
    for (std::size_t v = 0; v < mesh.Points.size(); ++v)
    {
      const Eigen::Vector3i p = mesh.Points[v].cast<int>();
      this->Ids[{ p[0], p[1], p[2] }] = static_cast<Index>(v);
      this->Surface.Points[v] = Vec3(x[p[0]], y[p[1]], z[p[2]]);
    }
    FeatureDetectionReport report;
    this->Edges = FindSharpEdges(this->Surface, FeatureDetectionOptions(), report);
  }

  Vec3& At(int i, int j) { return this->Surface.Points[this->Ids.at({ i, j, High })]; }

  /// A curve on the upper side.
  void Draw(const std::vector<std::array<int, 2>>& line)
  {
    for (std::size_t i = 1; i < line.size(); ++i)
    {
      this->Edges.push_back({ this->Ids.at({ line[i - 1][0], line[i - 1][1], High }),
        this->Ids.at({ line[i][0], line[i][1], High }) });
    }
  }
};

SurfaceFeatures Build(
  const SurfaceMesh& surface, const std::vector<PointPair>& edges, double cornerAngle = 140.0)
{
  FeatureGraphOptions options;
  options.CornerAngle = cornerAngle;
  SurfaceFeatures features;
  FeatureGraphReport report;
  const Status status = BuildSurfaceFeatures(surface, edges, {}, options, features, report);
  EXPECT_TRUE(status.Ok()) << status.Message;
  return features;
}

/// The curves through any of the points.
Curves Through(const SurfaceFeatures& features, const std::vector<Index>& points)
{
  Curves curves;
  for (std::size_t c = 0; c < features.Curves.size(); ++c)
  {
    const std::vector<Index>& path = features.Curves[c].Points;
    if (std::find_first_of(path.begin(), path.end(), points.begin(), points.end()) != path.end())
    {
      curves.push_back(static_cast<Index>(c));
    }
  }
  return curves;
}

/// With a chain from x = 2 to 8 beside the edge y = 0 of the upper side.
Plate WithDanglingChain()
{
  Plate plate({ 0, 2, 4, 6, 8, 10 }, { 0, Step, 5, 10 });
  plate.Draw({ { 1, 1 }, { 2, 1 }, { 3, 1 }, { 4, 1 } });
  return plate;
}

/// With a curve from side to side, a sliver away from the edge y = 0; the one of the two that is at
/// @a crooked isn't straight.
Plate WithSliver(int crooked)
{
  Plate plate({ 0, 2, 4, 6, 8, 10 }, { 0, Step, 5, 10 });
  plate.Draw({ { 0, 1 }, { 1, 1 }, { 2, 1 }, { 3, 1 }, { 4, 1 }, { 5, 1 } });
  plate.At(2, crooked)[2] += 0.3 * Step;
  return plate;
}

/// A prism of 20 sides, radius 5, with rims and a ring just below the upper one.
struct Prism
{
  static constexpr int Sides = 20;
  SurfaceMesh Surface;
  std::vector<PointPair> Edges;

  explicit Prism(double ringRadius)
  {
    const double radius[] = { 5, ringRadius, 5 };
    const double height[] = { 0, 10 - Step, 10 };
    for (int r = 0; r < 3; ++r)
    {
      for (int i = 0; i < Sides; ++i)
      {
        const double angle = 2 * std::acos(-1.0) * i / Sides;
        this->Surface.Points.emplace_back(
          radius[r] * std::cos(angle), radius[r] * std::sin(angle), height[r]);
        const Index a = r * Sides + i, b = r * Sides + (i + 1) % Sides;
        this->Edges.push_back({ a, b });
        if (r < 2)
        {
          this->Surface.Triangles.push_back({ a, b, b + Sides });
          this->Surface.Triangles.push_back({ a, b + Sides, a + Sides });
        }
      }
    }
    this->Surface.Points.emplace_back(0, 0, 0);
    this->Surface.Points.emplace_back(0, 0, 10);
    for (Index a = 0; a < Sides; ++a)
    {
      const Index b = (a + 1) % Sides;
      this->Surface.Triangles.push_back({ 3 * Sides, b, a });
      this->Surface.Triangles.push_back({ 3 * Sides + 1, a + 2 * Sides, b + 2 * Sides });
    }
  }
};

struct Extracted
{
  SurfaceFeatures Features;
  FeatureExtractionReport Report;

  Extracted(const SurfaceMesh& surface, const FeatureAnnotation& annotation,
    const FeatureExtractionOptions& options = FeatureExtractionOptions())
  {
    const Status status =
      ExtractFeatures(surface, &annotation, options, this->Features, this->Report);
    EXPECT_TRUE(status.Ok()) << status.Message;
  }
  std::array<std::size_t, 3> Counts() const
  {
    return { this->Features.Corners.size(), this->Features.Curves.size(),
      static_cast<std::size_t>(this->Features.NumberOfPatches) };
  }
  bool CornerAt(Index point) const
  {
    return std::any_of(this->Features.Corners.begin(), this->Features.Corners.end(),
      [&](const FeatureCorner& corner) { return corner.Point == point; });
  }
};

}

TEST(RedundantCurves, DanglingChainBesideAnEdge)
{
  const Plate plate = WithDanglingChain();
  const SurfaceFeatures features = Build(plate.Surface, plate.Edges);
  ASSERT_EQ(features.Curves.size(), 13u);
  const Curves chain = Through(features, { plate.Ids.at({ 2, 1, High }) });
  EXPECT_EQ(FindRedundantCurves(plate.Surface, features, Near), chain);
  EXPECT_EQ(FindRedundantCurves(plate.Surface, features, 1.001 * Step), chain);
  for (double distance : { 0.999 * Step, 0.0, -1.0, std::nan("") })
  {
    EXPECT_TRUE(FindRedundantCurves(plate.Surface, features, distance).empty()) << distance;
  }
  const SurfaceFeatures none = Build(plate.Surface, {});
  EXPECT_TRUE(FindRedundantCurves(plate.Surface, none, Near).empty());
}

TEST(RedundantCurves, OfTheTwoBesideASliverTheShorterStays)
{
  for (int crooked : { 0, 1 })
  {
    const Plate plate = WithSliver(crooked);
    const SurfaceFeatures features = Build(plate.Surface, plate.Edges);
    ASSERT_EQ(features.NumberOfPatches, 7);
    EXPECT_EQ(FindRedundantCurves(plate.Surface, features, Near),
      Through(features, { plate.Ids.at({ 2, crooked, High }) }));
  }
}

TEST(RedundantCurves, WidePatchWithNarrowEndsIsNoSliver)
{
  // The short curves at its ends stay, too: without them it would join a side of the box.
  Plate plate = WithSliver(1);
  plate.At(2, 1)[1] = 1;
  const SurfaceFeatures features = Build(plate.Surface, plate.Edges, 60);
  EXPECT_TRUE(FindRedundantCurves(plate.Surface, features, Near).empty());
}

TEST(RedundantCurves, NearOnlyAtItsEndsOrPoints)
{
  // A horseshoe round an edge of the lattice, both ends of which it comes near to.
  Plate plate({ 0, 2, 4 - Step, 4, 8, 8 + Step, 10 }, { 0, 4, 6, 10 });
  plate.Draw({ { 3, 1 }, { 4, 1 } });
  plate.Draw({ { 2, 1 }, { 2, 2 }, { 3, 2 }, { 4, 2 }, { 5, 2 }, { 5, 1 } });
  for (double cornerAngle : { 140.0, 60.0 })
  {
    const SurfaceFeatures features = Build(plate.Surface, plate.Edges, cornerAngle);
    ASSERT_EQ(features.Curves.size(), cornerAngle > 90 ? 16u : 14u);
    EXPECT_TRUE(FindRedundantCurves(plate.Surface, features, Near).empty());
  }
}

TEST(RedundantCurves, ShortEdgeBetweenLargePatchesStays)
{
  // The ridge of a hip roof, near the hips at all of its points.
  SurfaceMesh roof;
  roof.Points = { Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(10, 10, 0), Vec3(0, 10, 0),
    Vec3(5 - Step / 2, 5, 6), Vec3(5 + Step / 2, 5, 6) };
  roof.Triangles = { { 0, 2, 1 }, { 0, 3, 2 }, { 0, 1, 5 }, { 0, 5, 4 }, { 1, 2, 5 }, { 2, 3, 4 },
    { 2, 4, 5 }, { 3, 0, 4 } };
  SurfaceMesh fine; // with points inside the patches, that are far from all curves
  fine.Points = roof.Points;
  for (const Triangle& t : roof.Triangles)
  {
    const auto middle = static_cast<Index>(fine.Points.size());
    fine.Points.push_back((fine.Points[t[0]] + fine.Points[t[1]] + fine.Points[t[2]]) / 3);
    for (int k = 0; k < 3; ++k)
    {
      fine.Triangles.push_back({ t[k], t[(k + 1) % 3], middle });
    }
  }
  for (const SurfaceMesh& surface : { fine, roof })
  {
    const SurfaceFeatures features = Build(surface,
      { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 4 }, { 3, 4 }, { 1, 5 }, { 2, 5 }, { 4, 5 } });
    ASSERT_EQ(features.Curves.size(), 9u);
    ASSERT_EQ(features.NumberOfPatches, 5);
    EXPECT_TRUE(FindRedundantCurves(surface, features, Near).empty())
      << surface.Points.size() << " points";
  }
}

TEST(RedundantCurves, OfTwoLoopsTheShorterStays)
{
  for (double ringRadius : { 5 - 0.3 * Step, 5 + 0.3 * Step })
  {
    const Prism prism(ringRadius);
    const SurfaceFeatures features = Build(prism.Surface, prism.Edges);
    ASSERT_EQ(features.Curves.size(), 3u);
    ASSERT_TRUE(features.Corners.empty());
    const Index longer = ringRadius > 5 ? Prism::Sides : 2 * Prism::Sides;
    EXPECT_EQ(FindRedundantCurves(prism.Surface, features, Near), Through(features, { longer }));
    EXPECT_EQ(Extracted(prism.Surface, { prism.Edges, {} }).Counts(), (Three{ 0, 2, 3 }));
  }
}

TEST(RedundantCurves, OrderOfTheIdsChangesNothing)
{
  const Plate plates[] = { WithDanglingChain(), WithSliver(0), WithSliver(1) };
  std::mt19937 random(17);
  for (const Plate& plate : plates)
  {
    std::set<std::vector<Index>> wanted;
    for (int round = 0; round < 10; ++round)
    {
      std::vector<Index> newId(plate.Surface.Points.size());
      std::iota(newId.begin(), newId.end(), 0);
      SurfaceMesh surface = plate.Surface;
      std::vector<PointPair> edges = plate.Edges;
      if (round > 0)
      {
        std::shuffle(newId.begin(), newId.end(), random);
        std::shuffle(surface.Triangles.begin(), surface.Triangles.end(), random);
        std::shuffle(edges.begin(), edges.end(), random);
      }
      std::vector<Index> oldId(newId.size());
      for (std::size_t v = 0; v < newId.size(); ++v)
      {
        oldId[newId[v]] = static_cast<Index>(v);
        surface.Points[newId[v]] = plate.Surface.Points[v];
      }
      for (Triangle& t : surface.Triangles)
      {
        t = { newId[t[0]], newId[t[1]], newId[t[2]] };
      }
      for (PointPair& edge : edges)
      {
        edge = { newId[edge[1]], newId[edge[0]] };
      }
      const SurfaceFeatures features = Build(surface, edges);
      std::set<std::vector<Index>> dropped;
      for (Index c : FindRedundantCurves(surface, features, Near))
      {
        std::vector<Index> points;
        for (Index v : features.Curves[c].Points)
        {
          points.push_back(oldId[v]);
        }
        std::sort(points.begin(), points.end());
        dropped.insert(points);
      }
      EXPECT_EQ(dropped.size(), 1u);
      wanted = round == 0 ? dropped : wanted;
      EXPECT_EQ(dropped, wanted);
    }
  }
}

TEST(RedundantCurves, ExtractionDropsThem)
{
  for (int crooked : { 0, 1 })
  {
    const Plate plate = WithSliver(crooked);
    const FeatureAnnotation annotation = { plate.Edges, {} };
    const Extracted found(plate.Surface, annotation);
    ASSERT_EQ(found.Report.RedundantCurves.size(), 1u);
    const Vec3& place = found.Report.RedundantCurves[0];
    EXPECT_NEAR(place[1], crooked * Step, 1e-12);
    ASSERT_EQ(found.Report.Notes.size(), 1u);
    EXPECT_NE(found.Report.Notes[0].find(
                "1 curve dropped that can't be told from others beside, the first at ("),
      std::string::npos)
      << found.Report.Notes[0];
    EXPECT_EQ(found.Features.NumberOfPatches, 6);
    // The true edge isn't dropped without leaving its ends at the sides.
    EXPECT_EQ(found.Features.Curves.size(), crooked == 1 ? 12u : 14u);

    FeatureExtractionOptions off;
    off.RedundantDistance = 0;
    FeatureExtractionOptions all;
    all.Graph.EnforceAll = true;
    FeatureExtractionOptions tight;
    tight.RedundantDistance = 0.3 * Step / BoundingBox(plate.Surface).Diagonal();
    for (const FeatureExtractionOptions& options : { off, all, tight })
    {
      const Extracted kept(plate.Surface, annotation, options);
      EXPECT_TRUE(kept.Report.RedundantCurves.empty());
      EXPECT_TRUE(kept.Report.Notes.empty());
      EXPECT_EQ(kept.Counts(), (Three{ 10, 15, 7 }));
    }
  }
}

TEST(RedundantCurves, CornersWithoutCurvesGoToo)
{
  Plate plate = WithDanglingChain();
  const Index middle = plate.Ids.at({ 3, 1, High });
  const Index onEdge = plate.Ids.at({ 1, 0, High });
  const Index lonely = plate.Ids.at({ 2, 2, High });
  // From the edge, too: without the chain its start is a corner only when it is asked for.
  plate.Draw({ { 1, 0 }, { 1, 1 } });
  const Extracted plain(plate.Surface, { plate.Edges, {} });
  EXPECT_EQ(plain.Counts(), (Three{ 8, 12, 6 }));
  EXPECT_FALSE(plain.CornerAt(onEdge));
  const Extracted found(plate.Surface, { plate.Edges, { middle, onEdge, lonely } });
  EXPECT_EQ(found.Report.RedundantCurves.size(), 3u);
  EXPECT_EQ(found.Counts(), (Three{ 10, 13, 6 }));
  EXPECT_FALSE(found.CornerAt(middle));
  EXPECT_TRUE(found.CornerAt(onEdge));
  EXPECT_TRUE(found.CornerAt(lonely)); // it never had a curve
}

TEST(RedundantCurves, RealParts)
{
  if (!std::filesystem::exists(SharedData() / "surfaces/cad"))
  {
    GTEST_SKIP() << "no surfaces in " << SharedData();
  }
  for (const auto& [name, count] : std::map<std::string, std::size_t>{ { "block", 15 },
         { "fandisk", 0 }, { "g05_spur_gear", 0 }, { "hanger", 0 }, { "joint", 0 }, { "rod", 0 } })
  {
    SurfaceMesh surface;
    FeatureGraph file;
    const Status status = ReadPart(name, surface, file);
    ASSERT_TRUE(status.Ok()) << status.Message;
    const Extracted found(surface, { file.Edges, file.Corners });
    EXPECT_EQ(found.Report.RedundantCurves.size(), count) << name;
    EXPECT_EQ(found.Report.Notes.size(), count > 0 ? 1u : 0u) << name;
  }
}

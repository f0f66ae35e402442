// SPDX-License-Identifier: BSD-3-Clause
#include "HexLocalPadding.h"

#include "MappingShapes.h"
#include "QuadGraph.h"

#include <gtest/gtest.h>

using namespace featurehex;

namespace
{
/// A box with features, mapped and padded all round, then where quads are degenerate.
struct Setting
{
  MappingShape Shape;
  PaddedMesh Global, Padded;
  HexFeatures Before, Features;
  LocalPaddingReport Report;

  explicit Setting(
    const std::array<int, 3>& n, const std::vector<std::vector<Vec3>>& lines = {}, double cornerAngle = 140.0)
    : Shape(n, lines, cornerAngle)
  {
    this->Shape.Map();
    EXPECT_TRUE(this->Shape.Mapping.Complete()) << this->Shape.Reasons();
    const Status status = PadInterface(this->Shape.Mesh,
      std::vector<int>(this->Shape.Mesh.Hexes.size(), 1), PaddingOptions(), this->Global);
    EXPECT_TRUE(status.Ok()) << status.Message;
    this->Padded = this->Global;
    this->Before = this->Features =
      FeaturesOfPaddedMesh(this->Shape.Mapping.Features, this->Padded, HexStars(this->Padded.Mesh));
    this->Report = PadDegenerateQuads(
      this->Padded, this->Features, *this->Shape.Geometry, LocalPaddingOptions());
  }
};

QuadGraph GraphOf(const HexMesh& mesh)
{
  return QuadGraph(ExtractBoundary(mesh).Quads, mesh.Points.size());
}

/// Conforming, manifold, no two hexes with two common faces, one boundary quad a hex at most.
void ExpectSound(const PaddedMesh& padded)
{
  const HexTopology topology = AnalyzeHexMesh(padded.Mesh);
  EXPECT_TRUE(topology.Conforming());
  EXPECT_TRUE(topology.Surface.ClosedManifold());
  EXPECT_EQ(topology.OrphanPoints, 0);
  EXPECT_EQ(topology.Bodies, 1);
  const std::vector<std::array<Index, 6>> neighbors = FaceNeighbors(
    padded.Mesh.Hexes, CellsOfVertices(padded.Mesh.Hexes, padded.Mesh.Points.size()));
  for (std::size_t h = 0; h < neighbors.size(); ++h)
  {
    std::array<Index, 6> sorted = neighbors[h];
    std::sort(sorted.begin(), sorted.end());
    for (int i = 1; i < 6; ++i)
    {
      EXPECT_NE(sorted[i], sorted[i - 1]) << "hex " << h; // two on the boundary are wrong as well
    }
  }
  const std::size_t hexes = padded.Mesh.Hexes.size();
  EXPECT_EQ(padded.Region.size(), hexes);
  EXPECT_EQ(padded.IsLayer.size(), hexes);
  EXPECT_EQ(padded.SourceHex.size(), hexes);
  EXPECT_EQ(padded.SourceQuad.size(), hexes);
  EXPECT_EQ(padded.SourcePoint.size(), padded.Mesh.Points.size());
  EXPECT_EQ(padded.OnBoundary.size(), padded.Mesh.Points.size());
  const HexStars stars(padded.Mesh);
  for (std::size_t v = 0; v < padded.Mesh.Points.size(); ++v)
  {
    EXPECT_EQ(padded.OnBoundary[v] != 0, stars.OnBoundary(static_cast<Index>(v)));
  }
}

/// Paths are chains of boundary edges through the same points as before, and part the same patches.
void ExpectSameFeatures(const Setting& setting)
{
  const QuadGraph graph = GraphOf(setting.Padded.Mesh);
  std::vector<bool> wall(graph.NumberOfDarts(), false);
  ASSERT_EQ(setting.Features.CurvePaths.size(), setting.Before.CurvePaths.size());
  for (std::size_t c = 0; c < setting.Features.CurvePaths.size(); ++c)
  {
    const std::vector<Index>& path = setting.Features.CurvePaths[c];
    ASSERT_EQ(path.size(), setting.Before.CurvePaths[c].size());
    for (std::size_t i = 0; i < path.size(); ++i)
    {
      EXPECT_EQ(setting.Padded.Mesh.Points[path[i]],
        setting.Global.Mesh.Points[setting.Before.CurvePaths[c][i]]);
      if (i > 0)
      {
        const Index dart = graph.Find(path[i - 1], path[i]);
        ASSERT_GE(dart, 0) << "curve " << c;
        wall[dart] = wall[graph.Opposite(dart)] = true;
      }
    }
  }
  for (std::size_t c = 0; c < setting.Features.CornerVertices.size(); ++c)
  {
    EXPECT_EQ(setting.Padded.Mesh.Points[setting.Features.CornerVertices[c]],
      setting.Global.Mesh.Points[setting.Before.CornerVertices[c]]);
  }
  ASSERT_EQ(setting.Features.PatchOfQuad.size(), graph.Quads().size());
  std::set<int> patches;
  for (Index d = 0; d < graph.NumberOfDarts(); ++d)
  {
    const int patch = setting.Features.PatchOfQuad[d / 4];
    patches.insert(patch);
    if (!wall[d])
    {
      EXPECT_EQ(patch, setting.Features.PatchOfQuad[graph.Opposite(d) / 4]);
    }
  }
  EXPECT_EQ(static_cast<int>(patches.size()), setting.Shape.Graph.NumberOfPatches);
}

/// Quads on the left and on the right of each inner vertex of a path.
std::vector<std::array<int, 2>> SidesOf(const HexMesh& mesh, const std::vector<Index>& path)
{
  const QuadGraph graph = GraphOf(mesh);
  std::vector<std::array<int, 2>> sides;
  for (std::size_t i = 1; i + 1 < path.size(); ++i)
  {
    const int left =
      graph.QuadsOnLeft(graph.Find(path[i - 1], path[i]), graph.Find(path[i], path[i + 1]));
    sides.push_back({ left, graph.Valence(path[i]) - left });
  }
  return sides;
}

/// Where a curve had one quad on a side, or three, it has two, and nowhere one. @a ends: so many vertices at both ends
/// aside.
void ExpectOpened(const Setting& setting, Index curve, std::size_t ends)
{
  const auto before = SidesOf(setting.Global.Mesh, setting.Before.CurvePaths[curve]);
  const auto after = SidesOf(setting.Padded.Mesh, setting.Features.CurvePaths[curve]);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = ends; i + ends < after.size(); ++i)
  {
    for (int side : { 0, 1 })
    {
      if (before[i][side] == 2)
      {
        EXPECT_GE(after[i][side], 2) << "curve " << curve << ", vertex " << i + 1;
      }
      else
      {
        EXPECT_EQ(after[i][side], 2) << "curve " << curve << ", vertex " << i + 1;
      }
    }
  }
}

std::vector<Vec3> Diagonal(int from, int to, int offset, double z)
{
  std::vector<Vec3> points;
  for (int i = from; i <= to; ++i)
  {
    points.emplace_back(i, i + offset, z);
  }
  return points;
}
}

TEST(HexLocalPadding, FeaturesOfThePaddedMeshAreThoseOfTheInterface)
{
  const Setting setting({ 3, 3, 3 });
  const MappingShape& shape = setting.Shape;
  for (std::size_t c = 0; c < 8; ++c)
  {
    EXPECT_EQ(setting.Global.Mesh.Points[setting.Before.CornerVertices[c]],
      shape.Mesh.Points[shape.Mapping.Features.CornerVertices[c]]);
  }
  const QuadGraph graph = GraphOf(setting.Global.Mesh);
  for (std::size_t c = 0; c < 12; ++c)
  {
    const std::vector<Index>& path = setting.Before.CurvePaths[c];
    ASSERT_EQ(path.size(), 4u);
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      EXPECT_GE(graph.Find(path[i - 1], path[i]), 0);
    }
  }
  std::map<int, int> counts;
  for (std::size_t q = 0; q < graph.Quads().size(); ++q)
  {
    Vec3 center = Vec3::Zero();
    for (Index v : graph.Quads()[q])
    {
      center += 0.25 * setting.Global.Mesh.Points[v];
    }
    const int patch = setting.Before.PatchOfQuad[q];
    ++counts[patch];
    EXPECT_LT(shape.Geometry->Patch(patch).Search().Closest(center).Distance, 1e-12);
  }
  EXPECT_EQ(counts.size(), 6u);
}

TEST(HexLocalPadding, CubeOnItsOwnGridNeedsNone)
{
  const Setting setting({ 3, 3, 3 });
  EXPECT_EQ(setting.Report.DegenerateQuads, 0);
  EXPECT_EQ(setting.Report.Regions, 0);
  EXPECT_EQ(setting.Report.AddedHexes, 0);
  EXPECT_EQ(setting.Padded.Mesh.Hexes, setting.Global.Mesh.Hexes);
  EXPECT_EQ(setting.Features.CurvePaths, setting.Before.CurvePaths);
}

TEST(HexLocalPadding, StaircaseGetsTwoQuadsOnEachSide)
{
  const Setting setting({ 6, 6, 2 }, { Diagonal(0, 5, 1, 2) });
  const Index curve = setting.Shape.CurveThrough({ 2, 3, 2 });
  const auto before = SidesOf(setting.Global.Mesh, setting.Before.CurvePaths[curve]);
  ASSERT_EQ(before.size(), 9u);
  int bends = 0;
  for (const auto& [left, right] : before)
  {
    bends += std::min(left, right) == 1;
  }
  EXPECT_GE(bends, 4);
  EXPECT_GE(setting.Report.DegenerateQuads, bends);
  EXPECT_GE(setting.Report.Regions, 2); // both sides
  EXPECT_EQ(setting.Report.AddedHexes,
    static_cast<Index>(setting.Padded.Mesh.Hexes.size() - setting.Global.Mesh.Hexes.size()));
  EXPECT_GT(setting.Report.AddedHexes, 0);
  ExpectSound(setting.Padded);
  ExpectSameFeatures(setting);
  for (std::size_t c = 0; c < setting.Features.CurvePaths.size(); ++c)
  {
    ExpectOpened(setting, static_cast<Index>(c), 0);
  }
}

TEST(HexLocalPadding, DanglingStaircase)
{
  const Setting setting({ 8, 8, 2 }, { Diagonal(2, 6, 0, 2) });
  ASSERT_EQ(setting.Shape.Graph.NumberOfPatches, 6);
  EXPECT_GT(setting.Report.DegenerateQuads, 0);
  EXPECT_GT(setting.Report.AddedHexes, 0);
  ExpectSound(setting.Padded);
  ExpectSameFeatures(setting);
  // Away from its free ends it is as any other staircase.
  ExpectOpened(setting, setting.Shape.CurveThrough({ 4, 4, 2 }), 2);
}

TEST(HexLocalPadding, NarrowHorseshoe)
{
  std::vector<Vec3> horseshoe;
  for (int y = 7; y >= 2; --y)
  {
    horseshoe.emplace_back(3, y, 2);
  }
  for (int y = 2; y <= 7; ++y)
  {
    horseshoe.emplace_back(4, y, 2);
  }
  const Setting setting({ 8, 9, 2 }, { horseshoe }, 60.0);
  ExpectSound(setting.Padded);
  ExpectSameFeatures(setting);
}

TEST(HexLocalPadding, SameBitsEveryTime)
{
  const Setting first({ 5, 5, 2 }, { Diagonal(0, 4, 1, 2) });
  const Setting second({ 5, 5, 2 }, { Diagonal(0, 4, 1, 2) });
  EXPECT_EQ(first.Padded.Mesh.Hexes, second.Padded.Mesh.Hexes);
  EXPECT_EQ(first.Padded.Mesh.Points, second.Padded.Mesh.Points);
  EXPECT_EQ(first.Features.PatchOfQuad, second.Features.PatchOfQuad);
}

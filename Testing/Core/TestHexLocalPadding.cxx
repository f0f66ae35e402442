// SPDX-License-Identifier: BSD-3-Clause
#include "HexLocalPadding.h"

#include "MappingShapes.h"
#include "PaddingGroups.h"
#include "QuadGraph.h"

#include <gtest/gtest.h>

#include <random>

using namespace featurehex;

namespace
{
using Polylines = std::vector<std::vector<Vec3>>;

enum class Layers
{
  One,      ///< for all patches
  Crossing, ///< one for each group
  Needed    ///< one for each group that needs one
};

/// A box with features, mapped and padded all round, then where quads are degenerate.
struct Setting
{
  MappingShape Shape;
  std::vector<int> Groups;
  PaddedMesh Global, Padded;
  HexFeatures Before, Features;
  LocalPaddingReport Report;

  explicit Setting(const std::array<int, 3>& n, const Polylines& lines = {},
    Layers layers = Layers::One, double cornerAngle = 140.0)
    : Shape(n, lines, cornerAngle)
  {
    this->Shape.Map();
    EXPECT_TRUE(this->Shape.Mapping.Complete()) << this->Shape.Reasons();
    this->Groups = layers == Layers::One ? std::vector<int>(this->Shape.Graph.NumberOfPatches, 0)
                                         : GroupPatches(*this->Shape.Geometry);
    this->Before = this->Shape.Mapping.Features;
    PaddingOptions options;
    options.EveryGroup = layers != Layers::Needed;
    const Status status = PadInterface(this->Shape.Mesh,
      std::vector<int>(this->Shape.Mesh.Hexes.size(), 1), options, this->Global, &this->Before,
      layers == Layers::One ? nullptr : this->Shape.Geometry.get());
    EXPECT_TRUE(status.Ok()) << status.Message;
    this->Padded = this->Global;
    this->Features = this->Before;
    this->Report = PadDegenerateQuads(
      this->Padded, this->Features, *this->Shape.Geometry, LocalPaddingOptions());
  }

  /// The curve has one hex: the layers on its sides cross.
  bool OneHex(std::size_t curve) const
  {
    const FeatureCurve& sides = this->Shape.Graph.Curves[curve];
    return this->Groups[sides.LeftPatch] != this->Groups[sides.RightPatch];
  }
};

QuadGraph GraphOf(const HexMesh& mesh)
{
  return QuadGraph(ExtractBoundary(mesh).Quads, mesh.Points.size());
}

/// Conforming, manifold, no two hexes with two common faces, one boundary quad of each group a hex
/// at most.
void ExpectSound(const Setting& setting)
{
  const PaddedMesh& padded = setting.Padded;
  const HexTopology topology = AnalyzeHexMesh(padded.Mesh);
  EXPECT_TRUE(topology.Conforming());
  EXPECT_TRUE(topology.Surface.ClosedManifold());
  EXPECT_EQ(topology.OrphanPoints, 0);
  EXPECT_EQ(topology.Bodies, 1);
  const HexStars stars(padded.Mesh);
  std::map<Index, std::set<int>> groupsOfHex;
  for (std::size_t q = 0; q < stars.Quads.size(); ++q)
  {
    const int patch = setting.Features.PatchOfQuad[q];
    ASSERT_GE(patch, 0);
    EXPECT_TRUE(groupsOfHex[stars.QuadOwners[q]].insert(setting.Groups[patch]).second)
      << "hex " << stars.QuadOwners[q];
  }
  const std::vector<std::array<Index, 6>> neighbors = FaceNeighbors(
    padded.Mesh.Hexes, CellsOfVertices(padded.Mesh.Hexes, padded.Mesh.Points.size()));
  for (std::size_t h = 0; h < neighbors.size(); ++h)
  {
    std::array<Index, 6> sorted = neighbors[h];
    std::sort(sorted.begin(), sorted.end());
    for (int i = 1; i < 6; ++i)
    {
      EXPECT_TRUE(sorted[i] < 0 || sorted[i] != sorted[i - 1]) << "hex " << h;
    }
  }
  const std::size_t hexes = padded.Mesh.Hexes.size();
  EXPECT_EQ(padded.Region.size(), hexes);
  EXPECT_EQ(padded.IsLayer.size(), hexes);
  EXPECT_EQ(padded.SourceHex.size(), hexes);
  EXPECT_EQ(padded.SourcePoint.size(), padded.Mesh.Points.size());
  EXPECT_EQ(padded.OnBoundary.size(), padded.Mesh.Points.size());
  for (std::size_t v = 0; v < padded.Mesh.Points.size(); ++v)
  {
    EXPECT_EQ(padded.OnBoundary[v] != 0, stars.OnBoundary(static_cast<Index>(v)));
  }
}

/// The same points in the same order. More, between them, only where the rim of a group crosses the
/// curve: anywhere on one with one hex, else only at a crease where it ends.
void ExpectPathExtends(const Setting& setting, std::size_t c)
{
  const std::vector<Index>& path = setting.Features.CurvePaths[c];
  const std::vector<Index>& before = setting.Before.CurvePaths[c];
  ASSERT_GE(path.size(), before.size());
  EXPECT_EQ(setting.Padded.Mesh.Points[path.front()], setting.Global.Mesh.Points[before.front()]);
  EXPECT_EQ(setting.Padded.Mesh.Points[path.back()], setting.Global.Mesh.Points[before.back()]);
  EXPECT_EQ(std::set<Index>(path.begin(), path.end()).size(), path.size()) << "curve " << c;
  std::size_t found = 0;
  int between = 0;
  for (Index v : path)
  {
    if (found < before.size() &&
      setting.Padded.Mesh.Points[v] == setting.Global.Mesh.Points[before[found]])
    {
      EXPECT_LE(between, 2) << "curve " << c; // a crossing at each end of the edge
      EXPECT_TRUE(between == 0 || setting.OneHex(c) || found == 1 || found + 1 == before.size())
        << "curve " << c;
      ++found;
      between = 0;
    }
    else
    {
      ++between;
    }
  }
  EXPECT_EQ(found, before.size()) << "curve " << c;
}

/// Paths are chains of boundary edges through the same points as before, and part the same patches;
/// what had one hex has one.
void ExpectSameFeatures(const Setting& setting)
{
  const HexStars stars(setting.Padded.Mesh);
  const QuadGraph graph(stars.Quads, setting.Padded.Mesh.Points.size());
  std::vector<bool> wall(graph.NumberOfDarts(), false);
  ASSERT_EQ(setting.Features.PatchOfQuad.size(), graph.Quads().size());
  ASSERT_EQ(setting.Features.CurvePaths.size(), setting.Before.CurvePaths.size());
  for (std::size_t c = 0; c < setting.Features.CurvePaths.size(); ++c)
  {
    ExpectPathExtends(setting, c);
    const std::vector<Index>& path = setting.Features.CurvePaths[c];
    const FeatureCurve& curve = setting.Shape.Graph.Curves[c];
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      const Index dart = graph.Find(path[i - 1], path[i]);
      ASSERT_GE(dart, 0) << "curve " << c;
      const Index opposite = graph.Opposite(dart);
      EXPECT_FALSE(wall[dart]) << "curve " << c;
      wall[dart] = wall[opposite] = true;
      EXPECT_EQ(setting.Features.PatchOfQuad[dart / 4], curve.LeftPatch) << "curve " << c;
      EXPECT_EQ(setting.Features.PatchOfQuad[opposite / 4], curve.RightPatch) << "curve " << c;
      EXPECT_EQ(stars.QuadOwners[dart / 4] == stars.QuadOwners[opposite / 4], setting.OneHex(c))
        << "curve " << c << ", edge " << i;
    }
  }
  ASSERT_EQ(setting.Features.CornerVertices.size(), setting.Shape.Graph.Corners.size());
  for (std::size_t c = 0; c < setting.Features.CornerVertices.size(); ++c)
  {
    EXPECT_EQ(setting.Padded.Mesh.Points[setting.Features.CornerVertices[c]],
      setting.Global.Mesh.Points[setting.Before.CornerVertices[c]]);
  }
  for (std::size_t c = 0; c < setting.Features.CurvePaths.size(); ++c)
  {
    const FeatureCurve& curve = setting.Shape.Graph.Curves[c];
    EXPECT_EQ(
      setting.Features.CurvePaths[c].front(), setting.Features.CornerVertices[curve.FirstCorner]);
    EXPECT_EQ(
      setting.Features.CurvePaths[c].back(), setting.Features.CornerVertices[curve.LastCorner]);
  }
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

/// Where a curve had one quad on a side, or three, it has two, and nowhere one. @a ends: so many
/// vertices at both ends aside.
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

std::vector<Vec3> Horseshoe()
{
  std::vector<Vec3> points;
  for (int y = 7; y >= 2; --y)
  {
    points.emplace_back(3, y, 2);
  }
  for (int y = 2; y <= 7; ++y)
  {
    points.emplace_back(4, y, 2);
  }
  return points;
}

/// Two quads on each side of each inner vertex of the curves where layers cross.
void ExpectRegularCreases(const Setting& setting)
{
  for (std::size_t c = 0; c < setting.Features.CurvePaths.size(); ++c)
  {
    if (setting.OneHex(c))
    {
      for (const auto& [left, right] : SidesOf(setting.Padded.Mesh, setting.Features.CurvePaths[c]))
      {
        EXPECT_EQ(left, 2) << "curve " << c;
        EXPECT_EQ(right, 2) << "curve " << c;
      }
    }
  }
}

/// Vertices that the rims of the groups added to creases with one hex.
std::size_t AddedVertices(const Setting& setting)
{
  std::size_t added = 0;
  for (std::size_t c = 0; c < setting.Features.CurvePaths.size(); ++c)
  {
    added += setting.Features.CurvePaths[c].size() - setting.Before.CurvePaths[c].size();
  }
  return added;
}

void ExpectSoundCrossing(const Setting& setting)
{
  ExpectSound(setting);
  ExpectSameFeatures(setting);
  ExpectRegularCreases(setting);
  EXPECT_EQ(setting.Report.AddedHexes,
    static_cast<Index>(setting.Padded.Mesh.Hexes.size() - setting.Global.Mesh.Hexes.size()));
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
  ExpectSound(setting);
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
  ExpectSound(setting);
  ExpectSameFeatures(setting);
  // Away from its free ends it is as any other staircase.
  ExpectOpened(setting, setting.Shape.CurveThrough({ 4, 4, 2 }), 2);
}

TEST(HexLocalPadding, NarrowHorseshoe)
{
  const Setting setting({ 8, 9, 2 }, { Horseshoe() }, Layers::One, 60.0);
  ExpectSound(setting);
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

TEST(HexLocalPadding, CrossingLayersOfACubeNeedNone)
{
  const Setting setting({ 3, 3, 3 }, {}, Layers::Crossing);
  ExpectSoundCrossing(setting);
  EXPECT_EQ(setting.Report.DegenerateQuads, 0);
  EXPECT_EQ(setting.Report.AddedHexes, 0);
  EXPECT_EQ(setting.Padded.Mesh.Hexes, setting.Global.Mesh.Hexes);
  EXPECT_EQ(setting.Features.CurvePaths, setting.Before.CurvePaths);
  EXPECT_EQ(setting.Features.PatchOfQuad, setting.Before.PatchOfQuad);
}

TEST(HexLocalPadding, StaircaseBetweenCreasesWithOneHex)
{
  for (int offset : { 1, 2, -1, -2 })
  {
    const Setting setting({ 6, 6, 2 },
      { Diagonal(std::max(0, -offset), std::min(6, 6 - offset), offset, 2) }, Layers::Crossing);
    SCOPED_TRACE(offset);
    ExpectSoundCrossing(setting);
    EXPECT_GE(setting.Report.DegenerateQuads, 4);
    EXPECT_EQ(setting.Report.Regions, 2); // both sides
    EXPECT_GT(setting.Report.AddedHexes, 0);
    EXPECT_EQ(AddedVertices(setting), 4u); // both regions reach the creases at both ends
    const Index curve = setting.Shape.CurveThrough({ 3, 3.0 + offset, 2 });
    EXPECT_FALSE(setting.OneHex(curve));
    ExpectOpened(setting, curve, 0);
    for (std::size_t c = 0; c < setting.Shape.Graph.Curves.size(); ++c)
    {
      EXPECT_EQ(setting.OneHex(c), static_cast<Index>(c) != curve);
    }
  }
}

TEST(HexLocalPadding, StaircaseFromCornerToCorner)
{
  // Four curves at each end: two of the box have two hexes.
  const Setting setting({ 6, 6, 3 }, { Diagonal(0, 6, 0, 3) }, Layers::Crossing);
  ASSERT_EQ(std::set<int>(setting.Groups.begin(), setting.Groups.end()).size(), 4u);
  ExpectSoundCrossing(setting);
  EXPECT_GT(setting.Report.AddedHexes, 0);
}

TEST(HexLocalPadding, DanglingStaircaseAmongCrossingLayers)
{
  const Setting setting({ 8, 8, 2 }, { Diagonal(2, 6, 0, 2) }, Layers::Crossing);
  ExpectSoundCrossing(setting);
  EXPECT_GT(setting.Report.DegenerateQuads, 0);
  EXPECT_EQ(AddedVertices(setting), 0u); // away from the creases
  ExpectOpened(setting, setting.Shape.CurveThrough({ 4, 4, 2 }), 2);
}

TEST(HexLocalPadding, NarrowHorseshoeAmongCrossingLayers)
{
  const Setting setting({ 8, 9, 2 }, { Horseshoe() }, Layers::Crossing, 60.0);
  ExpectSoundCrossing(setting);
  EXPECT_GT(setting.Report.AddedHexes, 0);
}

TEST(HexLocalPadding, RimOverTheEndOfACurveOfAnotherPatch)
{
  // The stairs on the right reach the upper edge where a curve of the top ends.
  const Polylines lines = { { { 4, 1, 2 }, { 4, 1, 3 }, { 4, 2, 3 }, { 4, 3, 3 }, { 4, 3, 4 } },
    { { 0, 2, 4 }, { 1, 2, 4 }, { 2, 2, 4 }, { 3, 2, 4 }, { 4, 2, 4 } } };
  const Setting setting({ 4, 4, 4 }, lines, Layers::Crossing, 60.0);
  EXPECT_GT(setting.Report.AddedHexes, 0);
  ExpectSoundCrossing(setting);
  const Index across = setting.Shape.CurveThrough({ 2, 2, 4 });
  EXPECT_FALSE(setting.OneHex(across));
  EXPECT_EQ(
    setting.Features.CurvePaths[across].size(), setting.Before.CurvePaths[across].size() + 1);
}

TEST(HexLocalPadding, StaircasesOnSeveralFaces)
{
  std::size_t added = 0;
  for (unsigned seed = 0; seed < 80; ++seed)
  {
    std::mt19937 random(seed); // whose numbers are the same everywhere
    const auto upTo = [&random](int n) { return static_cast<int>(random() % n); };
    const int n = 4 + upTo(3);
    Polylines lines;
    for (int count = 1 + upTo(3); count > 0; --count)
    {
      const int axis = upTo(3);
      const int side = upTo(2) * n;
      const int step = 2 * upTo(2) - 1; // up or down
      int u = upTo(2) * upTo(n), v = step > 0 ? upTo(n) : n - upTo(n);
      std::vector<Vec3> line;
      while (line.size() < 12 && u <= n && v >= 0 && v <= n)
      {
        Vec3 p;
        p[axis] = side;
        p[(axis + 1) % 3] = u;
        p[(axis + 2) % 3] = v;
        line.push_back(p);
        (upTo(2) ? u += 1 : v += step);
      }
      lines.push_back(line);
    }
    SCOPED_TRACE(seed);
    const Setting setting({ n, n, n }, lines, Layers::Crossing, 60.0);
    ExpectSoundCrossing(setting);
    added += AddedVertices(setting);
    ExpectSoundCrossing(Setting({ n, n, n }, lines, Layers::Needed, 60.0));
  }
  EXPECT_GT(added, 80u); // many rims cross creases
}

TEST(HexLocalPadding, CrossingLayersHaveTheSameBitsEveryTime)
{
  const Setting first({ 5, 5, 2 }, { Diagonal(0, 4, 1, 2) }, Layers::Crossing);
  const Setting second({ 5, 5, 2 }, { Diagonal(0, 4, 1, 2) }, Layers::Crossing);
  EXPECT_EQ(first.Padded.Mesh.Hexes, second.Padded.Mesh.Hexes);
  EXPECT_EQ(first.Padded.Mesh.Points, second.Padded.Mesh.Points);
  EXPECT_EQ(first.Features.CurvePaths, second.Features.CurvePaths);
  EXPECT_EQ(first.Features.PatchOfQuad, second.Features.PatchOfQuad);
}

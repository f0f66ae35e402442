// SPDX-License-Identifier: BSD-3-Clause
#include "HexPadding.h"

#include "HexUntangling.h"
#include "LatticeBody.h"
#include "QuadGraph.h"

#include <algorithm>
#include <numeric>
#include <set>

using namespace featurehex;

namespace
{
using Body = LatticeBody;

/// A body with layers, and what of it must hold for any body and any groups.
struct Layers
{
  const Body& Source;
  std::vector<int> Groups;
  std::set<int> Layered; ///< groups that have a layer
  PaddedMesh Result;
  HexFeatures Features;

  /// @a layered: the groups that need a layer and get one; empty: all get one.
  Layers(const Body& body, const FeatureGeometry* geometry, const std::set<int>& layered = {})
    : Source(body)
    , Groups(geometry ? GroupPatches(*geometry) : std::vector<int>(body.Graph.NumberOfPatches, 0))
    , Layered(layered)
    , Features(body.Features)
  {
    PaddingOptions options;
    if (layered.empty())
    {
      options.EveryGroup = true;
      this->Layered.insert(this->Groups.begin(), this->Groups.end());
    }
    const Status status =
      PadInterface(body.Mesh, body.Region, options, this->Result, &this->Features, geometry);
    EXPECT_TRUE(status.Ok()) << status.Message;
  }
  explicit Layers(const Body& body)
    : Layers(body, body.Geometry.get())
  {
  }

  const Vec3& At(Index v) const { return this->Result.Mesh.Points[v]; }

  int HexesOfEdge(const HexStars& stars, Index a, Index b) const
  {
    int count = 0;
    for (Index h : stars.Hexes[a])
    {
      const Hex& hex = this->Result.Mesh.Hexes[h];
      count += std::find(hex.begin(), hex.end(), b) != hex.end();
    }
    return count;
  }

  void ExpectMesh() const
  {
    const HexMesh& mesh = this->Result.Mesh;
    const HexTopology topology = AnalyzeHexMesh(mesh);
    EXPECT_TRUE(topology.Conforming());
    EXPECT_TRUE(topology.Surface.ClosedManifold());
    EXPECT_EQ(topology.OrphanPoints, 0);
    EXPECT_EQ(topology.DuplicatePoints, 0);
    EXPECT_EQ(topology.Bodies, 1);
    EXPECT_EQ(topology.Surface.Genus, std::vector<Index>{ 0 });
    ASSERT_EQ(this->Result.SourceHex.size(), mesh.Hexes.size());
    ASSERT_EQ(this->Result.SourcePoint.size(), mesh.Points.size());
    ASSERT_EQ(this->Result.OnBoundary.size(), mesh.Points.size());
    std::vector<Index> layer;
    std::set<Index> cores;
    for (std::size_t h = 0; h < mesh.Hexes.size(); ++h)
    {
      EXPECT_EQ(this->Result.Region[h], 3);
      EXPECT_EQ(this->Source.Region[this->Result.SourceHex[h]], 3);
      if (this->Result.IsLayer[h])
      {
        layer.push_back(static_cast<Index>(h));
      }
      else
      {
        EXPECT_TRUE(cores.insert(this->Result.SourceHex[h]).second);
      }
    }
    EXPECT_EQ(this->Result.LayerHexes, layer);
    EXPECT_EQ(static_cast<std::ptrdiff_t>(cores.size()),
      std::count(this->Source.Region.begin(), this->Source.Region.end(), 3));
    EXPECT_EQ(mesh.Hexes.size(), cores.size() + this->ExpectedLayerHexes());
    const HexStars stars(mesh);
    for (std::size_t v = 0; v < mesh.Points.size(); ++v)
    {
      EXPECT_EQ(this->Result.OnBoundary[v] != 0, stars.OnBoundary(static_cast<Index>(v)));
    }
  }

  /// One for each quad of the interface in a group with a layer, each of its edges where two such
  /// groups meet, each vertex where three do.
  std::size_t ExpectedLayerHexes() const
  {
    const std::vector<InterfaceQuad> quads =
      InterfaceQuads(this->Source.Mesh, HexGraph(this->Source.Mesh).Neighbors, this->Source.Region);
    std::map<PointPair, std::set<int>> ofEdge;
    std::map<Index, std::set<int>> ofPoint;
    std::size_t count = 0;
    for (std::size_t q = 0; q < quads.size(); ++q)
    {
      const int group = this->Groups[this->Source.Features.PatchOfQuad[q]];
      if (this->Layered.count(group) == 0)
      {
        continue;
      }
      ++count;
      for (int k = 0; k < 4; ++k)
      {
        const Index a = quads[q].Vertices[k], b = quads[q].Vertices[(k + 1) & 3];
        ofEdge[{ std::min(a, b), std::max(a, b) }].insert(group);
        ofPoint[a].insert(group);
      }
    }
    for (const auto& [edge, groups] : ofEdge)
    {
      count += groups.size() == 2;
    }
    for (const auto& [point, groups] : ofPoint)
    {
      EXPECT_LE(groups.size(), 3u);
      count += groups.size() == 3;
    }
    return count;
  }

  /// Quads of a hex on the boundary belong to different groups; those of a layer's group are its
  /// hexes' alone.
  void ExpectOwners() const
  {
    const HexStars stars(this->Result.Mesh);
    ASSERT_EQ(this->Features.PatchOfQuad.size(), stars.Quads.size());
    std::map<Index, std::set<int>> groupsOfHex;
    for (std::size_t q = 0; q < stars.Quads.size(); ++q)
    {
      const int patch = this->Features.PatchOfQuad[q];
      ASSERT_GE(patch, 0);
      EXPECT_TRUE(this->Result.IsLayer[stars.QuadOwners[q]] ||
        this->Layered.count(this->Groups[patch]) == 0);
      EXPECT_TRUE(groupsOfHex[stars.QuadOwners[q]].insert(this->Groups[patch]).second);
    }
  }

  /// Corners, chains between them that part the right patches, no other borders. One hex where
  /// groups meet, else two.
  void ExpectFeatures() const
  {
    const HexStars stars(this->Result.Mesh);
    const QuadGraph graph(stars.Quads, this->Result.Mesh.Points.size());
    const SurfaceFeatures& wanted = this->Source.Graph;
    ASSERT_EQ(this->Features.CornerVertices.size(), wanted.Corners.size());
    for (std::size_t c = 0; c < wanted.Corners.size(); ++c)
    {
      const Index v = this->Features.CornerVertices[c];
      ASSERT_GE(v, 0);
      EXPECT_EQ(this->Result.SourcePoint[v], this->Source.Features.CornerVertices[c]);
      EXPECT_EQ(this->At(v), this->Source.Mesh.Points[this->Result.SourcePoint[v]]);
    }
    ASSERT_EQ(this->Features.CurvePaths.size(), wanted.Curves.size());
    std::vector<char> onPath(graph.NumberOfDarts(), 0);
    for (std::size_t c = 0; c < wanted.Curves.size(); ++c)
    {
      const std::vector<Index>& path = this->Features.CurvePaths[c];
      const FeatureCurve& curve = wanted.Curves[c];
      if (this->Source.Geometry->Curves()[c].Points.empty())
      {
        EXPECT_TRUE(path.empty()); // given up
        continue;
      }
      ASSERT_GT(path.size(), 1u);
      EXPECT_EQ(path.front(), this->Features.CornerVertices[curve.FirstCorner]);
      EXPECT_EQ(path.back(), this->Features.CornerVertices[curve.LastCorner]);
      EXPECT_EQ(std::set<Index>(path.begin(), path.end()).size(), path.size());
      const bool apart = this->Groups[curve.LeftPatch] != this->Groups[curve.RightPatch];
      for (std::size_t i = 1; i < path.size(); ++i)
      {
        const Index dart = graph.Find(path[i - 1], path[i]);
        ASSERT_GE(dart, 0) << "curve " << c << ", edge " << i;
        const Index opposite = graph.Opposite(dart);
        onPath[dart] = onPath[opposite] = 1;
        EXPECT_EQ(this->Features.PatchOfQuad[dart / 4], curve.LeftPatch);
        EXPECT_EQ(this->Features.PatchOfQuad[opposite / 4], curve.RightPatch);
        EXPECT_EQ(stars.QuadOwners[dart / 4] == stars.QuadOwners[opposite / 4], apart);
        EXPECT_EQ(this->HexesOfEdge(stars, path[i - 1], path[i]), apart ? 1 : 2);
      }
    }
    for (Index d = 0; d < graph.NumberOfDarts(); ++d)
    {
      if (!onPath[d])
      {
        const FeatureGeometry& geometry = *this->Source.Geometry;
        EXPECT_EQ(geometry.PatchOf(this->Features.PatchOfQuad[d / 4]),
          geometry.PatchOf(this->Features.PatchOfQuad[graph.Opposite(d) / 4]));
        EXPECT_GE(this->HexesOfEdge(stars, graph.Tail(d), graph.Head(d)), 2);
      }
    }
  }

  /// For patches where the interface is: nothing moves off them, or further than three layers.
  void ExpectPlaces() const
  {
    EXPECT_TRUE(InvertedHexes(this->Result.Mesh).empty());
    for (std::size_t v = 0; v < this->Result.Mesh.Points.size(); ++v)
    {
      const double moved =
        (this->At(static_cast<Index>(v)) - this->Source.Mesh.Points[this->Result.SourcePoint[v]])
          .norm();
      EXPECT_LT(moved, 0.1 * std::sqrt(3.0) + 1e-12);
    }
    const HexStars stars(this->Result.Mesh);
    for (std::size_t q = 0; q < stars.Quads.size(); ++q)
    {
      const SurfaceGeometry& patch = this->Source.Geometry->Patch(this->Features.PatchOfQuad[q]);
      for (Index v : stars.Quads[q])
      {
        EXPECT_LT(patch.Search().Closest(this->At(v)).Distance, 1e-12);
      }
    }
    const FeatureValidationReport report = ValidateFeatures(this->Result.Mesh,
      ExtractBoundary(this->Result.Mesh), this->Source.Surface,
      { &this->Source.Graph, &this->Features }, 1e-9);
    EXPECT_TRUE(report.AllCaptured()) << report.Complaint();
  }

  void ExpectAll() const
  {
    this->ExpectMesh();
    this->ExpectOwners();
    this->ExpectFeatures();
    this->ExpectPlaces();
  }

  int HexesOfCorner(const Vec3& p) const
  {
    for (std::size_t c = 0; c < this->Source.Graph.Corners.size(); ++c)
    {
      if (this->Source.Geometry->CornerPoint(static_cast<Index>(c)) == p)
      {
        return HexStars(this->Result.Mesh).Hexes[this->Features.CornerVertices[c]].size();
      }
    }
    ADD_FAILURE() << "no corner at " << p.transpose();
    return 0;
  }

  /// Hexes by their points, whatever the ids.
  std::set<std::vector<std::array<long, 3>>> HexesInSpace() const
  {
    std::set<std::vector<std::array<long, 3>>> hexes;
    for (const Hex& hex : this->Result.Mesh.Hexes)
    {
      std::vector<std::array<long, 3>> points;
      for (Index v : hex)
      {
        const Vec3 p = 1e6 * this->At(v);
        points.push_back({ std::lround(p[0]), std::lround(p[1]), std::lround(p[2]) });
      }
      std::sort(points.begin(), points.end());
      hexes.insert(points);
    }
    EXPECT_EQ(hexes.size(), this->Result.Mesh.Hexes.size());
    return hexes;
  }
};

void ExpectSameMesh(const PaddedMesh& a, const PaddedMesh& b)
{
  EXPECT_EQ(a.Mesh.Points, b.Mesh.Points);
  EXPECT_EQ(a.Mesh.Hexes, b.Mesh.Hexes);
  EXPECT_EQ(a.Region, b.Region);
  EXPECT_EQ(a.IsLayer, b.IsLayer);
  EXPECT_EQ(a.LayerHexes, b.LayerHexes);
  EXPECT_EQ(a.SourceHex, b.SourceHex);
  EXPECT_EQ(a.SourcePoint, b.SourcePoint);
  EXPECT_EQ(a.OnBoundary, b.OnBoundary);
}

void ExpectSameFeatures(const HexFeatures& a, const HexFeatures& b)
{
  EXPECT_EQ(a.CornerVertices, b.CornerVertices);
  EXPECT_EQ(a.CurvePaths, b.CurvePaths);
  EXPECT_EQ(a.PatchOfQuad, b.PatchOfQuad);
}
}

TEST(HexPaddingGroups, LayersOfABoxCross)
{
  for (const std::array<int, 3>& n :
    { std::array<int, 3>{ 4, 3, 2 }, std::array<int, 3>{ 1, 1, 1 }, std::array<int, 3>{ 5, 1, 2 } })
  {
    const Body box = BoxBody(n);
    ASSERT_EQ(std::set<int>(box.Groups.begin(), box.Groups.end()).size(), 6u);
    const Layers layers(box);
    layers.ExpectAll();
    const std::size_t hexes = (n[0] + 2) * (n[1] + 2) * (n[2] + 2);
    EXPECT_EQ(layers.Result.Mesh.Hexes.size(), hexes);
    EXPECT_EQ(layers.Result.LayerHexes.size(), hexes - n[0] * n[1] * n[2]);

    // A grid with planes at 0, 0.1, 1, 2 ... n - 1, n - 0.1, n.
    std::array<std::set<long>, 3> planes;
    for (const Vec3& p : layers.Result.Mesh.Points)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        planes[axis].insert(std::lround(1e9 * p[axis]));
      }
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      std::set<long> wanted = { 0, 100000000, n[axis] * 1000000000L - 100000000,
        n[axis] * 1000000000L };
      for (long i = 1; i < n[axis]; ++i)
      {
        wanted.insert(i * 1000000000L);
      }
      EXPECT_EQ(planes[axis], wanted);
    }
    EXPECT_EQ(layers.Result.Mesh.Points.size(),
      planes[0].size() * planes[1].size() * planes[2].size());

    // At each corner one hex with three quads, one more vertex at each end of each curve.
    for (int i = 0; i < 8; ++i)
    {
      const Vec3 p(i & 1 ? n[0] : 0, i & 2 ? n[1] : 0, i & 4 ? n[2] : 0);
      EXPECT_EQ(layers.HexesOfCorner(p), 1);
    }
    for (std::size_t c = 0; c < 12; ++c)
    {
      EXPECT_EQ(layers.Features.CurvePaths[c].size(), box.Features.CurvePaths[c].size() + 2);
    }
    std::map<int, std::size_t> quads;
    for (int patch : layers.Features.PatchOfQuad)
    {
      ++quads[patch];
    }
    std::multiset<std::size_t> areas;
    for (const auto& [patch, count] : quads)
    {
      areas.insert(count);
    }
    std::multiset<std::size_t> wanted;
    for (int axis = 0; axis < 3; ++axis)
    {
      const std::size_t area = (n[(axis + 1) % 3] + 2) * (n[(axis + 2) % 3] + 2);
      wanted.insert({ area, area });
    }
    EXPECT_EQ(areas, wanted);
  }
}

TEST(HexPaddingGroups, OrderOfTheLayersChangesNothing)
{
  for (Body& body : std::array<Body, 3>{ BoxBody({ 3, 2, 2 }), AngleBody(),
         BoxBody({ 3, 3, 2 }, { { 1, 0, 2 }, { 1, 1, 2 }, { 1, 2, 2 }, { 1, 3, 2 } }) })
  {
    const Layers layers(body);
    const auto hexes = layers.HexesInSpace();
    const int count = body.Graph.NumberOfPatches;
    // Of each patch; with a swap, so that not only the first one changes.
    std::vector<int> next(count);
    for (int turn = 0; turn < 3 * count; ++turn)
    {
      for (int patch = 0; patch < count; ++patch)
      {
        next[patch] = (patch + 1) % count;
      }
      std::swap(next[turn % count], next[turn * turn % count]);
      body.RenumberPatches(next);
      const Layers other(body);
      other.ExpectAll();
      EXPECT_EQ(other.HexesInSpace(), hexes);
      for (std::size_t c = 0; c < layers.Features.CurvePaths.size(); ++c)
      {
        EXPECT_EQ(other.Features.CurvePaths[c].size(), layers.Features.CurvePaths[c].size());
      }
    }
  }
}

TEST(HexPaddingGroups, ConcaveEdgeHasTwoHexesTheOthersHaveOne)
{
  const Body body = AngleBody();
  ASSERT_EQ(body.Graph.NumberOfPatches, 8);
  ASSERT_EQ(std::set<int>(body.Groups.begin(), body.Groups.end()).size(), 7u);
  const Layers layers(body);
  layers.ExpectAll();
  // In each slice 19 cubes, and one for each of 20 sides and each of the 5 convex corners.
  EXPECT_EQ(layers.Result.Mesh.Hexes.size(), (19u + 20u + 5u) * (3u + 2u));

  const Index concave = body.CurveThrough({ 2, 3, 1 });
  const HexStars stars(layers.Result.Mesh);
  const std::vector<Index>& path = layers.Features.CurvePaths[concave];
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    EXPECT_EQ(layers.HexesOfEdge(stars, path[i - 1], path[i]), 2);
  }
  // It ends at two other groups: their layers add an edge.
  ASSERT_EQ(path.size(), body.Features.CurvePaths[concave].size() + 2);
  EXPECT_EQ(layers.HexesOfCorner({ 2, 3, 0 }), 2);
  EXPECT_EQ(layers.HexesOfCorner({ 2, 3, 3 }), 2);
  EXPECT_EQ(layers.HexesOfCorner({ 0, 0, 0 }), 1);
  const std::size_t last = path.size() - 1;
  const double up = layers.At(path[last])[2] - layers.At(path[0])[2] > 0 ? 1 : -1;
  for (int k = 0; k < 3; ++k)
  {
    const double along = k == 2 ? 0.1 * up : 0.0;
    EXPECT_NEAR(layers.At(path[1])[k] - layers.At(path[0])[k], along, 1e-12);
    EXPECT_NEAR(layers.At(path[last])[k] - layers.At(path[last - 1])[k], along, 1e-12);
  }
  EXPECT_EQ(layers.Result.SourcePoint[path[1]], layers.Result.SourcePoint[path[0]]);
  EXPECT_EQ(layers.Result.SourcePoint[path[last]], layers.Result.SourcePoint[path[last - 1]]);
}

TEST(HexPaddingGroups, ConvexEdgeInsideAGroupHasTwoHexes)
{
  // Two sides of the top meet two of the body at the ends of its diagonal: the latter share a
  // group.
  const Body box = BoxBody({ 3, 3, 2 }, { { 0, 0, 2 }, { 1, 1, 2 }, { 2, 2, 2 }, { 3, 3, 2 } });
  ASSERT_EQ(box.Graph.NumberOfPatches, 7);
  ASSERT_EQ(std::set<int>(box.Groups.begin(), box.Groups.end()).size(), 4u);
  const Layers layers(box);
  layers.ExpectMesh();
  layers.ExpectOwners();
  layers.ExpectFeatures();
  for (double x : { 0.0, 3.0 })
  {
    EXPECT_EQ(layers.HexesOfCorner({ x, x, 2 }), 2);
    EXPECT_EQ(layers.HexesOfCorner({ x, x, 0 }), 2);
    EXPECT_EQ(layers.HexesOfCorner({ x, 3 - x, 2 }), 1);
    EXPECT_EQ(layers.HexesOfCorner({ x, 3 - x, 0 }), 1);
    // Both ends are at layers of other groups.
    for (double y : { 0.0, 3.0 })
    {
      const Index upright = box.CurveThrough({ x, y, 1 });
      EXPECT_EQ(
        layers.Features.CurvePaths[upright].size(), box.Features.CurvePaths[upright].size() + 2);
    }
  }
  const Index diagonal = box.CurveThrough({ 1, 1, 2 });
  EXPECT_EQ(
    layers.Features.CurvePaths[diagonal].size(), box.Features.CurvePaths[diagonal].size() + 2);
  // At one end alone: at the other its own groups meet.
  const Index edge = box.CurveThrough({ 1, 0, 2 });
  EXPECT_EQ(layers.Features.CurvePaths[edge].size(), box.Features.CurvePaths[edge].size() + 1);
}

TEST(HexPaddingGroups, GivenUpCurveHasTwoHexes)
{
  Body box = BoxBody({ 4, 3, 3 });
  GivenUpFeatures givenUp;
  givenUp.Curves = { box.CurveThrough({ 1, 0, 3 }) };
  box.Map(givenUp);
  ASSERT_EQ(std::set<int>(box.Groups.begin(), box.Groups.end()).size(), 5u);
  const Layers layers(box);
  layers.ExpectMesh();
  layers.ExpectOwners();
  layers.ExpectFeatures();
  EXPECT_TRUE(InvertedHexes(layers.Result.Mesh).empty());
  EXPECT_EQ(layers.HexesOfCorner({ 0, 0, 3 }), 2);
  EXPECT_EQ(layers.HexesOfCorner({ 4, 0, 3 }), 2);
  EXPECT_EQ(layers.HexesOfCorner({ 0, 0, 0 }), 1);
}

TEST(HexPaddingGroups, CurveInsideAGroupThatCrossesTheLayerOfAnother)
{
  // Across the top of a box, from the middle of an edge to that of the other.
  const Body box = BoxBody({ 4, 3, 2 }, { { 2, 0, 2 }, { 2, 1, 2 }, { 2, 2, 2 }, { 2, 3, 2 } });
  ASSERT_EQ(box.Graph.NumberOfPatches, 7);
  ASSERT_EQ(std::set<int>(box.Groups.begin(), box.Groups.end()).size(), 6u);
  const Layers layers(box);
  layers.ExpectAll();
  EXPECT_EQ(layers.Result.Mesh.Hexes.size(), 6u * 5u * 4u);
  const Index across = box.CurveThrough({ 2, 1, 2 });
  EXPECT_EQ(layers.Features.CurvePaths[across].size(), 6u);
  EXPECT_EQ(layers.HexesOfCorner({ 2, 0, 2 }), 2);
}

TEST(HexPaddingGroups, BoxOnItsGridGetsNoLayer)
{
  const Body box = BoxBody({ 4, 3, 2 });
  PaddedMesh padded;
  HexFeatures features = box.Features;
  const Status status = PadInterface(
    box.Mesh, box.Region, PaddingOptions(), padded, &features, box.Geometry.get());
  ASSERT_TRUE(status.Ok()) << status.Message;
  EXPECT_EQ(padded.Mesh.Hexes.size(), 4u * 3u * 2u);
  EXPECT_EQ(padded.Mesh.Points.size(), 5u * 4u * 3u);
  EXPECT_TRUE(padded.LayerHexes.empty());
  const HexTopology topology = AnalyzeHexMesh(padded.Mesh);
  EXPECT_TRUE(topology.Conforming());
  const FeatureValidationReport report = ValidateFeatures(
    padded.Mesh, topology.Boundary, box.Surface, { &box.Graph, &features }, 1e-9);
  EXPECT_TRUE(report.AllCaptured()) << report.Complaint();
}

TEST(HexPaddingGroups, OneLayerAmongGroupsWithoutAny)
{
  const Body body = StairBody();
  const int top = body.PatchAt({ 2, 2, 3 }, Vec3::UnitZ());
  const Layers layers(body, body.Geometry.get(), { body.Groups[top] });
  layers.ExpectMesh();
  layers.ExpectOwners();
  layers.ExpectFeatures();
  EXPECT_EQ(layers.Result.LayerHexes.size(), 4u * 4u + 4u); // with the riser
  for (Index h : layers.Result.LayerHexes)
  {
    EXPECT_EQ(body.Region[layers.Result.SourceHex[h]], 3);
  }
  // Upright curves get a vertex where the layer ends on both sides of them, others get none.
  for (std::size_t c = 0; c < body.Graph.Curves.size(); ++c)
  {
    const FeatureCurve& curve = body.Graph.Curves[c];
    const Vec3 along = body.Surface.Points[curve.Points[1]] - body.Surface.Points[curve.Points[0]];
    EXPECT_EQ(layers.Features.CurvePaths[c].size(),
      body.Features.CurvePaths[c].size() + (along.z() != 0 ? 1 : 0))
      << "curve " << c;
  }
}

TEST(HexPaddingGroups, LayersOfTwoGroupsCrossAmongOthersWithoutAny)
{
  // Stairs in the top and in the side at x = 4, which meet along an edge.
  Body box = BoxBody({ 4, 4, 4 });
  const Body body({ 4, 4, 4 },
    [](int i, int j, int k) { return (j >= 2 || k < 3) && (j < 2 || i < 3); },
    std::move(box.Surface), std::move(box.Graph));
  const int top = body.PatchAt({ 2, 2, 4 }, Vec3::UnitZ());
  const int side = body.PatchAt({ 4, 2, 2 }, Vec3::UnitX());
  const Layers layers(body, body.Geometry.get(), { body.Groups[top], body.Groups[side] });
  layers.ExpectMesh();
  layers.ExpectOwners();
  layers.ExpectFeatures();
}

TEST(HexPaddingGroups, LoopsKeepTheirVertices)
{
  const FeatureShape cylinder = CylinderWithFeatures(4);
  const FeatureGeometry geometry(cylinder.Surface, cylinder.Graph, 0.1);
  HexFeatures features = cylinder.Features;
  PaddedMesh padded;
  PaddingOptions options;
  options.EveryGroup = true;
  ASSERT_TRUE(PadInterface(
    cylinder.Mesh, std::vector<int>(64, 1), options, padded, &features, &geometry)
                .Ok());
  EXPECT_EQ(padded.Mesh.Hexes.size(), (16u + 16u) * (4u + 2u));
  EXPECT_TRUE(InvertedHexes(padded.Mesh).empty());
  const HexTopology topology = AnalyzeHexMesh(padded.Mesh);
  EXPECT_TRUE(topology.Conforming());
  EXPECT_TRUE(topology.Surface.ClosedManifold());
  const HexStars stars(padded.Mesh);
  const QuadGraph graph(stars.Quads, padded.Mesh.Points.size());
  ASSERT_EQ(features.CurvePaths.size(), 2u);
  for (std::size_t c = 0; c < 2; ++c)
  {
    const std::vector<Index>& path = features.CurvePaths[c];
    ASSERT_EQ(path.size(), 17u);
    EXPECT_EQ(path.front(), path.back());
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      EXPECT_EQ(padded.SourcePoint[path[i]], cylinder.Features.CurvePaths[c][i]);
      const Index dart = graph.Find(path[i - 1], path[i]);
      ASSERT_GE(dart, 0);
      EXPECT_EQ(stars.QuadOwners[dart / 4], stars.QuadOwners[graph.Opposite(dart) / 4]);
    }
  }
  const FeatureValidationReport report = ValidateFeatures(padded.Mesh, topology.Boundary,
    cylinder.Surface, { &cylinder.Graph, &features }, 0.01);
  EXPECT_TRUE(report.AllCaptured()) << report.Complaint();
}

TEST(HexPaddingGroups, WithoutGeometryOneLayer)
{
  for (const Body& body : std::array<Body, 2>{ BoxBody({ 3, 2, 2 }), AngleBody() })
  {
    PaddedMesh plain;
    ASSERT_TRUE(PadInterface(body.Mesh, body.Region, PaddingOptions(), plain).Ok());
    const Layers layers(body, nullptr);
    ExpectSameMesh(layers.Result, plain);
    layers.ExpectAll();
    for (std::size_t c = 0; c < body.Features.CurvePaths.size(); ++c)
    {
      const std::vector<Index>& path = layers.Features.CurvePaths[c];
      ASSERT_EQ(path.size(), body.Features.CurvePaths[c].size());
      for (std::size_t i = 0; i < path.size(); ++i)
      {
        EXPECT_EQ(layers.Result.SourcePoint[path[i]], body.Features.CurvePaths[c][i]);
      }
    }
  }
}

TEST(HexPaddingGroups, GeometryWithOneGroupIsAsNone)
{
  Body box = BoxBody({ 3, 2, 2 });
  GivenUpFeatures givenUp;
  for (Index c = 0; c < 12; ++c)
  {
    givenUp.Curves.insert(c);
  }
  box.Map(givenUp);
  ASSERT_EQ(box.Groups, std::vector<int>(6, 0));
  const Layers with(box);
  const Layers without(box, nullptr);
  ExpectSameMesh(with.Result, without.Result);
  ExpectSameFeatures(with.Features, without.Features);
}

TEST(HexPaddingGroups, WithFeaturesTheSameBitsEveryTime)
{
  const Body body = AngleBody();
  const Layers first(body);
  const Layers second(body);
  ExpectSameMesh(first.Result, second.Result);
  ExpectSameFeatures(first.Features, second.Features);
}

TEST(HexPaddingGroups, PatchesThatDoNotFitAreRefused)
{
  const Body box = BoxBody({ 2, 2, 2 });
  for (const int change : { -1, 1 })
  {
    HexFeatures features = box.Features;
    features.PatchOfQuad.resize(features.PatchOfQuad.size() + change);
    const HexFeatures before = features;
    PaddedMesh padded;
    const Status status =
      PadInterface(box.Mesh, box.Region, PaddingOptions(), padded, &features, box.Geometry.get());
    EXPECT_EQ(status.Code, StatusCode::InvalidMesh);
    EXPECT_NE(status.Message.find("24 quads and " + std::to_string(24 + change) + " patches"),
      std::string::npos)
      << status.Message;
    EXPECT_TRUE(padded.Mesh.Hexes.empty());
    ExpectSameFeatures(features, before);
  }
  HexFeatures features = box.Features;
  features.PatchOfQuad.back() = 6;
  PaddedMesh padded;
  const Status status = PadInterface(
    box.Mesh, box.Region, PaddingOptions(), padded, &features, box.Geometry.get());
  EXPECT_EQ(status.Code, StatusCode::InvalidMesh);
  EXPECT_NE(status.Message.find("patch 6"), std::string::npos) << status.Message;
  EXPECT_TRUE(padded.Mesh.Hexes.empty());
}

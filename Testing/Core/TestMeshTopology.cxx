// SPDX-License-Identifier: BSD-3-Clause

#include "MeshTopology.h"
#include "ValidationShapes.h"

#include <gtest/gtest.h>

#include <limits>

using namespace featurehex;

TEST(MeshTopology, Cubes)
{
  const HexTopology t = AnalyzeHexMesh(CubeMesh(3));
  EXPECT_TRUE(t.Conforming());
  EXPECT_EQ(t.Hexes, 27);
  EXPECT_EQ(t.Points, 64);
  EXPECT_EQ(t.Bodies, 1);
  EXPECT_EQ(t.Faces, 108);
  EXPECT_EQ(t.InteriorFaces, 54);
  EXPECT_EQ(t.Edges, 144);
  EXPECT_EQ(t.BoundaryEdges, 108);
  EXPECT_EQ(t.SingularInteriorEdges, 0);
  EXPECT_EQ(t.SingularBoundaryEdges, 36); // the twelve edges of the cube, three each
  EXPECT_EQ(t.OrphanPoints, 0);
  EXPECT_EQ(t.DuplicatePoints, 0);
  EXPECT_TRUE(t.Surface.ClosedManifold());
  EXPECT_EQ(t.Surface.Faces, 54);
  EXPECT_EQ(t.Surface.Vertices, 56);
  EXPECT_EQ(t.Surface.Genus, std::vector<Index>{ 0 });
  EXPECT_EQ(t.Surface.EulerCharacteristic, 2);
  EXPECT_NEAR(t.Surface.Volume, 27.0, 1e-12);
  EXPECT_NEAR(t.Surface.Area, 54.0, 1e-12);
  EXPECT_EQ(t.Surface.Cavities, 0);
  EXPECT_TRUE(std::is_sorted(t.Boundary.Owners.begin(), t.Boundary.Owners.end()));
}

TEST(MeshTopology, CavityTunnelAndTwoBodies)
{
  const HexTopology cavity = AnalyzeHexMesh(
    LatticeMesh({ 3, 3, 3 }, [](int i, int j, int k) { return i != 1 || j != 1 || k != 1; }));
  EXPECT_TRUE(cavity.Surface.ClosedManifold());
  EXPECT_EQ(cavity.Surface.Components, 2);
  EXPECT_EQ(cavity.Surface.Cavities, 1);
  EXPECT_EQ(cavity.Bodies, 1);
  EXPECT_NEAR(cavity.Surface.Volume, 26.0, 1e-12);

  const HexTopology ring =
    AnalyzeHexMesh(LatticeMesh({ 3, 3, 1 }, [](int i, int j, int) { return i != 1 || j != 1; }));
  EXPECT_TRUE(ring.Surface.ClosedManifold());
  EXPECT_EQ(ring.Surface.Genus, std::vector<Index>{ 1 });
  EXPECT_TRUE(SameTopology(ring.Surface, [] {
    const SurfaceMesh torus = TorusSurface(12, 8);
    return AnalyzeSurface(torus.Points, torus.Triangles);
  }()));

  const HexTopology two =
    AnalyzeHexMesh(LatticeMesh({ 3, 1, 1 }, [](int i, int, int) { return i != 1; }));
  EXPECT_EQ(two.Bodies, 2);
  EXPECT_EQ(two.Surface.Components, 2);
  EXPECT_EQ(two.Surface.Cavities, 0);
  EXPECT_EQ(two.Surface.EulerCharacteristic, 4);
  EXPECT_FALSE(SameTopology(two.Surface, cavity.Surface)); // same genera, one a cavity
  EXPECT_FALSE(SameTopology(two.Surface, ring.Surface));
}

TEST(MeshTopology, NonManifoldEdgeAndVertex)
{
  const HexTopology edge =
    AnalyzeHexMesh(LatticeMesh({ 2, 2, 1 }, [](int i, int j, int) { return i == j; }));
  EXPECT_TRUE(edge.Conforming());
  EXPECT_EQ(edge.Surface.NonManifoldEdges, 1);
  EXPECT_EQ(edge.Surface.BadEdges.size(), 1u);
  EXPECT_FALSE(edge.Surface.ClosedManifold());
  EXPECT_EQ(edge.Bodies, 2);

  const HexTopology vertex =
    AnalyzeHexMesh(LatticeMesh({ 2, 2, 2 }, [](int i, int j, int k) { return i == j && j == k; }));
  EXPECT_EQ(vertex.Surface.NonManifoldEdges, 0);
  EXPECT_EQ(vertex.Surface.NonManifoldVertices, 1);
  ASSERT_EQ(vertex.Surface.BadVertices.size(), 1u);
  EXPECT_FALSE(vertex.Surface.ClosedManifold());
  EXPECT_EQ(vertex.Surface.Genus, (std::vector<Index>{ 0, 0 })); // counted per umbrella
}

TEST(MeshTopology, BrokenConformity)
{
  HexMesh duplicate = CubeMesh(2);
  duplicate.Hexes.push_back(duplicate.Hexes[3]);
  HexTopology t = AnalyzeHexMesh(duplicate);
  EXPECT_FALSE(t.Conforming());
  EXPECT_EQ(t.DuplicateHexes, 1);
  EXPECT_EQ(t.DuplicateHexIds, std::vector<Index>{ 8 });
  EXPECT_EQ(t.OverusedFaces, 3);

  // The neighbour's corners of the shared face in crossed order.
  HexMesh twisted = LatticeMesh({ 2, 1, 1 }, [](int, int, int) { return true; });
  std::swap(twisted.Hexes[1][0], twisted.Hexes[1][3]);
  t = AnalyzeHexMesh(twisted);
  EXPECT_EQ(t.TwistedFaces, 1);
  EXPECT_EQ(t.Defects.Twisted, (std::vector<Index>{ 0, 1 }));
  EXPECT_FALSE(t.Conforming());

  // One hex turned inside out.
  HexMesh mirrored = LatticeMesh({ 2, 1, 1 }, [](int, int, int) { return true; });
  for (int k = 0; k < 4; ++k)
  {
    std::swap(mirrored.Hexes[1][k], mirrored.Hexes[1][k + 4]);
  }
  t = AnalyzeHexMesh(mirrored);
  EXPECT_EQ(t.MisorientedFaces, 1);
  EXPECT_FALSE(t.Conforming());

  HexMesh degenerate = CubeMesh(1);
  degenerate.Hexes[0][1] = degenerate.Hexes[0][0];
  t = AnalyzeHexMesh(degenerate);
  EXPECT_EQ(t.DegenerateHexes, 1);
  EXPECT_FALSE(t.Conforming());

  // Two cubes that lie against each other with points of their own: hanging.
  HexMesh cracked = LatticeMesh({ 3, 1, 1 }, [](int i, int, int) { return i != 1; });
  for (Vec3& p : cracked.Points)
  {
    p.x() = p.x() > 1.5 ? p.x() - 1 : p.x();
  }
  t = AnalyzeHexMesh(cracked);
  EXPECT_EQ(t.DuplicatePoints, 4);
  EXPECT_EQ(t.Surface.Components, 2);
}

TEST(MeshTopology, OrphansAndCoincidentPoints)
{
  HexMesh mesh = CubeMesh(2);
  mesh.Points.push_back(Vec3(5, 5, 5));
  EXPECT_EQ(AnalyzeHexMesh(mesh).OrphanPoints, 1);

  std::vector<Vec3> points = CubeMesh(5).Points;
  EXPECT_EQ(CountCoincidentPoints(points, 1e-9), 0);
  points.push_back(points[17] + Vec3(0.9e-9, 0, 0));
  points.push_back(points[30] - Vec3(0, 0.9e-9, 0));
  points.push_back(points[40] + Vec3(0, 2e-9, 0));
  points.emplace_back(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  EXPECT_EQ(CountCoincidentPoints(points, 1e-9), 2);
  EXPECT_EQ(CountCoincidentPoints(std::vector<Vec3>(1000, Vec3::Ones()), 0.0), 999);
  // One far point doesn't make the others coincide, nor the search slow.
  points = CubeMesh(20).Points;
  points.emplace_back(1e15, 0, 0);
  EXPECT_EQ(CountCoincidentPoints(points, 1e-12), 0);
}

TEST(MeshTopology, Surfaces)
{
  SurfaceMesh s = SphereSurface(10);
  SurfaceTopology t = AnalyzeSurface(s.Points, s.Triangles);
  EXPECT_TRUE(t.ClosedManifold());
  EXPECT_EQ(t.Genus, std::vector<Index>{ 0 });
  EXPECT_GT(t.Volume, 0.0);
  std::swap(s.Triangles[5][0], s.Triangles[5][1]);
  EXPECT_EQ(AnalyzeSurface(s.Points, s.Triangles).MisorientedEdges, 3);
  s.Triangles.erase(s.Triangles.begin() + 5);
  t = AnalyzeSurface(s.Points, s.Triangles);
  EXPECT_EQ(t.OpenEdges, 3);
  EXPECT_FALSE(t.ClosedManifold());
  EXPECT_FALSE(AnalyzeSurface(s.Points, std::vector<Triangle>()).ClosedManifold());

  const SurfaceMesh torus = TorusSurface(20, 10);
  EXPECT_EQ(AnalyzeSurface(torus.Points, torus.Triangles).Genus, std::vector<Index>{ 1 });
}

TEST(MeshTopology, EmptyMesh)
{
  const HexTopology t = AnalyzeHexMesh({});
  EXPECT_FALSE(t.Conforming());
  EXPECT_FALSE(t.Surface.ClosedManifold());
  EXPECT_EQ(t.Bodies, 0);
}

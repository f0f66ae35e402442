// SPDX-License-Identifier: BSD-3-Clause
#include "ShellTopology.h"

#include "DomainShapes.h"

using namespace domainshapes;

namespace
{
/// A quad mesh with the shape of a triangle surface: each triangle as three quads.
std::pair<std::vector<Vec3>, std::vector<Quad>> Quads(const SurfaceMesh& surface)
{
  std::vector<Vec3> points = surface.Points;
  std::map<std::pair<Index, Index>, Index> middles;
  const auto middle = [&](Index a, Index b) {
    const auto [entry, fresh] =
      middles.insert({ std::minmax(a, b), static_cast<Index>(points.size()) });
    if (fresh)
    {
      points.push_back(0.5 * (points[a] + points[b]));
    }
    return entry->second;
  };
  std::vector<Quad> quads;
  for (const Triangle& t : surface.Triangles)
  {
    const Index center = static_cast<Index>(points.size());
    points.push_back((points[t[0]] + points[t[1]] + points[t[2]]) / 3);
    for (int k = 0; k < 3; ++k)
    {
      const Index next = middle(t[k], t[(k + 1) % 3]);
      const Index before = middle(t[(k + 2) % 3], t[k]);
      quads.push_back({ t[k], next, center, before });
    }
  }
  return { points, quads };
}

ShellComparison Compare(const SurfaceMesh& surface, const SurfaceMesh& mesh)
{
  const auto [points, quads] = Quads(mesh);
  return CompareShells(FindShells(surface.Points, surface.Triangles),
    TriangleSearch(surface.Points, surface.Triangles), FindShells(points, quads), points, quads);
}
}

TEST(ShellTopology, ShellsOneByOne)
{
  const SurfaceMesh surface = Together(
    Together(Sphere(Vec3::Zero(), 3), Flipped(Sphere(Vec3::Zero(), 2))), Torus(0.8, 0.2));
  const Shells shells = FindShells(surface.Points, surface.Triangles);
  ASSERT_EQ(shells.List.size(), 3u);
  EXPECT_EQ(shells.List[0].EulerCharacteristic, 2);
  EXPECT_NEAR(shells.List[0].Volume, 4 * Pi / 3 * 27, 2);
  EXPECT_TRUE(shells.List[1].Cavity());
  EXPECT_EQ(shells.List[2].Genus(), 1);
  EXPECT_LT(shells.List[2].Center.norm(), 1e-9);
  EXPECT_EQ(shells.OfFace.size(), surface.Triangles.size());
  EXPECT_TRUE(FindShells({}, std::vector<Quad>()).List.empty());
}

TEST(ShellTopology, CavitiesFarFromTheOrigin)
{
  const SurfaceMesh surface = Flipped(Sphere(Vec3(1e9, -3e9, 2e9), 1.0));
  const Shells shells = FindShells(surface.Points, surface.Triangles);
  EXPECT_TRUE(shells.List[0].Cavity());
  EXPECT_NEAR(shells.List[0].Volume, -4 * Pi / 3, 0.05);
}

TEST(ShellTopology, QuadsAndTrianglesAgree)
{
  const SurfaceMesh torus = Torus(1, 0.3);
  const auto [points, quads] = Quads(torus);
  const Shells a = FindShells(torus.Points, torus.Triangles);
  const Shells b = FindShells(points, quads);
  EXPECT_EQ(b.List[0].EulerCharacteristic, a.List[0].EulerCharacteristic);
  EXPECT_NEAR(b.List[0].Volume, a.List[0].Volume, 1e-12);
}

TEST(ShellTopology, VerdictsAndWords)
{
  const SurfaceMesh two = Together(Sphere(Vec3(-2, 0, 0), 1), Sphere(Vec3(2, 0, 0), 1));
  const ShellComparison same = Compare(two, two);
  EXPECT_TRUE(same.Same());
  EXPECT_EQ(same.Matched, (std::vector<Index>{ 0, 1 }));

  const ShellComparison missing = Compare(two, Sphere(Vec3(2, 0, 0), 1));
  EXPECT_EQ(missing.Verdicts[0], ShellVerdict::Missing);
  EXPECT_EQ(missing.Verdicts[1], ShellVerdict::Same);
  EXPECT_EQ(missing.Report.find("Shell 1 (round -2"), 0u);
  EXPECT_NE(missing.Report.find("has no hexes of its own."), std::string::npos);

  const ShellComparison split = Compare(two, Together(two, Sphere(Vec3(2, 0, 1), 0.2)));
  EXPECT_EQ(split.Verdicts[1], ShellVerdict::Split);

  const ShellComparison genus = Compare(Sphere(Vec3::Zero(), 1), Torus(1, 0.3));
  EXPECT_EQ(genus.Verdicts[0], ShellVerdict::Genus);
  EXPECT_NE(genus.Report.find("genus 1 instead of 0"), std::string::npos);
}

TEST(ShellTopology, CavitiesMatchCavities)
{
  const SurfaceMesh hollow = Together(Sphere(Vec3::Zero(), 1), Flipped(Sphere(Vec3::Zero(), 0.9)));
  EXPECT_TRUE(Compare(hollow, hollow).Same());
  const ShellComparison filled = Compare(hollow, Sphere(Vec3::Zero(), 0.92));
  EXPECT_EQ(filled.Verdicts[0], ShellVerdict::Same);
  EXPECT_EQ(filled.Verdicts[1], ShellVerdict::Missing);
}

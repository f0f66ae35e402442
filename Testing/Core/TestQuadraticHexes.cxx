// SPDX-License-Identifier: BSD-3-Clause
#include "QuadraticHexes.h"

#include "QuadraticCertificate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace featurehex;

namespace
{
constexpr int Size = 3;

/// A cube of 27 hexes from -1 to 1; @a ball: its boundary on the unit sphere.
HexMesh Grid(bool ball)
{
  HexMesh mesh;
  for (int k = 0; k <= Size; ++k)
  {
    for (int j = 0; j <= Size; ++j)
    {
      for (int i = 0; i <= Size; ++i)
      {
        const Vec3 p = 2.0 / Size * Vec3(i, j, k) - Vec3::Ones();
        mesh.Points.push_back(ball ? Vec3(p.cwiseAbs().maxCoeff() / p.norm() *
                                          (0.35 + 0.65 * p.cwiseAbs().maxCoeff()) * p)
                                   : p);
      }
    }
  }
  const auto id = [](int i, int j, int k) { return i + (Size + 1) * (j + (Size + 1) * k); };
  for (int k = 0; k < Size; ++k)
  {
    for (int j = 0; j < Size; ++j)
    {
      for (int i = 0; i < Size; ++i)
      {
        mesh.Hexes.push_back({ id(i, j, k), id(i + 1, j, k), id(i + 1, j + 1, k), id(i, j + 1, k),
          id(i, j, k + 1), id(i + 1, j, k + 1), id(i + 1, j + 1, k + 1), id(i, j + 1, k + 1) });
      }
    }
  }
  return mesh;
}

/// The unit sphere from an octahedron, 4^n triangles a side.
SurfaceMesh Sphere(int n)
{
  SurfaceMesh surface;
  surface.Points = { Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitY(), Vec3::UnitZ(),
    -Vec3::UnitZ() };
  surface.Triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 },
    { 1, 2, 5 }, { 3, 1, 5 }, { 0, 3, 5 } };
  for (; n > 0; --n)
  {
    std::map<std::array<Index, 2>, Index> middles;
    const auto middle = [&](Index a, Index b)
    {
      const auto [at, fresh] = middles.emplace(
        std::array<Index, 2>{ std::min(a, b), std::max(a, b) }, Index(surface.Points.size()));
      if (fresh)
      {
        surface.Points.push_back((surface.Points[a] + surface.Points[b]).normalized());
      }
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : surface.Triangles)
    {
      const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), { { a, ab, ca }, { ab, b, bc }, { ca, bc, c }, { ab, bc, ca } });
    }
    surface.Triangles = finer;
  }
  return surface;
}

/// A ball of 7 hexes: one in the middle, one at each of its faces.
HexMesh PaddedBall()
{
  HexMesh mesh;
  for (double size : { 0.3, 1.0 / std::sqrt(3.0) })
  {
    for (const Vec3& p : { Vec3(-1, -1, -1), Vec3(1, -1, -1), Vec3(1, 1, -1), Vec3(-1, 1, -1),
           Vec3(-1, -1, 1), Vec3(1, -1, 1), Vec3(1, 1, 1), Vec3(-1, 1, 1) })
    {
      mesh.Points.push_back(size * p);
    }
  }
  mesh.Hexes = { { 0, 1, 2, 3, 4, 5, 6, 7 } };
  for (const auto& f : HexFaces)
  {
    mesh.Hexes.push_back({ f[0], f[1], f[2], f[3], f[0] + 8, f[1] + 8, f[2] + 8, f[3] + 8 });
  }
  return mesh;
}

QuadraticMesh Make(const HexMesh& mesh, const QuadraticTargets& targets, int nodes)
{
  QuadraticOptions options;
  options.NodesPerHex = nodes;
  options.LargestMove = 0.5;
  Monitor monitor;
  QuadraticMesh result;
  const Status status = MakeQuadratic(mesh, targets, options, monitor, result);
  EXPECT_TRUE(status.Ok()) << status.Message;
  return result;
}

/// Each hex proven; returns the smallest ratio.
double ExpectValid(const QuadraticMesh& mesh)
{
  double smallest = 1.0;
  for (std::size_t h = 0; h < mesh.HexNodes.size() / mesh.NodesPerHex; ++h)
  {
    HexGrid27 grid;
    for (int k = 0; k < mesh.NodesPerHex; ++k)
    {
      grid[GridPlaces()[k]] = mesh.Points[mesh.HexNodes[h * mesh.NodesPerHex + k]];
    }
    if (mesh.NodesPerHex == 20)
    {
      FillSerendipity(grid);
    }
    smallest = std::min(smallest, QuadraticHexRatio(grid));
  }
  EXPECT_GT(smallest, 0.0);
  return smallest;
}
} // namespace

TEST(QuadraticHexes, StraightWithoutSurface)
{
  const HexMesh cube = Grid(false);
  for (int nodes : { 20, 27 })
  {
    const QuadraticMesh mesh = Make(cube, {}, nodes);
    // Nodes of the grid of twice the size; without mid-face and middle nodes those with one odd
    // number at most.
    EXPECT_EQ(mesh.Points.size(), nodes == 27 ? 343u : 64u + 3u * 3u * 16u);
    EXPECT_EQ(mesh.HexNodes.size(), 27u * static_cast<std::size_t>(nodes));
    EXPECT_EQ(mesh.Added.Kind.size(), mesh.Points.size() - 64u);
    EXPECT_EQ(mesh.Report.OnSurface, 0);
    EXPECT_NEAR(ExpectValid(mesh), 1.0, 1e-9);
    for (std::size_t i = 0; i < 64; ++i)
    {
      EXPECT_EQ(mesh.Points[i], cube.Points[i]);
    }
  }
}

TEST(QuadraticHexes, NodesOfTheBoundaryLieOnTheSurface)
{
  const HexMesh ball = PaddedBall();
  const SurfaceMesh sphere = Sphere(5);
  for (int nodes : { 20, 27 })
  {
    const QuadraticMesh mesh = Make(ball, { &sphere }, nodes);
    EXPECT_EQ(mesh.Report.BoundaryNodes, nodes == 20 ? 12 : 18);
    EXPECT_EQ(mesh.Report.OnSurface, mesh.Report.BoundaryNodes);
    EXPECT_EQ(mesh.Report.Shortened, 0);
    EXPECT_GE(ExpectValid(mesh), mesh.Report.SmallestRatio - 1e-9);
    for (std::size_t i = 0; i < mesh.Added.Kind.size(); ++i)
    {
      if (mesh.Added.Kind[i] == FeatureKind::Surface)
      {
        EXPECT_NEAR(mesh.Points[16 + i].norm(), 1.0, 1e-3);
      }
    }
  }
}

TEST(QuadraticHexes, NodesGoBackRatherThanBreakAHex)
{
  // The cube against a sphere round it: corners and edges would move far.
  const HexMesh cube = Grid(false);
  SurfaceMesh sphere = Sphere(4);
  for (Vec3& p : sphere.Points)
  {
    p = 1.2 * p + Vec3(0.13, 0.07, 0.02);
  }
  for (int nodes : { 20, 27 })
  {
    QuadraticOptions options;
    options.NodesPerHex = nodes;
    options.LargestMove = 10.0;
    Monitor monitor;
    QuadraticMesh mesh;
    ASSERT_TRUE(MakeQuadratic(cube, { &sphere }, options, monitor, mesh).Ok());
    EXPECT_GT(mesh.Report.Shortened, 0);
    EXPECT_GT(mesh.Report.OnSurface, 0);
    ExpectValid(mesh);
    options.LargestMove = 0.1;
    ASSERT_TRUE(MakeQuadratic(cube, { &sphere }, options, monitor, mesh).Ok());
    EXPECT_GT(mesh.Report.TooFar, 0);
    ExpectValid(mesh);
  }
}

TEST(QuadraticHexes, NodesOfCurvesLieOnTheirCurve)
{
  // The equator of the sphere, as a curve of the surface and of the mesh.
  const HexMesh ball = Grid(true);
  const SurfaceMesh sphere = Sphere(4);
  SurfaceFeatures graph;
  graph.PatchOfTriangle.assign(sphere.Triangles.size(), 0);
  graph.Curves.resize(2);
  std::map<double, Index> equator;
  for (std::size_t v = 0; v < sphere.Points.size(); ++v)
  {
    if (sphere.Points[v].z() == 0.0)
    {
      equator[std::atan2(sphere.Points[v].y(), sphere.Points[v].x())] = static_cast<Index>(v);
    }
  }
  for (const auto& [angle, v] : equator)
  {
    graph.Curves[1].Points.push_back(v);
  }
  HexFeatures features;
  features.PatchOfQuad.assign(54, 0);
  features.CurvePaths.resize(2);
  features.CurvePaths[1] = { 16, 17, 18, 19 }; // at z = -1/3
  const QuadraticMesh mesh = Make(ball, { &sphere, &graph, &features }, 20);
  int nodes = 0;
  for (std::size_t i = 0; i < mesh.Added.Kind.size(); ++i)
  {
    if (mesh.Added.Kind[i] == FeatureKind::Curve)
    {
      ++nodes;
      EXPECT_EQ(mesh.Added.Id[i], 1);
    }
    else if (mesh.Added.Kind[i] == FeatureKind::Surface)
    {
      EXPECT_EQ(mesh.Added.Id[i], 0);
    }
  }
  EXPECT_EQ(nodes, 3);
  ExpectValid(mesh);
}

TEST(QuadraticHexes, SaysWhatIsWrong)
{
  HexMesh mesh = Grid(false);
  Monitor monitor;
  QuadraticMesh result;
  QuadraticOptions options;
  options.NodesPerHex = 8;
  EXPECT_EQ(MakeQuadratic(mesh, {}, options, monitor, result).Code, StatusCode::InvalidOption);
  std::swap(mesh.Points[21], mesh.Points[42]);
  EXPECT_EQ(MakeQuadratic(mesh, {}, {}, monitor, result).Code, StatusCode::InvalidMesh);
  EXPECT_TRUE(result.Points.empty());
  monitor.SetTimeLimit(1e-9);
  EXPECT_EQ(MakeQuadratic(Grid(false), {}, {}, monitor, result).Code, StatusCode::TimeLimit);
}

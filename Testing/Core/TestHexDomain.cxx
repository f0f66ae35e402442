// SPDX-License-Identifier: BSD-3-Clause
#include "HexDomain.h"

#include "DomainShapes.h"
#include "SurfaceSizing.h"

#include <vtkSMPTools.h>

#include <random>

using namespace domainshapes;

namespace
{
HexDomain Domain(
  const Shape& shape, const HexMesh& mesh, const DomainOptions& options = DomainOptions())
{
  Monitor monitor;
  HexDomain domain;
  const Status status = ComputeHexDomain(
    mesh, shape.Surface, shape.Search, shape.Winding, options, monitor, domain);
  EXPECT_TRUE(status.Ok()) << status.Message;
  return domain;
}

std::vector<char> InsideOf(const HexDomain& domain)
{
  std::vector<char> inside;
  for (int region : domain.Region)
  {
    inside.push_back(region > 0);
  }
  return inside;
}

SurfaceTopology InterfaceTopology(const HexMesh& mesh, const HexDomain& domain)
{
  std::vector<Quad> quads;
  for (const InterfaceQuad& quad : domain.Interface)
  {
    quads.push_back(quad.Vertices);
  }
  return AnalyzeSurface(mesh.Points, quads);
}

/// Everything the stage promises when the resolution is sufficient.
void ExpectSameTopology(
  const Shape& shape, const HexMesh& mesh, const HexDomain& domain, int bodies)
{
  EXPECT_TRUE(domain.Topology.Same()) << domain.Topology.Report;
  EXPECT_TRUE(domain.TopologyPoints.empty());
  EXPECT_TRUE(domain.MissingPoints.empty());
  EXPECT_EQ(domain.NumberOfRegions, bodies);
  const SurfaceTopology found = InterfaceTopology(mesh, domain);
  EXPECT_TRUE(found.ClosedManifold());
  EXPECT_TRUE(SameTopology(found, AnalyzeSurface(shape.Surface.Points, shape.Surface.Triangles)));
}

Vec3 Center(const HexMesh& mesh, std::size_t hex)
{
  Vec3 center = Vec3::Zero();
  for (Index v : mesh.Hexes[hex])
  {
    center += mesh.Points[v] / 8;
  }
  return center;
}

double SideOf(const Shape& shape) { return BoundingBox(shape.Surface).Size().maxCoeff(); }
}

TEST(HexDomain, SphereLabelsAreRight)
{
  const Shape sphere(Sphere(Vec3(5, 6, 7), 1.0, 24));
  const HexMesh mesh = DualMesh(sphere.Surface, 2.0 / 26);
  const HexDomain domain = Domain(sphere, mesh);
  ExpectSameTopology(sphere, mesh, domain, 1);
  Index inside = 0;
  for (std::size_t h = 0; h < mesh.Hexes.size(); ++h)
  {
    const Vec3 center = Center(mesh, h);
    const double radius = (center - Vec3(5, 6, 7)).norm();
    // Between the two radii the facets decide.
    if (radius < 0.99 || radius > 1.0)
    {
      EXPECT_EQ(domain.Region[h] > 0, sphere.Winding.Inside(center));
    }
    inside += domain.Region[h] > 0;
  }
  EXPECT_EQ(inside, domain.InsideHexes);
  EXPECT_LE(domain.RepairFlips + domain.IslandFlips + domain.LonelyFlips, 5);
  std::printf("%zu hexes, %d inside, %d winding numbers\n", mesh.Hexes.size(), inside,
    domain.WindingNumbers);
  EXPECT_LT(domain.WindingNumbers, 0.2 * mesh.Hexes.size());
}

TEST(HexDomain, TorusKeepsItsTunnel)
{
  const Shape torus(Torus(1.0, 0.35));
  const HexMesh mesh = DualMesh(torus.Surface, SideOf(torus) / 26);
  const HexDomain domain = Domain(torus, mesh);
  ExpectSameTopology(torus, mesh, domain, 1);
  EXPECT_EQ(domain.InterfaceShells.List[0].Genus(), 1);
}

TEST(HexDomain, TwoBodies)
{
  const Shape shape(Together(Sphere(Vec3(-1.3, 0, 0), 1), Sphere(Vec3(1.3, 0, 0), 1)));
  const HexMesh mesh = DualMesh(shape.Surface, SideOf(shape) / 26);
  const HexDomain domain = Domain(shape, mesh);
  ExpectSameTopology(shape, mesh, domain, 2);
  for (std::size_t h = 0; h < mesh.Hexes.size(); ++h)
  {
    if (domain.Region[h] > 0)
    {
      EXPECT_EQ(domain.Region[h] == domain.Region[domain.Interface[0].Inside],
        Center(mesh, h)[0] * Center(mesh, domain.Interface[0].Inside)[0] > 0);
    }
  }
}

TEST(HexDomain, CavityAndSolidInTheCavity)
{
  const Shape hollow(Together(Sphere(Vec3::Zero(), 1), Flipped(Sphere(Vec3(0.1, 0, 0), 0.6))));
  const HexMesh hollowMesh = DualMesh(hollow.Surface, 2.0 / 26);
  ExpectSameTopology(hollow, hollowMesh, Domain(hollow, hollowMesh), 1);

  const Shape nested(Together(hollow.Surface, Torus(0.3, 0.1)));
  const HexMesh nestedMesh = DualMesh(nested.Surface, 2.0 / 26);
  ExpectSameTopology(nested, nestedMesh, Domain(nested, nestedMesh), 2);
}

TEST(HexDomain, LabelBiasAddsHexesButNotInGaps)
{
  const Shape sphere(Sphere(Vec3::Zero(), 1.0));
  const HexMesh mesh = DualMesh(sphere.Surface, 2.0 / 26);
  DomainOptions biased;
  biased.LabelBias = 0.2;
  EXPECT_GT(Domain(sphere, mesh, biased).InsideHexes, 1.05 * Domain(sphere, mesh).InsideHexes);

  const double edge = 0.1;
  const Shape boxes(Together(BoxSurface(Vec3(0.03, 0.04, 1.12), Vec3(2.03, 2.04, 3.12)),
    BoxSurface(Vec3(0.03, 0.04, -1), Vec3(2.03, 2.04, 1.02))));
  const HexMesh gapMesh = DualMesh(boxes.Surface, edge);
  const auto inGap = [&](const HexDomain& domain) {
    int count = 0;
    for (std::size_t h = 0; h < gapMesh.Hexes.size(); ++h)
    {
      const Vec3 c = Center(gapMesh, h);
      count += domain.Region[h] > 0 && c[2] > 1.02 && c[2] < 1.12 && c[0] > 0.2 && c[0] < 1.8 &&
        c[1] > 0.2 && c[1] < 1.8;
    }
    return count;
  };
  biased.LabelBias = 0.45;
  EXPECT_EQ(inGap(Domain(boxes, gapMesh, biased)), 0);
}

TEST(HexDomain, ThinLimbsAreRefinedUntilTheyAreWhole)
{
  // A ring far thinner than the cells: first lost or in pieces, never left wrong.
  const Shape ring(Torus(1.0, 0.02, 96, 12));
  const double edge = SideOf(ring) / 26;
  DomainOptions options;
  options.TargetEdgeLength = edge;
  std::vector<RefinementPoint> points;
  int rounds = 0;
  for (; rounds < 6; ++rounds)
  {
    const HexMesh mesh = DualMesh(ring.Surface, edge, points);
    const HexDomain domain = Domain(ring, mesh, options);
    std::printf("round %d: %zu hexes, %d inside, %s, %zu + %zu points\n", rounds,
      mesh.Hexes.size(), domain.InsideHexes,
      domain.Topology.Same() ? "same topology" : domain.Topology.Report.c_str(),
      domain.TopologyPoints.size(), domain.MissingPoints.size());
    if (domain.TopologyPoints.empty() && domain.MissingPoints.empty())
    {
      ExpectSameTopology(ring, mesh, domain, 1);
      break;
    }
    points.insert(points.end(), domain.TopologyPoints.begin(), domain.TopologyPoints.end());
    points.insert(points.end(), domain.MissingPoints.begin(), domain.MissingPoints.end());
  }
  EXPECT_LT(rounds, 4);
}

TEST(HexDomain, MergedBodiesAreSaidAndRefined)
{
  const double edge = 0.2;
  const Shape close(Together(Sphere(Vec3(0, 0, 1.02), 1), Sphere(Vec3(0, 0, -1.02), 1)));
  DomainOptions options;
  options.TargetEdgeLength = edge;
  std::vector<RefinementPoint> points;
  bool same = false;
  for (int round = 0; round < 5 && !same; ++round)
  {
    const HexMesh mesh = DualMesh(close.Surface, edge, points);
    const HexDomain domain = Domain(close, mesh, options);
    same = domain.Topology.Same();
    EXPECT_EQ(same, domain.TopologyPoints.empty());
    for (const RefinementPoint& point : domain.TopologyPoints)
    {
      EXPECT_LT(std::abs(point.Position[2]), 0.5);
      EXPECT_GE(point.Level, 1);
    }
    points.insert(points.end(), domain.TopologyPoints.begin(), domain.TopologyPoints.end());
  }
  EXPECT_TRUE(same);
}

TEST(HexDomain, LostSpikesAreMissing)
{
  // A sphere with a needle of one triangle fan.
  SurfaceMesh surface = Sphere(Vec3::Zero(), 1.0, 16);
  // Off the axes, so that no row of hexes happens to lie along it.
  const Vec3 direction = Vec3(0.35, 0.2, 1).normalized();
  std::size_t top = 0;
  for (std::size_t v = 0; v < surface.Points.size(); ++v)
  {
    top = surface.Points[v].dot(direction) > surface.Points[top].dot(direction) ? v : top;
  }
  surface.Points[top] = 1.8 * direction;
  const Shape spiky(surface);
  const HexDomain domain = Domain(spiky, DualMesh(spiky.Surface, 0.2));
  EXPECT_TRUE(domain.Topology.Same());
  ASSERT_FALSE(domain.MissingPoints.empty());
  for (const RefinementPoint& point : domain.MissingPoints)
  {
    EXPECT_GT(point.Position.norm(), 1.0);
    EXPECT_GT(point.Position.normalized().dot(direction), 0.95);
  }
}

TEST(HexDomain, RandomLabelsAreRepaired)
{
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    const Shape torus(Torus(1.0, 0.4));
    std::vector<RefinementPoint> points;
    points.push_back({ Vec3(1.4, 0, 0), 2 });
    const HexMesh mesh = DualMesh(torus.Surface, SideOf(torus) / 16, points);
    const HexDomain domain = Domain(torus, mesh);
    const HexGraph graph(mesh);
    std::vector<char> inside = InsideOf(domain);
    std::vector<double> distances;
    std::mt19937 random(seed);
    Index changed = 0;
    for (std::size_t h = 0; h < inside.size(); ++h)
    {
      const Vec3 center = Center(mesh, h);
      const double size = std::cbrt((mesh.Points[mesh.Hexes[h][6]] - mesh.Points[mesh.Hexes[h][0]])
                                      .cwiseAbs()
                                      .prod());
      const double distance = torus.Search.Closest(center).Distance / std::max(size, 1e-3);
      distances.push_back(inside[h] ? -distance : distance);
      if (distance < 1.5 && random() % 100 < 10 * (1 + seed % 4))
      {
        inside[h] ^= 1;
        ++changed;
      }
    }
    const std::size_t bad = NonManifoldVertices(graph, inside).size();
    const RepairResult result = RepairInterface(graph, distances, 20000, inside);
    std::printf("seed %u: %d labels changed, %zu bad vertices, %d flips, %zu left\n", seed, changed,
      bad, result.Flips, result.NonManifoldVertices.size());
    EXPECT_GT(bad, 0u);
    EXPECT_TRUE(result.NonManifoldVertices.empty());
    std::vector<Quad> quads;
    for (const InterfaceQuad& quad : InterfaceQuads(mesh, graph.Neighbors, inside))
    {
      quads.push_back(quad.Vertices);
    }
    EXPECT_TRUE(AnalyzeSurface(mesh.Points, quads).ClosedManifold());
  }
}

TEST(HexDomain, FailsOutsideItsDomain)
{
  const Shape sphere(Sphere(Vec3::Zero(), 1));
  Monitor monitor;
  HexDomain domain;
  const HexMesh small = DualMesh(Sphere(Vec3::Zero(), 0.3), 0.1);
  const Status status = ComputeHexDomain(
    small, sphere.Surface, sphere.Search, sphere.Winding, DomainOptions(), monitor, domain);
  EXPECT_EQ(status.Code, StatusCode::InvalidMesh);
  EXPECT_FALSE(status.Where.empty());
  EXPECT_EQ(ComputeHexDomain(HexMesh(), sphere.Surface, sphere.Search, sphere.Winding,
              DomainOptions(), monitor, domain)
              .Code,
    StatusCode::InvalidMesh);
  EXPECT_EQ(ComputeHexDomain(small, SurfaceMesh(), TriangleSearch(), WindingNumber(),
              DomainOptions(), monitor, domain)
              .Code,
    StatusCode::EmptySurface);
}

TEST(HexDomain, SameForAnyNumberOfThreads)
{
  const Shape torus(Torus(1.0, 0.15));
  const HexMesh mesh = DualMesh(torus.Surface, SideOf(torus) / 20);
  const HexDomain many = Domain(torus, mesh);
  vtkSMPTools::Initialize(1);
  const HexDomain one = Domain(torus, mesh);
  vtkSMPTools::Initialize();
  EXPECT_EQ(one.Region, many.Region);
  EXPECT_EQ(one.Topology.Report, many.Topology.Report);
  ASSERT_EQ(one.MissingPoints.size(), many.MissingPoints.size());
  for (std::size_t i = 0; i < one.MissingPoints.size(); ++i)
  {
    EXPECT_EQ(one.MissingPoints[i].Position, many.MissingPoints[i].Position);
  }
}

TEST(HexDomain, ScansHaveTheirTopologyAtOnce)
{
  for (const char* name : { "bunny", "octopus_low", "ant2", "bumpy_torus" })
  {
    SurfaceMesh surface = Scan(name);
    if (surface.Points.empty())
    {
      GTEST_SKIP() << "no scans: FEATUREHEX_SHARED is not a folder with data/surfaces/organic";
    }
    const Shape shape(std::move(surface));
    Monitor monitor;
    SizingOptions sizing;
    sizing.TargetEdgeLength = SideOf(shape) / 26;
    sizing.Slack = 0.005 * shape.Diagonal();
    const std::vector<RefinementPoint> points =
      ComputeSizing(shape.Surface, shape.Search, sizing, monitor);
    const HexMesh mesh = DualMesh(shape.Surface, sizing.TargetEdgeLength, points);
    DomainOptions options;
    options.TargetEdgeLength = sizing.TargetEdgeLength;
    options.Slack = sizing.Slack;
    options.LabelBias = 0.1;
    const HexDomain domain = Domain(shape, mesh, options);
    EXPECT_TRUE(domain.Topology.Same()) << name << ": " << domain.Topology.Report;
    EXPECT_TRUE(InterfaceTopology(mesh, domain).ClosedManifold());
  }
}

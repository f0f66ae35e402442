// SPDX-License-Identifier: BSD-3-Clause
#include "HexPadding.h"

#include "DomainShapes.h"
#include "HexDomain.h"
#include "HexUntangling.h"
#include "ValidationShapes.h"

#include <algorithm>
#include <numeric>
#include <set>

using namespace domainshapes;

namespace
{
struct Padded
{
  HexMesh Dual;
  HexDomain Domain;
  PaddedMesh Result;

  Padded(const Shape& shape, double edgeLength)
    : Dual(DualMesh(shape.Surface, edgeLength))
  {
    Monitor monitor;
    const Status labelled = ComputeHexDomain(this->Dual, shape.Surface, shape.Search,
      shape.Winding, DomainOptions(), monitor, this->Domain);
    EXPECT_TRUE(labelled.Ok()) << labelled.Message;
    const Status status =
      PadInterface(this->Dual, this->Domain.Region, PaddingOptions(), this->Result);
    EXPECT_TRUE(status.Ok()) << status.Message;
  }
};

void ExpectPromises(const Padded& padded)
{
  const PaddedMesh& result = padded.Result;
  const HexTopology topology = AnalyzeHexMesh(result.Mesh);
  EXPECT_TRUE(topology.Conforming());
  EXPECT_EQ(topology.OrphanPoints, 0);
  EXPECT_TRUE(topology.Surface.ClosedManifold());
  EXPECT_EQ(topology.Bodies, padded.Domain.NumberOfRegions);
  EXPECT_EQ(result.Mesh.Hexes.size(),
    static_cast<std::size_t>(padded.Domain.InsideHexes) + padded.Domain.Interface.size());

  // The boundary is the interface, quad by quad, point for point.
  std::multiset<Quad> wanted;
  for (InterfaceQuad quad : padded.Domain.Interface)
  {
    std::sort(quad.Vertices.begin(), quad.Vertices.end());
    wanted.insert(quad.Vertices);
  }
  std::multiset<Quad> found;
  std::vector<int> quadsOfHex(result.Mesh.Hexes.size(), 0);
  for (std::size_t q = 0; q < topology.Boundary.Quads.size(); ++q)
  {
    const Index owner = topology.Boundary.Owners[q];
    EXPECT_EQ(++quadsOfHex[owner], 1);
    EXPECT_TRUE(result.IsLayer[owner]);
    Quad source;
    std::set<Index> ids(topology.Boundary.Quads[q].begin(), topology.Boundary.Quads[q].end());
    for (int k = 0; k < 4; ++k)
    {
      const Index v = topology.Boundary.Quads[q][k];
      source[k] = result.SourcePoint[v];
      EXPECT_TRUE(result.OnBoundary[v]);
      EXPECT_EQ(result.Mesh.Points[v], padded.Dual.Points[source[k]]);
      EXPECT_TRUE(ids.count(result.Mesh.Hexes[owner][HexFaces[1][k]]));
    }
    std::sort(source.begin(), source.end());
    found.insert(source);
  }
  EXPECT_EQ(found, wanted);
  EXPECT_EQ(result.LayerHexes.size(), wanted.size());
  EXPECT_TRUE(std::is_sorted(result.LayerHexes.begin(), result.LayerHexes.end()));
  for (std::size_t h = 0; h < result.Mesh.Hexes.size(); ++h)
  {
    EXPECT_EQ(result.Region[h], padded.Domain.Region[result.SourceHex[h]]);
    EXPECT_GT(result.Region[h], 0);
  }
}
}

TEST(HexPadding, ConformingAndTheBoundaryIsTheInterface)
{
  const Shape shapes[] = { Shape(Sphere(Vec3::Zero(), 1)), Shape(Torus(1.0, 0.35)),
    Shape(Together(Sphere(Vec3::Zero(), 1), Flipped(Sphere(Vec3(0.1, 0, 0), 0.5)))),
    Shape(Together(Sphere(Vec3(-1.2, 0, 0), 1), Sphere(Vec3(1.2, 0, 0), 1))) };
  for (const Shape& shape : shapes)
  {
    const Padded padded(shape, BoundingBox(shape.Surface).Size().maxCoeff() / 26);
    ExpectPromises(padded);
    const std::size_t inverted = InvertedHexes(padded.Result.Mesh).size();
    std::printf("%zu hexes, %zu inverted\n", padded.Result.Mesh.Hexes.size(), inverted);
    EXPECT_LT(inverted, 0.03 * padded.Result.Mesh.Hexes.size());
  }
}

TEST(HexPadding, OneHexBecomesSeven)
{
  HexMesh grid;
  for (int z = 0; z < 4; ++z)
  {
    for (int y = 0; y < 4; ++y)
    {
      for (int x = 0; x < 4; ++x)
      {
        grid.Points.push_back(Vec3(x, y, z));
        if (x < 3 && y < 3 && z < 3)
        {
          const Index v = x + 4 * (y + 4 * z);
          grid.Hexes.push_back({ v, v + 1, v + 5, v + 4, v + 16, v + 17, v + 21, v + 20 });
        }
      }
    }
  }
  std::vector<int> region(27, 0);
  region[13] = 4;
  PaddedMesh padded;
  ASSERT_TRUE(PadInterface(grid, region, PaddingOptions(), padded).Ok());
  EXPECT_EQ(padded.Mesh.Hexes.size(), 7u);
  EXPECT_EQ(padded.Mesh.Points.size(), 16u);
  EXPECT_TRUE(InvertedHexes(padded.Mesh).empty());
  EXPECT_EQ(padded.Region, std::vector<int>(7, 4));
  Box box;
  for (std::size_t v = 0; v < 16; ++v)
  {
    if (!padded.OnBoundary[v])
    {
      box.Extend(padded.Mesh.Points[v]);
    }
  }
  EXPECT_NEAR(box.Size()[0], 1 - 0.2 / std::sqrt(3.0), 1e-12);
}

TEST(HexPadding, NeighboursInSpaceAreNeighboursInMemory)
{
  const Shape sphere(Sphere(Vec3::Zero(), 1));
  const Padded padded(sphere, 2.0 / 26);
  const HexMesh& mesh = padded.Result.Mesh;
  std::vector<Index> identity(mesh.Points.size());
  std::iota(identity.begin(), identity.end(), 0);
  EXPECT_EQ(MortonRank(mesh.Points), identity);
  Index before = 0;
  for (const Hex& hex : mesh.Hexes)
  {
    const Index lowest = *std::min_element(hex.begin(), hex.end());
    EXPECT_GE(lowest, before);
    before = lowest;
  }
}

TEST(HexPadding, SaysWhatIsWrong)
{
  HexMesh mesh = DualMesh(Sphere(Vec3::Zero(), 1), 0.5);
  PaddedMesh padded;
  EXPECT_EQ(PadInterface(mesh, {}, PaddingOptions(), padded).Code, StatusCode::InvalidMesh);
  const std::vector<int> outside(mesh.Hexes.size(), 0);
  EXPECT_EQ(PadInterface(mesh, outside, PaddingOptions(), padded).Code, StatusCode::InvalidMesh);
  PaddingOptions flat;
  flat.Thickness = 0;
  EXPECT_EQ(PadInterface(mesh, outside, flat, padded).Code, StatusCode::InvalidOption);
}

TEST(HexPadding, BodiesThatTouchAlongAnEdgeAreRefused)
{
  const HexMesh mesh = CubeMesh(2);
  // Hexes 0 and 3 share an edge, 0 and 7 the middle point.
  for (const Index other : { 3, 7 })
  {
    std::vector<int> region(8, 0);
    region[0] = region[other] = 1;
    PaddedMesh padded;
    const Status status = PadInterface(mesh, region, PaddingOptions(), padded);
    EXPECT_EQ(status.Code, StatusCode::InvalidMesh);
    EXPECT_NE(status.Message.find("not a manifold"), std::string::npos) << status.Message;
    EXPECT_EQ(status.Where.size(), 1u);
    EXPECT_TRUE(padded.Mesh.Hexes.empty());
  }
}

// SPDX-License-Identifier: BSD-3-Clause

#include "HexValidation.h"
#include "ValidationShapes.h"

#include <gtest/gtest.h>
#include <vtkSMPTools.h>

#include <limits>
#include <map>
#include <set>

using namespace featurehex;

namespace
{
HexValidationReport Validate(
  const HexMesh& mesh, const SurfaceMesh* surface = nullptr, double tolerance = 0.005)
{
  HexValidationOptions options;
  options.Tolerance = tolerance;
  Monitor monitor;
  return ValidateHexMesh(mesh, surface, options, monitor);
}

SurfaceMesh Skin(const HexMesh& mesh)
{
  return SplitQuads(mesh.Points, ExtractBoundary(mesh).Quads);
}

std::uint32_t DefectsOf(const HexValidationReport& r, Index hex)
{
  for (const OffendingHex& o : r.Offending)
  {
    if (o.Hex == hex)
    {
      return o.Defects;
    }
  }
  return 0;
}
}

TEST(HexValidation, GoodMeshKeepsEveryPromise)
{
  const HexMesh ball = BallMesh(10);
  const SurfaceMesh sphere = SphereSurface(40);
  const HexValidationReport r = Validate(ball, &sphere, 0.01);
  EXPECT_TRUE(r.Result.Ok()) << r.Result.Message;
  EXPECT_TRUE(r.Valid());
  EXPECT_TRUE(r.Offending.empty());
  EXPECT_EQ(r.CertifiedValid, 1000);
  EXPECT_NEAR(r.Volume, r.Topology.Surface.Volume, 1e-12);
  EXPECT_GT(r.MinimumJacobianRatio, 0.0);
  EXPECT_LE(r.MinimumJacobianRatio, 1.0);
  EXPECT_TRUE(Validate(ball).Valid()); // without a surface
  // The same mesh is not within a tolerance that it misses.
  const HexValidationReport strict = Validate(ball, &sphere, 0.0005);
  EXPECT_FALSE(strict.Valid());
  EXPECT_EQ(strict.Result.Code, StatusCode::Validation);
  EXPECT_FALSE(strict.Offending.empty());
  for (const OffendingHex& o : strict.Offending)
  {
    EXPECT_EQ(o.Defects, static_cast<std::uint32_t>(BeyondTolerance));
  }
}

TEST(HexValidation, FiguresHaveUniqueNamesAndFixedOrder)
{
  const HexMesh ball = BallMesh(4);
  const SurfaceMesh sphere = SphereSurface(30);
  const auto figures = Validate(ball, &sphere).Figures();
  std::set<std::string> names;
  for (const auto& [name, value] : figures)
  {
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_TRUE(std::isfinite(value)) << name;
  }
  const auto broken = Validate({}, &sphere).Figures();
  ASSERT_EQ(broken.size(), figures.size());
  for (std::size_t i = 0; i < figures.size(); ++i)
  {
    EXPECT_EQ(figures[i].first, broken[i].first);
  }
  EXPECT_LT(Validate(ball).Figures().size(), figures.size());
}

TEST(HexValidation, EmptyAndBrokenIds)
{
  EXPECT_FALSE(Validate({}).Valid());
  HexMesh mesh = CubeMesh(2);
  mesh.Hexes[3][2] = 1000;
  const HexValidationReport r = Validate(mesh);
  EXPECT_FALSE(r.Valid());
  EXPECT_EQ(r.Result.Code, StatusCode::IndexOutOfRange);
  EXPECT_EQ(DefectsOf(r, 3), static_cast<std::uint32_t>(IdOutOfRange));

  HexMesh repeated = CubeMesh(2);
  repeated.Hexes[3][2] = repeated.Hexes[3][1];
  const HexValidationReport d = Validate(repeated);
  EXPECT_FALSE(d.Valid());
  EXPECT_TRUE(DefectsOf(d, 3) & RepeatedId);
  EXPECT_TRUE(DefectsOf(d, 3) & NonPositiveCorner);
  EXPECT_TRUE(DefectsOf(d, 3) & NotCertified);
}

TEST(HexValidation, NonFinitePoint)
{
  HexMesh mesh = CubeMesh(2);
  const SurfaceMesh skin = Skin(mesh);
  mesh.Points[mesh.Hexes[0][0]].z() = std::numeric_limits<double>::quiet_NaN();
  const HexValidationReport r = Validate(mesh, &skin);
  EXPECT_FALSE(r.Valid());
  EXPECT_EQ(r.NonFinitePoints, 1);
  EXPECT_TRUE(DefectsOf(r, 0) & NonFinitePoint);
  EXPECT_FALSE(r.FreeOfIntersections());
  EXPECT_FALSE(r.WithinTolerance());
}

TEST(HexValidation, InvertedAndOrphan)
{
  HexMesh mesh = CubeMesh(3);
  const SurfaceMesh skin = Skin(mesh);
  mesh.Points[mesh.Hexes[13][0]] += Vec3(2, 2, 2);
  mesh.Points.push_back(Vec3(1, 2, 0.5));
  const HexValidationReport r = Validate(mesh, &skin);
  EXPECT_FALSE(r.PositiveCorners());
  EXPECT_FALSE(r.Certified());
  EXPECT_FALSE(r.PureConforming());
  EXPECT_TRUE(r.Manifold());
  EXPECT_TRUE(r.WithinTolerance());
  EXPECT_TRUE(DefectsOf(r, 13) & NotCertified);
  EXPECT_NE(r.Result.Message.find("unused"), std::string::npos);
  EXPECT_FALSE(r.Result.Where.empty());
}

TEST(HexValidation, NonManifoldHexesAreNamed)
{
  const HexValidationReport r =
    Validate(LatticeMesh({ 3, 2, 1 }, [](int i, int j, int) { return i == j || i == 2; }));
  EXPECT_FALSE(r.Manifold());
  EXPECT_TRUE(r.PositiveCorners());
  // Cubes (0,0), (2,0), (1,1), (2,1): (0,0) and (2,0) touch (1,1) along an edge.
  EXPECT_TRUE(DefectsOf(r, 0) & NonManifoldBoundary);
}

TEST(HexValidation, FilledCavityIsFoundByTopologyAndVolume)
{
  const HexMesh hollow = LatticeMesh(
    { 5, 5, 5 }, [](int i, int j, int k) { return i != 2 || j != 2 || k != 2; });
  const SurfaceMesh skin = Skin(hollow);
  EXPECT_TRUE(Validate(hollow, &skin).Valid());
  const HexValidationReport filled = Validate(CubeMesh(5), &skin);
  EXPECT_FALSE(filled.Valid());
  EXPECT_FALSE(filled.TopologyMatches());
  EXPECT_FALSE(filled.WithinTolerance());
  // The void as a solid of its own: same boundary, same genera, wrong volume.
  HexMesh inverse = LatticeMesh(
    { 5, 5, 5 }, [](int i, int j, int k) { return i == 2 && j == 2 && k == 2; });
  const HexMesh cube = CubeMesh(5);
  const auto offset = static_cast<Index>(inverse.Points.size());
  inverse.Points.insert(inverse.Points.end(), cube.Points.begin(), cube.Points.end());
  for (Hex h : cube.Hexes)
  {
    for (Index& v : h)
    {
      v += offset;
    }
    inverse.Hexes.push_back(h);
  }
  const HexValidationReport solid = Validate(inverse, &skin);
  EXPECT_TRUE(solid.WithinTolerance());
  EXPECT_FALSE(solid.VolumeFits());
  EXPECT_FALSE(solid.TopologyMatches());
  EXPECT_FALSE(solid.Valid());
}

TEST(HexValidation, SelfIntersection)
{
  // Two bars that cross, each sound.
  HexMesh mesh = LatticeMesh({ 5, 3, 1 }, [](int, int j, int) { return j != 1; });
  for (Vec3& p : mesh.Points)
  {
    if (p.y() > 1.5)
    {
      p = Vec3(4.7 - p.y(), p.x() - 2.2, p.z() + 0.4);
    }
  }
  const HexValidationReport r = Validate(mesh);
  EXPECT_TRUE(r.PureConforming());
  EXPECT_TRUE(r.Certified());
  EXPECT_FALSE(r.FreeOfIntersections());
  EXPECT_FALSE(r.Valid());
  EXPECT_GT(r.SuspectQuads, 0);
  std::uint32_t all = 0;
  for (const OffendingHex& o : r.Offending)
  {
    all |= o.Defects;
  }
  EXPECT_EQ(all, static_cast<std::uint32_t>(SelfIntersecting));
}

TEST(HexValidation, StronglyTwistedQuadsAreNotBlamed)
{
  HexMesh mesh = CubeMesh(4);
  for (Vec3& p : mesh.Points)
  {
    const double a = 0.35 * p.z();
    const Vec3 q = p - Vec3(2, 2, 0);
    p = Vec3(q.x() * std::cos(a) - q.y() * std::sin(a), q.x() * std::sin(a) + q.y() * std::cos(a),
      q.z());
  }
  const HexValidationReport r = Validate(mesh);
  EXPECT_TRUE(r.Valid()) << r.Result.Message;
}

TEST(HexValidation, SameFiguresForAnyNumberOfThreads)
{
  const HexMesh ball = BallMesh(8);
  const SurfaceMesh sphere = SphereSurface(40);
  vtkSMPTools::Initialize(1);
  const auto one = Validate(ball, &sphere).Figures();
  vtkSMPTools::Initialize(2);
  EXPECT_EQ(one, Validate(ball, &sphere).Figures());
}

TEST(HexValidation, StoppedIsReported)
{
  struct Impatient : Monitor
  {
    bool AbortRequested() override { return true; }
  } monitor;
  const HexMesh ball = BallMesh(6);
  const SurfaceMesh sphere = SphereSurface(20);
  const HexValidationReport r = ValidateHexMesh(ball, &sphere, {}, monitor);
  EXPECT_EQ(r.Result.Code, StatusCode::Aborted);
  EXPECT_FALSE(r.Valid());
}

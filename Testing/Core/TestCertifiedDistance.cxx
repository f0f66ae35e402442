// SPDX-License-Identifier: BSD-3-Clause

#include "CertifiedDistance.h"

#include "DistancePieces.h"
#include "MeshTopology.h"
#include "ValidationShapes.h"

#include <gtest/gtest.h>
#include <vtkSMPTools.h>

#include <cstring>
#include <limits>
#include <random>

using namespace featurehex;

namespace
{
DistanceBounds Measure(const SurfaceMesh& surface, const HexMesh& mesh, double tolerance)
{
  Monitor monitor;
  return CertifiedDistance(surface).Measure(
    mesh.Points, ExtractBoundary(mesh).Quads, tolerance, monitor);
}

DistanceDecision Decide(const SurfaceMesh& surface, const HexMesh& mesh, double tolerance)
{
  Monitor monitor;
  return CertifiedDistance(surface).DistanceWithin(
    mesh.Points, ExtractBoundary(mesh).Quads, tolerance, monitor);
}

/// The cube of the given size as 12 triangles.
SurfaceMesh Cube(double size)
{
  HexMesh mesh = CubeMesh(1);
  for (Vec3& p : mesh.Points)
  {
    p *= size;
  }
  return SplitQuads(mesh.Points, ExtractBoundary(mesh).Quads);
}

HexMesh Moved(HexMesh mesh, const Vec3& by)
{
  for (Vec3& p : mesh.Points)
  {
    p += by;
  }
  return mesh;
}
}

TEST(CertifiedDistance, SameCubeIsZero)
{
  const DistanceBounds b = Measure(Cube(10), CubeMesh(10), 0.1);
  EXPECT_TRUE(b.Converged());
  EXPECT_LE(b.Lower(), 1e-12);
  EXPECT_LE(b.Upper(), 0.001 + 1e-9);
  EXPECT_LE(b.Mean(), 1e-12);
  EXPECT_EQ(b.SplitError, 0.0);
  EXPECT_EQ(b.Deviation.size(), 600u);
  EXPECT_TRUE(Decide(Cube(10), CubeMesh(10), 1e-3).Within);
}

TEST(CertifiedDistance, ShiftedCube)
{
  const HexMesh mesh = Moved(CubeMesh(10), Vec3(0.3, 0.4, 0));
  const DistanceBounds b = Measure(Cube(10), mesh, 0.1);
  EXPECT_TRUE(b.Converged());
  EXPECT_LE(b.Lower(), 0.5 + 1e-12);
  EXPECT_GE(b.Upper(), 0.5);
  EXPECT_LE(b.Upper() - b.Lower(), 0.0051);
  EXPECT_TRUE(Decide(Cube(10), mesh, 0.501).Within);
  const DistanceDecision no = Decide(Cube(10), mesh, 0.499);
  EXPECT_FALSE(no.Within);
  EXPECT_FALSE(no.Quads.empty());
  EXPECT_FALSE(no.Triangles.empty());
  for (const DistanceWitness& w : no.Quads)
  {
    EXPECT_GT(w.Distance, 0.499);
  }
  EXPECT_EQ(b.MeshToSurface.Witnesses.size(),
    static_cast<std::size_t>(std::count_if(b.Deviation.begin(), b.Deviation.end(),
      [](double d) { return d > 0.1 + 0.002; })));
}

TEST(CertifiedDistance, ConcentricSpheres)
{
  const double radius = 1.01;
  const SurfaceMesh sphere = SphereSurface(80);
  const HexMesh ball = BallMesh(12, radius);
  const DistanceBounds b = Measure(sphere, ball, 0.01);
  EXPECT_TRUE(b.Converged());
  EXPECT_LE(b.Upper() - b.Lower(), 0.01 * b.Lower() + 1e-9);
  // Patches and triangles lie inside the spheres of their corners.
  EXPECT_GE(b.Upper(), 0.01);
  EXPECT_LE(b.Lower(), 0.0105);
  EXPECT_NEAR(b.SurfaceToMesh.Mean, b.MeshToSurface.Mean, 0.001);
  EXPECT_FALSE(Decide(sphere, ball, 0.0099).Within);
  EXPECT_TRUE(Decide(sphere, ball, 0.011).Within);
}

/// Quads exactly in the faces of the cube, no parallelograms, 0.02 long at one corner and 3 at the
/// opposite one. With equal shares of the budget the elements at the fine corner, 0.18 in radius,
/// stay as they are.
TEST(CertifiedDistance, ElementsThatNeedMoreGetWhatTheOthersLeave)
{
  constexpr int n = 8;
  HexMesh mesh = CubeMesh(n);
  std::mt19937 random(7);
  for (Vec3& p : mesh.Points)
  {
    for (double& x : p)
    {
      if (x > 0 && x < n)
      {
        x += 0.05 * (2.0 * random() / 4294967295.0 - 1.0);
      }
      x = 10 * (x / n) * (x / n) * (x / n);
    }
  }
  constexpr double tolerance = 0.3;
  const DistanceBounds b = Measure(Cube(10), mesh, tolerance);
  EXPECT_TRUE(b.Converged());
  EXPECT_LE(b.Lower(), 1e-12 * 10 * std::sqrt(3.0));
  EXPECT_LE(b.Upper(), 0.01 * tolerance + 1e-9);
  // Flat quads are the union of their triangles however skew they are.
  EXPECT_LE(b.SplitError, 1e-12);
}

TEST(CertifiedDistance, TrianglesOfAPatchAreAsNearAsTheirError)
{
  std::mt19937 random(3);
  const auto jitter = [&random](double size)
  { return size * (2.0 * random() / 4294967295.0 - 1.0); };
  int planar = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    const double height = trial % 4 == 0 ? 0.0 : jitter(0.3);
    Vec3 p[4] = { Vec3(0, 0, height), Vec3(1, 0, 0), Vec3(1, 1, jitter(0.05)), Vec3(0, 1, 0) };
    for (Vec3& corner : p)
    {
      corner += Vec3(jitter(0.4), jitter(0.4), 0);
    }
    const double error = TriangleError(p, 0.25);
    const Vec3 twist = p[0] - p[1] + p[2] - p[3];
    EXPECT_LE(error, 0.25 * twist.norm());
    planar += error < 0.2 * twist.norm() ? 1 : 0;
    const TriangleSearch triangles({ p[0], p[1], p[2], p[3] }, { { 0, 1, 2 }, { 0, 2, 3 } });
    constexpr int n = 12;
    std::vector<Vec3> points;
    std::vector<Triangle> fine;
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        const double u = static_cast<double>(i) / n;
        const double v = static_cast<double>(j) / n;
        points.push_back((1 - v) * ((1 - u) * p[0] + u * p[1]) + v * ((1 - u) * p[3] + u * p[2]));
        EXPECT_LE(triangles.Closest(points.back()).Distance, error + 1e-12);
        if (i > 0 && j > 0)
        {
          const Index last = static_cast<Index>(points.size()) - 1;
          fine.push_back({ last - n - 2, last - n - 1, last });
          fine.push_back({ last - n - 2, last, last - 1 });
        }
      }
    }
    // The other way, against a fine triangulation of the patch.
    const TriangleSearch patch(points, fine);
    const double fineError = 0.25 * twist.norm() / (n * n);
    for (int i = 0; i <= n; ++i)
    {
      const double u = static_cast<double>(i) / n;
      for (const Vec3& x :
        { Vec3((1 - u) * p[0] + u * p[2]), Vec3((p[0] + u * p[1] + (1 - u) * p[2]) / 2),
          Vec3((p[0] + u * p[3] + (1 - u) * p[2]) / 2) })
      {
        EXPECT_LE(patch.Closest(x).Distance, error + fineError + 1e-12);
      }
    }
  }
  EXPECT_GT(planar, 40);
}

TEST(CertifiedDistance, OneDirectionOnly)
{
  // A mesh on half of the surface is near it, but the surface isn't near the mesh.
  const HexMesh half =
    LatticeMesh({ 10, 10, 10 }, [](int i, int, int) { return i < 5; });
  const DistanceBounds b = Measure(Cube(10), half, 0.1);
  EXPECT_NEAR(b.SurfaceToMesh.Lower, 5.0, 0.05);
  EXPECT_GE(b.SurfaceToMesh.Upper, 5.0);
  EXPECT_NEAR(b.MeshToSurface.Lower, 5.0, 0.05); // the middle of the cut
  EXPECT_NEAR(b.SurfaceToMesh.Where.x(), 10.0, 0.5);
}

TEST(CertifiedDistance, TwistedPatchAgainstDenseSamples)
{
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  for (int n = 0; n < 8; ++n)
  {
    HexMesh mesh = CubeMesh(2);
    for (Vec3& p : mesh.Points)
    {
      p += Vec3(uniform(random), uniform(random), uniform(random));
    }
    const SurfaceMesh surface = SphereSurface(12, 1.2, Vec3(1, 1, 1));
    const TriangleSearch search(surface.Points, surface.Triangles);
    const std::vector<Quad> quads = ExtractBoundary(mesh).Quads;
    const DistanceBounds b = Measure(surface, mesh, 0.05);
    EXPECT_TRUE(b.Converged());
    EXPECT_LE(b.Upper() - b.Lower(), 0.01 * std::max(0.05, b.Lower()) + 1e-9);
    double forward = 0;
    SurfaceMesh fine;
    for (std::size_t q = 0; q < quads.size(); ++q)
    {
      double here = 0;
      const int m = 24;
      const auto base = static_cast<Index>(fine.Points.size());
      for (int i = 0; i <= m; ++i)
      {
        for (int j = 0; j <= m; ++j)
        {
          const double u = double(i) / m, v = double(j) / m;
          const Vec3 x =
            (1 - v) * ((1 - u) * mesh.Points[quads[q][0]] + u * mesh.Points[quads[q][1]]) +
            v * ((1 - u) * mesh.Points[quads[q][3]] + u * mesh.Points[quads[q][2]]);
          here = std::max(here, search.Closest(x).Distance);
          fine.Points.push_back(x);
          if (i < m && j < m)
          {
            const Index a = base + i * (m + 1) + j;
            fine.Triangles.push_back({ a, a + m + 1, a + m + 2 });
            fine.Triangles.push_back({ a, a + m + 2, a + 1 });
          }
        }
      }
      EXPECT_GE(b.Deviation[q], here - 1e-12);
      EXPECT_LE(b.DeviationFound[q], b.Deviation[q]);
      forward = std::max(forward, here);
    }
    EXPECT_GE(b.MeshToSurface.Upper, forward);
    EXPECT_NEAR(b.MeshToSurface.Lower, forward, 0.01);
    const TriangleSearch back(fine.Points, fine.Triangles);
    double backward = 0;
    for (const Triangle& t : surface.Triangles)
    {
      const int m = 12;
      for (int i = 0; i <= m; ++i)
      {
        for (int j = 0; i + j <= m; ++j)
        {
          const Vec3 x = (i * surface.Points[t[0]] + j * surface.Points[t[1]] +
                           (m - i - j) * surface.Points[t[2]]) / m;
          backward = std::max(backward, back.Closest(x).Distance);
        }
      }
    }
    EXPECT_GE(b.SurfaceToMesh.Upper, backward - 0.001);
    EXPECT_NEAR(b.SurfaceToMesh.Lower, backward, 0.01);
  }
}

TEST(CertifiedDistance, DecisionAgreesWithValue)
{
  std::mt19937 random(9);
  std::uniform_real_distribution<double> uniform(0.97, 1.03);
  HexMesh ball = BallMesh(10);
  for (Vec3& p : ball.Points)
  {
    p *= uniform(random);
  }
  const SurfaceMesh sphere = SphereSurface(40);
  const DistanceBounds b = Measure(sphere, ball, 0.02);
  EXPECT_TRUE(b.Converged());
  EXPECT_FALSE(Decide(sphere, ball, 0.999 * b.Lower()).Within);
  EXPECT_TRUE(Decide(sphere, ball, 1.03 * b.Upper()).Within);
}

TEST(CertifiedDistance, HugeOffset)
{
  // 2^30: the shapes keep their exact coordinates.
  const Vec3 offset = Vec3::Constant(1073741824.0);
  SurfaceMesh cube = Cube(10);
  for (Vec3& p : cube.Points)
  {
    p += offset;
  }
  const DistanceBounds b = Measure(cube, Moved(CubeMesh(10), offset + Vec3(0.25, 0, 0)), 0.1);
  EXPECT_TRUE(b.Converged());
  EXPECT_NEAR(b.Lower(), 0.25, 1e-9);
  EXPECT_NEAR(b.Upper(), 0.25, 0.0026);
}

TEST(CertifiedDistance, HopelessInputsAreNeverWithin)
{
  const SurfaceMesh cube = Cube(1);
  Monitor monitor;
  const CertifiedDistance distance(cube);
  EXPECT_FALSE(distance.DistanceWithin({}, {}, 1.0, monitor).Within);
  EXPECT_FALSE(distance.Measure({}, {}, 1.0, monitor).Converged());
  EXPECT_EQ(distance.Measure({}, {}, 1.0, monitor).Upper(), 1e300);
  HexMesh mesh = CubeMesh(1);
  mesh.Points[2].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(Decide(cube, mesh, 1.0).Within);
  EXPECT_FALSE(Measure(cube, mesh, 1.0).Converged());
  EXPECT_FALSE(Decide({}, CubeMesh(1), 1.0).Within);
  EXPECT_FALSE(Decide(cube, Moved(CubeMesh(1), Vec3(1e6, 0, 0)), 0.01).Within);
  EXPECT_NEAR(Measure(cube, Moved(CubeMesh(1), Vec3(1e6, 0, 0)), 0.01).Lower(), 1e6, 2.0);
}

TEST(CertifiedDistance, StoppedIsNotWithin)
{
  struct Impatient : Monitor
  {
    bool AbortRequested() override { return true; }
  } monitor;
  const CertifiedDistance distance(Cube(10));
  const HexMesh mesh = CubeMesh(10);
  const std::vector<Quad> quads = ExtractBoundary(mesh).Quads;
  EXPECT_FALSE(distance.DistanceWithin(mesh.Points, quads, 1.0, monitor).Within);
  const DistanceBounds b = distance.Measure(mesh.Points, quads, 1.0, monitor);
  EXPECT_FALSE(b.Converged());
  EXPECT_EQ(b.Upper(), 1e300);
}

TEST(CertifiedDistance, SameBitsForAnyNumberOfThreads)
{
  const SurfaceMesh sphere = SphereSurface(40);
  const HexMesh ball = BallMesh(8, 1.01);
  vtkSMPTools::Initialize(1);
  const DistanceBounds one = Measure(sphere, ball, 0.01);
  vtkSMPTools::Initialize(2);
  const DistanceBounds two = Measure(sphere, ball, 0.01);
  EXPECT_EQ(one.Deviation, two.Deviation);
  const double a[] = { one.Lower(), one.Upper(), one.MeshToSurface.Mean, one.SurfaceToMesh.Mean };
  const double b[] = { two.Lower(), two.Upper(), two.MeshToSurface.Mean, two.SurfaceToMesh.Mean };
  EXPECT_EQ(std::memcmp(a, b, sizeof(a)), 0);
  EXPECT_EQ(one.MeshToSurface.Pieces, two.MeshToSurface.Pieces);
}

TEST(CertifiedDistance, WitnessesAreWhereTheySayTheyAre)
{
  const SurfaceMesh sphere = SphereSurface(40);
  HexMesh ball = BallMesh(8);
  for (Vec3& p : ball.Points)
  {
    p.x() *= p.x() > 0.5 ? 1.2 : 1.0; // a bump
  }
  const TriangleSearch search(sphere.Points, sphere.Triangles);
  const DistanceDecision d = Decide(sphere, ball, 0.05);
  const DistanceBounds b = Measure(sphere, ball, 0.05);
  ASSERT_FALSE(d.Quads.empty());
  ASSERT_FALSE(b.MeshToSurface.Witnesses.empty());
  for (const auto& witnesses : { d.Quads, b.MeshToSurface.Witnesses })
  {
    for (const DistanceWitness& w : witnesses)
    {
      EXPECT_GT(w.Distance, 0.05);
      EXPECT_NEAR(search.Closest(w.Point).Distance, w.Distance, 2e-4);
      EXPECT_GT(w.Point.x(), 0.4);
    }
  }
  EXPECT_NEAR(search.Closest(b.MeshToSurface.Where).Distance, b.MeshToSurface.Lower, 1e-9);
}

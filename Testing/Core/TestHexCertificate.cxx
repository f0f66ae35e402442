// SPDX-License-Identifier: BSD-3-Clause

#include "HexCertificate.h"
#include "HexQuality.h"
#include "ValidationShapes.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

using namespace featurehex;

namespace
{
std::array<Vec3, 8> Corners(const HexMesh& mesh, Index hex)
{
  std::array<Vec3, 8> p;
  for (int i = 0; i < 8; ++i)
  {
    p[i] = mesh.Points[mesh.Hexes[hex][i]];
  }
  return p;
}

std::array<Vec3, 8> UnitCube()
{
  return Corners(CubeMesh(1), 0);
}

/// Jacobian determinant of the trilinear map at (u, v, w), by the definition.
double Determinant(const std::array<Vec3, 8>& p, double u, double v, double w)
{
  Mat3 j = Mat3::Zero();
  for (int i = 0; i < 8; ++i)
  {
    const int a = (i & 1) ^ (i >> 1 & 1), b = i >> 1 & 1, c = i >> 2;
    const double fu = a ? u : 1 - u, fv = b ? v : 1 - v, fw = c ? w : 1 - w;
    j.col(0) += (a ? 1 : -1) * fv * fw * p[i];
    j.col(1) += (b ? 1 : -1) * fu * fw * p[i];
    j.col(2) += (c ? 1 : -1) * fu * fv * p[i];
  }
  return j.determinant();
}

double Bezier(const std::array<double, 27>& c, double u, double v, double w)
{
  const auto basis = [](int i, double t) {
    return i == 0 ? (1 - t) * (1 - t) : i == 1 ? 2 * t * (1 - t) : t * t;
  };
  double sum = 0;
  for (int n = 0; n < 27; ++n)
  {
    sum += c[n] * basis(n % 3, u) * basis(n / 3 % 3, v) * basis(n / 9, w);
  }
  return sum;
}

/// Unit cube with every coordinate moved by at most @a amount.
std::array<Vec3, 8> Perturbed(std::mt19937& random, double amount)
{
  std::uniform_real_distribution<double> uniform(-amount, amount);
  std::array<Vec3, 8> p = UnitCube();
  for (Vec3& v : p)
  {
    v += Vec3(uniform(random), uniform(random), uniform(random));
  }
  return p;
}

double SampledMinimum(const std::array<Vec3, 8>& p, int n)
{
  double least = 1e300;
  for (int i = 0; i <= n; ++i)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int k = 0; k <= n; ++k)
      {
        least = std::min(least, Determinant(p, double(i) / n, double(j) / n, double(k) / n));
      }
    }
  }
  return least;
}
}

TEST(HexCertificate, CoefficientsReproduceTheDeterminant)
{
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (int n = 0; n < 200; ++n)
  {
    const std::array<Vec3, 8> p = Perturbed(random, 0.6);
    const std::array<double, 27> c = BezierJacobian(p);
    const double u = uniform(random), v = uniform(random), w = uniform(random);
    EXPECT_NEAR(Bezier(c, u, v, w), Determinant(p, u, v, w), 1e-13);
  }
}

TEST(HexCertificate, CubeAtEveryScaleAndOffset)
{
  for (double scale : { 1e-250, 1e-9, 1.0, 1e9, 1e90 })
  {
    std::array<Vec3, 8> p = UnitCube();
    for (Vec3& v : p)
    {
      v *= scale;
    }
    const HexCertificate c = CertifyHex(p);
    EXPECT_EQ(c.State, Validity::Valid) << scale;
    EXPECT_NEAR(c.Volume, scale * scale * scale, 1e-12 * scale * scale * scale);
  }
  std::array<Vec3, 8> p = UnitCube();
  for (Vec3& v : p)
  {
    v += Vec3::Constant(1e12);
  }
  const HexCertificate c = CertifyHex(p);
  EXPECT_EQ(c.State, Validity::Valid);
  EXPECT_NEAR(c.Ratio(), 1.0, 1e-12);
}

TEST(HexCertificate, PositiveCornersNegativeInside)
{
  // Search for hexes whose corners are all clearly positive while a point on an edge or inside is
  // negative: the trap of corner checks.
  std::mt19937 random(7);
  int traps = 0;
  for (int n = 0; n < 20000; ++n)
  {
    const std::array<Vec3, 8> p = Perturbed(random, 0.6);
    const std::array<double, 27> c = BezierJacobian(p);
    double corner = 1e300;
    for (int k : { 0, 2, 6, 8, 18, 20, 24, 26 })
    {
      corner = std::min(corner, c[k]);
    }
    if (corner > 0.02 && SampledMinimum(p, 8) < -0.001)
    {
      ++traps;
      EXPECT_EQ(CertifyHex(p).State, Validity::Invalid);
    }
  }
  EXPECT_GT(traps, 10);
}

TEST(HexCertificate, AgreesWithDenseSamples)
{
  std::mt19937 random(3);
  int valid = 0, subdivided = 0;
  for (int n = 0; n < 2000; ++n)
  {
    const std::array<Vec3, 8> p = Perturbed(random, 0.45);
    const HexCertificate c = CertifyHex(p);
    const double sampled = SampledMinimum(p, 10);
    EXPECT_NE(c.State, Validity::Undecided);
    if (c.State == Validity::Valid)
    {
      ++valid;
      const std::array<double, 27> b = BezierJacobian(p);
      subdivided += *std::min_element(b.begin(), b.end()) <= 0;
      EXPECT_GT(c.LowerBound, 0.0);
      EXPECT_LE(c.LowerBound, sampled);
    }
    else
    {
      EXPECT_LT(c.LowerBound, 0.0);
      EXPECT_LT(sampled, 0.05);
    }
  }
  EXPECT_GT(valid, 200);
  EXPECT_GT(subdivided, 0);
}

TEST(HexCertificate, InvalidInputs)
{
  HexMesh mesh = CubeMesh(1);
  mesh.Points[0].x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(CertifyHex(mesh, 0).State, Validity::Invalid);
  mesh.Points[0].x() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(CertifyHex(mesh, 0).State, Validity::Invalid);
  EXPECT_EQ(CertifyHex(mesh, 0).Ratio(), -1e300 / 1e300);

  HexMesh repeated = CubeMesh(1);
  repeated.Hexes[0][5] = repeated.Hexes[0][6];
  EXPECT_EQ(CertifyHex(repeated, 0).State, Validity::Invalid);
  repeated.Hexes[0][5] = 99;
  EXPECT_EQ(CertifyHex(repeated, 0).State, Validity::Invalid);

  std::array<Vec3, 8> mirrored = UnitCube();
  for (Vec3& p : mirrored)
  {
    p.z() = -p.z();
  }
  EXPECT_EQ(CertifyHex(mirrored).State, Validity::Invalid);

  std::array<Vec3, 8> point;
  point.fill(Vec3::Ones());
  EXPECT_EQ(CertifyHex(point).State, Validity::Invalid);
}

TEST(HexCertificate, ExactlySingularIsNeverValid)
{
  // A corner of three coplanar edges: determinant zero there, positive elsewhere.
  std::array<Vec3, 8> p = UnitCube();
  p[0] = Vec3(1.0, 1.0, 1.0) / 3.0;
  EXPECT_NE(CertifyHex(p).State, Validity::Valid);
  // Flat everywhere.
  p = UnitCube();
  for (Vec3& v : p)
  {
    v.z() = 0.25 * v.x();
  }
  EXPECT_NE(CertifyHex(p).State, Validity::Valid);
}

TEST(HexCertificate, WholeMesh)
{
  HexMesh ball = BallMesh(6);
  double volume = 0;
  for (const HexCertificate& c : CertifyHexes(ball))
  {
    EXPECT_EQ(c.State, Validity::Valid);
    volume += c.Volume;
  }
  EXPECT_NEAR(volume, 4.18879, 0.2);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "HexOptimizer.h"

#include "TangledMesh.h"

#include <gtest/gtest.h>

#include <vtkSMPTools.h>

using namespace featurehex;

namespace
{
double TermValue(const SurfaceTerm& term, const Vec3& p)
{
  const Vec3 d = p - term.Target;
  const double nd = term.Normal.dot(d);
  return term.Weight * (nd * nd + term.Tether * d.squaredNorm());
}

/// What the optimiser minimises, summed anew from its definition.
double Energy(const HexMesh& mesh, const HexStars& stars, const HexOptimizer& optimizer)
{
  double energy = 0;
  for (const Hex& hex : mesh.Hexes)
  {
    for (int c = 0; c < 8; ++c)
    {
      Mat3 frame;
      for (int k = 0; k < 3; ++k)
      {
        frame.col(k) = mesh.Points[hex[HexCornerNeighbors[c][k]]] - mesh.Points[hex[c]];
      }
      energy += std::pow(frame.norm(), 3) / (std::pow(3.0, 1.5) * frame.determinant());
    }
  }
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    energy += TermValue(optimizer.VertexTerms[v], mesh.Points[v]);
  }
  for (std::size_t q = 0; q < stars.Quads.size(); ++q)
  {
    for (const QuadTerm& term : { optimizer.CentroidTerms[q], optimizer.ReverseTerms[q] })
    {
      Vec3 p = Vec3::Zero();
      for (int k = 0; k < 4; ++k)
      {
        p += term.Weights[k] * mesh.Points[stars.Quads[q][k]];
      }
      energy += TermValue(term.Term, p);
    }
  }
  return energy;
}

/// Draws the boundary of a lattice cube to a sphere of radius 0.6 n round its centre.
void DrawToSphere(const HexMesh& mesh, const HexStars& stars, int n, HexOptimizer& optimizer)
{
  const Vec3 center = Vec3::Constant(0.5 * n);
  const auto term = [&](const Vec3& p) {
    SurfaceTerm result;
    result.Normal = (p - center).normalized();
    result.Target = center + 0.6 * n * result.Normal;
    result.Weight = 3.0;
    result.Tether = 0.02;
    return result;
  };
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    if (stars.OnBoundary(static_cast<Index>(v)))
    {
      optimizer.VertexTerms[v] = term(mesh.Points[v]);
    }
  }
  for (std::size_t q = 0; q < stars.Quads.size(); ++q)
  {
    const Quad& quad = stars.Quads[q];
    optimizer.CentroidTerms[q].Term = term(0.25 *
      (mesh.Points[quad[0]] + mesh.Points[quad[1]] + mesh.Points[quad[2]] + mesh.Points[quad[3]]));
    QuadTerm& reverse = optimizer.ReverseTerms[q];
    reverse.Weights = { 0.4, 0.3, 0.2, 0.1 };
    reverse.Term = term(0.4 * mesh.Points[quad[0]] + 0.3 * mesh.Points[quad[1]] +
      0.2 * mesh.Points[quad[2]] + 0.1 * mesh.Points[quad[3]]);
  }
}

/// A valid grid that is not at rest.
HexMesh RoughGrid(int n)
{
  HexMesh mesh = TangledGrid(n, 0.15);
  const HexStars stars(mesh);
  EXPECT_GT(HexOptimizer(mesh, stars).LeastDeterminant(), 0);
  return mesh;
}
}

TEST(HexOptimizer, EnergyNeverRisesAndTheMeshStaysValid)
{
  HexMesh mesh = RoughGrid(7);
  const HexStars stars(mesh);
  HexOptimizer optimizer(mesh, stars);
  DrawToSphere(mesh, stars, 7, optimizer);
  double energy = Energy(mesh, stars, optimizer);
  const double first = energy;
  for (int sweep = 0; sweep < 30; ++sweep)
  {
    optimizer.Sweep(-1.0);
    const double now = Energy(mesh, stars, optimizer);
    EXPECT_LE(now, energy * (1 + 1e-12)) << "sweep " << sweep;
    EXPECT_GT(optimizer.LeastDeterminant(), 0);
    energy = now;
  }
  EXPECT_LT(energy, 0.9 * first);
}

TEST(HexOptimizer, EndsWhereTheGradientVanishes)
{
  HexMesh mesh = RoughGrid(5);
  const HexStars stars(mesh);
  HexOptimizer optimizer(mesh, stars);
  DrawToSphere(mesh, stars, 5, optimizer);
  for (int sweep = 0; sweep < 400; ++sweep)
  {
    optimizer.ActivateAll();
    if (optimizer.Sweep(-1.0) == 0)
    {
      break;
    }
  }
  constexpr double step = 1e-4;
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double x = mesh.Points[v][k];
      mesh.Points[v][k] = x + step;
      const double above = Energy(mesh, stars, optimizer);
      mesh.Points[v][k] = x - step;
      const double below = Energy(mesh, stars, optimizer);
      mesh.Points[v][k] = x;
      EXPECT_NEAR((above - below) / (2 * step), 0, 5e-3) << "vertex " << v;
    }
  }
}

TEST(HexOptimizer, FixedVerticesStay)
{
  HexMesh mesh = RoughGrid(6);
  const std::vector<Vec3> before = mesh.Points;
  const HexStars stars(mesh);
  HexOptimizer held(mesh, stars);
  for (std::size_t v = 0; v < mesh.Points.size(); v += 3)
  {
    held.Fixed[v] = true;
  }
  EXPECT_GT(held.Sweep(-1.0), 0u);
  held.ActivateAll();
  held.Sweep(0.1);
  for (std::size_t v = 0; v < mesh.Points.size(); v += 3)
  {
    EXPECT_EQ(mesh.Points[v], before[v]);
  }
}

TEST(HexOptimizer, OnlyActiveVerticesMove)
{
  HexMesh mesh = RoughGrid(8);
  const HexStars stars(mesh);
  HexOptimizer optimizer(mesh, stars);
  for (int sweep = 0; sweep < 400 && optimizer.Sweep(-1.0) > 0; ++sweep)
  {
  }
  EXPECT_EQ(optimizer.Sweep(-1.0), 0u) << "at rest, nothing is active";
  optimizer.ActivateBoundary();
  const std::vector<Vec3> before = mesh.Points;
  DrawToSphere(mesh, stars, 8, optimizer);
  EXPECT_GT(optimizer.Sweep(-1.0), 0u);
  EXPECT_NE(mesh.Points, before);
}

TEST(HexOptimizer, LeastDeterminantPassesOverCornersThatCannotMove)
{
  HexMesh mesh = CubeMesh(4);
  const HexStars stars(mesh);
  mesh.Points[0] = Vec3(1.5, 1.5, 1.5);
  HexOptimizer optimizer(mesh, stars);
  EXPECT_LT(optimizer.LeastDeterminant(), 0);
  EXPECT_FALSE(optimizer.Hopeless(0));
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    optimizer.Fixed[v] = stars.OnBoundary(static_cast<Index>(v));
  }
  EXPECT_TRUE(optimizer.Hopeless(0));
  EXPECT_FALSE(optimizer.Hopeless(1));
}

TEST(HexOptimizer, UntanglingReducesInvertedCorners)
{
  HexMesh mesh = TangledGrid(6, 1.0);
  const HexStars stars(mesh);
  HexOptimizer optimizer(mesh, stars);
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    optimizer.Fixed[v] = stars.OnBoundary(static_cast<Index>(v));
  }
  EXPECT_LT(optimizer.LeastDeterminant(), 0);
  for (int sweep = 0; sweep < 20; ++sweep)
  {
    optimizer.ActivateAll();
    optimizer.Sweep(0.05);
  }
  EXPECT_GT(optimizer.LeastDeterminant(), 0);
}

TEST(HexOptimizer, SameBitsForAnyNumberOfThreads)
{
  std::vector<std::vector<Vec3>> results;
  for (int threads : { 1, 2 })
  {
    HexMesh mesh = RoughGrid(16);
    const HexStars stars(mesh);
    HexOptimizer optimizer(mesh, stars);
    DrawToSphere(mesh, stars, 16, optimizer);
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads }, [&] {
      for (int sweep = 0; sweep < 5; ++sweep)
      {
        optimizer.Sweep(-1.0);
      }
    });
    results.push_back(mesh.Points);
  }
  EXPECT_EQ(results[0], results[1]);
}

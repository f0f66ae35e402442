// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceGeometry.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace featurehex;

namespace
{
/// A tetrahedron over the triangle, flat enough not to matter.
SurfaceMesh Tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c)
{
  SurfaceMesh surface;
  surface.Points = { a, b, c, (a + b + c) / 3 + 1e-3 * (b - a).cross(c - a).normalized() };
  surface.Triangles = { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } };
  return surface;
}

double FarthestFromSamples(const SurfaceMesh& surface, const std::vector<Vec3>& samples)
{
  double farthest = 0;
  const Triangle& t = surface.Triangles[0];
  for (int i = 0; i <= 20; ++i)
  {
    for (int j = 0; i + j <= 20; ++j)
    {
      const Vec3 p = (surface.Points[t[0]] * i + surface.Points[t[1]] * j +
                       surface.Points[t[2]] * (20 - i - j)) /
        20;
      double nearest = 1e300;
      for (const Vec3& sample : samples)
      {
        nearest = std::min(nearest, (sample - p).norm());
      }
      farthest = std::max(farthest, nearest);
    }
  }
  return farthest;
}
}

TEST(SurfaceGeometry, SamplesAreNotFartherApartThanTheSpacing)
{
  const SurfaceMesh shapes[] = { Tetrahedron({ 0, 0, 0 }, { 1, 0, 0 }, { 0.4, 0.9, 0 }),
    Tetrahedron({ 0, 0, 0 }, { 3, 0, 0 }, { 1.5, 0.12, 0 }),
    Tetrahedron({ 0, 0, 0 }, { 0.2, 0.1, 0.3 }, { 2, 2, 2 }) };
  for (const SurfaceMesh& surface : shapes)
  {
    for (double spacing : { 0.3, 0.1, 0.05 })
    {
      EXPECT_LE(
        FarthestFromSamples(surface, SurfaceGeometry(surface).Samples(spacing)), spacing);
    }
  }
}

TEST(SurfaceGeometry, ASliverGetsNoMoreSamplesThanItsEdgesNeed)
{
  const SurfaceMesh surface = Tetrahedron({ 0, 0, 0 }, { 10, 0, 0 }, { 5, 0.01, 0 });
  // Three edges of 10, 5 and 5, three short cuts to the middle, and four points.
  EXPECT_LE(SurfaceGeometry(surface).Samples(0.1).size(), 350u);
}

TEST(SurfaceGeometry, SpacingMayChangeAlongATriangle)
{
  const SurfaceMesh mesh = Tetrahedron({ 0, 0, 0 }, { 8, 0, 0 }, { 0, 8, 0 });
  const SurfaceGeometry surface{ SurfaceMesh(mesh) };
  const auto spacing = [](const Vec3& p, Index&) { return p[0] < 4 ? 0.1 : 0.8; };
  const std::vector<Vec3> samples = surface.Samples(spacing);
  const auto near = [&samples](const Vec3& p) {
    double nearest = 1e300;
    for (const Vec3& sample : samples)
    {
      nearest = std::min(nearest, (sample - p).norm());
    }
    return nearest;
  };
  for (double y : { 0.33, 1.21, 2.07 })
  {
    EXPECT_LE(near(Vec3(1.03, y, 0)), 0.1);
    EXPECT_LE(near(Vec3(5.03, y, 0)), 0.8);
  }
  EXPECT_LT(samples.size(), surface.Samples(0.1).size() * 0.9);
}

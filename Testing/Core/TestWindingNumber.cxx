// SPDX-License-Identifier: BSD-3-Clause
#include "WindingNumber.h"

#include "DomainShapes.h"

#include <random>

using namespace domainshapes;

namespace
{
/// Sum of all solid angles, without the tree.
double ExactWinding(const SurfaceMesh& surface, const Vec3& p)
{
  double sum = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    const Vec3 a = (surface.Points[t[0]] - p).normalized();
    const Vec3 b = (surface.Points[t[1]] - p).normalized();
    const Vec3 c = (surface.Points[t[2]] - p).normalized();
    sum += 2 * std::atan2(a.dot(b.cross(c)), 1 + a.dot(b) + b.dot(c) + c.dot(a));
  }
  return sum / (4 * Pi);
}
}

TEST(WindingNumber, AgreesWithTheExactSum)
{
  const SurfaceMesh torus = Torus(1.0, 0.3);
  const WindingNumber winding(torus);
  std::mt19937 random(1);
  std::uniform_real_distribution<double> side(-1.5, 1.5);
  double worst = 0.0;
  for (int i = 0; i < 2000; ++i)
  {
    const Vec3 p(side(random), side(random), 0.4 * side(random));
    const double exact = ExactWinding(torus, p);
    worst = std::max(worst, std::abs(winding.At(p) - exact));
    EXPECT_EQ(winding.Inside(p), exact > 0.5);
  }
  std::printf("worst error of the tree: %.4f\n", worst);
  EXPECT_LT(worst, 0.05);
}

TEST(WindingNumber, RightNextToTheSurface)
{
  const SurfaceMesh sphere = Sphere(Vec3(1, 2, 3), 2.0);
  const WindingNumber winding(sphere);
  for (const Triangle& t : sphere.Triangles)
  {
    const Vec3& a = sphere.Points[t[0]];
    const Vec3& b = sphere.Points[t[1]];
    const Vec3& c = sphere.Points[t[2]];
    const Vec3 middle = (a + b + c) / 3.0;
    const Vec3 normal = (b - a).cross(c - a).normalized();
    EXPECT_TRUE(winding.Inside(middle - 1e-6 * normal));
    EXPECT_FALSE(winding.Inside(middle + 1e-6 * normal));
  }
}

TEST(WindingNumber, CavitiesAndNestedSolids)
{
  const SurfaceMesh hollow =
    Together(Sphere(Vec3::Zero(), 3), Flipped(Sphere(Vec3::Zero(), 2)));
  const SurfaceMesh surface = Together(hollow, Sphere(Vec3::Zero(), 1));
  const WindingNumber winding(surface);
  EXPECT_TRUE(winding.Inside(Vec3(0, 0, 0.3)));
  EXPECT_FALSE(winding.Inside(Vec3(0, 1.5, 0)));
  EXPECT_TRUE(winding.Inside(Vec3(2.5, 0, 0)));
  EXPECT_FALSE(winding.Inside(Vec3(3.5, 0, 0)));
}

TEST(WindingNumber, EmptySurface)
{
  EXPECT_EQ(WindingNumber().At(Vec3::Zero()), 0.0);
  EXPECT_EQ(WindingNumber(SurfaceMesh()).At(Vec3::Zero()), 0.0);
}

TEST(WindingNumber, CoincidentTrianglesDontRecurseForever)
{
  SurfaceMesh surface = BoxSurface(Vec3::Zero(), Vec3::Ones());
  const std::vector<Triangle> box = surface.Triangles;
  for (int i = 0; i < 50; ++i)
  {
    surface.Triangles.insert(surface.Triangles.end(), box.begin(), box.end());
  }
  EXPECT_NEAR(WindingNumber(surface).At(Vec3::Constant(0.5)), 51.0, 0.5);
}

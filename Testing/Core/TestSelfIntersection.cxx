// SPDX-License-Identifier: BSD-3-Clause
#include "SelfIntersection.h"

#include <gtest/gtest.h>

#include <vtkSMPTools.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <random>

using namespace featurehex;

namespace
{
bool Meet(const std::vector<Vec3>& points, const Triangle& s, const Triangle& t)
{
  return !FindSelfIntersections(points, { s, t }).empty();
}

using Whole = Eigen::Matrix<long long, 3, 1>;

/// Strict separation of the convex hulls along one direction.
bool Separates(const Whole& axis, const std::vector<Whole>& a, const std::vector<Whole>& b)
{
  const auto range = [&axis](const std::vector<Whole>& points)
  {
    long long low = axis.dot(points[0]), high = low;
    for (const Whole& p : points)
    {
      low = std::min(low, axis.dot(p));
      high = std::max(high, axis.dot(p));
    }
    return std::make_pair(low, high);
  };
  const auto ra = range(a);
  const auto rb = range(b);
  return ra.second < rb.first || rb.second < ra.first;
}

/// Separating axes of two flat convex polygons in integers: normals, products of edges, and edge
/// normals in the plane. Shares nothing with the code under test.
bool PolygonsMeet(const std::vector<Whole>& a, const std::vector<Whole>& b)
{
  const Whole na = (a[1] - a[0]).cross(a[2] - a[0]);
  const Whole nb = (b[1] - b[0]).cross(b[2] - b[0]);
  std::vector<Whole> axes = { na, nb };
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const Whole ea = a[(i + 1) % a.size()] - a[i];
    axes.push_back(na.cross(ea));
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const Whole eb = b[(j + 1) % b.size()] - b[j];
      axes.push_back(ea.cross(eb));
      axes.push_back(nb.cross(eb));
    }
  }
  return std::none_of(
    axes.begin(), axes.end(), [&](const Whole& axis) { return Separates(axis, a, b); });
}

Vec3 ToDouble(const Whole& p)
{
  return p.cast<double>();
}

/// A grid of n x n squares, each as two triangles, at height z(x, y).
template <typename Height>
void AddGrid(int n, const Height& z, std::vector<Vec3>& points, std::vector<Triangle>& triangles)
{
  const Index base = static_cast<Index>(points.size());
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const double x = static_cast<double>(i) / n, y = static_cast<double>(j) / n;
      points.push_back(Vec3(x, y, z(x, y)));
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const Index a = base + j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
      triangles.push_back({ a, b, d });
      triangles.push_back({ a, d, c });
    }
  }
}
} // namespace

TEST(SelfIntersection, SeparateTriangles)
{
  const Vec3 a(0, 0, 0), b(4, 0, 0), c(0, 4, 0);
  const auto meet = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
    return Meet({ a, b, c, p, q, r }, { 0, 1, 2 }, { 3, 4, 5 });
  };
  EXPECT_TRUE(meet(Vec3(1, 1, -1), Vec3(1, 1, 1), Vec3(5, 5, 1)));      // pierces
  EXPECT_FALSE(meet(Vec3(1, 1, 1e-80), Vec3(1, 1, 1), Vec3(5, 5, 1))); // just above
  EXPECT_TRUE(meet(Vec3(1, 1, 0), Vec3(1, 1, 1), Vec3(5, 5, 1)));       // vertex on face
  EXPECT_TRUE(meet(Vec3(2, 0, 0), Vec3(2, -1, 1), Vec3(2, -1, -1)));    // vertex on edge
  EXPECT_TRUE(meet(Vec3(4, 0, 0), Vec3(5, -1, 1), Vec3(5, -1, -1)));    // vertex on vertex
  EXPECT_TRUE(meet(Vec3(2, 0, -1), Vec3(2, 0, 1), Vec3(2, -3, 0)));     // edge on edge
  EXPECT_TRUE(meet(Vec3(1, 1, 0), Vec3(2, 1, 0), Vec3(1, 2, 0)));       // contained, coplanar
  EXPECT_TRUE(meet(Vec3(-9, -9, 0), Vec3(99, -9, 0), Vec3(-9, 99, 0))); // containing
  EXPECT_TRUE(meet(Vec3(4, 0, 0), Vec3(8, 0, 0), Vec3(8, 4, 0)));       // coplanar, one point
  EXPECT_FALSE(meet(Vec3(3, 3, 0), Vec3(8, 0, 0), Vec3(8, 4, 0)));      // coplanar, apart
  EXPECT_FALSE(meet(Vec3(1, 1, 1), Vec3(2, 1, 1), Vec3(1, 2, 1)));      // parallel
}

TEST(SelfIntersection, SharedVerticesAreNoContact)
{
  const std::vector<Vec3> points = { Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0), Vec3(2, 2, 0),
    Vec3(0, 0, 2), Vec3(-2, 0, 0), Vec3(0, -2, 0), Vec3(1, 1, 1), Vec3(1, 1, -1) };
  // Edges: unfolded, right angle, folded flat onto each other.
  EXPECT_FALSE(Meet(points, { 0, 1, 2 }, { 1, 3, 2 }));
  EXPECT_FALSE(Meet(points, { 0, 1, 2 }, { 0, 1, 4 }));
  EXPECT_TRUE(Meet(points, { 0, 1, 2 }, { 0, 1, 3 }));
  // Vertices: opposite in the plane, piercing, coplanar overlap, only an edge direction common.
  EXPECT_FALSE(Meet(points, { 0, 1, 2 }, { 0, 5, 6 }));
  EXPECT_TRUE(Meet(points, { 0, 1, 2 }, { 0, 7, 8 }));
  EXPECT_TRUE(Meet(points, { 0, 1, 2 }, { 0, 3, 5 }));
  EXPECT_TRUE(Meet({ Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0), Vec3(1, 0, 0), Vec3(0, 0, 5) },
    { 0, 1, 2 }, { 0, 3, 4 }));
  // All three.
  EXPECT_TRUE(Meet(points, { 0, 1, 2 }, { 2, 1, 0 }));
}

TEST(SelfIntersection, EqualPointsOfDifferentIdsAreAContact)
{
  const std::vector<Vec3> points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 0),
    Vec3(-1, 0, 0), Vec3(0, -1, 0) };
  EXPECT_TRUE(Meet(points, { 0, 1, 2 }, { 3, 4, 5 }));
}

TEST(SelfIntersection, DegenerateTrianglesAreSegments)
{
  const std::vector<Vec3> points = { Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0, 2, 0),
    Vec3(0.5, 0.5, -1), Vec3(0.5, 0.5, 3), Vec3(0.5, 0.5, 1), Vec3(3, 3, -1), Vec3(3, 3, 3),
    Vec3(3, 3, 1), Vec3(0, 0.5, 1), Vec3(1, 0.5, 1), Vec3(2, 0.5, 1) };
  EXPECT_TRUE(Meet(points, { 0, 1, 2 }, { 3, 4, 5 }));
  EXPECT_FALSE(Meet(points, { 0, 1, 2 }, { 6, 7, 8 }));
  EXPECT_TRUE(Meet(points, { 3, 4, 5 }, { 9, 10, 11 }));
  EXPECT_FALSE(Meet(points, { 6, 7, 8 }, { 9, 10, 11 }));
}

TEST(SelfIntersection, AgreesWithSeparatingAxesInIntegers)
{
  std::mt19937 generator(11);
  int met = 0, apart = 0;
  for (int i = 0; i < 60000; ++i)
  {
    // Small grids give all special positions; shared = 0, 1 or 2 vertices.
    std::uniform_int_distribution<int> coordinate(0, i % 5 + 1);
    std::vector<Whole> p(6);
    for (Whole& q : p)
    {
      q = Whole(coordinate(generator), coordinate(generator), coordinate(generator));
    }
    const int shared = i % 3;
    std::vector<Whole> s = { p[0], p[1], p[2] };
    std::vector<Whole> t = { p[3], p[4], p[5] };
    Triangle second = { 3, 4, 5 };
    for (int k = 0; k < shared; ++k)
    {
      t[k] = p[k];
      second[k] = k;
    }
    const Whole ns = (s[1] - s[0]).cross(s[2] - s[0]);
    const Whole nt = (t[1] - t[0]).cross(t[2] - t[0]);
    if (ns.isZero() || nt.isZero())
    {
      continue;
    }
    bool expected;
    if (shared == 0)
    {
      expected = PolygonsMeet(s, t);
    }
    else if (shared == 1)
    {
      // Cut the tip off the first triangle: what is common beyond the tip reaches farther.
      constexpr long long scale = 3000;
      const std::vector<Whole> rest = { scale * s[0] + (s[1] - s[0]), scale * s[1], scale * s[2],
        scale * s[0] + (s[2] - s[0]) };
      expected = PolygonsMeet(rest, { scale * t[0], scale * t[1], scale * t[2] });
    }
    else
    {
      expected = ns.dot(t[2] - s[0]) == 0 && ns.dot(nt) > 0;
    }
    std::vector<Vec3> points;
    for (const Whole& q : p)
    {
      points.push_back(ToDouble(q));
    }
    ASSERT_EQ(Meet(points, { 0, 1, 2 }, second), expected)
      << "case " << i << ", shared vertices " << shared;
    // Order and orientation don't matter.
    ASSERT_EQ(Meet(points, { second[1], second[0], second[2] }, { 2, 0, 1 }), expected) << i;
    (expected ? met : apart) += 1;
  }
  EXPECT_GT(met, 1000);
  EXPECT_GT(apart, 1000);
}

TEST(SelfIntersection, FindsAllPairsOfASoup)
{
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> place(0, 1), side(-0.15, 0.15);
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  for (Index t = 0; t < 400; ++t)
  {
    const Vec3 center(place(generator), place(generator), place(generator));
    for (int k = 0; k < 3; ++k)
    {
      points.push_back(center + Vec3(side(generator), side(generator), side(generator)));
    }
    triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
  }
  std::vector<TrianglePair> expected;
  for (Index a = 0; a < 400; ++a)
  {
    for (Index b = a + 1; b < 400; ++b)
    {
      if (Meet(points, triangles[a], triangles[b]))
      {
        expected.push_back({ a, b });
      }
    }
  }
  ASSERT_GT(expected.size(), 50u);
  EXPECT_TRUE(FindSelfIntersections(points, triangles, 1000000) == expected);
  const auto some = FindSelfIntersections(points, triangles, 10);
  EXPECT_EQ(some.size(), 10u);
  EXPECT_TRUE(std::is_sorted(some.begin(), some.end()));
  EXPECT_TRUE(std::includes(expected.begin(), expected.end(), some.begin(), some.end()));
}

TEST(SelfIntersection, NothingToFind)
{
  EXPECT_TRUE(FindSelfIntersections({}, {}).empty());
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  AddGrid(
    20, [](double x, double y) { return x * y; }, points, triangles);
  AddGrid(
    20, [](double x, double y) { return x * y + 1e-13; }, points, triangles);
  EXPECT_TRUE(FindSelfIntersections(points, triangles).empty());
  EXPECT_TRUE(FindSelfIntersections(points, triangles, 0).empty());
}

TEST(SelfIntersection, OffsetAndScaleDoNotMatter)
{
  // Offsets that keep the coordinates exact: multiples of 1/64 near 2^30.
  for (double scale : { 1.0, std::ldexp(1.0, -300), std::ldexp(1.0, 300), std::ldexp(1.0, 900) })
  {
    for (double offset : { 0.0, std::ldexp(1.0, 30) })
    {
      std::vector<Vec3> points;
      std::vector<Triangle> triangles;
      AddGrid(
        8, [](double, double) { return 0.0; }, points, triangles);
      AddGrid(
        8, [](double x, double) { return x - 0.5 + 1.0 / 64; }, points, triangles);
      const auto expected = FindSelfIntersections(points, triangles, 100000);
      ASSERT_FALSE(expected.empty());
      for (Vec3& p : points)
      {
        p = scale * (p + Vec3::Constant(offset));
      }
      EXPECT_TRUE(FindSelfIntersections(points, triangles, 100000) == expected);
    }
  }
}

TEST(SelfIntersection, SameBitsForAnyNumberOfThreads)
{
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  AddGrid(
    80, [](double x, double y) { return std::sin(9 * x) * y; }, points, triangles);
  AddGrid(
    80, [](double x, double y) { return std::cos(7 * y) * x; }, points, triangles);
  for (std::size_t limit : { std::size_t(50), std::size_t(1000000) })
  {
    vtkSMPTools::Initialize(1);
    const auto one = FindSelfIntersections(points, triangles, limit);
    vtkSMPTools::Initialize(2);
    EXPECT_TRUE(FindSelfIntersections(points, triangles, limit) == one);
    EXPECT_FALSE(one.empty());
  }
}

TEST(SelfIntersection, PlaceIsNearBothTriangles)
{
  const std::vector<Vec3> points = { Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 4, 0), Vec3(1, 1, -1),
    Vec3(1, 1, 1), Vec3(2, 2, 1) };
  const std::vector<Triangle> triangles = { { 0, 1, 2 }, { 3, 4, 5 } };
  const auto pairs = FindSelfIntersections(points, triangles);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_TRUE(IntersectionPlace(points, triangles, pairs[0]).isApprox(Vec3(1.5, 1.5, 0)));
}

TEST(SelfIntersection, StopsWhenAsked)
{
  class Stopper : public Monitor
  {
    bool AbortRequested() override { return true; }
  } monitor;
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  AddGrid(
    50, [](double, double) { return 0.0; }, points, triangles);
  FindSelfIntersections(points, triangles, 100, &monitor);
  EXPECT_TRUE(monitor.Stopped());
}

/// Flat and tilted: each test of neighbours needs the exact path. Prints the time.
TEST(SelfIntersection, CoplanarTrianglesAreNotSlow)
{
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  AddGrid(
    224, [](double x, double y) { return 0.3 * x + 0.7 * y; }, points, triangles);
  const auto start = std::chrono::steady_clock::now();
  EXPECT_TRUE(FindSelfIntersections(points, triangles).empty());
  const double seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::cout << triangles.size() << " nearly coplanar triangles: " << seconds << " s\n";
}

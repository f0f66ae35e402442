// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceCheck.h"

#include "SharedData.h"
#include "SurfaceFlaws.h"
#include "SurfaceReader.h"
#include "SurfaceTopology.h"

#include <gtest/gtest.h>

#include <vtkSMPTools.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <limits>
#include <random>

using namespace featurehex;
namespace fs = std::filesystem;

namespace
{
/// A box of n x n squares on each side, outward; every triangle has points of its own as in STL.
SurfaceMesh SoupBox(const Vec3& low, const Vec3& high, int n = 1)
{
  SurfaceMesh s;
  const auto corner = [&](const Vec3& p)
  {
    s.Points.push_back(low + p.cwiseProduct(high - low));
    return static_cast<Index>(s.Points.size() - 1);
  };
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int side = 0; side < 2; ++side)
    {
      for (int i = 0; i < n; ++i)
      {
        for (int j = 0; j < n; ++j)
        {
          const auto at = [&](int a, int b)
          {
            Vec3 p;
            p[axis] = side;
            p[(axis + 1) % 3] = static_cast<double>(i + a) / n;
            p[(axis + 2) % 3] = static_cast<double>(j + b) / n;
            return corner(p);
          };
          Triangle t = { at(0, 0), at(1, 0), at(1, 1) };
          Triangle u = { at(0, 0), at(1, 1), at(0, 1) };
          if (side == 0)
          {
            std::swap(t[1], t[2]);
            std::swap(u[1], u[2]);
          }
          s.Triangles.push_back(t);
          s.Triangles.push_back(u);
        }
      }
    }
  }
  return s;
}

struct Result
{
  ::featurehex::Status Status;
  SurfaceCheckReport Report;
};

Result Check(SurfaceMesh& surface, const SurfaceCheckOptions& options = {})
{
  Result result;
  Monitor monitor;
  result.Status = CheckSurface(surface, options, result.Report, monitor);
  return result;
}

/// The same box with shared points.
SurfaceMesh CleanBox(const Vec3& low, const Vec3& high, int n = 1)
{
  SurfaceMesh s = SoupBox(low, high, n);
  EXPECT_TRUE(Check(s).Status.Ok());
  return s;
}

SurfaceMesh UnitBox(int n = 1)
{
  return CleanBox(Vec3::Zero(), Vec3::Ones(), n);
}

void Append(SurfaceMesh& surface, const SurfaceMesh& other)
{
  const Index base = static_cast<Index>(surface.Points.size());
  surface.Points.insert(surface.Points.end(), other.Points.begin(), other.Points.end());
  for (const Triangle& t : other.Triangles)
  {
    surface.Triangles.push_back({ t[0] + base, t[1] + base, t[2] + base });
  }
}

void Reverse(SurfaceMesh& surface)
{
  for (Triangle& t : surface.Triangles)
  {
    std::swap(t[0], t[1]);
  }
}

/// n x m torus; outward.
SurfaceMesh Torus(int n, int m)
{
  SurfaceMesh s;
  const double turn = 2 * std::acos(-1.0);
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < m; ++j)
    {
      const double a = turn * i / n, b = turn * j / m;
      s.Points.push_back(
        Vec3((2 + std::cos(b)) * std::cos(a), (2 + std::cos(b)) * std::sin(a), std::sin(b)));
      const auto id = [&](int p, int q)
      { return static_cast<Index>((i + p) % n * m + (j + q) % m); };
      s.Triangles.push_back({ id(0, 0), id(1, 0), id(1, 1) });
      s.Triangles.push_back({ id(0, 0), id(1, 1), id(0, 1) });
    }
  }
  return s;
}

double SignedVolume(const SurfaceMesh& s)
{
  double volume = 0;
  for (const Triangle& t : s.Triangles)
  {
    volume += s.Points[t[0]].dot(s.Points[t[1]].cross(s.Points[t[2]])) / 6;
  }
  return volume;
}

/// What CheckSurface() promises of an accepted surface.
void ExpectClean(const SurfaceMesh& s, const SurfaceCheckReport& report)
{
  const EdgeTable edges(s.Triangles);
  edges.VisitEdges(
    [&s](const EdgeUse* first, const EdgeUse* last)
    {
      ASSERT_EQ(last - first, 2);
      const auto start = [&s](const EdgeUse& use)
      { return s.Triangles[use.Side / 3][use.Side % 3]; };
      EXPECT_NE(start(first[0]), start(first[1]));
    });
  for (Index fans : CountFans(s.Triangles, OppositeSides(edges), s.Points.size()))
  {
    EXPECT_EQ(fans, 1);
  }
  ASSERT_EQ(report.ComponentOfTriangle.size(), s.Triangles.size());
  double volume = 0;
  Index triangles = 0;
  for (const SurfaceComponent& c : report.Components)
  {
    EXPECT_GT(c.Volume, 0);
    EXPECT_EQ(c.Cavity, c.Depth % 2 == 1);
    EXPECT_EQ(c.Parent < 0, c.Depth == 0);
    volume += c.Cavity ? -c.Volume : c.Volume;
    triangles += c.NumberOfTriangles;
  }
  EXPECT_EQ(static_cast<std::size_t>(triangles), s.Triangles.size());
  EXPECT_DOUBLE_EQ(volume, report.Volume);
}

void ExpectAccepted(SurfaceMesh& s, Result& result)
{
  result = Check(s);
  ASSERT_TRUE(result.Status.Ok()) << result.Status.Message;
  ExpectClean(s, result.Report);
}

/// One error with the code and the words, and an untouched surface.
void ExpectRejected(SurfaceMesh s, StatusCode code, const std::string& words)
{
  const SurfaceMesh before = s;
  const Result result = Check(s);
  EXPECT_EQ(StatusCodeName(result.Status.Code), std::string(StatusCodeName(code)))
    << result.Status.Message;
  std::string message = result.Status.Message;
  std::transform(message.begin(), message.end(), message.begin(), ::tolower);
  EXPECT_NE(message.find(words), std::string::npos) << result.Status.Message;
  EXPECT_EQ(message.back(), '.');
  EXPECT_TRUE(s.Triangles == before.Triangles);
  EXPECT_EQ(s.Points.size(), before.Points.size());
  EXPECT_LE(result.Status.Where.size(), SurfaceCheckOptions().MaximumNumberOfPlaces);
}
} // namespace

TEST(SurfaceCheck, CleanSurfaceIsUnchanged)
{
  SurfaceMesh s = UnitBox(3);
  const SurfaceMesh before = s;
  Result r;
  ExpectAccepted(s, r);
  EXPECT_TRUE(s.Triangles == before.Triangles);
  EXPECT_TRUE(s.Points == before.Points);
  EXPECT_TRUE(r.Report.Warnings.empty());
  ASSERT_EQ(r.Report.Components.size(), 1u);
  EXPECT_NEAR(r.Report.Volume, 1.0, 1e-14);
  EXPECT_DOUBLE_EQ(r.Report.Diagonal, std::sqrt(3.0));
  for (std::size_t v = 0; v < s.Points.size(); ++v)
  {
    EXPECT_EQ(r.Report.Points[v], static_cast<Index>(v));
  }
}

TEST(SurfaceCheck, MergesThePointsOfStl)
{
  SurfaceMesh s = SoupBox(Vec3(-1, -1, -0.0), Vec3(1, 1, 1), 4);
  // The other zero is the same place.
  s.Points[0] += Vec3(0, 0, 0.0);
  const SurfaceMesh before = s;
  Result r;
  ExpectAccepted(s, r);
  EXPECT_EQ(s.Points.size(), 98u);
  EXPECT_EQ(s.Triangles.size(), 192u);
  EXPECT_EQ(r.Report.NumberOfMergedPoints, 576 - 98);
  EXPECT_TRUE(r.Report.Warnings.empty());
  for (std::size_t t = 0; t < before.Triangles.size(); ++t)
  {
    ASSERT_EQ(r.Report.Triangles[t], static_cast<Index>(t));
    for (int k = 0; k < 3; ++k)
    {
      const Index old = before.Triangles[t][k];
      EXPECT_EQ(s.Triangles[t][k], r.Report.Points[old]);
      EXPECT_TRUE(s.Points[r.Report.Points[old]] == before.Points[old]);
    }
  }
}

TEST(SurfaceCheck, EmptyAndIndices)
{
  ExpectRejected({}, StatusCode::EmptySurface, "empty");
  SurfaceMesh s = UnitBox();
  s.Triangles.clear();
  ExpectRejected(s, StatusCode::EmptySurface, "no faces");
  for (Index bad : { -1, 8, std::numeric_limits<Index>::max(), std::numeric_limits<Index>::min() })
  {
    s = UnitBox();
    s.Triangles[5][1] = bad;
    ExpectRejected(s, StatusCode::IndexOutOfRange, "index out of range");
  }
}

TEST(SurfaceCheck, NonFiniteCoordinates)
{
  const double bad[] = { std::numeric_limits<double>::quiet_NaN(),
    std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 1e101 };
  for (double value : bad)
  {
    for (int k = 0; k < 3; ++k)
    {
      SurfaceMesh s = UnitBox();
      s.Points[3][k] = value;
      ExpectRejected(s, StatusCode::NonFinite, "non-finite coordinate");
    }
  }
}

TEST(SurfaceCheck, OpenBoundary)
{
  SurfaceMesh s = UnitBox(3);
  s.Triangles.erase(s.Triangles.begin() + 7);
  ExpectRejected(
    s, StatusCode::OpenBoundary, "open boundary: 3 edges have only one face, in 1 loop");
  s.Triangles.erase(s.Triangles.begin() + 80);
  ExpectRejected(s, StatusCode::OpenBoundary, "6 edges have only one face, in 2 loops");
  s.Triangles.resize(s.Triangles.size() / 2);
  ExpectRejected(s, StatusCode::OpenBoundary, "open boundary");
  s.Triangles.resize(1);
  ExpectRejected(s, StatusCode::OpenBoundary, "open");
}

TEST(SurfaceCheck, NonManifoldEdges)
{
  SurfaceMesh fin = UnitBox(3);
  fin.Points.push_back(Vec3(2, 2, 2));
  fin.Triangles.push_back(
    { fin.Triangles[0][0], fin.Triangles[0][1], static_cast<Index>(fin.Points.size() - 1) });
  ExpectRejected(fin, StatusCode::NonManifold, "1 non-manifold edge:");
  ExpectRejected(fin, StatusCode::NonManifold, "has 3 faces (triangles 0, ");
  SurfaceMesh boxes = UnitBox();
  Append(boxes, CleanBox(Vec3(1, 1, 0), Vec3(2, 2, 1)));
  ExpectRejected(boxes, StatusCode::NonManifold, "non-manifold edge");
  ExpectRejected(boxes, StatusCode::NonManifold, "has 4 faces");
}

TEST(SurfaceCheck, NonManifoldVertex)
{
  SurfaceMesh s = UnitBox(2);
  Append(s, CleanBox(Vec3::Ones(), Vec3(2, 2, 2), 2));
  ExpectRejected(s, StatusCode::NonManifold, "1 non-manifold vertex");
}

TEST(SurfaceCheck, Duplicates)
{
  SurfaceMesh s = UnitBox(3);
  const SurfaceMesh before = s;
  for (int t = 0; t < 10; ++t)
  {
    // Some also turned round.
    Triangle copy = s.Triangles[5 * t];
    std::swap(copy[0], copy[t % 2]);
    s.Triangles.push_back(copy);
  }
  Result r;
  ExpectAccepted(s, r);
  EXPECT_TRUE(s.Triangles == before.Triangles);
  EXPECT_EQ(r.Report.NumberOfDuplicateTriangles, 10);
  EXPECT_EQ(r.Report.Triangles.back(), -1);
  ASSERT_EQ(r.Report.Warnings.size(), 1u);
  EXPECT_EQ(r.Report.Warnings[0], "10 duplicate triangles dropped.");
  // A second copy of everything.
  s = before;
  Append(s, before);
  ExpectAccepted(s, r);
  EXPECT_TRUE(s.Triangles == before.Triangles);
}

TEST(SurfaceCheck, BodiesThatShareAFace)
{
  SurfaceMesh s = UnitBox();
  SurfaceMesh other = CleanBox(Vec3(1, 0, 0), Vec3(2, 1, 1));
  SurfaceMesh both = s;
  Append(both, other);
  ExpectRejected(both, StatusCode::SelfIntersection, "self-intersection (coplanar overlap)");
  // Not point by point: a smaller box on the face, a finer one, edge to edge.
  for (const SurfaceMesh& second :
    { CleanBox(Vec3(1, 0.2, 0.2), Vec3(2, 0.7, 0.7)), CleanBox(Vec3(0.4, 0.4, 1), Vec3(2, 2, 2), 3),
      CleanBox(Vec3(1, 1, 0.5), Vec3(2, 2, 0.7)) })
  {
    both = s;
    Append(both, second);
    ExpectRejected(both, StatusCode::SelfIntersection, "self-intersection");
  }
}

TEST(SurfaceCheck, SelfIntersections)
{
  SurfaceMesh s = UnitBox(2);
  Append(s, CleanBox(Vec3(0.5, 0.4, 0.3), Vec3(2, 2, 2)));
  ExpectRejected(s, StatusCode::SelfIntersection, "self-intersection: ");
  SurfaceMesh spike = UnitBox(4);
  const auto top = std::find_if(
    spike.Points.begin(), spike.Points.end(), [](const Vec3& p) { return p == Vec3(0.5, 0.5, 1); });
  *top = Vec3(0.4, 0.3, -1);
  ExpectRejected(spike, StatusCode::SelfIntersection, "self-intersection");
  // Only touching from inside.
  *top = Vec3(0.4, 0.3, 0);
  ExpectRejected(spike, StatusCode::SelfIntersection, "self-intersection");
  *top = Vec3(0.4, 0.3, 1e-15);
  EXPECT_TRUE(Check(spike).Status.Ok());
  SurfaceCheckOptions one;
  one.MaximumNumberOfPlaces = 1;
  const Result r = Check(s, one);
  EXPECT_EQ(r.Status.Where.size(), 1u);
  EXPECT_NE(r.Status.Message.find("at least 1 pair"), std::string::npos) << r.Status.Message;
}

TEST(SurfaceCheck, ZeroVolume)
{
  SurfaceMesh flat;
  flat.Points = { Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0) };
  flat.Triangles = { { 0, 1, 2 }, { 0, 2, 1 } };
  ExpectRejected(flat, StatusCode::Degenerate, "zero volume");
  SurfaceMesh pressed = UnitBox(3);
  for (Vec3& p : pressed.Points)
  {
    p = Vec3(p[0] + 0.1 * p[2], p[1] + 0.05 * p[2], 0.3 * (p[0] + 0.1 * p[2]));
  }
  ExpectRejected(pressed, StatusCode::Degenerate, "zero volume");
  SurfaceMesh point = UnitBox();
  std::fill(point.Points.begin(), point.Points.end(), Vec3(1, 2, 3));
  ExpectRejected(point, StatusCode::Degenerate, "zero volume");
  SurfaceMesh vanishing = UnitBox();
  for (Vec3& p : vanishing.Points)
  {
    p *= 1e-300;
  }
  ExpectRejected(vanishing, StatusCode::Degenerate, "zero volume");
  SurfaceMesh line = UnitBox();
  for (std::size_t v = 0; v < line.Points.size(); ++v)
  {
    line.Points[v] = Vec3(v, 0, 0);
  }
  ExpectRejected(line, StatusCode::Degenerate, "degenerate");
}

TEST(SurfaceCheck, NotOrientable)
{
  SurfaceMesh plane;
  plane.Points = { Vec3(0, 0, 1), Vec3(1, 0, 0), Vec3(0.31, 0.95, 0.1), Vec3(-0.81, 0.59, 0),
    Vec3(-0.81, -0.59, 0.2), Vec3(0.31, -0.95, 0) };
  plane.Triangles = { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 3, 4 }, { 0, 4, 5 }, { 0, 5, 1 }, { 1, 2, 4 },
    { 2, 3, 5 }, { 3, 4, 1 }, { 4, 5, 2 }, { 5, 1, 3 } };
  ExpectRejected(plane, StatusCode::NotOrientable, "not orientable");
}

TEST(SurfaceCheck, Orientation)
{
  const SurfaceMesh before = Torus(20, 12);
  ASSERT_GT(SignedVolume(before), 0);
  SurfaceMesh s = before;
  Reverse(s);
  Result r;
  ExpectAccepted(s, r);
  EXPECT_NEAR(SignedVolume(s), SignedVolume(before), 1e-12);
  EXPECT_EQ(r.Report.NumberOfReorientedTriangles, 480);
  EXPECT_EQ(r.Report.Warnings.size(), 1u);
  EXPECT_EQ(r.Report.Components[0].Genus, 1);
  s = before;
  for (std::size_t t = 0; t < s.Triangles.size(); t += 7)
  {
    std::swap(s.Triangles[t][0], s.Triangles[t][2]);
  }
  ExpectAccepted(s, r);
  EXPECT_NEAR(SignedVolume(s), SignedVolume(before), 1e-12);
  EXPECT_EQ(r.Report.NumberOfReorientedTriangles, 69);
}

TEST(SurfaceCheck, NestedComponents)
{
  // A ball in a cavity in a cavity's body..., five deep, in mixed order and random orientation, and
  // two separate ones; the torus surrounds nothing.
  SurfaceMesh s;
  const double size[] = { 3, 5, 1, 4, 2 };
  for (int i = 0; i < 5; ++i)
  {
    SurfaceMesh box = CleanBox(Vec3::Constant(-size[i]), Vec3::Constant(size[i]), i + 1);
    if (i % 2)
    {
      Reverse(box);
    }
    Append(s, box);
  }
  Append(s, CleanBox(Vec3(6, 0, 0), Vec3(7, 1, 1)));
  Append(s, CleanBox(Vec3(-4.6, -0.1, -0.1), Vec3(-4.4, 0.1, 0.1)));
  SurfaceMesh torus = Torus(16, 8);
  for (Vec3& p : torus.Points)
  {
    p += Vec3(0, 0, 20);
  }
  Append(s, torus);
  Append(s, CleanBox(Vec3(-0.5, -0.5, 19.5), Vec3(0.5, 0.5, 20.5)));
  Result r;
  ExpectAccepted(s, r);
  const auto& c = r.Report.Components;
  ASSERT_EQ(c.size(), 9u);
  const Index depth[] = { 2, 0, 4, 1, 3, 0, 1, 0, 0 };
  const Index parent[] = { 3, -1, 4, 1, 0, -1, 1, -1, -1 };
  for (int i = 0; i < 9; ++i)
  {
    EXPECT_EQ(c[i].Depth, depth[i]) << i;
    EXPECT_EQ(c[i].Parent, parent[i]) << i;
    EXPECT_EQ(c[i].Genus, i == 7 ? 1 : 0) << i;
  }
  EXPECT_NEAR(c[1].Volume, 1000, 1e-9);
  EXPECT_NEAR(SignedVolume(s), r.Report.Volume, 1e-9);
  EXPECT_EQ(r.Report.ComponentOfTriangle.front(), 0);
  EXPECT_EQ(r.Report.ComponentOfTriangle.back(), 8);
}

/// The ray hits vertices, edges and faces edge-on.
TEST(SurfaceCheck, NestingInSpecialPositions)
{
  for (int n = 1; n < 5; ++n)
  {
    SurfaceMesh s = CleanBox(Vec3::Zero(), Vec3::Constant(4), 4);
    Append(s, CleanBox(Vec3::Constant(1), Vec3::Constant(3), n));
    Append(s, CleanBox(Vec3(8, 1, 1), Vec3(10, 3, 3), n));
    Append(s, CleanBox(Vec3(-10, 0, 0), Vec3(-8, 4, 4), n));
    Result r;
    ExpectAccepted(s, r);
    ASSERT_EQ(r.Report.Components.size(), 4u);
    EXPECT_TRUE(r.Report.Components[1].Cavity);
    EXPECT_FALSE(r.Report.Components[2].Cavity);
    EXPECT_FALSE(r.Report.Components[3].Cavity);
    EXPECT_NEAR(r.Report.Volume, 64 - 8 + 8 + 32, 1e-12);
  }
}

TEST(SurfaceCheck, UnusedPoints)
{
  SurfaceMesh s = UnitBox();
  const SurfaceMesh before = s;
  s.Points.insert(s.Points.begin(), Vec3(7, 7, 7));
  for (Triangle& t : s.Triangles)
  {
    t = { t[0] + 1, t[1] + 1, t[2] + 1 };
  }
  Result r;
  ExpectAccepted(s, r);
  EXPECT_TRUE(s.Triangles == before.Triangles);
  EXPECT_EQ(r.Report.NumberOfUnusedPoints, 1);
  EXPECT_EQ(r.Report.Points[0], -1);
  EXPECT_EQ(r.Report.Points[1], 0);
}

/// A doubled corner and a triangle without area that joins it to the original.
TEST(SurfaceCheck, CollapsedTriangles)
{
  SurfaceMesh s = UnitBox(2);
  const SurfaceMesh before = s;
  for (int t = 0; t < 8; ++t)
  {
    // Split the edge a b at a copy of a: the triangle across gets the same split.
    const Index a = s.Triangles[t][0], b = s.Triangles[t][1];
    const Index copy = static_cast<Index>(s.Points.size());
    s.Points.push_back(s.Points[a]);
    s.Triangles.push_back({ a, copy, b });
    s.Triangles[t][0] = t % 2 ? a : copy;
  }
  Result r;
  ExpectAccepted(s, r);
  EXPECT_TRUE(s.Triangles == before.Triangles);
  EXPECT_EQ(r.Report.NumberOfCollapsedTriangles, 8);
}

/// Caps on one edge of a box: vertices on the edge with triangles of zero area on one side.
TEST(SurfaceCheck, CollinearTrianglesAreFlippedAway)
{
  for (int count : { 1, 2, 5, 40 })
  {
    SurfaceMesh s = UnitBox();
    // Triangle 0 = (p q r): points on p q belong to its side only; a fan of flat triangles closes
    // the gap to the edge p q of the neighbour.
    const Triangle t = s.Triangles[0];
    const auto side = [&](int i)
    { return s.Points[t[0]] + i / 64.0 * (s.Points[t[1]] - s.Points[t[0]]); };
    Index previous = t[0];
    s.Triangles[0] = { 0, 0, 0 };
    for (int i = 1; i <= count; ++i)
    {
      const Index next = static_cast<Index>(s.Points.size());
      s.Points.push_back(side(i));
      s.Triangles.push_back({ previous, next, t[2] });
      s.Triangles.push_back({ next, previous, t[1] });
      previous = next;
    }
    s.Triangles[0] = { previous, t[1], t[2] };
    // The last flat triangle would be (q previous q); the first one starts at p.
    const std::size_t triangles = s.Triangles.size();
    Result r;
    ExpectAccepted(s, r);
    EXPECT_EQ(s.Triangles.size(), triangles);
    EXPECT_EQ(s.Points.size(), 8u + count);
    EXPECT_GE(r.Report.NumberOfFlippedEdges, count);
    EXPECT_NEAR(r.Report.Volume, 1.0, 1e-14);
    EXPECT_EQ(r.Report.Warnings.size(), 1u);
    for (const Triangle& c : s.Triangles)
    {
      EXPECT_GT((s.Points[c[1]] - s.Points[c[0]]).cross(s.Points[c[2]] - s.Points[c[0]]).norm(), 0);
    }
  }
}

TEST(SurfaceCheck, CollinearTrianglesThatCannotBeFlipped)
{
  // A tetrahedron with a corner on an edge: the flip would double the edge between the others.
  SurfaceMesh s;
  s.Points = { Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 1) };
  s.Triangles = { { 0, 1, 2 }, { 0, 3, 1 }, { 1, 3, 2 }, { 2, 3, 0 } };
  ExpectRejected(s, StatusCode::Degenerate, "degenerate");
}

/// Everything is relative: positions scaled by powers of ten and moved give the same answers.
TEST(SurfaceCheck, ScaleAndOffset)
{
  for (double scale : { 1e-90, 1e-9, 1.0, 1e12, 1e90 })
  {
    SurfaceMesh s = Torus(24, 10);
    for (Vec3& p : s.Points)
    {
      p *= scale;
    }
    Result r;
    ExpectAccepted(s, r);
    EXPECT_EQ(s.Triangles.size(), 480u);
    EXPECT_TRUE(r.Report.Warnings.empty());
    EXPECT_EQ(r.Report.Components[0].Genus, 1);
  }
  SurfaceMesh s = Torus(24, 10);
  for (Vec3& p : s.Points)
  {
    p += Vec3(1e9, -1e9, 1e9);
  }
  Result r;
  ExpectAccepted(s, r);
  EXPECT_TRUE(r.Report.Warnings.empty());
  EXPECT_NEAR(r.Report.Volume, SignedVolume(Torus(24, 10)), 1e-4);
}

TEST(SurfaceCheck, OrderOfTheInputDoesNotMatter)
{
  SurfaceMesh s = Torus(12, 8);
  SurfaceMesh inner = CleanBox(Vec3(1.7, -0.2, -0.2), Vec3(2.2, 0.2, 0.2), 2);
  Append(s, inner);
  Result expected;
  SurfaceMesh first = s;
  ExpectAccepted(first, expected);
  ASSERT_EQ(expected.Report.Components.size(), 2u);
  std::mt19937 generator(4);
  for (int i = 0; i < 5; ++i)
  {
    SurfaceMesh shuffled = s;
    std::shuffle(shuffled.Triangles.begin(), shuffled.Triangles.end(), generator);
    for (Triangle& t : shuffled.Triangles)
    {
      std::rotate(t.begin(), t.begin() + generator() % 3, t.end());
      if (generator() % 2)
      {
        std::swap(t[0], t[1]);
      }
    }
    Result r;
    ExpectAccepted(shuffled, r);
    EXPECT_EQ(r.Report.Components.size(), 2u);
    EXPECT_NEAR(r.Report.Volume, expected.Report.Volume, 1e-12);
    EXPECT_NEAR(SignedVolume(shuffled), SignedVolume(first), 1e-12);
  }
}

TEST(SurfaceCheck, AbortAndTimeLimit)
{
  class Stopper : public Monitor
  {
    bool AbortRequested() override { return true; }
  } stopper;
  SurfaceMesh s = Torus(30, 30);
  SurfaceCheckReport report;
  EXPECT_EQ(CheckSurface(s, {}, report, stopper).Code, StatusCode::Aborted);
  EXPECT_EQ(s.Triangles.size(), 1800u);
  Monitor limited;
  limited.SetTimeLimit(1e-9);
  EXPECT_EQ(CheckSurface(s, {}, report, limited).Code, StatusCode::TimeLimit);
}

/// Random small soups: never a crash, and what is accepted is clean.
TEST(SurfaceCheck, RandomSoups)
{
  std::mt19937 generator(8);
  int accepted = 0;
  for (int i = 0; i < 4000; ++i)
  {
    SurfaceMesh s;
    const int points = 4 + generator() % 5;
    for (int v = 0; v < points; ++v)
    {
      s.Points.push_back(Vec3(generator() % 4, generator() % 4, generator() % 4));
    }
    const int triangles = 1 + generator() % 12;
    for (int t = 0; t < triangles; ++t)
    {
      s.Triangles.push_back({ static_cast<Index>(generator() % points),
        static_cast<Index>(generator() % points), static_cast<Index>(generator() % points) });
    }
    if (i % 2)
    {
      // A tetrahedron and noise.
      Append(s, { { Vec3(0, 0, 0), Vec3(3, 0, 0), Vec3(0, 3, 0), Vec3(1, 1, 3) },
                  { { 0, 2, 1 }, { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 } } });
      s.Triangles.erase(s.Triangles.begin(),
        s.Triangles.end() - std::min<std::size_t>(s.Triangles.size(), 4 + generator() % 3));
    }
    const Result r = Check(s);
    if (r.Status.Ok())
    {
      ++accepted;
      ExpectClean(s, r.Report);
    }
    else
    {
      EXPECT_FALSE(r.Status.Message.empty());
    }
  }
  EXPECT_GT(accepted, 50);
}

TEST(SurfaceCheck, SharedBadFiles)
{
  const fs::path folder = SharedData() / "bad";
  if (!fs::exists(folder))
  {
    GTEST_SKIP() << folder << " doesn't exist";
  }
  // Beginning of the name, code, words; "" and Ok: accepted. Files that don't pass the reader are
  // in TestSurfaceReader.
  struct Row
  {
    const char* Name;
    StatusCode Code;
    const char* Words;
  };
  const Row rows[] = { { "b01", StatusCode::OpenBoundary, "open boundary" },
    { "b02", StatusCode::OpenBoundary, "3 edges have only one face, in 1 loop" },
    { "b03", StatusCode::NonManifold, "has 3 faces" },
    { "b04", StatusCode::NonManifold, "non-manifold edge" },
    { "b05", StatusCode::NonManifold, "non-manifold vertex" },
    { "b06", StatusCode::SelfIntersection, "self-intersection" },
    { "b07", StatusCode::SelfIntersection, "self-intersection" },
    { "b08", StatusCode::Ok, "20 duplicate triangles dropped" },
    { "b09", StatusCode::Ok, "1982 of 1982 triangles reversed" },
    { "b10", StatusCode::Ok, "triangles reversed" },
    { "b11", StatusCode::NonFinite, "non-finite coordinate" },
    { "b12", StatusCode::NonFinite, "non-finite coordinate" },
    { "b15", StatusCode::OpenBoundary, "open" }, { "b16", StatusCode::Degenerate, "zero volume" },
    { "b17", StatusCode::Ok, "" }, { "b18", StatusCode::Ok, "degenerate triangles" },
    { "b19", StatusCode::Ok, "" }, { "b20", StatusCode::Ok, "" }, { "b21", StatusCode::Ok, "" },
    { "b27", StatusCode::SelfIntersection, "self-intersection (coplanar overlap)" },
    { "b28", StatusCode::NotOrientable, "not orientable" } };
  for (const Row& row : rows)
  {
    for (const auto& entry : fs::directory_iterator(folder))
    {
      if (entry.path().filename().string().rfind(row.Name, 0) != 0)
      {
        continue;
      }
      SCOPED_TRACE(entry.path().filename());
      SurfaceMesh s;
      ASSERT_TRUE(ReadSurface(entry.path().string(), s).Ok());
      if (row.Code != StatusCode::Ok)
      {
        ExpectRejected(s, row.Code, row.Words);
        continue;
      }
      Result r;
      ExpectAccepted(s, r);
      EXPECT_GT(r.Report.Volume, 0);
      ASSERT_EQ(r.Report.Warnings.size(), row.Words[0] ? 1u : 0u);
      if (row.Words[0])
      {
        EXPECT_NE(r.Report.Warnings[0].find(row.Words), std::string::npos) << r.Report.Warnings[0];
      }
    }
  }
}

TEST(SurfaceCheck, SharedGoodFiles)
{
  if (!fs::exists(SharedData() / "surfaces"))
  {
    GTEST_SKIP() << SharedData() / "surfaces"
                 << " doesn't exist";
  }
  std::vector<fs::path> files;
  for (const auto& entry : fs::recursive_directory_iterator(SharedData() / "surfaces"))
  {
    if (entry.path().extension() == ".obj")
    {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files)
  {
    SCOPED_TRACE(file.filename());
    SurfaceMesh s;
    ASSERT_TRUE(ReadSurface(file.string(), s).Ok());
    const SurfaceMesh before = s;
    const auto start = std::chrono::steady_clock::now();
    Result r;
    ExpectAccepted(s, r);
    if (s.Triangles.size() > 90000)
    {
      std::cout << file.filename().string() << " " << s.Triangles.size() << " triangles: "
                << std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count()
                << " s with the test's own checks\n";
    }
    EXPECT_TRUE(s.Triangles == before.Triangles);
    EXPECT_TRUE(s.Points == before.Points);
    EXPECT_TRUE(r.Report.Warnings.empty());
    EXPECT_EQ(r.Report.Components.size(), 1u);
  }
}

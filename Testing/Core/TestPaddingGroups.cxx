// SPDX-License-Identifier: BSD-3-Clause
#include "PaddingGroups.h"

#include "FeatureShapes.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace featurehex;

namespace
{
const double Pi = std::acos(-1.0);

using Polygon = std::vector<Index>;
using Polygons = std::vector<Polygon>;

/// A polyhedron whose patches are given: curves are the edges between them.
struct Body
{
  SurfaceMesh Surface;
  SurfaceFeatures Graph;
  std::vector<int> PatchIds; ///< of the patches in the order in which they were given
  double Trim = 0.1;

  /// Polygons are seen from their first points, which must see all of them. @a everyCorner: also
  /// acute ones.
  Body(const std::vector<Vec3>& points, const std::vector<Polygons>& patches,
    bool everyCorner = false)
  {
    this->Surface.Points = points;
    std::map<PointPair, std::size_t> patchOnLeft;
    std::vector<std::size_t> firstTriangles;
    for (std::size_t patch = 0; patch < patches.size(); ++patch)
    {
      firstTriangles.push_back(this->Surface.Triangles.size());
      for (const Polygon& polygon : patches[patch])
      {
        for (std::size_t i = 0; i < polygon.size(); ++i)
        {
          patchOnLeft[{ polygon[i], polygon[(i + 1) % polygon.size()] }] = patch;
        }
        for (std::size_t i = 2; i < polygon.size(); ++i)
        {
          this->Surface.Triangles.push_back({ polygon[0], polygon[i - 1], polygon[i] });
        }
      }
    }
    std::vector<PointPair> edges;
    for (const auto& [edge, patch] : patchOnLeft)
    {
      if (edge[0] < edge[1] && patchOnLeft.at({ edge[1], edge[0] }) != patch)
      {
        edges.push_back(edge);
      }
    }
    FeatureGraphOptions options;
    options.EnforceAll = everyCorner;
    FeatureGraphReport report;
    const Status status =
      BuildSurfaceFeatures(this->Surface, edges, {}, options, this->Graph, report);
    EXPECT_TRUE(status.Ok()) << status.Message;
    EXPECT_EQ(this->Graph.NumberOfPatches, static_cast<int>(patches.size()));
    for (std::size_t triangle : firstTriangles)
    {
      this->PatchIds.push_back(this->Graph.PatchOfTriangle[triangle]);
    }
  }

  /// Groups of the patches in the order in which they were given, numbered as they come.
  std::vector<int> Groups(const GivenUpFeatures& givenUp = GivenUpFeatures()) const
  {
    const FeatureGeometry geometry(this->Surface, this->Graph, this->Trim, givenUp);
    const std::vector<int> groups = GroupPatches(geometry);
    EXPECT_EQ(groups, GroupPatches(geometry));
    EXPECT_EQ(groups.size(), this->PatchIds.size());
    int next = 0;
    for (int group : groups)
    {
      EXPECT_LE(group, next); // no gaps, in the order of the patches
      next = std::max(next, group + 1);
    }
    std::map<int, int> number;
    std::vector<int> result;
    for (int patch : this->PatchIds)
    {
      result.push_back(
        number.emplace(groups[patch], static_cast<int>(number.size())).first->second);
    }
    return result;
  }

  Index CurveBetween(std::size_t first, std::size_t second) const
  {
    for (std::size_t c = 0; c < this->Graph.Curves.size(); ++c)
    {
      const std::set<int> sides = { this->Graph.Curves[c].LeftPatch,
        this->Graph.Curves[c].RightPatch };
      if (sides == std::set<int>{ this->PatchIds[first], this->PatchIds[second] })
      {
        return static_cast<Index>(c);
      }
    }
    ADD_FAILURE() << "no curve between patches " << first << " and " << second;
    return 0;
  }

  Index CornerAt(Index point) const
  {
    for (std::size_t c = 0; c < this->Graph.Corners.size(); ++c)
    {
      if (this->Graph.Corners[c].Point == point)
      {
        return static_cast<Index>(c);
      }
    }
    ADD_FAILURE() << "no corner at point " << point;
    return 0;
  }
};

using Groups = std::vector<int>;

std::vector<std::array<double, 2>> Square()
{
  return { { 0, 0 }, { 2, 0 }, { 2, 2 }, { 0, 2 } };
}

/// Points: bottom, then top. Patches: bottom, top, side after each point of the base.
Body Prism(const std::vector<std::array<double, 2>>& base)
{
  const Index n = static_cast<Index>(base.size());
  std::vector<Vec3> points;
  Polygon bottom, top;
  std::vector<Polygons> patches(2);
  for (double z : { 0.0, 2.0 })
  {
    for (const auto& [x, y] : base)
    {
      points.emplace_back(x, y, z);
    }
  }
  for (Index i = 0; i < n; ++i)
  {
    const Index next = (i + 1) % n;
    bottom.push_back((n - i) % n);
    top.push_back(n + i);
    patches.push_back({ { i, next, n + next, n + i } });
  }
  patches[0] = { bottom };
  patches[1] = { top };
  return Body(points, patches);
}

/// Over an isosceles triangle with @a angle degrees at its first point.
Body TrianglePrism(double angle)
{
  const double half = angle / 360 * Pi;
  const double x = 2 * std::cos(half), y = 2 * std::sin(half);
  return Prism({ { 0, 0 }, { x, -y }, { x, y } });
}

/// Over a kite with right angles beside a corner of @a angle degrees, which is the first.
Body KitePrism(double angle)
{
  const double half = angle / 360 * Pi;
  const double x = 2 * std::cos(half), y = 2 * std::sin(half);
  return Prism({ { 0, 0 }, { x, -y }, { 2 / std::cos(half), 0 }, { x, y } });
}

/// A box of edge 2 with curves on its top from the middle of the front edge to points of the other
/// edges of the top, counter-clockwise from the right. Patches: bottom, front, right, back, left,
/// top from right to left.
Body BoxWithFan(const std::vector<Vec3>& ends, bool everyCorner = false)
{
  std::vector<Vec3> points = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 }, { 0, 0, 2 },
    { 2, 0, 2 }, { 2, 2, 2 }, { 0, 2, 2 }, { 1, 0, 2 } };
  Polygon right = { 1, 2, 6 }, back = { 2, 3, 7 }, left = { 3, 0, 4 };
  std::vector<Polygon> tops = { { 8, 5 } };
  const auto passCorner = [&](Index corner, bool passed) {
    if (passed && std::find(tops.back().begin(), tops.back().end(), corner) == tops.back().end())
    {
      tops.back().push_back(corner);
    }
  };
  std::vector<Index> onRight, onBack, onLeft;
  bool behind6 = false, behind7 = false;
  for (const Vec3& end : ends)
  {
    const Index id = static_cast<Index>(points.size());
    points.push_back(end);
    const bool isBack = end.y() == 2, isLeft = end.x() == 0;
    passCorner(6, !behind6 && (isBack || isLeft));
    behind6 = behind6 || isBack || isLeft;
    passCorner(7, !behind7 && isLeft);
    behind7 = behind7 || isLeft;
    (isLeft ? onLeft : isBack ? onBack : onRight).push_back(id);
    tops.back().push_back(id);
    tops.push_back({ 8, id });
  }
  passCorner(6, !behind6);
  passCorner(7, !behind7);
  tops.back().push_back(4);
  // Seen from outside a side runs against the top.
  right.insert(right.end(), onRight.rbegin(), onRight.rend());
  right.push_back(5);
  back.insert(back.end(), onBack.rbegin(), onBack.rend());
  back.push_back(6);
  left.insert(left.end(), onLeft.rbegin(), onLeft.rend());
  left.push_back(7);
  std::vector<Polygons> patches = { { { 0, 3, 2, 1 } }, { { 0, 1, 5, 8, 4 } }, { right }, { back },
    { left } };
  for (const Polygon& top : tops)
  {
    patches.push_back({ top });
  }
  return Body(points, patches, everyCorner);
}

/// Patches: base, then the sides of a pyramid over a regular polygon whose first corner is in
/// direction x.
Body Pyramid(int sides, double radius, const Vec3& apex, bool everyCorner = false)
{
  std::vector<Vec3> points;
  Polygon base;
  std::vector<Polygons> patches(1);
  for (int i = 0; i < sides; ++i)
  {
    const double angle = 2 * Pi * i / sides;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
    base.push_back(sides - 1 - i);
    patches.push_back({ { i, (i + 1) % sides, sides } });
  }
  points.push_back(apex);
  patches[0] = { base };
  return Body(points, patches, everyCorner);
}

/// A box with a small bump in its front, below a piece of its upper edge, where the crease is flat.
/// Patches: front, top, the others.
Body BoxWithBump(double length)
{
  const double from = 1.0, to = 1.0 + length;
  const std::vector<Vec3> points = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 },
    { 0, 0, 2 }, { 2, 0, 2 }, { 2, 2, 2 }, { 0, 2, 2 }, { from, 0, 2 }, { to, 0, 2 },
    { 0.5 * (from + to), 0, 1.9 }, { 0.5 * (from + to), -0.1, 1.99 } };
  const Polygons front = { { 10, 4, 0 }, { 10, 0, 1 }, { 10, 1, 5 }, { 10, 5, 9 }, { 10, 8, 4 },
    { 11, 8, 10 }, { 11, 10, 9 }, { 11, 9, 8 } };
  return Body(points,
    { front, { { 7, 4, 8, 9, 5, 6 } }, { { 0, 3, 2, 1 } }, { { 1, 2, 6, 5 } }, { { 2, 3, 7, 6 } },
      { { 3, 0, 4, 7 } } });
}

/// A box whose front is a ramp of 146 degrees to the top from x = @a ramp to 2 and upright from 0
/// to @a wall. Patches: front, top, the others.
Body BoxWithRamp(double wall, double ramp)
{
  const std::vector<Vec3> points = { { 0, 0, 0 }, { wall, 0, 0 }, { ramp, -3, 0 }, { 2, -3, 0 },
    { 2, 2, 0 }, { 0, 2, 0 }, { 0, 0, 2 }, { wall, 0, 2 }, { ramp, 0, 2 }, { 2, 0, 2 },
    { 2, 2, 2 }, { 0, 2, 2 } };
  return Body(points,
    { { { 0, 1, 7, 6 }, { 7, 1, 2 }, { 7, 2, 8 }, { 2, 3, 9, 8 } }, { { 11, 6, 7, 8, 9, 10 } },
      { { 1, 0, 5, 4, 3, 2 } }, { { 3, 4, 10, 9 } }, { { 4, 5, 11, 10 } }, { { 5, 0, 6, 11 } } });
}
}

TEST(PaddingGroups, FacesOfABoxAreApart)
{
  EXPECT_EQ(Prism(Square()).Groups(), (Groups{ 0, 1, 2, 3, 4, 5 }));
}

TEST(PaddingGroups, FacesAtAConcaveEdgeAreTogether)
{
  // The concave corner is the first point, its sides the first and the last.
  const Body body = Prism({ { 1, 1 }, { 1, 2 }, { 0, 2 }, { 0, 0 }, { 2, 0 }, { 2, 1 } });
  EXPECT_EQ(body.Groups(), (Groups{ 0, 1, 2, 3, 4, 5, 6, 2 }));
}

TEST(PaddingGroups, SidesOfAFlatCurveAreTogether)
{
  EXPECT_EQ(BoxWithFan({ { 1, 2, 2 } }).Groups(), (Groups{ 0, 1, 2, 3, 4, 5, 5 }));
}

TEST(PaddingGroups, OneHexUpTo120Degrees)
{
  for (double angle : { 32.0, 45.0, 60.0, 90.0, 115.0 })
  {
    EXPECT_EQ(TrianglePrism(angle).Groups(), (Groups{ 0, 1, 2, 3, 4 })) << angle;
  }
  for (double angle : { 60.0, 90.0, 120.0 })
  {
    EXPECT_EQ(KitePrism(angle).Groups(), (Groups{ 0, 1, 2, 3, 4, 5 })) << angle;
  }
  for (double angle : { 127.0, 135.0, 148.0 })
  {
    EXPECT_EQ(KitePrism(angle).Groups(), (Groups{ 0, 1, 2, 3, 4, 2 })) << angle;
  }
}

TEST(PaddingGroups, WideSectorThatIsOneQuad)
{
  // 135 and 45 degrees on the top, then 163 and 17.
  EXPECT_EQ(BoxWithFan({ { 2, 1, 2 } }, true).Groups(), (Groups{ 0, 1, 2, 3, 4, 5, 5 }));
  EXPECT_EQ(BoxWithFan({ { 2, 0.3, 2 } }, true).Groups(), (Groups{ 0, 1, 2, 3, 4, 1, 1 }));
  EXPECT_EQ(BoxWithFan({ { 0, 0.3, 2 } }, true).Groups(), (Groups{ 0, 1, 2, 3, 4, 1, 1 }));
}

TEST(PaddingGroups, ThreeSectorsOfOneGroup)
{
  EXPECT_EQ(
    BoxWithFan({ { 2, 1, 2 }, { 0, 1, 2 } }).Groups(), (Groups{ 0, 1, 2, 3, 4, 1, 1, 1 }));
}

TEST(PaddingGroups, TwoSectorsOfEachOfTwoGroups)
{
  // A curve right round the box: four sectors where it crosses an edge.
  std::vector<Vec3> points;
  for (double x : { 0.0, 1.0, 2.0 })
  {
    for (const auto& [y, z] : Square())
    {
      points.emplace_back(x, y, z);
    }
  }
  std::vector<Polygons> patches = { { { 0, 3, 2, 1 } }, { { 8, 9, 10, 11 } } };
  for (Index k = 0; k < 4; ++k)
  {
    const Index next = (k + 1) % 4;
    for (Index x : { 0, 4 })
    {
      patches.push_back({ { x + k, x + next, x + next + 4, x + k + 4 } });
    }
  }
  EXPECT_EQ(Body(points, patches).Groups(), (Groups{ 0, 1, 2, 2, 3, 3, 4, 4, 5, 5 }));
}

TEST(PaddingGroups, CornerOfMoreThanThreeSectors)
{
  EXPECT_EQ(Pyramid(3, 1.2, { 0, 0, 1.5 }).Groups(), (Groups{ 0, 1, 2, 3 }));
  // The two sides beside the flattest crease are together, and the other two: each pair has two
  // quads at the apex.
  EXPECT_EQ(Pyramid(4, 1.2, { 0.2, 0, 2 }).Groups(), (Groups{ 0, 1, 2, 2, 1 }));
  EXPECT_EQ(Pyramid(4, 1.2, { 0, 0.2, 2 }).Groups(), (Groups{ 0, 1, 1, 2, 2 }));
  EXPECT_EQ(Pyramid(4, 1.2, { -0.2, 0, 2 }).Groups(), (Groups{ 0, 1, 2, 2, 1 }));
  EXPECT_EQ(Pyramid(4, 1.2, { 0, -0.2, 2 }).Groups(), (Groups{ 0, 1, 1, 2, 2 }));
}

TEST(PaddingGroups, NoGroupHasMoreThanTwoSectorsBesideAnother)
{
  const Body pyramid = Pyramid(5, 1.2, { 0.1, 0.05, 2 }, true);
  EXPECT_EQ(pyramid.Groups(), (Groups{ 0, 1, 1, 1, 1, 1 }));
}

TEST(PaddingGroups, NeedleWithoutRoomForOneHex)
{
  // All angles at the tip are 18 degrees: the one hex there would be flat.
  const Groups groups = Pyramid(3, 0.18, { 0, 0, 1 }, true).Groups();
  EXPECT_EQ(std::set<int>(groups.begin(), groups.end()).size(), 3u);
  EXPECT_EQ(std::count(groups.begin(), groups.end(), 0), 1); // the base
  // Without a corner there nothing parts the sides.
  EXPECT_EQ(Pyramid(3, 0.18, { 0, 0, 1 }).Groups(), (Groups{ 0, 1, 1, 1 }));
}

TEST(PaddingGroups, GivenUpCurve)
{
  const Body box = Prism(Square());
  GivenUpFeatures givenUp;
  givenUp.Curves = { box.CurveBetween(1, 4) };
  EXPECT_EQ(box.Groups(givenUp), (Groups{ 0, 1, 2, 3, 1, 4 }));
}

TEST(PaddingGroups, CornerThatIsNotEnforced)
{
  Body box = Prism(Square());
  const Index corner = box.CornerAt(6); // of the top and the second and third side
  GivenUpFeatures givenUp;
  givenUp.Corners = { corner };
  const Groups expected = { 0, 1, 2, 1, 1, 3 };
  EXPECT_EQ(box.Groups(givenUp), expected);
  box.Graph.Corners[corner].Flaw = CornerFlaw::ManyCurves;
  EXPECT_EQ(box.Groups(), expected);
  box.Trim = 5; // nothing of the curves is left
  EXPECT_EQ(box.Groups(), expected);
}

TEST(PaddingGroups, CapsAndSideOfACylinderAreApart)
{
  const FeatureShape cylinder = CylinderWithFeatures(4);
  ASSERT_EQ(cylinder.Graph.NumberOfPatches, 3);
  const FeatureGeometry geometry(cylinder.Surface, cylinder.Graph, 0.1);
  EXPECT_EQ(GroupPatches(geometry), (Groups{ 0, 1, 2 }));
}

TEST(PaddingGroups, WithoutCurvesOneGroup)
{
  const SurfaceMesh sphere = SphereSurface(6);
  SurfaceFeatures features;
  FeatureGraphReport report;
  ASSERT_TRUE(
    BuildSurfaceFeatures(sphere, {}, {}, FeatureGraphOptions(), features, report).Ok());
  EXPECT_EQ(GroupPatches(FeatureGeometry(sphere, features, 0.1)), Groups{ 0 });
}

TEST(PaddingGroups, FlatPieceOfACrease)
{
  // 1.75 % of its length.
  EXPECT_EQ(BoxWithRamp(1.965, 1.98).Groups(), (Groups{ 0, 1, 2, 3, 4, 5 }));
  EXPECT_EQ(BoxWithRamp(1.5, 1.6).Groups(), (Groups{ 0, 0, 1, 2, 3, 4 }));
  EXPECT_EQ(BoxWithRamp(1.0, 1.1).Groups(), (Groups{ 0, 0, 1, 2, 3, 4 }));
}

TEST(PaddingGroups, SmallTrianglesSayLittle)
{
  for (double length : { 0.01, 0.03, 0.3 })
  {
    EXPECT_EQ(BoxWithBump(length).Groups(), (Groups{ 0, 1, 2, 3, 4, 5 })) << length;
  }
}

TEST(PaddingGroups, RotationOrderAndSizeChangeNothing)
{
  Eigen::Matrix3d rotation;
  rotation = Eigen::AngleAxisd(0.7, Vec3(1, -2, 0.5).normalized());
  for (const Body& body : { Prism(Square()), BoxWithFan({ { 2, 1, 2 } }),
         Pyramid(4, 1.2, { 0.2, 0.05, 2 }), KitePrism(135), BoxWithRamp(1.5, 1.6) })
  {
    for (double scale : { 1e-3, 1.0, 1e4 })
    {
      Body moved = body;
      for (Vec3& p : moved.Surface.Points)
      {
        p = scale * (rotation * p + Vec3(10, -20, 5));
      }
      moved.Trim *= scale;
      EXPECT_EQ(moved.Groups(), body.Groups());
    }
    Body turned = body; // curves run the other way
    for (FeatureCurve& curve : turned.Graph.Curves)
    {
      std::reverse(curve.Points.begin(), curve.Points.end());
      std::swap(curve.FirstCorner, curve.LastCorner);
      std::swap(curve.LeftPatch, curve.RightPatch);
    }
    EXPECT_EQ(turned.Groups(), body.Groups());
  }
}

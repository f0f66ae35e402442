// SPDX-License-Identifier: BSD-3-Clause
#include "SolverMeshes.h"

#include <cmath>

using namespace featurehex;

TEST(SolverMesh, LabelsFacesEdgesAndCorners)
{
  for (int nodes : { 8, 20, 27 })
  {
    const SolverMesh mesh = TwoBodies(nodes);
    const SolverGroups groups(mesh);
    ASSERT_EQ(groups.Patches.size(), 3u);
    EXPECT_EQ(groups.Patches.at(0).size(), 1u);
    EXPECT_EQ(groups.Patches.at(4).size(), 8u);
    EXPECT_EQ(groups.Curves.at(2).size(), 4u);
    EXPECT_EQ(groups.Corners.at(5).size(), 1u);
    EXPECT_EQ(groups.Bodies.size(), 2u);
    const std::vector<Index> bottom = PointsOfSides(mesh, groups.Patches.at(0));
    EXPECT_EQ(bottom.size(), nodes == 8 ? 4u : nodes == 20 ? 8u : 9u);
    for (Index v : bottom)
    {
      EXPECT_EQ(mesh.Points[v].z(), 0.0);
    }
    EXPECT_EQ(PointsOfSegments(mesh, groups.Curves.at(0)).size(), nodes == 8 ? 4u : 8u);
    ExpectMiddles(mesh.Points, mesh);
  }
}

TEST(SolverMesh, FacesWithoutQuadTakeThePatchOfTheirPoints)
{
  SolverMesh mesh = TwoBodies();
  SolverLabels labels;
  ASSERT_TRUE(LabelSolverMesh(labels, mesh).Ok());
  EXPECT_EQ(SolverGroups(mesh).Patches.at(0).size(), 10u);
  // The lower points lie in patch 7, the upper ones in 8, those between in none: faces of the lower
  // hex belong to 7, those of the upper to 8.
  labels.PatchOfPoint = { 7, 7, 7, 7, -1, -1, -1, -1, 8, 8, 8, 8 };
  ASSERT_TRUE(LabelSolverMesh(labels, mesh).Ok());
  EXPECT_EQ(SolverGroups(mesh).Patches.at(7).size(), 5u);
  EXPECT_EQ(SolverGroups(mesh).Patches.at(8).size(), 5u);
  // A cut: points of two patches, or of none.
  labels.PatchOfPoint = { 7, 7, 7, 7, -1, -1, -1, -1, 8, 8, 9, 9 };
  ASSERT_TRUE(LabelSolverMesh(labels, mesh).Ok());
  EXPECT_EQ(SolverGroups(mesh).Patches.at(10).size(), 3u);
}

TEST(SolverMesh, QuadsBetweenBodiesAndStrangers)
{
  SolverMesh mesh = TwoBodies();
  SolverLabels labels;
  labels.Quads = { { 7, 6, 5, 4 }, { 0, 1, 2, 11 } };
  labels.Patches = { 3, 9 };
  labels.Edges = { { 0, 2 }, { 5, 1 } };
  labels.Curves = { 1, 2 };
  ASSERT_TRUE(LabelSolverMesh(labels, mesh).Ok());
  const SolverGroups groups(mesh);
  ASSERT_EQ(groups.Patches.count(3), 1u);
  EXPECT_EQ(mesh.Sides[groups.Patches.at(3).front()].Hex, 0);
  EXPECT_EQ(groups.Patches.count(9), 0u);
  EXPECT_EQ(groups.Curves.count(1), 0u);
  EXPECT_EQ(groups.Curves.count(2), 1u);
}

TEST(SolverMesh, SaysWhatIsWrong)
{
  SolverMesh mesh;
  EXPECT_EQ(LabelSolverMesh({}, mesh).Code, StatusCode::EmptySurface);
  mesh = TwoBodies();
  mesh.HexNodes[3] = 12;
  EXPECT_EQ(LabelSolverMesh({}, mesh).Code, StatusCode::IndexOutOfRange);
  mesh = TwoBodies();
  mesh.Points[2].x() = NAN;
  EXPECT_EQ(LabelSolverMesh({}, mesh).Code, StatusCode::NonFinite);
  mesh = TwoBodies();
  mesh.Corners[0].Point = -1;
  EXPECT_EQ(CheckSolverMesh(mesh).Code, StatusCode::IndexOutOfRange);
  mesh = TwoBodies();
  mesh.Sides[0].Face = 6;
  EXPECT_EQ(CheckSolverMesh(mesh).Code, StatusCode::IndexOutOfRange);
}

TEST(SolverMesh, NamesOfGroups)
{
  EXPECT_EQ(GroupName("patch", 0), "patch_0");
  EXPECT_EQ(GroupName("curve", -3), "curve_n3");
  EXPECT_EQ(GroupName("body", INT32_MIN), "body_n2147483648");
}

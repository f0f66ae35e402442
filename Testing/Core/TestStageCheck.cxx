// SPDX-License-Identifier: BSD-3-Clause
#include "StageCheck.h"
#include "ValidationShapes.h"

#include <gtest/gtest.h>

#include <limits>

using namespace featurehex;

namespace
{
void ExpectDefect(const Status& status, const std::string& words)
{
  EXPECT_EQ(status.Code, StatusCode::Unexpected);
  EXPECT_NE(status.Message.find("Wrong result of the stage probe"), std::string::npos)
    << status.Message;
  EXPECT_NE(status.Message.find(words), std::string::npos) << status.Message;
}

Status Check(const HexMesh& mesh, StagePromise promise, CheckDepth depth = CheckDepth::Full)
{
  return CheckStageOutput({ "probe", promise }, mesh, depth);
}
} // namespace

TEST(StageCheck, GoodOutputsPass)
{
  EXPECT_TRUE(Check(BallMesh(4), StagePromise::Certified).Ok());
  const SurfaceMesh sphere = SphereSurface(8);
  EXPECT_TRUE(
    CheckStageOutput({ "probe", StagePromise::Conforming }, sphere, CheckDepth::Full).Ok());
  OctreeOptions options;
  options.TargetEdgeLength = 0.3;
  BlockOctree octree;
  Monitor monitor;
  ASSERT_TRUE(BuildBlockOctree(sphere, {}, options, octree, nullptr, monitor).Ok());
  EXPECT_TRUE(
    CheckStageOutput({ "probe", StagePromise::Conforming }, octree, CheckDepth::Full).Ok());
}

TEST(StageCheck, CheapChecksAlwaysRun)
{
  for (const CheckDepth depth : { CheckDepth::Cheap, CheckDepth::Full })
  {
    HexMesh mesh = CubeMesh(2);
    mesh.Hexes[3][5] = 27;
    ExpectDefect(Check(mesh, StagePromise::Ids, depth), "hex 3 refers to point 27 of 27");
    mesh = CubeMesh(2);
    mesh.Points[7].y() = std::numeric_limits<double>::infinity();
    EXPECT_TRUE(Check(mesh, StagePromise::Ids, depth).Ok());
    ExpectDefect(Check(mesh, StagePromise::Finite, depth), "point 7 is not finite at (");
    ExpectDefect(Check(HexMesh(), StagePromise::Ids, depth), "no hex");
    mesh = CubeMesh(2);
    ExpectDefect(
      CheckStageOutput({ "probe", StagePromise::Finite, { { "Region", 7, 8 } } }, mesh, depth),
      "the array Region has 7 values instead of 8");
    BlockOctree octree;
    ExpectDefect(CheckStageOutput({ "probe", StagePromise::Finite }, octree, depth), "no leaves");
  }
}

TEST(StageCheck, BrokenConformityHasItsPlace)
{
  HexMesh mesh = CubeMesh(2);
  mesh.Hexes.push_back(mesh.Hexes[6]);
  EXPECT_TRUE(Check(mesh, StagePromise::Conforming, CheckDepth::Cheap).Ok());
  const Status status = Check(mesh, StagePromise::Conforming);
  ExpectDefect(status, "hex 8 is there twice at (0, 1, 1)");
  ASSERT_EQ(status.Where.size(), 1u);
  EXPECT_EQ(status.Where[0], Vec3(0, 1, 1));
  mesh = CubeMesh(2);
  mesh.Hexes[2][1] = mesh.Hexes[2][0];
  ExpectDefect(Check(mesh, StagePromise::Conforming), "hex 2 repeats a point");
}

TEST(StageCheck, InvertedCornersAreOnlyAllowedWithoutThePromise)
{
  HexMesh mesh = CubeMesh(2);
  mesh.Points[13] += Vec3(1.5, 0, 0); // the middle one
  EXPECT_TRUE(Check(mesh, StagePromise::Conforming).Ok());
  ExpectDefect(Check(mesh, StagePromise::PositiveCorners), "has an inverted corner");
}

TEST(StageCheck, PositiveCornersAreNoCertificate)
{
  // Found by a search: corner determinants of 0.125 and more, -0.5 on an edge.
  const HexMesh mesh = { { { -0.5, -0.5, 0 }, { 1.5, -0.5, 0 }, { 0.5, 1.5, 0.5 },
                           { -0.5, 0.5, 0.5 }, { -0.5, 0.5, 1 }, { 1.5, -0.5, 1.5 }, { 1, 1, 1.5 },
                           { 0.5, 1, 0.5 } },
    { { 0, 1, 2, 3, 4, 5, 6, 7 } } };
  ASSERT_TRUE(Check(mesh, StagePromise::PositiveCorners).Ok());
  const Status status = Check(mesh, StagePromise::Certified);
  EXPECT_EQ(status.Code, StatusCode::Validation);
  EXPECT_NE(status.Message.find("probe leaves a hex"), std::string::npos) << status.Message;
}

TEST(StageCheck, OpenSurfaceAndUnbalancedOctree)
{
  SurfaceMesh surface = SphereSurface(8);
  surface.Triangles.pop_back();
  const StageOutput output = { "probe", StagePromise::Conforming };
  ExpectDefect(CheckStageOutput(output, surface, CheckDepth::Full), "not a closed manifold");
  OctreeOptions options;
  options.TargetEdgeLength = 0.3;
  BlockOctree octree;
  Monitor monitor;
  ASSERT_TRUE(BuildBlockOctree(SphereSurface(8), {}, options, octree, nullptr, monitor).Ok());
  octree.Leaves.pop_back();
  ExpectDefect(CheckStageOutput(output, octree, CheckDepth::Full), "not a balanced block octree");
}

TEST(StageCheck, TestsCheckInFull)
{
  EXPECT_EQ(DefaultCheckDepth(), CheckDepth::Full)
    << "Start the test with FEATUREHEX_CHECK_STAGES=1, as CTest does.";
}

// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureHexMesher.h"

#include "FeatureGraphFile.h"
#include "SurfaceReader.h"
#include "ValidationShapes.h"

#include <gtest/gtest.h>

#include <vtkSMPTools.h>

using namespace featurehex;

namespace
{
/// A surface of Data/rotation with its features.
void Read(const std::string& name, SurfaceMesh& surface, MeshingOptions& options)
{
  const std::string path = std::string(FEATUREHEX_SOURCE_DIR) + "/Data/rotation/" + name;
  Status status = ReadSurface(path + ".obj", surface);
  ASSERT_TRUE(status.Ok()) << status.Message;
  FeatureGraph graph;
  status = ReadFeatureGraph(
    path + ".fgraph", static_cast<std::int64_t>(surface.Points.size()), graph);
  ASSERT_TRUE(status.Ok()) << status.Message;
  options.Features.Mode = FeatureMode::Given;
  options.Features.Edges = graph.Edges;
  options.Features.Corners = graph.Corners;
  options.TargetEdgeLength = BoundingBox(surface).Size().maxCoeff() / 8;
}
}

TEST(FeatureHexMesher, TurnedCubeHasAllItsFeaturesForAnyNumberOfThreads)
{
  SurfaceMesh surface;
  MeshingOptions options;
  Read("cube_xyz_25", surface, options);
  MeshingResult results[2];
  for (int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads }, [&] {
      Monitor monitor;
      const Status status = MeshSurface(surface, options, monitor, results[threads - 1]);
      EXPECT_TRUE(status.Ok()) << status.Message;
    });
  }
  const MeshingResult& result = results[0];
  ASSERT_FALSE(result.Mesh.Hexes.empty());
  EXPECT_TRUE(result.Validation.Result.Ok()) << result.Validation.Result.Message;
  EXPECT_GE(result.Validation.Quality.Minimum, 0.2);
  const FeatureValidationReport& features = result.Validation.Features;
  EXPECT_TRUE(features.AllCaptured()) << features.Complaint();
  EXPECT_EQ(features.CornerTotals().Captured, 8);
  EXPECT_EQ(features.CurveTotals().Captured, 12);
  EXPECT_EQ(features.PatchTotals().Captured, 6);
  EXPECT_EQ(results[1].Mesh.Points, result.Mesh.Points);
  EXPECT_EQ(results[1].Mesh.Hexes, result.Mesh.Hexes);
  EXPECT_EQ(results[1].Features.CurvePaths, result.Features.CurvePaths);
}

TEST(FeatureHexMesher, CubeOnTheAxesIsAGrid)
{
  MeshingOptions options;
  options.Features.Mode = FeatureMode::Angle;
  for (const Vec3& low : { Vec3(0, 0, 0), Vec3(0.37, -12.1, 3.3) })
  {
    SurfaceMesh surface = CubeSurface();
    for (Vec3& p : surface.Points)
    {
      p += low;
    }
    Monitor monitor;
    MeshingResult result;
    const Status status = MeshSurface(surface, options, monitor, result);
    ASSERT_TRUE(status.Ok()) << status.Message;
    EXPECT_TRUE(result.Validation.Result.Ok()) << result.Validation.Result.Message;
    EXPECT_LE(result.Mesh.Hexes.size(), 1000u);
    EXPECT_GE(result.Validation.Quality.Minimum, 0.95);
    const FeatureValidationReport& features = result.Validation.Features;
    EXPECT_TRUE(features.AllCaptured()) << features.Complaint();
    EXPECT_EQ(features.CornerTotals().Captured, 8);
    EXPECT_EQ(features.CurveTotals().Captured, 12);
    EXPECT_EQ(features.PatchTotals().Captured, 6);
    EXPECT_EQ(result.Rounds.size(), 1u);
  }
}

TEST(FeatureHexMesher, FeaturesThatNoMeshCanHaveAreGivenUp)
{
  // Twelve curves meet at the tip, and no vertex of an interface has as many edges.
  SurfaceMesh surface;
  MeshingOptions options;
  Read("apex_12", surface, options);
  options.Features.EnforceAll = true;
  options.MaximumLevel = 2;
  options.Tolerance = 0.02; // the tip is blunt then, and the test quick
  Monitor monitor;
  MeshingResult result;
  const Status status = MeshSurface(surface, options, monitor, result);
  ASSERT_TRUE(status.Ok()) << status.Message;
  const FeatureValidationReport& features = result.Validation.Features;
  EXPECT_FALSE(features.AllCaptured());
  EXPECT_EQ(features.CornerTotals().Captured, features.CornerTotals().Found - 1);
  EXPECT_EQ(result.Features.CornerVertices[12], -1);
  EXPECT_GE(result.Rounds.size(), 3u);
  EXPECT_NE(result.Rounds[0].Reason.find("with 12 curves"), std::string::npos)
    << result.Rounds[0].Reason;
}

TEST(FeatureHexMesher, HexesAreAsSmallAsWanted)
{
  SurfaceMesh surface;
  MeshingOptions options;
  Read("cube_xyz_25", surface, options);
  options.Features = FeatureInput();
  options.Tolerance = 0.02;
  options.EdgeLengths.assign(surface.Points.size(), 0.0);
  options.EdgeLengths[3] = 0.3 * options.TargetEdgeLength;
  Monitor monitor;
  MeshingResult result;
  Status status = MeshSurface(surface, options, monitor, result);
  ASSERT_TRUE(status.Ok()) << status.Message;
  const Vec3 corner = surface.Points[3];
  Vec3 opposite = corner;
  for (const Vec3& p : surface.Points)
  {
    opposite = (p - corner).norm() > (opposite - corner).norm() ? p : opposite;
  }
  const auto levelNear = [&](const Vec3& place) {
    std::size_t nearest = 0;
    double least = 1e300;
    for (std::size_t h = 0; h < result.Mesh.Hexes.size(); ++h)
    {
      const double distance = (result.Mesh.Points[result.Mesh.Hexes[h][0]] - place).norm();
      nearest = distance < least ? h : nearest;
      least = std::min(least, distance);
    }
    return result.Level[nearest];
  };
  EXPECT_EQ(levelNear(corner), 2);
  EXPECT_LT(levelNear(opposite), 2);

  options.EdgeLengths[5] = -1;
  status = MeshSurface(surface, options, monitor, result);
  EXPECT_EQ(status.Code, StatusCode::InvalidOption);
  EXPECT_NE(status.Message.find("at point 5"), std::string::npos) << status.Message;
  ASSERT_EQ(status.Where.size(), 1u);
  EXPECT_EQ(status.Where[0], surface.Points[5]);
  options.EdgeLengths.pop_back();
  status = MeshSurface(surface, options, monitor, result);
  EXPECT_EQ(status.Code, StatusCode::InvalidOption);
  EXPECT_NE(status.Message.find("give one for each"), std::string::npos) << status.Message;
}

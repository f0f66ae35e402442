// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureGraphFile.h"

#include "FileAccess.h"
#include "SharedData.h"
#include "SurfaceReader.h"

#include <gtest/gtest.h>

#include <filesystem>

using namespace featurehex;
namespace fs = std::filesystem;

TEST(FeatureGraphFile, RoundTrip)
{
  FeatureGraph graph;
  graph.Corners = { 3, 0 };
  graph.Edges = { { 0, 1 }, { 1, 2147483645 } };
  graph.Angle = 139.9;
  graph.OrphanCurveSingle = false;
  const std::string name = (fs::temp_directory_path() / "featurehex-round-trip.fgraph").string();
  ASSERT_TRUE(WriteFeatureGraph(name, graph).Ok());
  FeatureGraph copy;
  const Status status = ReadFeatureGraph(name, -1, copy);
  ASSERT_TRUE(status.Ok()) << status.Message;
  EXPECT_EQ(copy.Corners, graph.Corners);
  EXPECT_EQ(copy.Edges, graph.Edges);
  EXPECT_EQ(copy.Angle, graph.Angle);
  EXPECT_TRUE(copy.OrphanCurve);
  EXPECT_FALSE(copy.OrphanCurveSingle);
  std::string text;
  ASSERT_TRUE(ReadFileBytes(name, text).Ok());
  EXPECT_EQ(text, "139.9 1 0\n2 2\n3\n0\n0 1\n1 2147483645\n");
  fs::remove(name);

  graph.Corners[0] = -1;
  EXPECT_EQ(WriteFeatureGraph(name, graph).Code, StatusCode::IndexOutOfRange);
  EXPECT_FALSE(fs::exists(name));
}

TEST(FeatureGraphFile, ErrorsNameTheLine)
{
  const struct
  {
    std::string Text;
    StatusCode Code;
    std::string Part;
  } cases[] = { { "", StatusCode::UnreadableFile, "line 1" },
    { "0 1", StatusCode::UnreadableFile, "line 1" },
    { "0 2 1\n0 0\n", StatusCode::UnreadableFile, "\"2\"" },
    { "x 1 1\n", StatusCode::UnreadableFile, "\"x\"" },
    { "0 1 1\n-1 0\n", StatusCode::UnreadableFile, "line 2: \"-1\"" },
    { "0 1 1\n4000000000 4000000000\n1\n", StatusCode::UnreadableFile, "truncated" },
    { "0 1 1\n9223372036854775807 9223372036854775807\n1\n", StatusCode::UnreadableFile,
      "truncated" },
    { "0 1 1\n1 1\n0\n0 5\n", StatusCode::IndexOutOfRange, "line 4: edge refers to point 5" },
    { "0 1 1\n1 1\n-1\n0 5\n", StatusCode::IndexOutOfRange, "line 3" },
    { "0 1 1\n1 0\n99999999999999999999\n", StatusCode::IndexOutOfRange, "line 3" },
    { "0 1 1\n0 1\n2 2\n", StatusCode::Degenerate, "line 3" },
    { "0 1 1\n0 1\n2.5 2\n", StatusCode::UnreadableFile, "\"2.5\"" },
    { "0 1 1\n0 1\n1 2 3\n", StatusCode::UnreadableFile, "\"3\" follows" } };
  for (const auto& c : cases)
  {
    FeatureGraph graph;
    const Status status = ParseFeatureGraph(c.Text, "test", 5, graph);
    EXPECT_EQ(status.Code, c.Code) << c.Text << status.Message;
    EXPECT_NE(status.Message.find(c.Part), std::string::npos) << status.Message;
    EXPECT_TRUE(graph.Corners.empty() && graph.Edges.empty());
  }
}

TEST(FeatureGraphFile, NoFeaturesAreFine)
{
  FeatureGraph graph;
  EXPECT_TRUE(ParseFeatureGraph("140 0 0\r\n0 0", "test", 0, graph).Ok());
  EXPECT_EQ(graph.Angle, 140.0);
  EXPECT_FALSE(graph.OrphanCurve);
}

TEST(FeatureGraphFile, EveryTruncationIsSafe)
{
  const std::string text = "0 1 1\n2 3\n0\n3\n0 1\n1 2\n2 31\n";
  for (std::size_t size = 0; size < text.size(); ++size)
  {
    const std::vector<char> copy(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size));
    FeatureGraph graph;
    const Status status = ParseFeatureGraph(std::string_view(copy.data(), size), "test", 32, graph);
    // Without the last digit or line end it is still a complete file.
    EXPECT_EQ(status.Ok(), size + 2 >= text.size()) << size << status.Message;
  }
}

TEST(FeatureGraphFile, ReadsTheGraphsOfTheCorpus)
{
  if (!fs::exists(SharedData() / "features"))
  {
    GTEST_SKIP() << SharedData() << " is not there";
  }
  int files = 0;
  for (const auto& entry : fs::directory_iterator(SharedData() / "features"))
  {
    if (entry.path().extension() != ".fgraph")
    {
      continue;
    }
    const fs::path surfaceFile =
      SharedData() / "surfaces" / "cad" / entry.path().stem().concat(".obj");
    SurfaceMesh surface;
    Status status = ReadSurface(surfaceFile.string(), surface);
    ASSERT_TRUE(status.Ok()) << status.Message;
    FeatureGraph graph;
    status = ReadFeatureGraph(
      entry.path().string(), static_cast<std::int64_t>(surface.Points.size()), graph);
    EXPECT_TRUE(status.Ok()) << status.Message;
    EXPECT_FALSE(graph.Edges.empty());
    ++files;
  }
  EXPECT_GT(files, 0);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "MeditFile.h"

#include "FileAccess.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

using namespace featurehex;
namespace fs = std::filesystem;

namespace
{
MeditMesh TwoCubes()
{
  MeditMesh mesh;
  for (int k = 0; k < 3; ++k)
  {
    for (const auto& [x, y] : { std::pair(0., 0.), { 1. / 3, 0. }, { 0.1, 1e-300 }, { -0., 1e22 } })
    {
      mesh.Points.push_back({ x, y, k * M_PI });
      mesh.PointReferences.push_back(k);
    }
  }
  mesh.Hexes = { { 0, 1, 2, 3, 4, 5, 6, 7 }, { 4, 5, 6, 7, 8, 9, 10, 11 } };
  mesh.HexReferences = { 1, 2 };
  mesh.Quads = { { 0, 3, 2, 1 }, { 8, 9, 10, 11 } };
  mesh.QuadReferences = { -7, 2147483647 };
  mesh.Edges = { { 0, 1 }, { 1, 2 } };
  mesh.EdgeReferences = { 4, 5 };
  mesh.Corners = { 0, 11 };
  mesh.Ridges = { 1 };
  return mesh;
}

fs::path TemporaryFile(const char* name)
{
  return fs::temp_directory_path() / name;
}

std::string TextOf(const MeditMesh& mesh)
{
  const std::string name = TemporaryFile("featurehex-medit-text.mesh").string();
  EXPECT_TRUE(WriteMedit(name, mesh).Ok());
  std::string text;
  EXPECT_TRUE(ReadFileBytes(name, text).Ok());
  fs::remove(name);
  return text;
}

void ExpectSame(const MeditMesh& a, const MeditMesh& b)
{
  EXPECT_EQ(a.Points, b.Points);
  EXPECT_EQ(a.PointReferences, b.PointReferences);
  EXPECT_EQ(a.Hexes, b.Hexes);
  EXPECT_EQ(a.HexReferences, b.HexReferences);
  EXPECT_EQ(a.Quads, b.Quads);
  EXPECT_EQ(a.QuadReferences, b.QuadReferences);
  EXPECT_EQ(a.Edges, b.Edges);
  EXPECT_EQ(a.EdgeReferences, b.EdgeReferences);
  EXPECT_EQ(a.Corners, b.Corners);
  EXPECT_EQ(a.Ridges, b.Ridges);
}

void ExpectContract(const Status& status, const MeditMesh& mesh)
{
  if (!status.Ok())
  {
    EXPECT_FALSE(status.Message.empty());
    ExpectSame(mesh, MeditMesh());
    return;
  }
  const Index count = static_cast<Index>(mesh.Points.size());
  ASSERT_EQ(mesh.HexReferences.size(), mesh.Hexes.size());
  ASSERT_EQ(mesh.PointReferences.size(), mesh.Points.size());
  for (const Hex& hex : mesh.Hexes)
  {
    for (Index v : hex)
    {
      ASSERT_TRUE(v >= 0 && v < count);
    }
  }
  for (Index ridge : mesh.Ridges)
  {
    ASSERT_TRUE(ridge >= 0 && ridge < static_cast<Index>(mesh.Edges.size()));
  }
}
} // namespace

TEST(MeditFile, RoundTripKeepsEveryBit)
{
  const MeditMesh mesh = TwoCubes();
  MeditMesh copy;
  const Status status = ParseMedit(TextOf(mesh), "test", copy);
  ASSERT_TRUE(status.Ok()) << status.Message;
  ExpectSame(copy, mesh);
  EXPECT_TRUE(std::signbit(copy.Points[3][0]));
}

TEST(MeditFile, MissingReferencesAreWrittenAsZero)
{
  MeditMesh mesh = TwoCubes();
  mesh.PointReferences.clear();
  mesh.HexReferences.clear();
  MeditMesh copy;
  ASSERT_TRUE(ParseMedit(TextOf(mesh), "test", copy).Ok());
  EXPECT_EQ(copy.HexReferences, std::vector<std::int32_t>(2, 0));
}

TEST(MeditFile, ReadsOtherWritersFiles)
{
  const char* text =
    "# made by hand\r\nMeshVersionFormatted\r\n1\r\nDimension\r\n3\r\n"
    "Hexahedra\r\n1\r\n1 2 3 4 5 6 7 8 0\r\n"
    "Vertices 8\r\n0 0 0 0  1 0 0 0  1 1 0 0  0 1 0 0\r\n0 0 1 0 1 0 1 0 1 1 1 0\r\n"
    "0 1 nan 0\r\nTriangles 1\r\n1 2 3 0\r\nNormals 1 0.5 0 0\r\nTetrahedra 0\r\nEnd";
  MeditMesh mesh;
  const Status status = ParseMedit(text, "test", mesh);
  ASSERT_TRUE(status.Ok()) << status.Message;
  EXPECT_EQ(mesh.Hexes.size(), 1u);
  EXPECT_TRUE(std::isnan(mesh.Points[7][2]));
}

TEST(MeditFile, ErrorsNameTheLine)
{
  const std::string head = "MeshVersionFormatted 2\nDimension 3\n";
  const std::string points = "Vertices\n2\n0 0 0 0\n1 0 0 0\n";
  const struct
  {
    std::string Text;
    StatusCode Code;
    std::string Part;
  } cases[] = { { "", StatusCode::UnreadableFile, "line 1" },
    { "solid", StatusCode::UnreadableFile, "MeshVersionFormatted" },
    { "MeshVersionFormatted 2\nDimension 2\n", StatusCode::UnreadableFile, "line 2" },
    { head, StatusCode::EmptySurface, "no points" },
    { head + "Vertices 4000000000\n0 0 0 0\n", StatusCode::UnreadableFile, "truncated" },
    { head + "Vertices 9223372036854775807\n", StatusCode::UnreadableFile, "truncated" },
    { head + "Vertices -1\n", StatusCode::UnreadableFile, "\"-1\"" },
    { head + "Vertices 1\n0 0 0,5 0\n", StatusCode::UnreadableFile, "line 4" },
    { head + "Vertices 1\n0 0 0 0.5\n", StatusCode::UnreadableFile, "entry 1 of 1" },
    { head + "Vertices 1\n0 0 0 99999999999\n", StatusCode::UnreadableFile, "entry 1 of 1" },
    { head + points + "Edges 1\n1 3 0\n", StatusCode::IndexOutOfRange,
      "line 8: refers to point 3" },
    { head + points + "Edges 1\n0 1 0\n", StatusCode::IndexOutOfRange, "line 8" },
    { head + points + "Corners 1\n-4\n", StatusCode::IndexOutOfRange, "-4" },
    { head + points + "Corners 1\n99999999999999999999\n", StatusCode::IndexOutOfRange, "line 8" },
    { head + points + "Edges 1\n1 2 0\nRidges 1\n2\n", StatusCode::IndexOutOfRange, "edge 2" },
    { head + points + "Tetrahedra 1\n1 2 1 2 0\n", StatusCode::InvalidMesh, "1 Tetrahedra" },
    { head + points + "Normals 1\n1 2\n", StatusCode::UnreadableFile, "truncated" },
    { head + points + "Tangents 9223372036854775807\n", StatusCode::UnreadableFile, "Tangents" },
    { head + points + "Surprise 1\n", StatusCode::UnreadableFile, "\"Surprise\"" } };
  for (const auto& c : cases)
  {
    MeditMesh mesh;
    const Status status = ParseMedit(c.Text, "test", mesh);
    EXPECT_EQ(status.Code, c.Code) << c.Text << status.Message;
    EXPECT_NE(status.Message.find(c.Part), std::string::npos) << status.Message;
    ExpectContract(status, mesh);
  }
}

TEST(MeditFile, EveryTruncationAndRandomDamageIsSafe)
{
  const std::string text = TextOf(TwoCubes());
  for (std::size_t size = 0; size < text.size(); ++size)
  {
    const std::vector<char> copy(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size));
    MeditMesh mesh;
    ExpectContract(ParseMedit(std::string_view(copy.data(), size), "test", mesh), mesh);
  }
  std::mt19937 random(7);
  const std::string pieces[] = { "-", "9999999999", "0", "nan", "#", "\n", "Ridges", " " };
  for (int round = 0; round < 5000; ++round)
  {
    std::string damaged = text;
    const std::size_t at = random() % damaged.size();
    if (random() % 2)
    {
      damaged[at] = static_cast<char>(random());
    }
    damaged.replace(random() % damaged.size(), random() % 6, pieces[random() % std::size(pieces)]);
    MeditMesh mesh;
    ExpectContract(ParseMedit(damaged, "test", mesh), mesh);
  }
}

TEST(MeditFile, WrongMeshesAreNotWritten)
{
  const std::string name = TemporaryFile("featurehex-medit-wrong.mesh").string();
  MeditMesh mesh = TwoCubes();
  mesh.Quads[1][2] = 12;
  EXPECT_EQ(WriteMedit(name, mesh).Code, StatusCode::IndexOutOfRange);
  mesh = TwoCubes();
  mesh.HexReferences.pop_back();
  EXPECT_EQ(WriteMedit(name, mesh).Code, StatusCode::IndexOutOfRange);
  mesh = TwoCubes();
  mesh.Points[3][1] = NAN;
  EXPECT_EQ(WriteMedit(name, mesh).Code, StatusCode::NonFinite);
  EXPECT_FALSE(fs::exists(name));
  EXPECT_EQ(WriteMedit("/nowhere/x.mesh", TwoCubes()).Code, StatusCode::UnwritableFile);
  EXPECT_EQ(ReadMedit("/nowhere/x.mesh", mesh).Code, StatusCode::UnreadableFile);
}

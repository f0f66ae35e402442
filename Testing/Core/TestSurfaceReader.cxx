// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceReader.h"

#include "SharedData.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <clocale>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <map>
#include <random>

using namespace featurehex;
namespace fs = std::filesystem;

namespace
{
fs::path BadData()
{
  return SharedData() / "bad";
}

Status Parse(const std::string& text, SurfaceFormat format, SurfaceMesh& surface)
{
  return ParseSurface(text, format, "test", surface);
}

/// What ReadSurface() guarantees.
void ExpectContract(const Status& status, const SurfaceMesh& surface)
{
  if (!status.Ok())
  {
    EXPECT_TRUE(surface.Points.empty() && surface.Triangles.empty());
    EXPECT_FALSE(status.Message.empty());
    return;
  }
  EXPECT_FALSE(surface.Triangles.empty());
  for (const Triangle& t : surface.Triangles)
  {
    for (Index v : t)
    {
      ASSERT_GE(v, 0);
      ASSERT_LT(v, static_cast<Index>(surface.Points.size()));
    }
  }
}

template <typename T>
void Append(std::string& bytes, T value, bool bigEndian = false)
{
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  if (bigEndian)
  {
    std::reverse(raw, raw + sizeof(T));
  }
  bytes.append(raw, sizeof(T));
}

const char* const TetraObj = "# tetrahedron\n"
                             "mtllib none.mtl\n"
                             "v 0 0 0\nv 1.5 0 0 1 0 0\n v +0 1e0 0\nv 0 0 -1.25e-3\n"
                             "vn 0 0 1\nvt 0 0\n"
                             "g body\ns off\n"
                             "f 1/1/1 3//1 2/1\n"
                             "f -4 -3 -1 # relative\n"
                             "f 2 \\\n 3 4\n"
                             "f 1 4 3";

const char* const TetraOff = "OFF # comment\n4 4 6\n0 0 0\n1 0 0 0.5 0.5 0.5\n0 1 0\n\n0 0 1\n"
                             "3 0 2 1 255 0 0\n3 0 1 3\n3 1 2 3\n3 0 3 2";

const char* const TriangleStl = "solid a facet in a name\nfacet normal nan 0 what\nouter loop\n"
                                "vertex 0 0 0\nvertex 1 0 0\nVERTEX 0 1 0\nendloop\nendfacet\n"
                                "endsolid a\n";

std::string BinaryStl(std::uint32_t promised, int written)
{
  std::string bytes(80, ' ');
  bytes.replace(0, 5, "solid");
  Append(bytes, promised);
  for (int i = 0; i < written; ++i)
  {
    for (float x : { 0.f, 0.f, 1.f, 0.f, 0.f, 0.5f, 1.f, 0.f, 0.f, 0.f, 1.f, float(i) })
    {
      Append(bytes, x);
    }
    Append(bytes, std::uint16_t(0));
  }
  return bytes;
}

std::string Ply(const std::string& format, bool bigEndian)
{
  std::string bytes = "ply\nformat " + format +
                      " 1.0\ncomment path C:\\a\\\nobj_info x\nelement vertex 4\nproperty float x\n"
                      "property double y\nproperty uchar red\nproperty float z\nelement camera 1\n"
                      "property list uchar short poses\nelement face 2\nproperty uchar flags\n"
                      "property list uchar int vertex_indices\nend_header\n";
  const double points[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1.5, -2 } };
  if (format == "ascii")
  {
    return bytes + "0 0 255 0\n1 0 255 0\n1 1 255 0\n0 1.5 255 -2\n2 7 8\n0 4 0 1 2 3\n1 3 0 2 1\n";
  }
  for (const auto& p : points)
  {
    Append(bytes, static_cast<float>(p[0]), bigEndian);
    Append(bytes, p[1], bigEndian);
    Append(bytes, std::uint8_t(255));
    Append(bytes, static_cast<float>(p[2]), bigEndian);
  }
  Append(bytes, std::uint8_t(2));
  Append(bytes, std::int16_t(7), bigEndian);
  Append(bytes, std::int16_t(8), bigEndian);
  Append(bytes, std::uint8_t(0));
  Append(bytes, std::uint8_t(4));
  for (int i : { 0, 1, 2, 3 })
  {
    Append(bytes, std::int32_t(i), bigEndian);
  }
  Append(bytes, std::uint8_t(1));
  Append(bytes, std::uint8_t(3));
  for (int i : { 0, 2, 1 })
  {
    Append(bytes, std::int32_t(i), bigEndian);
  }
  return bytes;
}
} // namespace

TEST(SurfaceReader, ReadsObj)
{
  SurfaceMesh surface;
  const Status status = Parse(TetraObj, SurfaceFormat::Obj, surface);
  ASSERT_TRUE(status.Ok()) << status.Message;
  ASSERT_EQ(surface.Points.size(), 4u);
  ASSERT_EQ(surface.Triangles.size(), 4u);
  EXPECT_EQ(surface.Points[1], Vec3(1.5, 0, 0));
  EXPECT_EQ(surface.Points[3][2], -1.25e-3);
  EXPECT_EQ(surface.Triangles[0], (Triangle{ 0, 2, 1 }));
  EXPECT_EQ(surface.Triangles[1], (Triangle{ 0, 1, 3 }));
  EXPECT_EQ(surface.Triangles[2], (Triangle{ 1, 2, 3 }));
}

TEST(SurfaceReader, LineEndsDoNotMatter)
{
  for (const char* end : { "\r\n", "\r", "\n\n \t\n" })
  {
    std::string text;
    for (const char* c = TetraObj; *c; ++c)
    {
      text += *c == '\n' && c[-1] != '\\' ? end : std::string(1, *c);
    }
    SurfaceMesh surface;
    const Status status = Parse(text, SurfaceFormat::Obj, surface);
    EXPECT_TRUE(status.Ok()) << status.Message;
    EXPECT_EQ(surface.Triangles.size(), 4u);
  }
}

TEST(SurfaceReader, PolygonsBecomeFansAndFacesMayComeFirst)
{
  SurfaceMesh surface;
  const Status status = Parse(
    "f 1 2 3 4 5\nv 0 0 0\nv 1 0 0\nv 2 1 0\nv 1 2 0\nv 0 1 0\n", SurfaceFormat::Obj, surface);
  ASSERT_TRUE(status.Ok()) << status.Message;
  ASSERT_EQ(surface.Triangles.size(), 3u);
  EXPECT_EQ(surface.Triangles[2], (Triangle{ 0, 3, 4 }));
}

TEST(SurfaceReader, NonFiniteCoordinatesArePassedOn)
{
  SurfaceMesh surface;
  ASSERT_TRUE(Parse("v nan -inf 1e400\nv 1e-400 -1e999 0.000e999999999999999999\n"
                    "v -0 12345678901234567890123e-300 1\nf 1 2 3\n",
    SurfaceFormat::Obj, surface)
                .Ok());
  EXPECT_TRUE(std::isnan(surface.Points[0][0]));
  EXPECT_EQ(surface.Points[0][1], -HUGE_VAL);
  EXPECT_EQ(surface.Points[0][2], HUGE_VAL);
  EXPECT_EQ(surface.Points[1][0], 0.0);
  EXPECT_EQ(surface.Points[1][1], -HUGE_VAL);
  EXPECT_EQ(surface.Points[1][2], 0.0);
}

TEST(SurfaceReader, ObjErrorsNameTheLine)
{
  struct
  {
    const char* Text;
    StatusCode Code;
    const char* Part;
  } cases[] = { { "v 0 0\n", StatusCode::UnreadableFile, "line 1" },
    { "\n\nv 0 0 1,5\n", StatusCode::UnreadableFile, "line 3: \"1,5\"" },
    { "v 0 0 0\nf 1 1\n", StatusCode::UnreadableFile, "line 2" },
    { "v 0 0 0\nf 1 x 1\n", StatusCode::UnreadableFile, "\"x\"" },
    { "v 0 0 0\nf 0 1 1\n", StatusCode::IndexOutOfRange, "line 2" },
    { "v 0 0 0\nf 1 -2 1\n", StatusCode::IndexOutOfRange, "point -2" },
    { "v 0 0 0\nf 1 1 1\nf 1 1 2\nf 9 1 1\n", StatusCode::IndexOutOfRange,
      "line 3: a face refers to point 2" },
    { "v 0 0 0\nf 1 1 99999999999999999999\n", StatusCode::IndexOutOfRange, "line 2" },
    { "v 0 0 0\nf 1 1 -99999999999999999999\n", StatusCode::IndexOutOfRange, "line 2" },
    { "v 0 0 0\n", StatusCode::EmptySurface, "no faces" },
    { "# nothing\n", StatusCode::EmptySurface, "no points" },
    { "", StatusCode::EmptySurface, "empty" },
    { "\x01\x02", StatusCode::UnreadableFile, "\"??\"" } };
  for (const auto& c : cases)
  {
    SurfaceMesh surface;
    const Status status = Parse(c.Text, SurfaceFormat::Obj, surface);
    EXPECT_EQ(status.Code, c.Code) << c.Text << status.Message;
    EXPECT_NE(status.Message.find(c.Part), std::string::npos) << status.Message;
    ExpectContract(status, surface);
  }
}

TEST(SurfaceReader, ReadsOff)
{
  for (const std::string header : { "", "C", "STCN" })
  {
    SurfaceMesh surface;
    const Status status = Parse(header + TetraOff, SurfaceFormat::Off, surface);
    ASSERT_TRUE(status.Ok()) << status.Message;
    EXPECT_EQ(surface.Points.size(), 4u);
    ASSERT_EQ(surface.Triangles.size(), 4u);
    EXPECT_EQ(surface.Triangles[3], (Triangle{ 0, 3, 2 }));
  }
  SurfaceMesh surface;
  EXPECT_EQ(Parse("OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", SurfaceFormat::Off, surface).Code,
    StatusCode::IndexOutOfRange);
  EXPECT_EQ(
    Parse("OFF 4000000000 9000000000000000000 0\n0 0 0\n", SurfaceFormat::Off, surface).Code,
    StatusCode::UnreadableFile);
  EXPECT_EQ(Parse("4OFF\n", SurfaceFormat::Off, surface).Code, StatusCode::UnreadableFile);
  EXPECT_EQ(
    Parse("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n1000000000 0 1 2\n", SurfaceFormat::Off, surface).Code,
    StatusCode::UnreadableFile);
}

TEST(SurfaceReader, ReadsStl)
{
  SurfaceMesh surface;
  Status status = Parse(TriangleStl, SurfaceFormat::Stl, surface);
  ASSERT_TRUE(status.Ok()) << status.Message;
  EXPECT_EQ(surface.Points.size(), 3u);
  EXPECT_EQ(surface.Points[2], Vec3(0, 1, 0));

  status = Parse(BinaryStl(3, 3), SurfaceFormat::Stl, surface);
  ASSERT_TRUE(status.Ok()) << status.Message;
  EXPECT_EQ(surface.Points.size(), 9u);
  EXPECT_EQ(surface.Triangles[2], (Triangle{ 6, 7, 8 }));
  EXPECT_EQ(surface.Points[8], Vec3(0, 1, 2));
  EXPECT_EQ(surface.Points[0][2], 0.5);
}

TEST(SurfaceReader, StlCountsAreCheckedBeforeAllocation)
{
  SurfaceMesh surface;
  for (std::uint32_t count : { 4u, 0x7fffffffu, 0xffffffffu })
  {
    const Status status = Parse(BinaryStl(count, 3), SurfaceFormat::Stl, surface);
    EXPECT_EQ(status.Code, StatusCode::UnreadableFile);
    EXPECT_NE(status.Message.find("truncated"), std::string::npos) << status.Message;
  }
  EXPECT_EQ(Parse(BinaryStl(0, 3), SurfaceFormat::Stl, surface).Code, StatusCode::UnreadableFile);
  EXPECT_EQ(Parse(BinaryStl(0, 0), SurfaceFormat::Stl, surface).Code, StatusCode::EmptySurface);
  EXPECT_TRUE(Parse(BinaryStl(2, 2) + "tail", SurfaceFormat::Stl, surface).Ok());
}

TEST(SurfaceReader, ReadsPlyInEachEncoding)
{
  for (const std::string format : { "ascii", "binary_little_endian", "binary_big_endian" })
  {
    SurfaceMesh surface;
    const Status status =
      Parse(Ply(format, format == "binary_big_endian"), SurfaceFormat::Ply, surface);
    ASSERT_TRUE(status.Ok()) << format << status.Message;
    ASSERT_EQ(surface.Points.size(), 4u);
    EXPECT_EQ(surface.Points[3], Vec3(0, 1.5, -2));
    ASSERT_EQ(surface.Triangles.size(), 3u);
    EXPECT_EQ(surface.Triangles[1], (Triangle{ 0, 2, 3 }));
    EXPECT_EQ(surface.Triangles[2], (Triangle{ 0, 2, 1 }));
  }
}

TEST(SurfaceReader, ReadsPlyStrips)
{
  SurfaceMesh surface;
  const Status status =
    Parse("ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n"
          "property float z\nelement tristrips 1\nproperty list int int vertex_indices\n"
          "end_header\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 2 0\n8 0 1 2 3 -1 2 3 4\n",
      SurfaceFormat::Ply, surface);
  ASSERT_TRUE(status.Ok()) << status.Message;
  ASSERT_EQ(surface.Triangles.size(), 3u);
  EXPECT_EQ(surface.Triangles[1], (Triangle{ 2, 1, 3 }));
  EXPECT_EQ(surface.Triangles[2], (Triangle{ 2, 3, 4 }));
}

TEST(SurfaceReader, PlyCountsAreCheckedBeforeAllocation)
{
  const std::string start = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  const std::string xyz = "\nproperty float x\nproperty float y\nproperty float z\n";
  SurfaceMesh surface;
  for (const char* count :
    { "4000000000", "9223372036854775807", "-1", "x", "99999999999999999999" })
  {
    EXPECT_EQ(
      Parse(start + count + xyz + "end_header\n............", SurfaceFormat::Ply, surface).Code,
      StatusCode::UnreadableFile);
  }
  // An element without properties has no bytes, so any count of it is possible, and no work.
  EXPECT_EQ(
    Parse(start + "1" + xyz + "element nothing 9000000000000000000\nend_header\n............",
      SurfaceFormat::Ply, surface)
      .Code,
    StatusCode::EmptySurface);
  std::string list =
    start + "1" + xyz +
    "element face 1\nproperty list int int vertex_indices\nend_header\n............";
  Append(list, std::int32_t(0x7fffffff));
  Append(list, std::int32_t(0));
  EXPECT_EQ(Parse(list, SurfaceFormat::Ply, surface).Code, StatusCode::UnreadableFile);
}

TEST(SurfaceReader, EveryTruncationIsSafe)
{
  const std::pair<SurfaceFormat, std::string> files[] = { { SurfaceFormat::Obj, TetraObj },
    { SurfaceFormat::Off, TetraOff }, { SurfaceFormat::Stl, TriangleStl },
    { SurfaceFormat::Stl, BinaryStl(3, 3) }, { SurfaceFormat::Ply, Ply("ascii", false) },
    { SurfaceFormat::Ply, Ply("binary_little_endian", false) },
    { SurfaceFormat::Ply, Ply("binary_big_endian", true) } };
  for (const auto& [format, text] : files)
  {
    for (std::size_t size = 0; size < text.size(); ++size)
    {
      // A heap copy of the exact size, so that the sanitizer sees each byte read too much.
      const std::vector<char> copy(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(size));
      SurfaceMesh surface;
      const Status status =
        ParseSurface(std::string_view(copy.data(), size), format, "test", surface);
      ExpectContract(status, surface);
      if (format == SurfaceFormat::Stl && size + 20 < text.size())
      {
        EXPECT_FALSE(status.Ok()) << size;
      }
    }
  }
}

TEST(SurfaceReader, RandomDamageIsSafe)
{
  const std::pair<SurfaceFormat, std::string> files[] = { { SurfaceFormat::Obj, TetraObj },
    { SurfaceFormat::Off, TetraOff }, { SurfaceFormat::Stl, TriangleStl },
    { SurfaceFormat::Stl, BinaryStl(3, 3) }, { SurfaceFormat::Ply, Ply("ascii", false) },
    { SurfaceFormat::Ply, Ply("binary_little_endian", false) },
    { SurfaceFormat::Ply, Ply("binary_big_endian", true) } };
  std::mt19937 random(20240501);
  const std::string pieces[] = { "-", "9999999999", "1e999", "nan", "#", "\n", "\\\n", " ", "0",
    std::string(1, '\0'), "\xff", "list", "/", "." };
  for (const auto& [format, text] : files)
  {
    for (int round = 0; round < 3000; ++round)
    {
      std::string damaged = text;
      for (unsigned k = 0; k < 1 + random() % 3; ++k)
      {
        const std::size_t at = random() % damaged.size();
        switch (random() % 3)
        {
          case 0:
            damaged[at] = static_cast<char>(random());
            break;
          case 1:
            damaged.replace(at, random() % 4, pieces[random() % std::size(pieces)]);
            break;
          default:
            damaged.erase(at, random() % 8);
            break;
        }
        damaged += damaged.empty() ? " " : "";
      }
      SurfaceMesh surface;
      ExpectContract(ParseSurface(damaged, format, "test", surface), surface);
    }
  }
}

TEST(SurfaceReader, FormatByExtensionThenByContent)
{
  EXPECT_EQ(DetectSurfaceFormat("a/B.OBJ", "ply\n"), SurfaceFormat::Obj);
  EXPECT_EQ(DetectSurfaceFormat("x.Stl", ""), SurfaceFormat::Stl);
  EXPECT_EQ(DetectSurfaceFormat("x", "ply\nformat"), SurfaceFormat::Ply);
  EXPECT_EQ(DetectSurfaceFormat("x.dat", "COFF\n3 1 0"), SurfaceFormat::Off);
  EXPECT_EQ(DetectSurfaceFormat("x.dat", BinaryStl(2, 2)), SurfaceFormat::Stl);
  EXPECT_EQ(DetectSurfaceFormat("x.dat", "hello"), SurfaceFormat::Unknown);
  SurfaceMesh surface;
  EXPECT_EQ(Parse("hello", SurfaceFormat::Unknown, surface).Code, StatusCode::UnreadableFile);
}

TEST(SurfaceReader, MissingFilesFoldersAndDevices)
{
  SurfaceMesh surface;
  EXPECT_EQ(ReadSurface("/nowhere/x.stl", surface).Code, StatusCode::UnreadableFile);
  EXPECT_EQ(
    ReadSurface(fs::temp_directory_path().string(), surface).Code, StatusCode::UnreadableFile);
  EXPECT_EQ(ReadSurface("/dev/zero", surface).Code, StatusCode::UnreadableFile);
  EXPECT_EQ(ReadSurface("", surface).Code, StatusCode::UnreadableFile);
}

TEST(SurfaceReader, DecimalCommaOfTheLocaleIsIgnored)
{
  // Where the locale is not installed the test still covers the default one.
  const char* changed = std::setlocale(LC_ALL, "de_DE.UTF-8");
  SurfaceMesh surface;
  const Status status = Parse(TetraObj, SurfaceFormat::Obj, surface);
  std::setlocale(LC_ALL, "C");
  RecordProperty("locale", changed ? changed : "C");
  ASSERT_TRUE(status.Ok()) << status.Message;
  EXPECT_EQ(surface.Points[1][0], 1.5);
}

TEST(SurfaceReader, BrokenFilesOfTheTable)
{
  if (!fs::exists(BadData()))
  {
    GTEST_SKIP() << BadData() << " is not there";
  }
  const std::map<std::string, std::pair<StatusCode, std::string>> rejected = {
    { "b13_empty.obj", { StatusCode::EmptySurface, "empty" } },
    { "b14_points_only.obj", { StatusCode::EmptySurface, "no faces" } },
    { "b22_text_garbage.obj", { StatusCode::UnreadableFile, "line 1" } },
    { "b23_index_out_of_range.obj", { StatusCode::IndexOutOfRange, "line" } },
    { "b24_truncated_binary.stl", { StatusCode::UnreadableFile, "truncated" } },
    { "b25_text_garbage.stl", { StatusCode::UnreadableFile, "line 4" } },
    { "b26_stl_count_4e9.stl", { StatusCode::UnreadableFile, "truncated" } }
  };
  int files = 0;
  for (const auto& entry : fs::directory_iterator(BadData()))
  {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() == ".tsv")
    {
      continue;
    }
    SurfaceMesh surface;
    const Status status = ReadSurface(entry.path().string(), surface);
    ExpectContract(status, surface);
    const auto expected = rejected.find(name);
    if (expected == rejected.end())
    {
      EXPECT_TRUE(status.Ok()) << name << status.Message;
    }
    else
    {
      EXPECT_EQ(status.Code, expected->second.first) << name << status.Message;
      EXPECT_NE(status.Message.find(expected->second.second), std::string::npos) << status.Message;
    }
    ++files;
  }
  EXPECT_EQ(files, 28);
}

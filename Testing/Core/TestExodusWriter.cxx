// SPDX-License-Identifier: BSD-3-Clause
#include "ExodusWriter.h"

#include "SolverMeshes.h"

#include <cstring>

using namespace featurehex;

namespace
{
/// Just enough of a reader of netCDF's classic format, 64-bit offsets.
class NetCDF
{
public:
  explicit NetCDF(const std::string& bytes)
    : Bytes(bytes)
  {
    EXPECT_EQ(bytes.substr(0, 4), std::string("CDF\2"));
    this->At = 4;
    EXPECT_EQ(this->Int(), 0); // records
    std::vector<std::pair<std::string, int>> dimensions;
    this->Int();
    for (int n = this->Int(); n > 0; --n)
    {
      const std::string name = this->Name();
      dimensions.emplace_back(name, this->Int());
      this->Dimensions.insert(dimensions.back());
    }
    this->Attributes("");
    this->Int();
    std::size_t end = 0;
    for (int n = this->Int(); n > 0; --n)
    {
      const std::string name = this->Name();
      std::size_t count = 1;
      for (int rank = this->Int(); rank > 0; --rank)
      {
        count *=
          static_cast<std::size_t>(dimensions.at(static_cast<std::size_t>(this->Int())).second);
      }
      this->Attributes(name + ".");
      const int type = this->Int();
      const std::size_t width = type == 2 ? 1 : type == 4 ? 4 : 8;
      const auto size = static_cast<std::size_t>(this->Int());
      EXPECT_EQ(this->Int(), 0);
      const auto start = static_cast<std::size_t>(this->Int());
      EXPECT_EQ(size, count == 0 ? width : (count * width + 3) / 4 * 4) << name;
      EXPECT_TRUE(end == 0 || end == start) << name;
      end = start + (count * width + 3) / 4 * 4;
      EXPECT_LE(end, bytes.size());
      this->Variables[name] = bytes.substr(start, count * width);
    }
    EXPECT_EQ(end, bytes.size());
  }

  std::vector<int> Ints(const std::string& variable)
  {
    NetCDF part(*this, this->Variables.at(variable));
    std::vector<int> values;
    while (part.At < part.Bytes.size())
    {
      values.push_back(part.Int());
    }
    return values;
  }

  double Double(const std::string& variable, int i) const
  {
    std::uint64_t bits = 0;
    for (char c : this->Variables.at(variable).substr(static_cast<std::size_t>(i) * 8, 8))
    {
      bits = bits << 8 | static_cast<unsigned char>(c);
    }
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof(value));
    return value;
  }

  std::vector<std::string> Names(const std::string& variable) const
  {
    std::vector<std::string> names;
    const std::string& text = this->Variables.at(variable);
    for (std::size_t at = 0; at < text.size(); at += 33)
    {
      names.emplace_back(text.substr(at, 33).c_str());
    }
    return names;
  }

  std::map<std::string, int> Dimensions;
  std::map<std::string, std::string> Texts; ///< attributes, "variable.name"
  std::map<std::string, std::string> Variables;

private:
  NetCDF(const NetCDF&, const std::string& bytes)
    : Bytes(bytes)
  {
  }

  int Int()
  {
    std::uint32_t value = 0;
    for (int k = 0; k < 4; ++k)
    {
      value = value << 8 | static_cast<unsigned char>(this->Bytes.at(this->At++));
    }
    return static_cast<int>(value);
  }

  std::string Name()
  {
    const auto length = static_cast<std::size_t>(this->Int());
    const std::string name = this->Bytes.substr(this->At, length);
    this->At += (length + 3) / 4 * 4;
    return name;
  }

  void Attributes(const std::string& prefix)
  {
    this->Int();
    for (int n = this->Int(); n > 0; --n)
    {
      const std::string name = this->Name();
      const int type = this->Int();
      if (type == 2)
      {
        this->Texts[prefix + name] = this->Name();
      }
      else
      {
        this->At += 4 * static_cast<std::size_t>(this->Int());
      }
    }
  }

  std::string Bytes;
  std::size_t At = 0;
};

/// Corners of the sides of a hex and of its edges with mid-edge nodes 9 to 20, from the manual of
/// Exodus, 1-based.
constexpr int ExodusSides[6][4] = { { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 4, 8, 7 }, { 1, 5, 8, 4 },
  { 1, 4, 3, 2 }, { 5, 6, 7, 8 } };
constexpr int ExodusEdges[12][2] = { { 1, 2 }, { 2, 3 }, { 3, 4 }, { 4, 1 }, { 1, 5 }, { 2, 6 },
  { 3, 7 }, { 4, 8 }, { 5, 6 }, { 6, 7 }, { 7, 8 }, { 8, 5 } };
/// Sides of the nodes 22 to 27.
constexpr int ExodusFaceNodes[6] = { 5, 6, 4, 2, 1, 3 };
} // namespace

TEST(ExodusWriter, RoundTrip)
{
  for (int nodes : { 8, 20, 27 })
  {
    const SolverMesh mesh = TwoBodies(nodes);
    const std::string bytes = TextOf(mesh, WriteExodus);
    EXPECT_EQ(bytes, TextOf(mesh, WriteExodus));
    NetCDF file(bytes);
    EXPECT_EQ(file.Dimensions.at("num_nodes"), static_cast<int>(mesh.Points.size()));
    EXPECT_EQ(file.Dimensions.at("num_elem"), 2);
    EXPECT_EQ(file.Names("eb_names"), (std::vector<std::string>{ "body_1", "body_2" }));
    EXPECT_EQ(file.Ints("eb_prop1"), (std::vector<int>{ 1, 2 }));
    EXPECT_EQ(file.Texts.at("connect1.elem_type"), "HEX" + std::to_string(nodes));
    EXPECT_EQ(
      file.Names("ss_names"), (std::vector<std::string>{ "patch_0", "patch_1", "patch_4" }));
    EXPECT_EQ(file.Ints("ss_prop1"), (std::vector<int>{ 1, 2, 5 }));
    EXPECT_EQ(file.Names("ns_names"),
      (std::vector<std::string>{ "curve_0", "curve_2", "corner_0", "corner_5" }));
    EXPECT_EQ(file.Ints("ns_prop1"), (std::vector<int>{ 1, 3, 4, 9 }));
    EXPECT_EQ(file.Ints("node_ns4"), std::vector<int>{ 11 });
    std::vector<Vec3> points;
    for (int i = 0; i < file.Dimensions.at("num_nodes"); ++i)
    {
      points.push_back(
        { file.Double("coordx", i), file.Double("coordy", i), file.Double("coordz", i) });
    }
    EXPECT_EQ(points, mesh.Points);

    std::vector<std::vector<int>> hexes;
    for (const char* block : { "connect1", "connect2" })
    {
      hexes.push_back(file.Ints(block));
      ASSERT_EQ(hexes.back().size(), static_cast<std::size_t>(nodes));
    }
    const auto at = [&](int hex, int node) { return points.at(hexes[hex][node - 1] - 1); };
    const auto center = [&](int hex, int side)
    {
      Vec3 sum = Vec3::Zero();
      for (int corner : ExodusSides[side - 1])
      {
        sum += at(hex, corner) / 4.0;
      }
      return sum;
    };
    const std::vector<int> elements = file.Ints("elem_ss2"), sides = file.Ints("side_ss2");
    ASSERT_EQ(elements, std::vector<int>{ 2 });
    EXPECT_DOUBLE_EQ(center(1, sides[0]).z(), 2.0 / 3.0);
    EXPECT_EQ(file.Ints("elem_ss3").size(), 8u);
    for (int hex = 0; hex < 2; ++hex)
    {
      for (int e = 0; e < 12 && nodes > 8; ++e)
      {
        const Vec3 middle = (at(hex, ExodusEdges[e][0]) + at(hex, ExodusEdges[e][1])) / 2.0;
        EXPECT_LT((at(hex, 9 + e) - middle).norm(), 1e-9) << e;
      }
      for (int f = 0; f < 6 && nodes == 27; ++f)
      {
        EXPECT_LT((at(hex, 22 + f) - center(hex, ExodusFaceNodes[f])).norm(), 1e-9) << f;
      }
    }
  }
}

TEST(ExodusWriter, ElementsOfBlocksKeepTheirNumbers)
{
  SolverMesh mesh = TwoBodies();
  mesh.Regions = { 2, 1 };
  NetCDF file(TextOf(mesh, WriteExodus));
  EXPECT_EQ(file.Ints("elem_num_map"), (std::vector<int>{ 2, 1 }));
  EXPECT_EQ(file.Ints("elem_ss1"), std::vector<int>{ 2 });
}

TEST(ExodusWriter, SaysWhatIsWrong)
{
  EXPECT_EQ(WriteExodus("/nowhere/x.exo", TwoBodies()).Code, StatusCode::UnwritableFile);
  EXPECT_EQ(WriteExodus("/nowhere/x.exo", SolverMesh()).Code, StatusCode::EmptySurface);
  SolverMesh mesh = TwoBodies();
  mesh.Corners[0].Id = -1;
  EXPECT_EQ(WriteExodus("/nowhere/x.exo", mesh).Code, StatusCode::InvalidMesh);
}

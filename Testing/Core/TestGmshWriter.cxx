// SPDX-License-Identifier: BSD-3-Clause
#include "GmshWriter.h"

#include "SolverMeshes.h"

#include <cmath>

using namespace featurehex;

namespace
{
struct Element
{
  int Type, Physical;
  std::vector<Index> Nodes; ///< 0-based
};

/// Just enough of a reader of .msh files.
struct MeshFile
{
  std::map<std::pair<int, int>, std::string> Names; ///< by dimension and tag
  std::vector<Vec3> Points;
  std::vector<Element> Elements;

  explicit MeshFile(const std::string& text)
    : In(text)
  {
    std::string version;
    this->Expect("$MeshFormat");
    this->In >> version;
    this->Expect("0 8 $EndMeshFormat $PhysicalNames");
    for (int n = this->Int(); n > 0; --n)
    {
      const int dimension = this->Int(), tag = this->Int();
      std::string name;
      this->In >> name;
      this->Names[{ dimension, tag }] = name.substr(1, name.size() - 2);
    }
    this->Expect("$EndPhysicalNames");
    version == "4.1" ? this->Read41() : this->Read22();
    EXPECT_TRUE(this->In.good());
  }

private:
  void Expect(const std::string& words)
  {
    std::istringstream wanted(words);
    std::string a, b;
    while (wanted >> a)
    {
      this->In >> b;
      EXPECT_EQ(a, b);
    }
  }
  int Int()
  {
    int value = -1;
    this->In >> value;
    return value;
  }
  Vec3 Point()
  {
    Vec3 p;
    std::string word;
    for (int k = 0; k < 3; ++k)
    {
      this->In >> word;
      p[k] = std::stod(word);
    }
    return p;
  }
  void AddElement(int type, int physical)
  {
    const std::map<int, int> lengths = { { 1, 2 }, { 3, 4 }, { 5, 8 }, { 8, 3 }, { 10, 9 },
      { 12, 27 }, { 15, 1 }, { 16, 8 }, { 17, 20 } };
    this->Elements.push_back({ type, physical, {} });
    for (int k = 0; k < lengths.at(type); ++k)
    {
      this->Elements.back().Nodes.push_back(this->Int() - 1);
    }
  }
  void Read22()
  {
    this->Expect("$Nodes");
    const int points = this->Int();
    for (int i = 0; i < points; ++i)
    {
      EXPECT_EQ(this->Int(), i + 1);
      this->Points.push_back(this->Point());
    }
    this->Expect("$EndNodes $Elements");
    const int elements = this->Int();
    for (int i = 0; i < elements; ++i)
    {
      EXPECT_EQ(this->Int(), i + 1);
      const int type = this->Int();
      EXPECT_EQ(this->Int(), 2);
      const int physical = this->Int();
      this->Int();
      this->AddElement(type, physical);
    }
    this->Expect("$EndElements");
  }
  void Read41()
  {
    this->Expect("$Entities");
    int counts[4];
    for (int& count : counts)
    {
      count = this->Int();
    }
    std::map<std::pair<int, int>, int> physical;
    for (int dimension = 0; dimension < 4; ++dimension)
    {
      for (int n = 0; n < counts[dimension]; ++n)
      {
        const int tag = this->Int();
        const Vec3 low = this->Point();
        EXPECT_TRUE(dimension == 0 || (this->Point().array() >= low.array()).all());
        EXPECT_EQ(this->Int(), 1);
        physical[{ dimension, tag }] = this->Int();
        EXPECT_TRUE(dimension == 0 || this->Int() == 0);
      }
    }
    this->Expect("$EndEntities $Nodes");
    int blocks = this->Int();
    const int points = this->Int();
    EXPECT_EQ(this->Int(), 1);
    EXPECT_EQ(this->Int(), points);
    this->Points.resize(static_cast<std::size_t>(points), Vec3::Constant(NAN));
    for (; blocks > 0; --blocks)
    {
      this->Int();
      this->Int();
      EXPECT_EQ(this->Int(), 0);
      std::vector<int> ids(static_cast<std::size_t>(this->Int()));
      for (int& id : ids)
      {
        id = this->Int();
      }
      for (int id : ids)
      {
        this->Points.at(static_cast<std::size_t>(id) - 1) = this->Point();
      }
    }
    this->Expect("$EndNodes $Elements");
    blocks = this->Int();
    const int elements = this->Int();
    EXPECT_EQ(this->Int(), 1);
    EXPECT_EQ(this->Int(), elements);
    for (int id = 0; blocks > 0; --blocks)
    {
      const int dimension = this->Int(), tag = this->Int(), type = this->Int();
      for (int n = this->Int(); n > 0; --n)
      {
        EXPECT_EQ(this->Int(), ++id);
        this->AddElement(type, physical.at({ dimension, tag }));
      }
    }
    EXPECT_EQ(this->Elements.size(), static_cast<std::size_t>(elements));
    this->Expect("$EndElements");
  }

  std::istringstream In;
};

/// Edges of Gmsh's hex, from its manual: mid-edge nodes 8 to 19.
constexpr int GmshEdges[12][2] = { { 0, 1 }, { 0, 3 }, { 0, 4 }, { 1, 2 }, { 1, 5 }, { 2, 3 },
  { 2, 6 }, { 3, 7 }, { 4, 5 }, { 4, 7 }, { 5, 6 }, { 6, 7 } };
constexpr int GmshFaces[6][4] = { { 0, 3, 2, 1 }, { 0, 1, 5, 4 }, { 0, 4, 7, 3 }, { 1, 2, 6, 5 },
  { 2, 3, 7, 6 }, { 4, 5, 6, 7 } };

void ExpectMiddle(
  const MeshFile& file, const Element& element, std::vector<int> corners, std::size_t node)
{
  Vec3 sum = Vec3::Zero();
  for (int k : corners)
  {
    sum += file.Points[element.Nodes[k]];
  }
  EXPECT_LT((file.Points[element.Nodes[node]] - sum / double(corners.size())).norm(), 1e-6)
    << element.Type << " " << node;
}

void ExpectMiddles(const MeshFile& file, const Element& element)
{
  if (element.Type == 12 || element.Type == 17)
  {
    for (int e = 0; e < 12; ++e)
    {
      ExpectMiddle(file, element, { GmshEdges[e][0], GmshEdges[e][1] }, 8 + e);
    }
    for (int f = 0; f < 6 && element.Type == 12; ++f)
    {
      ExpectMiddle(file, element,
        { GmshFaces[f][0], GmshFaces[f][1], GmshFaces[f][2], GmshFaces[f][3] }, 20 + f);
    }
  }
  for (int k = 0; k < 4 && (element.Type == 10 || element.Type == 16); ++k)
  {
    ExpectMiddle(file, element, { k, (k + 1) % 4 }, 4 + k);
  }
  if (element.Type == 8)
  {
    ExpectMiddle(file, element, { 0, 1 }, 2);
  }
}
} // namespace

TEST(GmshWriter, RoundTrip)
{
  for (GmshVersion version : { GmshVersion::V22, GmshVersion::V41 })
  {
    for (int nodes : { 8, 20, 27 })
    {
      const SolverMesh mesh = TwoBodies(nodes);
      const MeshFile file(TextOf(mesh, [version](const std::string& path, const SolverMesh& m)
        { return WriteGmsh(path, m, version); }));
      EXPECT_EQ(file.Points, mesh.Points);
      EXPECT_EQ(
        file.Names, (std::map<std::pair<int, int>, std::string>{ { { 0, 1 }, "corner_0" },
                      { { 0, 6 }, "corner_5" }, { { 1, 1 }, "curve_0" }, { { 1, 3 }, "curve_2" },
                      { { 2, 1 }, "patch_0" }, { { 2, 2 }, "patch_1" }, { { 2, 5 }, "patch_4" },
                      { { 3, 1 }, "body_1" }, { { 3, 2 }, "body_2" } }));
      std::map<std::pair<int, int>, int> counts;
      const int hex = nodes == 8 ? 5 : nodes == 20 ? 17 : 12;
      const int quad = nodes == 8 ? 3 : nodes == 20 ? 16 : 10;
      const int line = nodes == 8 ? 1 : 8;
      for (const Element& element : file.Elements)
      {
        ++counts[{ element.Type, element.Physical }];
        ExpectMiddles(file, element);
        for (Index v : element.Nodes)
        {
          EXPECT_TRUE(
            element.Type != quad || element.Physical != 2 || file.Points[v].z() == 2.0 / 3.0);
          EXPECT_TRUE(element.Type != line || element.Physical != 1 || file.Points[v].z() == 0.0);
        }
      }
      EXPECT_EQ(
        counts, (std::map<std::pair<int, int>, int>{ { { 15, 1 }, 1 }, { { 15, 6 }, 1 },
                  { { line, 1 }, 4 }, { { line, 3 }, 4 }, { { quad, 1 }, 1 }, { { quad, 2 }, 1 },
                  { { quad, 5 }, 8 }, { { hex, 1 }, 1 }, { { hex, 2 }, 1 } }));
    }
  }
}

TEST(GmshWriter, SaysWhatIsWrong)
{
  const auto code = [](const SolverMesh& mesh)
  { return WriteGmsh("/nowhere/x.msh", mesh, GmshVersion::V41).Code; };
  EXPECT_EQ(code(TwoBodies()), StatusCode::UnwritableFile);
  EXPECT_EQ(code(SolverMesh()), StatusCode::EmptySurface);
  SolverMesh mesh = TwoBodies();
  mesh.Sides[3].Patch = -1;
  EXPECT_EQ(code(mesh), StatusCode::InvalidMesh);
}

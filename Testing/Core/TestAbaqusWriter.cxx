// SPDX-License-Identifier: BSD-3-Clause
#include "AbaqusWriter.h"

#include "SolverMeshes.h"
#include "TextScanner.h"

#include <algorithm>
#include <iterator>

using namespace featurehex;

namespace
{
/// Just enough of a reader of .inp files.
struct InputFile
{
  std::map<int, Vec3> Nodes;
  std::map<int, std::vector<int>> Elements;
  std::map<std::string, std::vector<int>> NodeSets, ElementSets;
  std::map<std::string, std::map<std::string, std::string>> Surfaces; ///< set and face
  std::set<std::string> Types;
  std::size_t WidestNumber = 0;

  explicit InputFile(const std::string& text)
  {
    std::istringstream lines(text);
    std::map<std::string, std::string> options;
    std::string line, keyword;
    std::vector<std::string> pending;
    while (std::getline(lines, line))
    {
      EXPECT_FALSE(line.empty());
      std::vector<std::string> words;
      std::string word;
      std::istringstream parts(line);
      while (std::getline(parts, word, ','))
      {
        word.erase(0, word.find_first_not_of(' '));
        words.push_back(word);
      }
      if (line[0] == '*')
      {
        EXPECT_TRUE(pending.empty());
        keyword = words[0];
        options.clear();
        for (const std::string& option : words)
        {
          options[option.substr(0, option.find('='))] = option.substr(option.find('=') + 1);
        }
        continue;
      }
      EXPECT_LE(words.size(), 16u);
      pending.insert(pending.end(), words.begin(), words.end());
      if (line.back() != ',')
      {
        this->Record(keyword, options, pending);
        pending.clear();
      }
    }
  }

private:
  void Record(const std::string& keyword, const std::map<std::string, std::string>& options,
    const std::vector<std::string>& words)
  {
    std::vector<int> ids;
    if (keyword == "*NODE")
    {
      Vec3& point = this->Nodes[std::stoi(words[0])];
      for (int k = 0; k < 3; ++k)
      {
        EXPECT_TRUE(ParseReal(words[k + 1], point[k]));
        this->WidestNumber = std::max(this->WidestNumber, words[k + 1].size());
      }
      return;
    }
    if (keyword == "*SURFACE")
    {
      this->Surfaces[options.at("NAME")][words[0]] = words[1];
      return;
    }
    if (keyword == "*HEADING")
    {
      return;
    }
    for (const std::string& word : words)
    {
      ids.push_back(std::stoi(word));
    }
    if (keyword == "*ELEMENT")
    {
      this->Types.insert(options.at("TYPE"));
      this->ElementSets[options.at("ELSET")].push_back(ids[0]);
      this->Elements[ids[0]] = { ids.begin() + 1, ids.end() };
      return;
    }
    auto& set = keyword == "*NSET" ? this->NodeSets[options.at("NSET")]
                                   : this->ElementSets[options.at("ELSET")];
    set.insert(set.end(), ids.begin(), ids.end());
  }
};

/// Corners of the faces S1 to S6, from the manual.
constexpr int AbaqusFaces[6][4] = { { 1, 2, 3, 4 }, { 5, 8, 7, 6 }, { 1, 5, 6, 2 }, { 2, 6, 7, 3 },
  { 3, 7, 8, 4 }, { 4, 8, 5, 1 } };
} // namespace

TEST(AbaqusWriter, RoundTrip)
{
  for (int nodes : { 8, 20 })
  {
    const SolverMesh mesh = TwoBodies(nodes);
    const InputFile file(TextOf(mesh, WriteAbaqus));
    EXPECT_EQ(file.Types, std::set<std::string>{ nodes == 8 ? "C3D8" : "C3D20" });
    ASSERT_EQ(file.Nodes.size(), mesh.Points.size());
    for (std::size_t i = 0; i < mesh.Points.size(); ++i)
    {
      EXPECT_LT((file.Nodes.at(static_cast<int>(i) + 1) - mesh.Points[i]).norm(), 1e-14);
    }
    EXPECT_LE(file.WidestNumber, 20u);
    for (int hex = 0; hex < 2; ++hex)
    {
      ASSERT_EQ(file.Elements.at(hex + 1).size(), static_cast<std::size_t>(nodes));
      for (int k = 0; k < nodes; ++k)
      {
        EXPECT_EQ(file.Elements.at(hex + 1)[k], mesh.Nodes(hex)[k] + 1);
      }
    }
    EXPECT_EQ(file.ElementSets.at("body_1"), std::vector<int>{ 1 });
    EXPECT_EQ(file.ElementSets.at("body_2"), std::vector<int>{ 2 });
    EXPECT_EQ(file.ElementSets.at("patch_4"), (std::vector<int>{ 1, 2 }));
    EXPECT_EQ(file.NodeSets.at("corner_5"), std::vector<int>{ 11 });
    EXPECT_EQ(file.NodeSets.at("curve_2").size(), nodes == 8 ? 4u : 8u);
    EXPECT_EQ(file.NodeSets.at("patch_1").size(), nodes == 8 ? 4u : 8u);
  }
}

TEST(AbaqusWriter, SurfacesAreTheFacesOfTheirPatch)
{
  const InputFile file(TextOf(TwoBodies(), WriteAbaqus));
  std::map<std::string, std::size_t> faces;
  for (const auto& [name, parts] : file.Surfaces)
  {
    const std::vector<int>& set = file.NodeSets.at(name);
    for (const auto& [elements, face] : parts)
    {
      for (int element : file.ElementSets.at(elements))
      {
        ++faces[name];
        for (int corner : AbaqusFaces[std::stoi(face.substr(1)) - 1])
        {
          const int node = file.Elements.at(element)[static_cast<std::size_t>(corner) - 1];
          EXPECT_NE(std::find(set.begin(), set.end(), node), set.end()) << name << elements;
        }
      }
    }
  }
  EXPECT_EQ(faces,
    (std::map<std::string, std::size_t>{ { "patch_0", 1 }, { "patch_1", 1 }, { "patch_4", 8 } }));
}

TEST(AbaqusWriter, NumbersOfAnyKindFit)
{
  SolverMesh mesh = TwoBodies();
  const double values[] = { -1.2345678901234567e-5, -0.12345678901234567, 1e22, 5e-324,
    -1.7976931348623157e308, 123456789.12345678, 1.0 / 3.0 };
  for (std::size_t i = 0; i < std::size(values); ++i)
  {
    mesh.Points[i].x() = values[i];
  }
  const InputFile file(TextOf(mesh, WriteAbaqus));
  EXPECT_LE(file.WidestNumber, 20u);
  for (std::size_t i = 0; i < std::size(values); ++i)
  {
    EXPECT_NEAR(file.Nodes.at(static_cast<int>(i) + 1).x() / values[i], 1.0, 1e-11);
  }
}

TEST(AbaqusWriter, SaysWhatIsWrong)
{
  EXPECT_EQ(WriteAbaqus("/nowhere/x.inp", TwoBodies()).Code, StatusCode::UnwritableFile);
  EXPECT_EQ(WriteAbaqus("/nowhere/x.inp", TwoBodies(27)).Code, StatusCode::InvalidMesh);
  EXPECT_EQ(WriteAbaqus("/nowhere/x.inp", SolverMesh()).Code, StatusCode::EmptySurface);
}

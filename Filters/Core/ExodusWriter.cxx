// SPDX-License-Identifier: BSD-3-Clause
#include "ExodusWriter.h"

#include "FileAccess.h"

#include <algorithm>
#include <cstring>

namespace featurehex
{
namespace
{
/// Exodus' side numbers of HexFaces, from 1.
constexpr int ExodusSides[6] = { 5, 6, 1, 2, 3, 4 };

/// Exodus' order of the nodes of a hex, in terms of SolverMesh: corners; mid-edge nodes of the
/// bottom, of the vertical edges, of the top; the middle; mid-face nodes -z, +z, -x, +x, -y, +y.
constexpr int ExodusNodes[27] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 16, 17, 18, 19, 12, 13, 14,
  15, 26, 20, 21, 25, 23, 22, 24 };

constexpr int NameLength = 33; ///< 32 characters and a zero

void Append32(std::string& bytes, std::int32_t value)
{
  const auto bits = static_cast<std::uint32_t>(value);
  for (int shift = 24; shift >= 0; shift -= 8)
  {
    bytes += static_cast<char>(bits >> shift & 255u);
  }
}

void Append64(std::string& bytes, std::uint64_t bits)
{
  for (int shift = 56; shift >= 0; shift -= 8)
  {
    bytes += static_cast<char>(bits >> shift & 255u);
  }
}

void AppendDouble(std::string& bytes, double value)
{
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  Append64(bytes, bits);
}

void Pad(std::string& bytes)
{
  bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
}

/// A netCDF file of the classic format in the making: dimensions, variables with their data.
class ClassicFile
{
public:
  enum Type
  {
    Char = 2,
    Int = 4,
    Float = 5,
    Double = 6
  };

  int Dimension(const std::string& name, std::size_t length)
  {
    this->Dimensions.push_back({ name, static_cast<std::int32_t>(length) });
    return static_cast<int>(this->Dimensions.size()) - 1;
  }

  void Attribute(const std::string& name, std::int32_t value)
  {
    std::string data;
    Append32(data, value);
    this->Add(this->Attributes, name, Int, 1, data);
  }
  void Attribute(const std::string& name, float value)
  {
    std::int32_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    std::string data;
    Append32(data, bits);
    this->Add(this->Attributes, name, Float, 1, data);
  }
  void Attribute(const std::string& name, const std::string& text)
  {
    this->Add(this->Attributes, name, Char, text.size(), text);
  }

  /// @a attribute: name and text of one attribute, or empty names.
  void Variable(const std::string& name, Type type, std::vector<int> dimensions, std::string data,
    const std::pair<std::string, std::string>& attribute = {})
  {
    Entry entry{ name, type, std::move(dimensions), {}, std::move(data) };
    if (!attribute.first.empty())
    {
      this->Add(entry.Attributes, attribute.first, Char, attribute.second.size(), attribute.second);
    }
    this->Variables.push_back(std::move(entry));
  }

  void Integers(const std::string& name, std::vector<int> dimensions,
    const std::vector<std::int32_t>& values,
    const std::pair<std::string, std::string>& attribute = {})
  {
    std::string data;
    data.reserve(4 * values.size());
    for (std::int32_t value : values)
    {
      Append32(data, value);
    }
    this->Variable(name, Int, std::move(dimensions), std::move(data), attribute);
  }

  /// Rows of NameLength characters.
  void Names(
    const std::string& name, std::vector<int> dimensions, const std::vector<std::string>& texts)
  {
    std::string data;
    for (std::string text : texts)
    {
      text.resize(NameLength - 1, '\0');
      data += text + '\0';
    }
    this->Variable(name, Char, std::move(dimensions), std::move(data));
  }

  std::string Bytes()
  {
    // The length of the head doesn't depend on the offsets in it.
    std::string bytes = this->Head(this->Head(0).size());
    for (Entry& variable : this->Variables)
    {
      Pad(variable.Data);
      bytes += variable.Data;
      variable.Data = {};
    }
    return bytes;
  }

private:
  struct NamedLength
  {
    std::string Name;
    std::int32_t Length;
  };
  struct AttributeList
  {
    std::int32_t Count = 0;
    std::string Bytes;
  };
  struct Entry
  {
    std::string Name;
    Type Kind;
    std::vector<int> Dimensions;
    AttributeList Attributes;
    std::string Data;
  };

  static void Name(std::string& bytes, const std::string& name)
  {
    Append32(bytes, static_cast<std::int32_t>(name.size()));
    bytes += name;
    Pad(bytes);
  }

  static void Add(AttributeList& list, const std::string& name, Type type, std::size_t count,
    const std::string& data)
  {
    ++list.Count;
    Name(list.Bytes, name);
    Append32(list.Bytes, type);
    Append32(list.Bytes, static_cast<std::int32_t>(count));
    list.Bytes += data;
    Pad(list.Bytes);
  }

  static void List(std::string& bytes, std::int32_t tag, std::size_t count)
  {
    Append32(bytes, count > 0 ? tag : 0);
    Append32(bytes, static_cast<std::int32_t>(count));
  }

  std::string Head(std::uint64_t offset) const
  {
    std::string head = { 'C', 'D', 'F', '\2' };
    Append32(head, 0); // records
    List(head, 10, this->Dimensions.size());
    for (const NamedLength& dimension : this->Dimensions)
    {
      Name(head, dimension.Name);
      Append32(head, dimension.Length);
    }
    List(head, 12, static_cast<std::size_t>(this->Attributes.Count));
    head += this->Attributes.Bytes;
    List(head, 11, this->Variables.size());
    for (const Entry& variable : this->Variables)
    {
      Name(head, variable.Name);
      Append32(head, static_cast<std::int32_t>(variable.Dimensions.size()));
      for (int dimension : variable.Dimensions)
      {
        Append32(head, dimension);
      }
      List(head, 12, static_cast<std::size_t>(variable.Attributes.Count));
      head += variable.Attributes.Bytes;
      Append32(head, variable.Kind);
      const std::uint64_t size = (variable.Data.size() + 3) / 4 * 4;
      // Readers compute the size from the dimensions where it doesn't fit.
      Append32(head, static_cast<std::int32_t>(
                       std::min<std::uint64_t>(this->SizeOf(variable, size), 0xffffffffu)));
      Append64(head, offset);
      offset += size;
    }
    return head;
  }

  /// A variable over time has no data yet, but the size of a record.
  std::uint64_t SizeOf(const Entry& variable, std::uint64_t size) const
  {
    const bool record =
      !variable.Dimensions.empty() &&
      this->Dimensions[static_cast<std::size_t>(variable.Dimensions[0])].Length == 0;
    return record ? 8 : size;
  }

  std::vector<NamedLength> Dimensions;
  AttributeList Attributes;
  std::vector<Entry> Variables;
};

class ExodusFile
{
public:
  explicit ExodusFile(const SolverMesh& mesh)
    : Mesh(mesh)
    , Groups(mesh)
  {
  }

  Status CheckLabels() const
  {
    for (const auto* labels :
      { &this->Groups.Bodies, &this->Groups.Patches, &this->Groups.Curves, &this->Groups.Corners })
    {
      if (!labels->empty() && labels->begin()->first < 0)
      {
        return Status(StatusCode::InvalidMesh, "A body, patch, curve or corner has the number " +
                                                 std::to_string(labels->begin()->first) +
                                                 "; Exodus files can't have negative ones.");
      }
    }
    return {};
  }

  std::string Bytes()
  {
    this->Begin();
    this->Coordinates();
    this->Blocks();
    this->SideSets();
    this->NodeSets();
    // What changes with time comes last in a file: nothing yet.
    this->File.Variable("time_whole", ClassicFile::Double, { this->Time }, {});
    return this->File.Bytes();
  }

private:
  void Begin()
  {
    this->File.Attribute("api_version", 5.14f);
    this->File.Attribute("version", 5.14f);
    this->File.Attribute("floating_point_word_size", 8);
    this->File.Attribute("file_size", 1);
    this->File.Attribute("maximum_name_length", NameLength - 1);
    this->File.Attribute("int64_status", 0);
    this->File.Attribute("title", std::string("FeatureHex"));
    this->File.Dimension("len_string", NameLength);
    this->File.Dimension("len_line", 81);
    this->File.Dimension("four", 4);
    this->NameWidth = this->File.Dimension("len_name", NameLength);
    this->Time = this->File.Dimension("time_step", 0);
  }

  void Coordinates()
  {
    const int axes = this->File.Dimension("num_dim", 3);
    const int nodes = this->File.Dimension("num_nodes", this->Mesh.Points.size());
    this->NumberOfElements = this->File.Dimension("num_elem", this->Mesh.Regions.size());
    this->File.Names("coor_names", { axes, this->NameWidth }, { "x", "y", "z" });
    const char* names[] = { "coordx", "coordy", "coordz" };
    for (int k = 0; k < 3; ++k)
    {
      std::string data;
      data.reserve(8 * this->Mesh.Points.size());
      for (const Vec3& point : this->Mesh.Points)
      {
        AppendDouble(data, point[k]);
      }
      this->File.Variable(names[k], ClassicFile::Double, { nodes }, std::move(data));
    }
  }

  /// Ids, names and status of blocks or sets: @a prefix eb, ss or ns.
  void Table(const std::string& prefix, const std::string& dimension,
    const std::vector<std::int32_t>& ids, const std::vector<std::string>& names)
  {
    const int count = this->File.Dimension(dimension, ids.size());
    this->File.Integers(prefix + "_status", { count }, std::vector<std::int32_t>(ids.size(), 1));
    this->File.Integers(prefix + "_prop1", { count }, ids, { "name", "ID" });
    this->File.Names(prefix + "_names", { count, this->NameWidth }, names);
  }

  void Blocks()
  {
    std::vector<std::int32_t> ids;
    std::vector<std::string> names;
    // A block without number can't have id 0.
    const bool fromZero = this->Groups.Bodies.begin()->first == 0;
    for (const auto& [region, hexes] : this->Groups.Bodies)
    {
      ids.push_back(region + fromZero);
      names.push_back(GroupName("body", region));
    }
    this->Table("eb", "num_el_blk", ids, names);

    const int width = this->Mesh.NodesPerHex;
    const std::string type = "HEX" + std::to_string(width);
    std::vector<std::int32_t> map;
    this->Elements.resize(this->Mesh.Regions.size());
    int block = 0;
    for (const auto& [region, hexes] : this->Groups.Bodies)
    {
      const std::string number = std::to_string(++block);
      std::vector<std::int32_t> nodes;
      for (Index hex : hexes)
      {
        map.push_back(hex + 1);
        this->Elements[static_cast<std::size_t>(hex)] = static_cast<std::int32_t>(map.size());
        for (int k = 0; k < width; ++k)
        {
          nodes.push_back(this->Mesh.Nodes(hex)[ExodusNodes[k]] + 1);
        }
      }
      const int count = this->File.Dimension("num_el_in_blk" + number, hexes.size());
      const int each =
        this->File.Dimension("num_nod_per_el" + number, static_cast<std::size_t>(width));
      this->File.Integers("connect" + number, { count, each }, nodes, { "elem_type", type });
    }
    if (this->Groups.Bodies.size() > 1)
    {
      this->File.Integers("elem_num_map", { this->NumberOfElements }, map);
    }
  }

  void SideSets()
  {
    if (this->Groups.Patches.empty())
    {
      return;
    }
    std::vector<std::int32_t> ids;
    std::vector<std::string> names;
    for (const auto& [patch, sides] : this->Groups.Patches)
    {
      ids.push_back(patch + 1);
      names.push_back(GroupName("patch", patch));
    }
    this->Table("ss", "num_side_sets", ids, names);
    int set = 0;
    for (const auto& [patch, chosen] : this->Groups.Patches)
    {
      const std::string number = std::to_string(++set);
      std::vector<std::int32_t> elements, sides;
      for (Index s : chosen)
      {
        const SolverMesh::Side& side = this->Mesh.Sides[s];
        elements.push_back(this->Elements[static_cast<std::size_t>(side.Hex)]);
        sides.push_back(ExodusSides[side.Face]);
      }
      const int count = this->File.Dimension("num_side_ss" + number, chosen.size());
      this->File.Integers("elem_ss" + number, { count }, elements);
      this->File.Integers("side_ss" + number, { count }, sides);
    }
  }

  void NodeSets()
  {
    std::vector<std::int32_t> ids;
    std::vector<std::string> names;
    std::vector<std::vector<std::int32_t>> nodes;
    for (const auto& [curve, segments] : this->Groups.Curves)
    {
      ids.push_back(curve + 1);
      names.push_back(GroupName("curve", curve));
      nodes.push_back(PointsOfSegments(this->Mesh, segments));
    }
    const std::int32_t highest = ids.empty() ? 0 : ids.back();
    for (const auto& [id, corners] : this->Groups.Corners)
    {
      ids.push_back(highest + 1 + id);
      names.push_back(GroupName("corner", id));
      nodes.emplace_back();
      for (Index corner : corners)
      {
        nodes.back().push_back(this->Mesh.Corners[corner].Point);
      }
    }
    if (ids.empty())
    {
      return;
    }
    this->Table("ns", "num_node_sets", ids, names);
    for (std::size_t set = 0; set < ids.size(); ++set)
    {
      for (std::int32_t& node : nodes[set])
      {
        ++node;
      }
      const std::string number = std::to_string(set + 1);
      const int count = this->File.Dimension("num_nod_ns" + number, nodes[set].size());
      this->File.Integers("node_ns" + number, { count }, nodes[set]);
    }
  }

  const SolverMesh& Mesh;
  const SolverGroups Groups;
  ClassicFile File;
  int NameWidth = 0;
  int Time = 0;
  int NumberOfElements = 0;
  std::vector<std::int32_t> Elements; ///< number of each hex in the file, from 1
};
} // namespace

Status WriteExodus(const std::string& path, const SolverMesh& mesh)
{
  Status status = CheckSolverMesh(mesh);
  if (!status.Ok())
  {
    return status;
  }
  ExodusFile file(mesh);
  status = file.CheckLabels();
  return status.Ok() ? WriteFileBytes(path, file.Bytes()) : status;
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause
#include "GmshWriter.h"

#include "FileAccess.h"
#include "TextScanner.h"

namespace featurehex
{
namespace
{
/// Gmsh's order of the nodes of a hex, in terms of SolverMesh: corners, mid-edge nodes, mid-face
/// nodes, the middle ("Gmsh reference manual", 9.2 node ordering).
constexpr int GmshHexNodes[27] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 16, 9, 17, 10, 18, 19, 12, 15, 13,
  14, 20, 22, 25, 23, 24, 21, 26 };

struct ElementTypes
{
  int Line, Quad, Hex;
};

ElementTypes TypesOf(const SolverMesh& mesh)
{
  return mesh.NodesPerHex == 8    ? ElementTypes{ 1, 3, 5 }
         : mesh.NodesPerHex == 20 ? ElementTypes{ 8, 16, 17 }
                                  : ElementTypes{ 8, 10, 12 };
}

constexpr int PointType = 15;

/// A physical group, which is one elementary entity too.
struct Group
{
  int Dimension;
  std::int64_t Tag;
  std::string Name;
  int ElementType;
  std::vector<std::vector<Index>> Elements; ///< nodes of each
};

std::vector<Group> GroupsOf(const SolverMesh& mesh)
{
  const SolverGroups labels(mesh);
  const ElementTypes types = TypesOf(mesh);
  std::vector<Group> groups;
  for (const auto& [id, corners] : labels.Corners)
  {
    groups.push_back({ 0, std::int64_t{ id } + 1, GroupName("corner", id), PointType, {} });
    for (Index c : corners)
    {
      groups.back().Elements.push_back({ mesh.Corners[c].Point });
    }
  }
  for (const auto& [id, segments] : labels.Curves)
  {
    groups.push_back({ 1, std::int64_t{ id } + 1, GroupName("curve", id), types.Line, {} });
    for (Index s : segments)
    {
      const SolverMesh::Segment& segment = mesh.Segments[s];
      groups.back().Elements.push_back(NodesOfSegment(mesh, segment.Hex, segment.Edge));
    }
  }
  for (const auto& [id, sides] : labels.Patches)
  {
    groups.push_back({ 2, std::int64_t{ id } + 1, GroupName("patch", id), types.Quad, {} });
    for (Index s : sides)
    {
      groups.back().Elements.push_back(NodesOfSide(mesh, mesh.Sides[s].Hex, mesh.Sides[s].Face));
    }
  }
  // A body without number gets tag 1: tags start there.
  const bool fromZero = !labels.Bodies.empty() && labels.Bodies.begin()->first == 0;
  for (const auto& [region, hexes] : labels.Bodies)
  {
    groups.push_back(
      { 3, std::int64_t{ region } + fromZero, GroupName("body", region), types.Hex, {} });
    for (Index hex : hexes)
    {
      std::vector<Index> nodes;
      for (int k = 0; k < mesh.NodesPerHex; ++k)
      {
        nodes.push_back(mesh.Nodes(hex)[GmshHexNodes[k]]);
      }
      groups.back().Elements.push_back(std::move(nodes));
    }
  }
  return groups;
}

class GmshText
{
public:
  GmshText(const SolverMesh& mesh, const std::vector<Group>& groups)
    : Mesh(mesh)
    , Groups(groups)
  {
  }

  std::string Version22()
  {
    this->Head("2.2 0 8");
    this->Line("$Nodes\n", { static_cast<std::int64_t>(this->Mesh.Points.size()) });
    for (std::size_t i = 0; i < this->Mesh.Points.size(); ++i)
    {
      AppendInteger(this->Out, static_cast<std::int64_t>(i) + 1);
      this->Point(" ", this->Mesh.Points[i]);
    }
    this->Line("$EndNodes\n$Elements\n", { this->NumberOfElements() });
    std::int64_t id = 0;
    for (const Group& group : this->Groups)
    {
      for (const std::vector<Index>& nodes : group.Elements)
      {
        this->Integers({ ++id, group.ElementType, 2, group.Tag, group.Tag });
        this->Nodes(nodes);
      }
    }
    this->Out += "$EndElements\n";
    return std::move(this->Out);
  }

  std::string Version41()
  {
    this->Head("4.1 0 8");
    this->Entities();
    this->NodeBlocks();
    const std::int64_t count = this->NumberOfElements();
    this->Line("$Elements\n", { static_cast<std::int64_t>(this->Groups.size()), count, 1, count });
    std::int64_t id = 0;
    for (const Group& group : this->Groups)
    {
      this->Line("", { group.Dimension, group.Tag, group.ElementType,
                       static_cast<std::int64_t>(group.Elements.size()) });
      for (const std::vector<Index>& nodes : group.Elements)
      {
        AppendInteger(this->Out, ++id);
        this->Nodes(nodes);
      }
    }
    this->Out += "$EndElements\n";
    return std::move(this->Out);
  }

private:
  void Integers(const std::vector<std::int64_t>& values)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      this->Out += i == 0 ? "" : " ";
      AppendInteger(this->Out, values[i]);
    }
  }

  void Line(const char* before, const std::vector<std::int64_t>& values)
  {
    this->Out += before;
    this->Integers(values);
    this->Out += '\n';
  }

  void Nodes(const std::vector<Index>& nodes)
  {
    for (Index v : nodes)
    {
      this->Out += ' ';
      AppendInteger(this->Out, std::int64_t{ v } + 1);
    }
    this->Out += '\n';
  }

  void Point(const char* before, const Vec3& point)
  {
    this->Out += before;
    for (int k = 0; k < 3; ++k)
    {
      this->Out += k == 0 ? "" : " ";
      AppendReal(this->Out, point[k]);
    }
    this->Out += '\n';
  }

  std::int64_t NumberOfElements() const
  {
    std::size_t count = 0;
    for (const Group& group : this->Groups)
    {
      count += group.Elements.size();
    }
    return static_cast<std::int64_t>(count);
  }

  void Head(const char* version)
  {
    this->Out = std::string("$MeshFormat\n") + version + "\n$EndMeshFormat\n";
    this->Line("$PhysicalNames\n", { static_cast<std::int64_t>(this->Groups.size()) });
    for (const Group& group : this->Groups)
    {
      this->Integers({ group.Dimension, group.Tag });
      this->Out += " \"" + group.Name + "\"\n";
    }
    this->Out += "$EndPhysicalNames\n";
  }

  /// Without their topology: which curves bound a patch isn't said.
  void Entities()
  {
    std::int64_t counts[4] = { 0, 0, 0, 0 };
    for (const Group& group : this->Groups)
    {
      ++counts[group.Dimension];
    }
    this->Line("$Entities\n", { counts[0], counts[1], counts[2], counts[3] });
    for (const Group& group : this->Groups)
    {
      Box box;
      for (const std::vector<Index>& nodes : group.Elements)
      {
        for (Index v : nodes)
        {
          box.Extend(this->Mesh.Points[v]);
        }
      }
      AppendInteger(this->Out, group.Tag);
      this->Point(" ", box.Low);
      this->Out.back() = ' ';
      if (group.Dimension > 0)
      {
        this->Point("", box.High);
        this->Out.back() = ' ';
      }
      this->Integers({ 1, group.Tag });
      this->Out += group.Dimension > 0 ? " 0\n" : "\n";
    }
    this->Out += "$EndEntities\n";
  }

  /// Each node belongs to the first group that uses it, that is, to the one of lowest dimension.
  void NodeBlocks()
  {
    std::vector<std::vector<Index>> own(this->Groups.size());
    std::vector<char> taken(this->Mesh.Points.size(), 0);
    for (std::size_t g = 0; g < this->Groups.size(); ++g)
    {
      for (const std::vector<Index>& nodes : this->Groups[g].Elements)
      {
        for (Index v : nodes)
        {
          if (!taken[v])
          {
            taken[v] = 1;
            own[g].push_back(v);
          }
        }
      }
    }
    // Points that no element uses go with the last body.
    for (std::size_t v = 0; v < taken.size(); ++v)
    {
      if (!taken[v])
      {
        own.back().push_back(static_cast<Index>(v));
      }
    }
    const auto points = static_cast<std::int64_t>(this->Mesh.Points.size());
    this->Line("$Nodes\n", { static_cast<std::int64_t>(this->Groups.size()), points, 1, points });
    for (std::size_t g = 0; g < this->Groups.size(); ++g)
    {
      this->Line("", { this->Groups[g].Dimension, this->Groups[g].Tag, 0,
                       static_cast<std::int64_t>(own[g].size()) });
      for (Index v : own[g])
      {
        this->Line("", { std::int64_t{ v } + 1 });
      }
      for (Index v : own[g])
      {
        this->Point("", this->Mesh.Points[v]);
      }
    }
    this->Out += "$EndNodes\n";
  }

  const SolverMesh& Mesh;
  const std::vector<Group>& Groups;
  std::string Out;
};
} // namespace

Status WriteGmsh(const std::string& path, const SolverMesh& mesh, GmshVersion version)
{
  const Status status = CheckSolverMesh(mesh);
  if (!status.Ok())
  {
    return status;
  }
  const std::vector<Group> groups = GroupsOf(mesh);
  for (const Group& group : groups)
  {
    if (group.Tag < 1)
    {
      return Status(StatusCode::InvalidMesh,
        "\"" + group.Name + "\" has a negative number; Gmsh's groups can't.");
    }
  }
  GmshText text(mesh, groups);
  return WriteFileBytes(path, version == GmshVersion::V22 ? text.Version22() : text.Version41());
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause
#include "AbaqusWriter.h"

#include "FileAccess.h"
#include "TextScanner.h"

#include <charconv>

namespace featurehex
{
namespace
{
/// Abaqus and CalculiX read this many characters of a number and ignore the rest, be it an
/// exponent.
constexpr std::size_t NumberWidth = 20;

class AbaqusText
{
public:
  explicit AbaqusText(const SolverMesh& mesh)
    : Mesh(mesh)
    , Groups(mesh)
  {
  }

  std::string Text()
  {
    this->Out = "*HEADING\nFeatureHex: hexahedral mesh with patches, curves and corners\n";
    this->Nodes();
    for (const auto& [region, hexes] : this->Groups.Bodies)
    {
      this->Elements(GroupName("body", region), hexes);
    }
    for (const auto& [patch, sides] : this->Groups.Patches)
    {
      this->Patch(GroupName("patch", patch), sides);
    }
    for (const auto& [curve, segments] : this->Groups.Curves)
    {
      this->Set("NSET", GroupName("curve", curve), PointsOfSegments(this->Mesh, segments));
    }
    for (const auto& [id, corners] : this->Groups.Corners)
    {
      std::vector<Index> points;
      for (Index corner : corners)
      {
        points.push_back(this->Mesh.Corners[corner].Point);
      }
      this->Set("NSET", GroupName("corner", id), points);
    }
    return std::move(this->Out);
  }

private:
  void Real(double value)
  {
    const std::size_t start = this->Out.size();
    AppendReal(this->Out, value);
    for (int digits = 16; this->Out.size() - start > NumberWidth; --digits)
    {
      char buffer[32];
      const auto end =
        std::to_chars(buffer, buffer + sizeof(buffer), value, std::chars_format::general, digits);
      this->Out.resize(start);
      this->Out.append(buffer, end.ptr);
    }
  }

  void Nodes()
  {
    this->Out += "*NODE, NSET=nodes\n";
    for (std::size_t i = 0; i < this->Mesh.Points.size(); ++i)
    {
      AppendInteger(this->Out, static_cast<std::int64_t>(i) + 1);
      for (int k = 0; k < 3; ++k)
      {
        this->Out += ", ";
        this->Real(this->Mesh.Points[i][k]);
      }
      this->Out += '\n';
    }
  }

  void Elements(const std::string& name, const std::vector<Index>& hexes)
  {
    this->Out += this->Mesh.NodesPerHex == 8 ? "*ELEMENT, TYPE=C3D8, ELSET=" + name + "\n"
                                             : "*ELEMENT, TYPE=C3D20, ELSET=" + name + "\n";
    for (Index hex : hexes)
    {
      AppendInteger(this->Out, std::int64_t{ hex } + 1);
      for (int k = 0; k < this->Mesh.NodesPerHex; ++k)
      {
        // A line has at most 16 entries; one that ends with a comma goes on.
        this->Out += k == 15 ? ",\n" : ", ";
        AppendInteger(this->Out, std::int64_t{ this->Mesh.Nodes(hex)[k] } + 1);
      }
      this->Out += '\n';
    }
  }

  /// @a kind: NSET or ELSET.
  void Set(const std::string& kind, const std::string& name, const std::vector<Index>& ids)
  {
    this->Out += "*" + kind + ", " + kind + "=" + name + "\n";
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      AppendInteger(this->Out, std::int64_t{ ids[i] } + 1);
      this->Out += (i + 1) % 16 == 0 || i + 1 == ids.size() ? "\n" : ", ";
    }
  }

  void Patch(const std::string& name, const std::vector<Index>& sides)
  {
    // HexFaces are in the order of Abaqus' faces S1 to S6.
    std::vector<Index> hexes;
    std::vector<Index> hexesOfFace[6];
    for (Index s : sides)
    {
      const SolverMesh::Side& side = this->Mesh.Sides[s];
      hexesOfFace[side.Face].push_back(side.Hex);
      if (hexes.empty() || hexes.back() != side.Hex)
      {
        hexes.push_back(side.Hex);
      }
    }
    this->Set("ELSET", name, hexes);
    std::string surface = "*SURFACE, NAME=" + name + ", TYPE=ELEMENT\n";
    for (int face = 0; face < 6; ++face)
    {
      if (!hexesOfFace[face].empty())
      {
        const std::string number = "S" + std::to_string(face + 1);
        this->Set("ELSET", name + "_" + number, hexesOfFace[face]);
        surface += name + "_" + number + ", " + number + "\n";
      }
    }
    this->Out += surface;
    this->Set("NSET", name, PointsOfSides(this->Mesh, sides));
  }

  const SolverMesh& Mesh;
  const SolverGroups Groups;
  std::string Out;
};
} // namespace

Status WriteAbaqus(const std::string& path, const SolverMesh& mesh)
{
  Status status = CheckSolverMesh(mesh);
  if (status.Ok() && mesh.NodesPerHex == 27)
  {
    status = Status(StatusCode::InvalidMesh,
      "CalculiX has no hexahedron of 27 nodes: write .inp with 8 or 20 nodes, or another format.");
  }
  return status.Ok() ? WriteFileBytes(path, AbaqusText(mesh).Text()) : status;
}
} // namespace featurehex

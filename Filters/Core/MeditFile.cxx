// SPDX-License-Identifier: BSD-3-Clause
#include "MeditFile.h"

#include "FileAccess.h"
#include "TextScanner.h"

#include <limits>

namespace featurehex
{
namespace
{
/// Sections that are skipped: integers (or reals) of an entry.
struct SkippedSection
{
  std::string_view Name;
  int Width;
};

constexpr SkippedSection SkippedSections[] = { { "Triangles", 4 }, { "RequiredVertices", 1 },
  { "RequiredEdges", 1 }, { "RequiredTriangles", 1 }, { "RequiredQuadrilaterals", 1 },
  { "Normals", 3 }, { "Tangents", 3 }, { "NormalAtVertices", 2 }, { "TangentAtVertices", 2 },
  { "NormalAtTriangleVertices", 3 }, { "NormalAtQuadrilateralVertices", 3 },
  { "TangentAtEdges", 3 }, { "SubDomainFromGeom", 4 }, { "SubDomainFromMesh", 4 } };

constexpr std::string_view ForeignSections[] = { "Tetrahedra", "Prisms", "Pyramids" };

class MeditParser
{
public:
  MeditParser(std::string_view bytes, const std::string& name, MeditMesh& mesh)
    : Scanner(bytes)
    , Name(name)
    , Mesh(mesh)
  {
  }

  Status Parse()
  {
    std::string_view word;
    std::int64_t number = 0;
    if (!this->Scanner.Word(word) || word != "MeshVersionFormatted" || !this->Integer(number))
    {
      return this->Error(
        "a Medit file starts with \"MeshVersionFormatted\" and a number, not with " + Quoted(word) +
        ". Is this an ASCII .mesh file?");
    }
    while (this->Scanner.Word(word) && word != "End")
    {
      Status status = this->Section(word);
      if (!status.Ok())
      {
        return status;
      }
    }
    return this->CheckReferences();
  }

private:
  Status Error(const std::string& what) const
  {
    return Status(StatusCode::UnreadableFile,
      this->Name + ", line " + std::to_string(this->Scanner.Line()) + ": " + what);
  }

  bool Integer(std::int64_t& value)
  {
    std::string_view word;
    return this->Scanner.Word(word) && ParseInteger(word, value);
  }

  Status Section(std::string_view keyword)
  {
    if (keyword == "Dimension")
    {
      std::int64_t dimension = 0;
      return this->Integer(dimension) && dimension == 3 ? Status()
                                                        : this->Error("the dimension is not 3.");
    }
    if (keyword == "Vertices")
    {
      return this->Vertices();
    }
    if (keyword == "Hexahedra")
    {
      return this->Elements(keyword, this->Mesh.Hexes, this->Mesh.HexReferences);
    }
    if (keyword == "Quadrilaterals")
    {
      return this->Elements(keyword, this->Mesh.Quads, this->Mesh.QuadReferences);
    }
    if (keyword == "Edges")
    {
      return this->Elements(keyword, this->Mesh.Edges, this->Mesh.EdgeReferences);
    }
    if (keyword == "Corners")
    {
      return this->Ids(keyword, this->Mesh.Corners, this->PointIds);
    }
    if (keyword == "Ridges")
    {
      return this->Ids(keyword, this->Mesh.Ridges, this->EdgeIds);
    }
    return this->OtherSection(keyword);
  }

  /// Count of a section, compared with what the file has room for: @a width words an entry.
  Status Count(std::string_view section, int width, std::int64_t& count)
  {
    std::string_view word;
    if (!this->Scanner.Word(word) || !ParseInteger(word, count) || count < 0)
    {
      return this->Error(Quoted(word) + " is no count of " + Quoted(section) + ".");
    }
    const std::int64_t room = (static_cast<std::int64_t>(this->Scanner.Remaining()) + 1) / 2;
    if (count > room / width || count > MaximumIndex)
    {
      return this->Error("truncated: " + Quoted(section) + " promises " + std::to_string(count) +
                         " entries, " + std::to_string(this->Scanner.Remaining()) +
                         " bytes follow.");
    }
    return {};
  }

  Status BadEntry(std::string_view section, std::int64_t i, std::int64_t count)
  {
    return this->Error(
      std::string(this->Scanner.Remaining() == 0 ? "truncated" : "not a number of the right kind") +
      " in entry " + std::to_string(i + 1) + " of " + std::to_string(count) + " of " +
      Quoted(section) + ".");
  }

  bool Reference(std::int32_t& reference)
  {
    std::int64_t value = 0;
    if (!this->Integer(value) || value < std::numeric_limits<std::int32_t>::min() ||
        value > std::numeric_limits<std::int32_t>::max())
    {
      return false;
    }
    reference = static_cast<std::int32_t>(value);
    return true;
  }

  /// Id of the file to 0-based; the upper end is checked when all points are known.
  bool Id(Index& id, ReferenceCheck& check)
  {
    std::int64_t value = 0;
    if (!this->Integer(value))
    {
      return false;
    }
    if (value < 1 || value > MaximumIndex)
    {
      this->WrongId = value;
      return false;
    }
    id = static_cast<Index>(value - 1);
    check.Add(value - 1, this->Scanner.Line());
    return true;
  }

  Status IndexError(std::int64_t id, std::size_t line, const char* what) const
  {
    return Status(StatusCode::IndexOutOfRange, this->Name + ", line " + std::to_string(line) +
                                                 ": refers to " + what + " " + std::to_string(id) +
                                                 ", which does not exist. Export the mesh again.");
  }

  Status Vertices()
  {
    std::int64_t count = 0;
    Status status = this->Count("Vertices", 4, count);
    if (!status.Ok())
    {
      return status;
    }
    this->Mesh.Points.reserve(this->Mesh.Points.size() + static_cast<std::size_t>(count));
    this->Mesh.PointReferences.reserve(this->Mesh.Points.capacity());
    for (std::int64_t i = 0; i < count; ++i)
    {
      Vec3 point;
      std::string_view word;
      std::int32_t reference = 0;
      for (int k = 0; k < 3; ++k)
      {
        if (!this->Scanner.Word(word) || !ParseReal(word, point[k]))
        {
          return this->BadEntry("Vertices", i, count);
        }
      }
      if (!this->Reference(reference))
      {
        return this->BadEntry("Vertices", i, count);
      }
      this->Mesh.Points.push_back(point);
      this->Mesh.PointReferences.push_back(reference);
    }
    return {};
  }

  template <std::size_t Size>
  Status Elements(std::string_view section, std::vector<std::array<Index, Size>>& elements,
    std::vector<std::int32_t>& references)
  {
    std::int64_t count = 0;
    Status status = this->Count(section, static_cast<int>(Size) + 1, count);
    if (!status.Ok())
    {
      return status;
    }
    elements.reserve(elements.size() + static_cast<std::size_t>(count));
    references.reserve(elements.capacity());
    for (std::int64_t i = 0; i < count; ++i)
    {
      std::array<Index, Size> element{};
      std::int32_t reference = 0;
      bool good = true;
      for (std::size_t k = 0; k < Size && good; ++k)
      {
        good = this->Id(element[k], this->PointIds);
      }
      if (!good || !this->Reference(reference))
      {
        return this->BadIdOrEntry(section, i, count);
      }
      elements.push_back(element);
      references.push_back(reference);
    }
    return {};
  }

  Status Ids(std::string_view section, std::vector<Index>& ids, ReferenceCheck& check)
  {
    std::int64_t count = 0;
    Status status = this->Count(section, 1, count);
    for (std::int64_t i = 0; i < count && status.Ok(); ++i)
    {
      Index id = 0;
      if (!this->Id(id, check))
      {
        return this->BadIdOrEntry(section, i, count);
      }
      ids.push_back(id);
    }
    return status;
  }

  Status BadIdOrEntry(std::string_view section, std::int64_t i, std::int64_t count)
  {
    return this->WrongId != NoWrongId
             ? this->IndexError(this->WrongId, this->Scanner.Line(), "entry")
             : this->BadEntry(section, i, count);
  }

  Status OtherSection(std::string_view keyword)
  {
    std::int64_t count = 0;
    for (const SkippedSection& section : SkippedSections)
    {
      if (section.Name == keyword)
      {
        Status status = this->Count(keyword, section.Width, count);
        std::string_view word;
        for (std::int64_t i = 0; status.Ok() && i < count * section.Width; ++i)
        {
          if (!this->Scanner.Word(word))
          {
            return this->BadEntry(keyword, i / section.Width, count);
          }
        }
        return status;
      }
    }
    for (std::string_view foreign : ForeignSections)
    {
      if (foreign == keyword)
      {
        Status status = this->Count(keyword, 1, count);
        return !status.Ok() || count == 0
                 ? status
                 : Status(StatusCode::InvalidMesh,
                     this->Name + ", line " + std::to_string(this->Scanner.Line()) +
                       ": the mesh has " + std::to_string(count) + " " + std::string(keyword) +
                       ". Only hexahedral meshes are read.");
      }
    }
    return this->Error(Quoted(keyword) + " is no known section of a Medit file.");
  }

  Status CheckReferences() const
  {
    std::int64_t id = 0;
    std::size_t line = 0;
    if (this->Mesh.Points.size() > static_cast<std::size_t>(MaximumIndex))
    {
      return this->Error("more than 2147483647 points.");
    }
    if (this->PointIds.FirstBeyond(static_cast<std::int64_t>(this->Mesh.Points.size()), id, line))
    {
      return this->IndexError(id + 1, line, "point");
    }
    if (this->EdgeIds.FirstBeyond(static_cast<std::int64_t>(this->Mesh.Edges.size()), id, line))
    {
      return this->IndexError(id + 1, line, "edge");
    }
    return this->Mesh.Points.empty()
             ? Status(StatusCode::EmptySurface, this->Name + ": the file has no points.")
             : Status();
  }

  static constexpr std::int64_t NoWrongId = 1;

  TextScanner Scanner;
  const std::string& Name;
  MeditMesh& Mesh;
  ReferenceCheck PointIds;
  ReferenceCheck EdgeIds;
  std::int64_t WrongId = NoWrongId; ///< the id that stopped Id(); 1 is never wrong
};

class MeditWriter
{
public:
  explicit MeditWriter(const MeditMesh& mesh)
    : Mesh(mesh)
  {
  }

  std::string Text()
  {
    this->Out = "MeshVersionFormatted 2\nDimension 3\n";
    this->Begin("Vertices", this->Mesh.Points.size());
    for (std::size_t i = 0; i < this->Mesh.Points.size(); ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        AppendReal(this->Out, this->Mesh.Points[i][k]);
        this->Out += ' ';
      }
      this->Reference(this->Mesh.PointReferences, i);
    }
    this->Ids("Corners", this->Mesh.Corners);
    this->Elements("Edges", this->Mesh.Edges, this->Mesh.EdgeReferences);
    this->Ids("Ridges", this->Mesh.Ridges);
    this->Elements("Quadrilaterals", this->Mesh.Quads, this->Mesh.QuadReferences);
    this->Elements("Hexahedra", this->Mesh.Hexes, this->Mesh.HexReferences);
    this->Out += "\nEnd\n";
    return std::move(this->Out);
  }

private:
  void Begin(const char* section, std::size_t count)
  {
    this->Out += '\n';
    this->Out += section;
    this->Out += '\n';
    AppendInteger(this->Out, static_cast<std::int64_t>(count));
    this->Out += '\n';
  }

  void Reference(const std::vector<std::int32_t>& references, std::size_t i)
  {
    AppendInteger(this->Out, references.empty() ? 0 : references[i]);
    this->Out += '\n';
  }

  void Ids(const char* section, const std::vector<Index>& ids)
  {
    if (!ids.empty())
    {
      this->Begin(section, ids.size());
      for (Index id : ids)
      {
        AppendInteger(this->Out, std::int64_t{ id } + 1);
        this->Out += '\n';
      }
    }
  }

  template <std::size_t Size>
  void Elements(const char* section, const std::vector<std::array<Index, Size>>& elements,
    const std::vector<std::int32_t>& references)
  {
    if (elements.empty())
    {
      return;
    }
    this->Begin(section, elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i)
    {
      for (Index id : elements[i])
      {
        AppendInteger(this->Out, std::int64_t{ id } + 1);
        this->Out += ' ';
      }
      this->Reference(references, i);
    }
  }

  const MeditMesh& Mesh;
  std::string Out;
};

template <std::size_t Size>
bool InRange(const std::vector<std::array<Index, Size>>& elements,
  const std::vector<std::int32_t>& references, Index count)
{
  for (const auto& element : elements)
  {
    for (Index id : element)
    {
      if (id < 0 || id >= count)
      {
        return false;
      }
    }
  }
  return references.empty() || references.size() == elements.size();
}

bool InRange(const std::vector<Index>& ids, Index count)
{
  for (Index id : ids)
  {
    if (id < 0 || id >= count)
    {
      return false;
    }
  }
  return true;
}

Status CheckForWriting(const MeditMesh& mesh)
{
  const Index points = static_cast<Index>(mesh.Points.size());
  if (!InRange(mesh.Hexes, mesh.HexReferences, points) ||
      !InRange(mesh.Quads, mesh.QuadReferences, points) ||
      !InRange(mesh.Edges, mesh.EdgeReferences, points) || !InRange(mesh.Corners, points) ||
      !InRange(mesh.Ridges, static_cast<Index>(mesh.Edges.size())) ||
      (!mesh.PointReferences.empty() && mesh.PointReferences.size() != mesh.Points.size()))
  {
    return Status(StatusCode::IndexOutOfRange,
      "The mesh to write as .mesh refers to points or edges that do not exist.");
  }
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    if (!mesh.Points[i].allFinite())
    {
      return Status(StatusCode::NonFinite,
        "Point " + std::to_string(i) + " of the mesh to write as .mesh is not finite.");
    }
  }
  return {};
}
} // namespace

Status ParseMedit(std::string_view bytes, const std::string& name, MeditMesh& mesh)
{
  mesh = {};
  Status status = MeditParser(bytes, name, mesh).Parse();
  if (!status.Ok())
  {
    mesh = {};
  }
  return status;
}

Status ReadMedit(const std::string& path, MeditMesh& mesh)
{
  mesh = {};
  std::string bytes;
  Status status = ReadFileBytes(path, bytes);
  return status.Ok() ? ParseMedit(bytes, FileBaseName(path), mesh) : status;
}

Status WriteMedit(const std::string& path, const MeditMesh& mesh)
{
  Status status = CheckForWriting(mesh);
  return status.Ok() ? WriteFileBytes(path, MeditWriter(mesh).Text()) : status;
}
} // namespace featurehex

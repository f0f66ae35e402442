// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceReader.h"

#include "FileAccess.h"
#include "SurfaceFormats.h"

namespace featurehex
{
namespace
{
bool StartsWith(std::string_view bytes, std::string_view start)
{
  return bytes.substr(0, start.size()) == start;
}

/// v x y z [w or colour]
Status ObjPoint(TextScanner& scanner, SurfaceBuilder& builder)
{
  Vec3 point;
  for (int i = 0; i < 3; ++i)
  {
    std::string_view word;
    if (!scanner.WordOnLine(word))
    {
      return builder.ParseError(scanner.Line(), "a \"v\" needs three coordinates.");
    }
    if (!ParseReal(word, point[i]))
    {
      return builder.ParseError(scanner.Line(), Quoted(word) + " is not a coordinate.");
    }
  }
  builder.AddPoint(point);
  return {};
}

/// f p[/t[/n]] ...: 1-based, negative ones count backwards from the last point so far.
Status ObjFace(TextScanner& scanner, SurfaceBuilder& builder)
{
  const std::size_t line = scanner.Line();
  std::string_view word;
  builder.BeginPolygon(line);
  while (scanner.WordOnLine(word))
  {
    std::int64_t number = 0;
    if (!ParseInteger(word.substr(0, word.find('/')), number))
    {
      return builder.ParseError(line, Quoted(word) + " is not a point index of a face.");
    }
    const std::int64_t id = number < 0 ? builder.NumberOfPoints() + number : number - 1;
    if (id < 0 || !builder.AddCorner(id))
    {
      return builder.IndexError(number, line);
    }
  }
  if (builder.NumberOfCorners() < 3)
  {
    return builder.ParseError(line, "a face needs at least three points.");
  }
  return {};
}

/// A keyword of the format: letters, then perhaps digits, '_' or '-'.
bool IsObjKeyword(std::string_view word)
{
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
  for (char c : word)
  {
    if (!letter(c) && !(c >= '0' && c <= '9') && c != '_' && c != '-')
    {
      return false;
    }
  }
  return letter(word.front());
}
} // namespace

bool SurfaceBuilder::AddCorner(std::int64_t id)
{
  if (id < 0 || id >= MaximumIndex)
  {
    return false;
  }
  this->References.Add(id, this->Where);
  const Index corner = static_cast<Index>(id);
  if (this->Corners == 0)
  {
    this->First = corner;
  }
  else if (this->Corners >= 2)
  {
    this->Surface.Triangles.push_back({ this->First, this->Previous, corner });
  }
  this->Previous = corner;
  ++this->Corners;
  return true;
}

Status SurfaceBuilder::ParseError(std::size_t where, const std::string& what) const
{
  return Status(StatusCode::UnreadableFile,
    this->Name + ", " + this->Unit + " " + std::to_string(where) + ": " + what);
}

Status SurfaceBuilder::IndexError(std::int64_t id, std::size_t where, bool oneBased) const
{
  return Status(StatusCode::IndexOutOfRange,
    this->Name + ", " + this->Unit + " " + std::to_string(where) + ": a face refers to point " +
      std::to_string(id + (oneBased ? 1 : 0)) + ", which does not exist (the file has " +
      std::to_string(this->Surface.Points.size()) +
      " points up to there). Export the surface again.");
}

Status SurfaceBuilder::Finish(bool oneBased) const
{
  if (this->NumberOfPoints() > MaximumIndex ||
      this->Surface.Triangles.size() > static_cast<std::size_t>(MaximumIndex))
  {
    return Status(StatusCode::UnreadableFile,
      this->Name + ": more than 2147483647 points or triangles. Decimate the surface first.");
  }
  std::int64_t id = 0;
  std::size_t where = 0;
  if (this->References.FirstBeyond(this->NumberOfPoints(), id, where))
  {
    return this->IndexError(id, where, oneBased);
  }
  if (this->Surface.Points.empty())
  {
    return Status(StatusCode::EmptySurface, this->Name + ": the file has no points.");
  }
  if (this->Surface.Triangles.empty())
  {
    return Status(StatusCode::EmptySurface,
      this->Name + ": the file has " + std::to_string(this->Surface.Points.size()) +
        " points but no faces. Export the surface with its triangles.");
  }
  return {};
}

Status ParseObj(std::string_view bytes, const std::string& name, SurfaceMesh& surface)
{
  TextScanner scanner(bytes, '#', true);
  SurfaceBuilder builder(name, "line", surface);
  std::string_view keyword;
  while (scanner.Word(keyword))
  {
    Status status;
    if (keyword == "v")
    {
      status = ObjPoint(scanner, builder);
    }
    else if (keyword == "f" || keyword == "fo")
    {
      status = ObjFace(scanner, builder);
    }
    else if (!IsObjKeyword(keyword))
    {
      status = builder.ParseError(
        scanner.Line(), Quoted(keyword) + " is no OBJ keyword. Is this an OBJ file?");
    }
    if (!status.Ok())
    {
      return status;
    }
    scanner.SkipLine();
  }
  return builder.Finish(true);
}

SurfaceFormat DetectSurfaceFormat(const std::string& path, std::string_view bytes)
{
  const std::string extension = FileExtension(path);
  if (extension == ".obj")
  {
    return SurfaceFormat::Obj;
  }
  if (extension == ".stl" || extension == ".stlb")
  {
    return SurfaceFormat::Stl;
  }
  if (extension == ".ply")
  {
    return SurfaceFormat::Ply;
  }
  if (extension == ".off" || extension == ".coff" || extension == ".noff")
  {
    return SurfaceFormat::Off;
  }
  if (StartsWith(bytes, "ply\n") || StartsWith(bytes, "ply\r"))
  {
    return SurfaceFormat::Ply;
  }
  if (HasBinaryStlSize(bytes) || StartsWith(bytes, "solid"))
  {
    return SurfaceFormat::Stl;
  }
  const std::string_view head = bytes.substr(0, bytes.find_first_of(" \t\r\n"));
  if (head.size() <= 7 && head.size() >= 3 && head.substr(head.size() - 3) == "OFF")
  {
    return SurfaceFormat::Off;
  }
  return StartsWith(bytes, "v ") || StartsWith(bytes, "mtllib ") ? SurfaceFormat::Obj
                                                                 : SurfaceFormat::Unknown;
}

Status ParseSurface(
  std::string_view bytes, SurfaceFormat format, const std::string& name, SurfaceMesh& surface)
{
  surface = {};
  if (bytes.find_first_not_of(" \t\r\n") == std::string_view::npos)
  {
    return Status(StatusCode::EmptySurface, name + ": the file is empty.");
  }
  Status status;
  switch (format)
  {
    case SurfaceFormat::Obj:
      status = ParseObj(bytes, name, surface);
      break;
    case SurfaceFormat::Stl:
      status = ParseStl(bytes, name, surface);
      break;
    case SurfaceFormat::Ply:
      status = ParsePly(bytes, name, surface);
      break;
    case SurfaceFormat::Off:
      status = ParseOff(bytes, name, surface);
      break;
    case SurfaceFormat::Unknown:
      status = Status(StatusCode::UnreadableFile,
        name + ": neither OBJ, STL, PLY nor OFF by its name or its first bytes. Give the file the "
               "extension of its format.");
      break;
  }
  if (!status.Ok())
  {
    surface = {};
  }
  return status;
}

Status ReadSurface(const std::string& path, SurfaceMesh& surface)
{
  surface = {};
  std::string bytes;
  Status status = ReadFileBytes(path, bytes);
  if (!status.Ok())
  {
    return status;
  }
  return ParseSurface(bytes, DetectSurfaceFormat(path, bytes), FileBaseName(path), surface);
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFormats.h"

#include <cstring>

namespace featurehex
{
namespace
{
constexpr std::size_t HeaderSize = 84;
constexpr std::size_t TriangleSize = 50;

std::uint32_t LittleEndian32(const char* bytes)
{
  std::uint32_t value = 0;
  for (int i = 3; i >= 0; --i)
  {
    value = value << 8 | static_cast<unsigned char>(bytes[i]);
  }
  return value;
}

double LittleEndianFloat(const char* bytes)
{
  const std::uint32_t bits = LittleEndian32(bytes);
  float value;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

bool SameWord(std::string_view word, std::string_view lowerCase)
{
  if (word.size() != lowerCase.size())
  {
    return false;
  }
  for (std::size_t i = 0; i < word.size(); ++i)
  {
    // ASCII letters differ from their capitals in this bit.
    if ((word[i] | 0x20) != lowerCase[i])
    {
      return false;
    }
  }
  return true;
}

/// Text starts with "solid" and has no control characters where a binary file has its header.
bool LooksLikeText(std::string_view bytes)
{
  std::string_view word;
  TextScanner scanner(bytes.substr(0, 512), 0);
  if (!scanner.Word(word) || !SameWord(word, "solid"))
  {
    return false;
  }
  for (char c : bytes.substr(0, 512))
  {
    if (c >= 0 && c < ' ' && c != '\n' && c != '\r' && c != '\t')
    {
      return false;
    }
  }
  return true;
}

Status ParseBinary(std::string_view bytes, const std::string& name, SurfaceMesh& surface)
{
  const auto error = [&name](const std::string& what)
  { return Status(StatusCode::UnreadableFile, name + ": " + what); };
  if (bytes.size() < HeaderSize)
  {
    return error("truncated: " + std::to_string(bytes.size()) +
                 " bytes, a binary STL has at least 84, and an ASCII STL starts with \"solid\".");
  }
  const std::size_t count = LittleEndian32(bytes.data() + 80);
  const std::size_t room = (bytes.size() - HeaderSize) / TriangleSize;
  if (count > room)
  {
    return error("truncated: the header promises " + std::to_string(count) +
                 " triangles, the file ends in the middle of triangle " + std::to_string(room + 1) +
                 " (byte " + std::to_string(bytes.size()) + "). Export or copy the file again.");
  }
  if (count == 0 && room > 0)
  {
    return error("the header promises 0 triangles, but the file has room for " +
                 std::to_string(room) + ". Export the file again.");
  }
  SurfaceBuilder builder(name, "triangle", surface);
  builder.ReservePoints(static_cast<std::int64_t>(3 * count));
  builder.ReserveTriangles(static_cast<std::int64_t>(count));
  for (std::size_t t = 0; t < count; ++t)
  {
    builder.BeginPolygon(t + 1);
    for (std::size_t v = 0; v < 3; ++v)
    {
      const char* at = bytes.data() + HeaderSize + TriangleSize * t + 12 * (v + 1);
      builder.AddPoint(
        { LittleEndianFloat(at), LittleEndianFloat(at + 4), LittleEndianFloat(at + 8) });
      if (!builder.AddCorner(builder.NumberOfPoints() - 1))
      {
        return builder.Finish();
      }
    }
  }
  return builder.Finish();
}

/// Reads facets one after another; the grammar is short enough to expect word by word.
class AsciiParser
{
public:
  AsciiParser(std::string_view bytes, const std::string& name, SurfaceMesh& surface)
    : Scanner(bytes, 0)
    , Builder(name, "line", surface)
  {
  }

  Status Parse()
  {
    std::string_view word;
    bool inSolid = false;
    while (this->Scanner.Word(word))
    {
      Status status;
      if (!inSolid && SameWord(word, "solid"))
      {
        inSolid = true;
        this->Scanner.SkipLine();
      }
      else if (inSolid && (SameWord(word, "endsolid") || SameWord(word, "end")))
      {
        inSolid = false;
        this->Scanner.SkipLine();
      }
      else if (inSolid && SameWord(word, "facet"))
      {
        status = this->Facet();
      }
      else
      {
        status = this->Unexpected(word, inSolid ? "\"facet\" or \"endsolid\"" : "\"solid\"");
      }
      if (!status.Ok())
      {
        return status;
      }
    }
    if (inSolid)
    {
      return this->Builder.ParseError(
        this->Scanner.Line(), "truncated: the file ends without \"endsolid\".");
    }
    return this->Builder.Finish();
  }

private:
  Status Unexpected(std::string_view word, const std::string& expected)
  {
    return this->Builder.ParseError(this->Scanner.Line(),
      (!word.empty()                     ? Quoted(word)
        : this->Scanner.Remaining() == 0 ? std::string("truncated: the file ends")
                                         : std::string("the line ends")) +
        " where " + expected + " is expected.");
  }

  Status Expect(std::string_view expected)
  {
    std::string_view word;
    if (this->Scanner.Word(word) && SameWord(word, expected))
    {
      return {};
    }
    return this->Unexpected(word, Quoted(expected));
  }

  Status Facet()
  {
    // The normal is not used, and often nonsense.
    this->Scanner.SkipLine();
    Status status = this->Expect("outer");
    if (status.Ok())
    {
      status = this->Expect("loop");
    }
    this->Builder.BeginPolygon(this->Scanner.Line());
    for (int v = 0; v < 3 && status.Ok(); ++v)
    {
      status = this->Vertex();
    }
    if (status.Ok())
    {
      status = this->Expect("endloop");
    }
    return status.Ok() ? this->Expect("endfacet") : status;
  }

  Status Vertex()
  {
    Status status = this->Expect("vertex");
    Vec3 point;
    for (int i = 0; i < 3 && status.Ok(); ++i)
    {
      std::string_view word;
      if (!this->Scanner.WordOnLine(word) || !ParseReal(word, point[i]))
      {
        status = this->Unexpected(word, "a coordinate");
      }
    }
    if (status.Ok())
    {
      this->Builder.AddPoint(point);
      if (!this->Builder.AddCorner(this->Builder.NumberOfPoints() - 1))
      {
        status = this->Builder.ParseError(this->Scanner.Line(), "too many points.");
      }
    }
    return status;
  }

  TextScanner Scanner;
  SurfaceBuilder Builder;
};
} // namespace

bool HasBinaryStlSize(std::string_view bytes)
{
  return bytes.size() >= HeaderSize &&
         (bytes.size() - HeaderSize) ==
           TriangleSize * std::size_t{ LittleEndian32(bytes.data() + 80) };
}

Status ParseStl(std::string_view bytes, const std::string& name, SurfaceMesh& surface)
{
  // Many binary files start with "solid" too, so the size decides first.
  if (!HasBinaryStlSize(bytes) && LooksLikeText(bytes))
  {
    return AsciiParser(bytes, name, surface).Parse();
  }
  return ParseBinary(bytes, name, surface);
}
} // namespace featurehex

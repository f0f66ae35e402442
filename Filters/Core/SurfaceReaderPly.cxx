// SPDX-License-Identifier: BSD-3-Clause
// PLY, the Stanford polygon format: G. Turk, "The PLY polygon file format", 1994.
#include "SurfaceFormats.h"

#include <cstring>
#include <vector>

namespace featurehex
{
namespace
{
enum class PlyType
{
  None,
  Int8,
  UInt8,
  Int16,
  UInt16,
  Int32,
  UInt32,
  Float,
  Double
};

constexpr std::size_t TypeSizes[] = { 0, 1, 1, 2, 2, 4, 4, 4, 8 };

std::size_t TypeSize(PlyType type)
{
  return TypeSizes[static_cast<int>(type)];
}

PlyType TypeFromName(std::string_view name)
{
  constexpr struct
  {
    std::string_view Name;
    PlyType Type;
  } names[] = { { "char", PlyType::Int8 }, { "int8", PlyType::Int8 }, { "uchar", PlyType::UInt8 },
    { "uint8", PlyType::UInt8 }, { "short", PlyType::Int16 }, { "int16", PlyType::Int16 },
    { "ushort", PlyType::UInt16 }, { "uint16", PlyType::UInt16 }, { "int", PlyType::Int32 },
    { "int32", PlyType::Int32 }, { "uint", PlyType::UInt32 }, { "uint32", PlyType::UInt32 },
    { "float", PlyType::Float }, { "float32", PlyType::Float }, { "double", PlyType::Double },
    { "float64", PlyType::Double } };
  for (const auto& entry : names)
  {
    if (entry.Name == name)
    {
      return entry.Type;
    }
  }
  return PlyType::None;
}

/// What a property is good for.
enum class Role
{
  Skip,
  X,
  Y,
  Z,
  Polygon,
  Strips
};

struct Property
{
  PlyType Type = PlyType::None;
  PlyType CountType = PlyType::None; ///< of a list; None: a single value
  Role Use = Role::Skip;
};

struct Element
{
  std::string Name;
  std::int64_t Count = 0;
  std::vector<Property> Properties;
};

/// The items of the body, whatever their encoding. All integers of the format fit in a double.
class PlyBody
{
public:
  enum class Encoding
  {
    Ascii,
    Little,
    Big
  };

  PlyBody(TextScanner& scanner, std::string_view bytes)
    : Scanner(scanner)
    , Bytes(bytes)
  {
  }

  void Begin(Encoding encoding)
  {
    this->Kind = encoding;
    this->Offset = this->Scanner.Position();
  }

  bool Ascii() const { return this->Kind == Encoding::Ascii; }

  std::size_t Remaining() const
  {
    return this->Ascii() ? this->Scanner.Remaining() : this->Bytes.size() - this->Offset;
  }

  /// Fewest bytes of an item; in text a digit and a separator.
  std::size_t LeastSize(PlyType type) const { return this->Ascii() ? 2 : TypeSize(type); }

  /// False: the file ends, or a word is no number.
  bool Next(PlyType type, double& value)
  {
    if (this->Ascii())
    {
      std::string_view word;
      return this->Scanner.Word(word) && ParseReal(word, value);
    }
    const std::size_t size = TypeSize(type);
    if (this->Remaining() < size)
    {
      return false;
    }
    value = this->Decode(type, size);
    this->Offset += size;
    return true;
  }

  /// "line 12" or "byte 340".
  std::string Place() const
  {
    return this->Ascii() ? "line " + std::to_string(this->Scanner.Line())
                         : "byte " + std::to_string(this->Offset);
  }

private:
  double Decode(PlyType type, std::size_t size) const
  {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < size; ++i)
    {
      const std::size_t at = this->Kind == Encoding::Big ? i : size - 1 - i;
      bits = bits << 8 | static_cast<unsigned char>(this->Bytes[this->Offset + at]);
    }
    switch (type)
    {
      case PlyType::Int8:
        return static_cast<std::int8_t>(bits);
      case PlyType::Int16:
        return static_cast<std::int16_t>(bits);
      case PlyType::Int32:
        return static_cast<std::int32_t>(bits);
      case PlyType::Float:
      {
        const std::uint32_t word = static_cast<std::uint32_t>(bits);
        float value;
        std::memcpy(&value, &word, sizeof(value));
        return value;
      }
      case PlyType::Double:
      {
        double value;
        std::memcpy(&value, &bits, sizeof(value));
        return value;
      }
      default:
        return static_cast<double>(bits);
    }
  }

  TextScanner& Scanner;
  std::string_view Bytes;
  std::size_t Offset = 0;
  Encoding Kind = Encoding::Ascii;
};

class PlyParser
{
public:
  PlyParser(std::string_view bytes, const std::string& name, SurfaceMesh& surface)
    : Scanner(bytes, 0)
    , Body(Scanner, bytes)
    , Name(name)
    , Builder(name, "face", surface)
  {
  }

  Status Parse()
  {
    Status status = this->Header();
    for (std::size_t i = 0; i < this->Elements.size() && status.Ok(); ++i)
    {
      status = this->ReadElement(this->Elements[i]);
    }
    return status.Ok() ? this->Builder.Finish() : status;
  }

private:
  Status Error(const std::string& place, const std::string& what) const
  {
    return Status(StatusCode::UnreadableFile, this->Name + ", " + place + ": " + what);
  }

  Status HeaderError(const std::string& what) const
  {
    return this->Error("line " + std::to_string(this->Scanner.Line()), what);
  }

  Status Header()
  {
    std::string_view word;
    if (!this->Scanner.Word(word) || word != "ply")
    {
      return this->HeaderError("a PLY file starts with \"ply\", not with " + Quoted(word) + ".");
    }
    this->Scanner.SkipLine();
    bool hasFormat = false;
    while (this->Scanner.Word(word))
    {
      Status status;
      if (word == "end_header")
      {
        this->Scanner.SkipLine();
        this->Body.Begin(this->Kind);
        return hasFormat ? this->CheckHeader() : this->HeaderError("no \"format\" line.");
      }
      if (word == "format")
      {
        status = this->Format();
        hasFormat = true;
      }
      else if (word == "element")
      {
        status = this->ElementLine();
      }
      else if (word == "property")
      {
        status = this->PropertyLine();
      }
      else if (word != "comment" && word != "obj_info")
      {
        status = this->HeaderError(Quoted(word) + " is no keyword of a PLY header.");
      }
      if (!status.Ok())
      {
        return status;
      }
      this->Scanner.SkipLine();
    }
    return this->HeaderError("truncated: the file ends without \"end_header\".");
  }

  Status Format()
  {
    std::string_view word;
    this->Scanner.WordOnLine(word);
    if (word == "ascii")
    {
      this->Kind = PlyBody::Encoding::Ascii;
    }
    else if (word == "binary_little_endian")
    {
      this->Kind = PlyBody::Encoding::Little;
    }
    else if (word == "binary_big_endian")
    {
      this->Kind = PlyBody::Encoding::Big;
    }
    else
    {
      return this->HeaderError(Quoted(word) + " is no PLY format.");
    }
    return {};
  }

  Status ElementLine()
  {
    std::string_view word;
    Element element;
    this->Scanner.WordOnLine(word);
    element.Name = std::string(word);
    if (!this->Scanner.IntegerOnLine(element.Count) || element.Count < 0)
    {
      return this->HeaderError("element " + Quoted(word) + " has no valid count.");
    }
    this->Elements.push_back(std::move(element));
    return {};
  }

  Status PropertyLine()
  {
    std::string_view word;
    Property property;
    this->Scanner.WordOnLine(word);
    if (word == "list")
    {
      this->Scanner.WordOnLine(word);
      property.CountType = TypeFromName(word);
      if (property.CountType == PlyType::None)
      {
        return this->HeaderError(Quoted(word) + " is no PLY type.");
      }
      this->Scanner.WordOnLine(word);
    }
    property.Type = TypeFromName(word);
    if (property.Type == PlyType::None)
    {
      return this->HeaderError(Quoted(word) + " is no PLY type.");
    }
    if (this->Elements.empty() || !this->Scanner.WordOnLine(word))
    {
      return this->HeaderError("a property needs a name and an element before it.");
    }
    Element& element = this->Elements.back();
    const bool list = property.CountType != PlyType::None;
    if (element.Name == "vertex" && !list && word.size() == 1 && word[0] >= 'x' && word[0] <= 'z')
    {
      property.Use = static_cast<Role>(static_cast<int>(Role::X) + (word[0] - 'x'));
    }
    else if (list && (word == "vertex_indices" || word == "vertex_index"))
    {
      property.Use = element.Name == "face"        ? Role::Polygon
                     : element.Name == "tristrips" ? Role::Strips
                                                   : Role::Skip;
    }
    element.Properties.push_back(property);
    return {};
  }

  /// Declared counts against the bytes that follow, before anything is allocated.
  Status CheckHeader()
  {
    std::size_t room = this->Body.Remaining() + 1;
    for (const Element& element : this->Elements)
    {
      std::size_t size = 0;
      bool coordinates[3] = {};
      for (const Property& property : element.Properties)
      {
        const bool list = property.CountType != PlyType::None;
        size += this->Body.LeastSize(list ? property.CountType : property.Type);
        if (property.Use >= Role::X && property.Use <= Role::Z)
        {
          coordinates[static_cast<int>(property.Use) - static_cast<int>(Role::X)] = true;
        }
      }
      if (element.Name == "vertex" && !(coordinates[0] && coordinates[1] && coordinates[2]))
      {
        return this->HeaderError("the vertices have no x, y and z.");
      }
      if (size > 0 && static_cast<std::size_t>(element.Count) > room / size)
      {
        return this->HeaderError("truncated: the header promises " + std::to_string(element.Count) +
                                 " of element " + Quoted(element.Name) + ", " +
                                 std::to_string(this->Body.Remaining()) + " bytes follow.");
      }
      room -= size * static_cast<std::size_t>(element.Count);
    }
    return {};
  }

  Status ReadElement(const Element& element)
  {
    if (element.Properties.empty())
    {
      return {};
    }
    if (element.Name == "vertex")
    {
      this->Builder.ReservePoints(element.Count);
    }
    else if (element.Name == "face")
    {
      this->Builder.ReserveTriangles(element.Count);
    }
    for (std::int64_t i = 0; i < element.Count; ++i)
    {
      Vec3 point = Vec3::Zero();
      for (const Property& property : element.Properties)
      {
        Status status = property.CountType != PlyType::None
                          ? this->List(element, property, i)
                          : this->Value(element, property, i, point);
        if (!status.Ok())
        {
          return status;
        }
      }
      if (element.Name == "vertex")
      {
        this->Builder.AddPoint(point);
      }
    }
    return {};
  }

  Status BodyError(const Element& element, std::int64_t i) const
  {
    return this->Error(
      this->Body.Place(), std::string(this->Body.Remaining() < 8 ? "truncated" : "not a number") +
                            " in " + Quoted(element.Name) + " " + std::to_string(i) + " of " +
                            std::to_string(element.Count) + ".");
  }

  Status Value(const Element& element, const Property& property, std::int64_t i, Vec3& point)
  {
    double value = 0.0;
    if (!this->Body.Next(property.Type, value))
    {
      return this->BodyError(element, i);
    }
    if (property.Use != Role::Skip)
    {
      point[static_cast<int>(property.Use) - static_cast<int>(Role::X)] = value;
    }
    return {};
  }

  Status List(const Element& element, const Property& property, std::int64_t i)
  {
    double count = 0.0;
    if (!this->Body.Next(property.CountType, count))
    {
      return this->BodyError(element, i);
    }
    const double room =
      static_cast<double>((this->Body.Remaining() + 1) / this->Body.LeastSize(property.Type));
    if (!(count >= 0.0 && count <= room))
    {
      return this->Error(
        this->Body.Place(), "a list of " + Quoted(element.Name) + " " + std::to_string(i) +
                              " has an impossible length; the file is truncated or damaged.");
    }
    this->Builder.BeginPolygon(static_cast<std::size_t>(i));
    this->Strip.clear();
    for (std::int64_t k = 0; k < static_cast<std::int64_t>(count); ++k)
    {
      double value = 0.0;
      if (!this->Body.Next(property.Type, value))
      {
        return this->BodyError(element, i);
      }
      Status status = this->Corner(property.Use, value, i);
      if (!status.Ok())
      {
        return status;
      }
    }
    if (property.Use == Role::Polygon && this->Builder.NumberOfCorners() < 3)
    {
      return this->Error(
        this->Body.Place(), "face " + std::to_string(i) + " has fewer than three points.");
    }
    return {};
  }

  Status Corner(Role use, double value, std::int64_t face)
  {
    if (use != Role::Polygon && use != Role::Strips)
    {
      return {};
    }
    const double limit = static_cast<double>(MaximumIndex);
    if (!(value >= -limit && value <= 2 * limit + 2) ||
        value != static_cast<double>(static_cast<std::int64_t>(value)))
    {
      return this->Error(
        this->Body.Place(), "face " + std::to_string(face) + " has an index that is no integer.");
    }
    const std::int64_t id = static_cast<std::int64_t>(value);
    if (use == Role::Polygon)
    {
      return this->Builder.AddCorner(id)
               ? Status()
               : this->Builder.IndexError(id, static_cast<std::size_t>(face));
    }
    return this->StripCorner(id, face);
  }

  /// -1 ends a strip; every other triangle of a strip is turned round.
  Status StripCorner(std::int64_t id, std::int64_t face)
  {
    if (id == -1)
    {
      this->Strip.clear();
      return {};
    }
    this->Strip.push_back(id);
    const std::size_t n = this->Strip.size();
    if (n < 3)
    {
      return {};
    }
    const std::size_t turned = (n - 3) % 2;
    this->Builder.BeginPolygon(static_cast<std::size_t>(face));
    for (const std::size_t k : { n - 3 + turned, n - 2 - turned, n - 1 })
    {
      if (!this->Builder.AddCorner(this->Strip[k]))
      {
        return this->Builder.IndexError(this->Strip[k], static_cast<std::size_t>(face));
      }
    }
    return {};
  }

  TextScanner Scanner;
  PlyBody Body;
  const std::string& Name;
  SurfaceBuilder Builder;
  PlyBody::Encoding Kind = PlyBody::Encoding::Ascii;
  std::vector<Element> Elements;
  std::vector<std::int64_t> Strip;
};
} // namespace

Status ParsePly(std::string_view bytes, const std::string& name, SurfaceMesh& surface)
{
  return PlyParser(bytes, name, surface).Parse();
}
} // namespace featurehex

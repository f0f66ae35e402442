// SPDX-License-Identifier: BSD-3-Clause
// "VTK File Formats", The VTK User's Guide, Kitware; arrays are big-endian.
#include "LegacyVTKFile.h"

#include "TextScanner.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace featurehex
{
namespace
{
constexpr int NoType = -1;

int TypeFromName(std::string_view name)
{
  constexpr struct
  {
    std::string_view Name;
    int Type;
  } names[] = { { "char", VTK_SIGNED_CHAR }, { "signed_char", VTK_SIGNED_CHAR },
    { "unsigned_char", VTK_UNSIGNED_CHAR }, { "short", VTK_SHORT },
    { "unsigned_short", VTK_UNSIGNED_SHORT }, { "int", VTK_INT },
    { "unsigned_int", VTK_UNSIGNED_INT }, { "long", VTK_TYPE_INT64 },
    { "unsigned_long", VTK_TYPE_UINT64 }, { "vtktypeint64", VTK_TYPE_INT64 },
    { "vtktypeuint64", VTK_TYPE_UINT64 }, { "float", VTK_FLOAT }, { "double", VTK_DOUBLE },
    // The writers of all versions put ids down as int.
    { "vtkIdType", VTK_INT } };
  for (const auto& entry : names)
  {
    if (entry.Name == name)
    {
      return entry.Type;
    }
  }
  return NoType;
}

/// Names have "%20" for a blank and so on.
std::string Decoded(std::string_view name)
{
  std::string text;
  for (std::size_t i = 0; i < name.size(); ++i)
  {
    const auto digit = [&name](std::size_t k)
    {
      constexpr std::string_view digits = "0123456789ABCDEF";
      return k < name.size() ? digits.find(name[k]) : std::string_view::npos;
    };
    const std::size_t high = digit(i + 1);
    const std::size_t low = digit(i + 2);
    if (name[i] == '%' && high != std::string_view::npos && low != std::string_view::npos)
    {
      text += static_cast<char>(16 * high + low);
      i += 2;
    }
    else
    {
      text += name[i];
    }
  }
  return text;
}

using ArrayPointer = vtkSmartPointer<vtkDataArray>;

class LegacyParser
{
public:
  LegacyParser(std::string_view bytes, const std::string& name, vtkPointSet* output)
    : Bytes(bytes)
    , Scanner(bytes, 0)
    , Name(name)
    , Output(output)
    , Target(output->GetFieldData())
  {
  }

  Status Parse(std::string_view dataSet)
  {
    Status status = this->Header(dataSet);
    std::string_view keyword;
    while (status.Ok() && this->Scanner.Word(keyword))
    {
      status = this->Section(keyword);
    }
    return status;
  }

  vtkSmartPointer<vtkCellArray> Vertices;
  vtkSmartPointer<vtkCellArray> Lines;
  vtkSmartPointer<vtkCellArray> Polygons; ///< or the cells of an unstructured grid
  vtkSmartPointer<vtkCellArray> Strips;
  ArrayPointer Types;

private:
  Status Error(const std::string& what) const
  {
    return Status(StatusCode::UnreadableFile,
      this->Name + ", line " + std::to_string(this->Scanner.Line()) + ": " + what);
  }

  Status Header(std::string_view dataSet)
  {
    std::string_view word;
    for (const char* expected : { "#", "vtk", "DataFile", "Version" })
    {
      if (!this->Scanner.WordOnLine(word) || word != expected)
      {
        return this->Error("this is not a legacy VTK file.");
      }
    }
    double version = 0.0;
    this->Scanner.RealOnLine(version);
    this->HasOffsets = version >= 5.0;
    this->Scanner.SkipLine();
    this->Scanner.SkipLine();
    if (!this->Scanner.Word(word) || (word != "ASCII" && word != "BINARY"))
    {
      return this->Error(Quoted(word) + " where \"ASCII\" or \"BINARY\" is expected.");
    }
    this->Binary = word == "BINARY";
    if (!this->Scanner.Word(word) || word != "DATASET" || !this->Scanner.Word(word) ||
        word != dataSet)
    {
      return this->Error(
        Quoted(word) + " where \"DATASET " + std::string(dataSet) + "\" is expected.");
    }
    return {};
  }

  Status Section(std::string_view keyword)
  {
    const bool grid = this->Output->IsA("vtkUnstructuredGrid");
    if (keyword == "POINTS")
    {
      return this->ReadPoints();
    }
    if (keyword == "CELL_TYPES" && grid)
    {
      std::int64_t count = 0;
      return this->Scanner.IntegerOnLine(count) ? this->ReadArray(VTK_INT, 1, count, this->Types)
                                                : this->Error("CELL_TYPES has no count.");
    }
    if (keyword == (grid ? "CELLS" : "POLYGONS"))
    {
      return this->ReadCells(this->Polygons);
    }
    if (keyword == "VERTICES" && !grid)
    {
      return this->ReadCells(this->Vertices);
    }
    if (keyword == "LINES" && !grid)
    {
      return this->ReadCells(this->Lines);
    }
    if (keyword == "TRIANGLE_STRIPS" && !grid)
    {
      return this->ReadCells(this->Strips);
    }
    return this->AttributeSection(keyword);
  }

  Status AttributeSection(std::string_view keyword)
  {
    if (keyword == "POINT_DATA" || keyword == "CELL_DATA")
    {
      this->Target = keyword == "POINT_DATA"
                       ? static_cast<vtkFieldData*>(this->Output->GetPointData())
                       : this->Output->GetCellData();
      return this->Scanner.IntegerOnLine(this->Count)
               ? Status()
               : this->Error(Quoted(keyword) + " has no count.");
    }
    if (keyword == "METADATA")
    {
      return this->SkipMetadata();
    }
    if (keyword == "FIELD")
    {
      return this->ReadField();
    }
    if (keyword == "SCALARS")
    {
      return this->ReadScalars();
    }
    if (keyword == "VECTORS" || keyword == "NORMALS")
    {
      return this->ReadAttribute(3);
    }
    if (keyword == "TENSORS")
    {
      return this->ReadAttribute(9);
    }
    if (keyword == "GLOBAL_IDS" || keyword == "PEDIGREE_IDS")
    {
      return this->ReadAttribute(1);
    }
    if (keyword == "TEXTURE_COORDINATES" || keyword == "COLOR_SCALARS" || keyword == "LOOKUP_TABLE")
    {
      return this->ReadSized(keyword);
    }
    return this->Error(Quoted(keyword) + " is no keyword that can stand here.");
  }

  Status ReadPoints()
  {
    std::int64_t count = 0;
    std::string_view type;
    if (!this->Scanner.IntegerOnLine(count) || !this->Scanner.WordOnLine(type))
    {
      return this->Error("POINTS has no count and type.");
    }
    ArrayPointer array;
    Status status = this->ReadArray(TypeFromName(type), 3, count, array);
    if (status.Ok())
    {
      vtkNew<vtkPoints> points;
      points->SetData(array);
      this->Output->SetPoints(points);
    }
    return status;
  }

  /// Versions before 5: each cell as its size and ids. Since: offsets and ids.
  Status ReadCells(vtkSmartPointer<vtkCellArray>& cells)
  {
    std::int64_t count = 0;
    std::int64_t size = 0;
    if (!this->Scanner.IntegerOnLine(count) || !this->Scanner.IntegerOnLine(size))
    {
      return this->Error("cells have no counts.");
    }
    cells = vtkSmartPointer<vtkCellArray>::New();
    return this->HasOffsets ? this->ReadOffsetCells(count, size, cells)
                            : this->ReadSizedCells(count, size, cells);
  }

  Status ReadSizedCells(std::int64_t count, std::int64_t size, vtkCellArray* cells)
  {
    ArrayPointer values;
    Status status = this->ReadArray(VTK_INT, 1, size, values);
    std::int64_t at = 0;
    for (std::int64_t c = 0; c < count && status.Ok(); ++c)
    {
      const std::int64_t points =
        at < size ? static_cast<std::int64_t>(values->GetComponent(at, 0)) : -1;
      if (points < 0 || points > size - at - 1)
      {
        return this->Error("cell " + std::to_string(c) + " of " + std::to_string(count) +
                           " has an impossible number of points.");
      }
      status = this->InsertCell(values, at + 1, at + 1 + points, cells);
      at += points + 1;
    }
    return status;
  }

  Status ReadOffsetCells(std::int64_t count, std::int64_t size, vtkCellArray* cells)
  {
    ArrayPointer offsets;
    ArrayPointer ids;
    Status status = this->ReadNamed("OFFSETS", count, offsets);
    if (status.Ok())
    {
      status = this->ReadNamed("CONNECTIVITY", size, ids);
    }
    for (std::int64_t c = 0; c + 1 < count && status.Ok(); ++c)
    {
      const double begin = offsets->GetComponent(c, 0);
      const double end = offsets->GetComponent(c + 1, 0);
      status = begin >= 0 && begin <= end && end <= static_cast<double>(size)
                 ? this->InsertCell(
                     ids, static_cast<std::int64_t>(begin), static_cast<std::int64_t>(end), cells)
                 : this->Error("cell " + std::to_string(c) + " has impossible offsets.");
    }
    return status;
  }

  Status ReadNamed(const char* keyword, std::int64_t count, ArrayPointer& array)
  {
    std::string_view word;
    std::string_view type;
    return this->Scanner.Word(word) && word == keyword && this->Scanner.WordOnLine(type)
             ? this->ReadArray(TypeFromName(type), 1, count, array)
             : this->Error(Quoted(word) + " where \"" + keyword + "\" is expected.");
  }

  Status InsertCell(
    vtkDataArray* values, std::int64_t begin, std::int64_t end, vtkCellArray* cells) const
  {
    if (end - begin > MaximumIndex)
    {
      return this->Error("a cell has more than 2147483647 points.");
    }
    cells->InsertNextCell(static_cast<int>(end - begin));
    for (std::int64_t i = begin; i < end; ++i)
    {
      const double id = values->GetComponent(i, 0);
      if (!(id >= 0 && id < static_cast<double>(MaximumIndex)))
      {
        return Status(StatusCode::IndexOutOfRange,
          this->Name + ", line " + std::to_string(this->Scanner.Line()) +
            ": a cell refers to a point that does not exist. Export the file again.");
      }
      cells->InsertCellPoint(static_cast<vtkIdType>(id));
    }
    return {};
  }

  Status ReadField()
  {
    std::string_view word;
    std::int64_t arrays = 0;
    if (!this->Scanner.WordOnLine(word) || !this->Scanner.IntegerOnLine(arrays))
    {
      return this->Error("FIELD has no name and number of arrays.");
    }
    Status status;
    for (std::int64_t i = 0; i < arrays && status.Ok(); ++i)
    {
      status = this->ReadFieldArray();
    }
    return status;
  }

  Status ReadFieldArray()
  {
    std::string_view name;
    std::string_view type;
    std::int64_t components = 0;
    std::int64_t tuples = 0;
    bool good = this->Scanner.Word(name);
    if (good && name == "METADATA")
    {
      Status status = this->SkipMetadata();
      good = status.Ok() && this->Scanner.Word(name);
    }
    if (good && name == "NULL_ARRAY")
    {
      this->Scanner.SkipLine();
      return {};
    }
    if (!good || !this->Scanner.IntegerOnLine(components) || !this->Scanner.IntegerOnLine(tuples) ||
        !this->Scanner.WordOnLine(type))
    {
      return this->Error(Quoted(name) + " has no components, tuples and type.");
    }
    if (type == "string" || type == "utf8_string")
    {
      return this->SkipTexts(components, tuples);
    }
    return this->ReadAndAdd(name, TypeFromName(type), components, tuples);
  }

  Status ReadScalars()
  {
    std::string_view name;
    std::string_view type;
    std::string_view word;
    std::int64_t components = 1;
    if (!this->Scanner.WordOnLine(name) || !this->Scanner.WordOnLine(type))
    {
      return this->Error("SCALARS has no name and type.");
    }
    if (this->Scanner.WordOnLine(word) && !ParseInteger(word, components))
    {
      return this->Error(Quoted(word) + " is no number of components.");
    }
    const TextScanner before = this->Scanner;
    if (this->Scanner.Word(word) && word == "LOOKUP_TABLE")
    {
      this->Scanner.WordOnLine(word);
    }
    else
    {
      this->Scanner = before;
    }
    return this->ReadAndAdd(name, TypeFromName(type), components, this->Count);
  }

  Status ReadAttribute(int components)
  {
    std::string_view name;
    std::string_view type;
    return this->Scanner.WordOnLine(name) && this->Scanner.WordOnLine(type)
             ? this->ReadAndAdd(name, TypeFromName(type), components, this->Count)
             : this->Error("an array has no name and type.");
  }

  /// Name and a number of components or entries.
  Status ReadSized(std::string_view keyword)
  {
    std::string_view name;
    std::string_view type;
    std::int64_t size = 0;
    if (!this->Scanner.WordOnLine(name) || !this->Scanner.IntegerOnLine(size))
    {
      return this->Error(Quoted(keyword) + " has no name and size.");
    }
    if (keyword == "TEXTURE_COORDINATES")
    {
      this->Scanner.WordOnLine(type);
      return this->ReadAndAdd(name, TypeFromName(type), size, this->Count);
    }
    ArrayPointer skipped;
    const int colorType = this->Binary ? VTK_UNSIGNED_CHAR : VTK_FLOAT;
    return keyword == "LOOKUP_TABLE" ? this->ReadArray(colorType, 4, size, skipped)
                                     : this->ReadArray(colorType, size, this->Count, skipped);
  }

  Status ReadAndAdd(std::string_view name, int type, std::int64_t components, std::int64_t tuples)
  {
    ArrayPointer array;
    Status status = this->ReadArray(type, components, tuples, array);
    if (status.Ok())
    {
      array->SetName(Decoded(name).c_str());
      this->Target->AddArray(array);
    }
    return status;
  }

  /// Values from the next line on.
  Status ReadArray(int type, std::int64_t components, std::int64_t tuples, ArrayPointer& array)
  {
    if (type == NoType)
    {
      return this->Error("an array has no known type.");
    }
    array = ArrayPointer::Take(vtkDataArray::CreateDataArray(type));
    this->Scanner.SkipLine();
    const std::int64_t remaining = static_cast<std::int64_t>(this->Scanner.Remaining());
    const std::int64_t room =
      this->Binary ? remaining / array->GetDataTypeSize() : (remaining + 1) / 2;
    if (components < 1 || tuples < 0 || components > MaximumIndex || tuples > room / components)
    {
      return this->Error("truncated or damaged: an array promises " + std::to_string(tuples) +
                         " x " + std::to_string(components) + " values, " +
                         std::to_string(remaining) + " bytes follow.");
    }
    array->SetNumberOfComponents(static_cast<int>(components));
    array->SetNumberOfTuples(tuples);
    return this->Binary ? this->FillBinary(array) : this->FillText(array);
  }

  Status FillBinary(vtkDataArray* array)
  {
    const std::size_t size = static_cast<std::size_t>(array->GetDataTypeSize());
    const std::size_t total = size * static_cast<std::size_t>(array->GetNumberOfValues());
    if (total > 0)
    {
      char* to = static_cast<char*>(array->GetVoidPointer(0));
      std::memcpy(to, this->Bytes.data() + this->Scanner.Position(), total);
      // This machine and each other that VTK is packaged for is little-endian.
      for (std::size_t i = 0; i < total; i += size)
      {
        std::reverse(to + i, to + i + size);
      }
    }
    this->Scanner.Advance(total);
    return {};
  }

  Status FillText(vtkDataArray* array)
  {
    const int components = array->GetNumberOfComponents();
    const bool real = array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE;
    const double least = array->GetDataTypeMin();
    const double most = array->GetDataTypeMax();
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      for (int k = 0; k < components; ++k)
      {
        std::string_view word;
        double value = 0.0;
        if (!this->Scanner.Word(word) || !ParseReal(word, value) ||
            (!real && !(value >= least && value <= most)))
        {
          return this->Error(word.empty()
                               ? std::string("truncated: the file ends inside an array.")
                               : Quoted(word) + " is no number of the type of its array.");
        }
        array->SetComponent(i, k, value);
      }
    }
    return {};
  }

  /// Text: one a line. Binary: one to eight bytes of length, whose first two bits say how many.
  Status SkipTexts(std::int64_t components, std::int64_t tuples)
  {
    this->Scanner.SkipLine();
    const std::int64_t room = static_cast<std::int64_t>(this->Scanner.Remaining()) + 1;
    if (components < 0 || tuples < 0 || (components > 0 && tuples > room / components))
    {
      return this->Error("truncated or damaged: impossible number of texts.");
    }
    for (std::int64_t i = 0; i < components * tuples; ++i)
    {
      if (!this->Binary)
      {
        this->Scanner.SkipLine();
        continue;
      }
      const std::string_view rest = this->Bytes.substr(this->Scanner.Position());
      const auto byte = [&rest](std::size_t k) { return static_cast<unsigned char>(rest[k]); };
      const std::size_t width = rest.empty() ? 1 : std::size_t{ 1 } << (3 - (byte(0) >> 6));
      if (rest.size() < width)
      {
        return this->Error("truncated: the file ends inside an array.");
      }
      std::uint64_t length = byte(0) & 0x3f;
      for (std::size_t k = 1; k < width; ++k)
      {
        length = length << 8 | byte(k);
      }
      if (length > rest.size() - width)
      {
        return this->Error("truncated: the file ends inside an array.");
      }
      this->Scanner.Advance(width + static_cast<std::size_t>(length));
    }
    return {};
  }

  /// Ends with an empty line.
  Status SkipMetadata()
  {
    std::string_view word;
    this->Scanner.SkipLine();
    while (this->Scanner.WordOnLine(word))
    {
      this->Scanner.SkipLine();
    }
    return {};
  }

  std::string_view Bytes;
  TextScanner Scanner;
  const std::string& Name;
  vtkPointSet* Output;
  vtkFieldData* Target;   ///< where arrays go: points, cells or the whole
  std::int64_t Count = 0; ///< of POINT_DATA or CELL_DATA
  bool Binary = false;
  bool HasOffsets = false;
};
} // namespace

Status ParseLegacyVTK(std::string_view bytes, const std::string& name, vtkPolyData* output)
{
  output->Initialize();
  LegacyParser parser(bytes, name, output);
  Status status = parser.Parse("POLYDATA");
  if (!status.Ok())
  {
    return status;
  }
  output->SetVerts(parser.Vertices);
  output->SetLines(parser.Lines);
  output->SetPolys(parser.Polygons);
  output->SetStrips(parser.Strips);
  return {};
}

Status ParseLegacyVTK(std::string_view bytes, const std::string& name, vtkUnstructuredGrid* output)
{
  output->Initialize();
  LegacyParser parser(bytes, name, output);
  Status status = parser.Parse("UNSTRUCTURED_GRID");
  if (!status.Ok() || !parser.Polygons)
  {
    return status;
  }
  vtkNew<vtkUnsignedCharArray> types;
  const vtkIdType count = parser.Types ? parser.Types->GetNumberOfTuples() : 0;
  for (vtkIdType c = 0; c < count; ++c)
  {
    // A type that doesn't fit becomes 0, an empty cell, which is rejected where cells are checked.
    const double type = parser.Types->GetComponent(c, 0);
    if (type == VTK_POLYHEDRON)
    {
      // SetCells() would take the cell's list of points for its list of faces.
      return Status(StatusCode::InvalidMesh,
        name + ": cell " + std::to_string(c) + " is a polyhedron. Only linear cells are read.");
    }
    types->InsertNextValue(type >= 0 && type < 256 ? static_cast<unsigned char>(type) : 0);
  }
  if (count != parser.Polygons->GetNumberOfCells())
  {
    return Status(StatusCode::UnreadableFile,
      name + ": " + std::to_string(count) + " cell types for " +
        std::to_string(parser.Polygons->GetNumberOfCells()) + " cells.");
  }
  output->SetCells(types, parser.Polygons);
  return {};
}
} // namespace featurehex

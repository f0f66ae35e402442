// SPDX-License-Identifier: BSD-3-Clause
#include "GuardedVTKFiles.h"

#include "FileAccess.h"
#include "LegacyVTKFile.h"
#include "TextScanner.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCommand.h"
#include "vtkDataArrayRange.h"
#include "vtkDataCompressor.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridWriter.h"
#include "vtkXMLDataParser.h"
#include "vtkXMLPolyDataReader.h"
#include "vtkXMLUnstructuredGridReader.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <algorithm>

namespace featurehex
{
namespace
{
/// Takes the errors of a VTK object instead of the output window.
class ErrorCollector : public vtkCommand
{
public:
  static ErrorCollector* New() { return new ErrorCollector; }

  void Execute(vtkObject*, unsigned long event, void* data) override
  {
    if (event == vtkCommand::ErrorEvent && this->Message.empty())
    {
      this->Message = data ? Shortened(static_cast<const char*>(data)) : "unknown error";
    }
  }

  const std::string& First() const { return this->Message; }

private:
  /// "ERROR: In f.cxx, line 3\nvtkX (0x1): text\n\n" to "text".
  static std::string Shortened(std::string text)
  {
    const std::size_t start = text.find("): ");
    text = start == std::string::npos ? text : text.substr(start + 3);
    text.erase(text.find_last_not_of(" \n.") + 1);
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
  }

  std::string Message;
};

/// An XML reader whose decompressor reports to the reader's error observer too: it would print.
template <typename XMLReader>
class ObservedReader : public XMLReader
{
public:
  static ObservedReader* New() { VTK_STANDARD_NEW_BODY(ObservedReader); }

protected:
  int ReadPrimaryElement(vtkXMLDataElement* element) override
  {
    // By now the head of the file is read, which names the compressor.
    if (vtkDataCompressor* compressor = this->XMLParser->GetCompressor())
    {
      compressor->AddObserver(vtkCommand::ErrorEvent, this->GetReaderErrorObserver());
    }
    return XMLReader::ReadPrimaryElement(element);
  }
};

Status Unreadable(const std::string& path, const std::string& what)
{
  return Status(StatusCode::UnreadableFile, FileBaseName(path) + ": " + what);
}

/// A file of n bytes has at most this many values: one bit each, or what a compressed block can
/// hold at the very best.
std::int64_t MostValues(const std::string& bytes)
{
  const bool compressed = bytes.substr(0, 4096).find("compressor=") != std::string::npos;
  return (compressed ? 8192 : 8) * static_cast<std::int64_t>(bytes.size());
}

Status TooMany(const std::string& path, std::string_view what, std::int64_t count)
{
  return Unreadable(path, "truncated or damaged: " + Quoted(what) + " promises " +
                            std::to_string(count) + " values, the file is too short for that.");
}

/// Counts of the attributes of an XML file.
Status CheckXMLCounts(const std::string& path, const std::string& bytes)
{
  const std::int64_t most = MostValues(bytes);
  const std::string_view text(bytes);
  for (std::size_t at = text.find("Number"); at != std::string_view::npos;
       at = text.find("Number", at + 1))
  {
    const std::size_t equals = text.find_first_of("=<> \n", at);
    if (equals == std::string_view::npos || text[equals] != '=')
    {
      continue;
    }
    const std::string_view rest = text.substr(equals + 1, 40);
    const std::size_t last = rest.find_first_of("\"'", 1);
    std::int64_t count = 0;
    if (rest.size() < 2 || last == std::string_view::npos ||
        !ParseInteger(rest.substr(1, last - 1), count) || count < 0 || count > most)
    {
      return TooMany(path, text.substr(at, equals - at), count);
    }
  }
  return {};
}

/// Value of an attribute in the text of an XML tag; empty: it has none of this name.
std::string_view AttributeOf(std::string_view tag, std::string_view name)
{
  const char* const space = " \t\r\n";
  for (std::size_t at = 0; at < tag.size();)
  {
    const std::size_t equals = tag.find('=', at);
    const std::size_t open = tag.find_first_of("\"'", equals);
    if (equals == std::string_view::npos || open == std::string_view::npos)
    {
      break;
    }
    const std::size_t close = std::min(tag.find(tag[open], open + 1), tag.size());
    const std::size_t last = tag.find_last_not_of(space, equals - 1);
    const std::size_t first = tag.find_last_of(space, last) + 1;
    if (equals > 0 && last != std::string_view::npos && tag.substr(first, last + 1 - first) == name)
    {
      return tag.substr(open + 1, close - open - 1);
    }
    at = close + 1;
  }
  return {};
}

/// Each array has a type that VTK knows: VTK 9.1 crashes on field data that
/// hasn't, and prints its complaint.
Status CheckXMLTypes(const std::string& path, std::string_view text)
{
  static const std::string_view Types[] = { "Int8", "Int16", "Int32", "Int64", "UInt8", "UInt16",
    "UInt32", "UInt64", "Float32", "Float64", "String", "Bit" };
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1))
  {
    const std::string_view tag = text.substr(at + 1, text.find('<', at + 1) - at - 1);
    const std::string_view name = tag.substr(0, tag.find_first_of(" \t\r\n/>"));
    if (name == "AppendedData")
    {
      break;
    }
    const std::string_view type = AttributeOf(tag, "type");
    if ((name == "DataArray" || name == "Array") &&
        std::find(std::begin(Types), std::end(Types), type) == std::end(Types))
    {
      return Unreadable(path, "an array has the type " + Quoted(type) +
                                ", which is no type of a VTK file. Export or copy the file again.");
    }
  }
  return {};
}

/// Offsets that grow within the connectivity, ids of existing points.
struct CheckCellsWorker
{
  template <typename State>
  void operator()(State& state, vtkIdType points, bool& good) const
  {
    const auto offsets = vtk::DataArrayValueRange<1>(state.GetOffsets());
    const auto ids = vtk::DataArrayValueRange<1>(state.GetConnectivity());
    vtkIdType previous = 0;
    good = offsets.size() == 0 || offsets[0] == 0;
    for (const auto offset : offsets)
    {
      good = good && offset >= previous && offset <= ids.size();
      previous = offset;
    }
    good = good && (offsets.size() == 0 || previous == ids.size());
    for (const auto id : ids)
    {
      good = good && id >= 0 && id < points;
    }
  }
};

bool CellsInRange(vtkCellArray* cells, vtkIdType points)
{
  bool good = true;
  if (cells)
  {
    cells->Visit(CheckCellsWorker{}, points, good);
  }
  return good;
}

bool LengthsMatch(vtkFieldData* arrays, vtkIdType count)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    if (array && array->GetNumberOfTuples() != count)
    {
      return false;
    }
  }
  return true;
}

Status WrongIds(const std::string& path)
{
  return Status(StatusCode::IndexOutOfRange,
    FileBaseName(path) + ": cells refer to points that do not exist. Export the file again.");
}

Status CheckArrays(const std::string& path, vtkPointSet* data)
{
  return LengthsMatch(data->GetPointData(), data->GetNumberOfPoints()) &&
             LengthsMatch(data->GetCellData(), data->GetNumberOfCells())
           ? Status()
           : Unreadable(path, "an array is not as long as the points or cells it belongs to.");
}

Status CheckContent(const std::string& path, vtkPolyData* data)
{
  const vtkIdType points = data->GetNumberOfPoints();
  for (vtkCellArray* cells :
    { data->GetVerts(), data->GetLines(), data->GetPolys(), data->GetStrips() })
  {
    if (!CellsInRange(cells, points))
    {
      return WrongIds(path);
    }
  }
  return CheckArrays(path, data);
}

/// Number of points of the linear cell types; 0: any; -1: no linear cell.
int PointsOfType(int type)
{
  switch (type)
  {
    case VTK_VERTEX:
      return 1;
    case VTK_LINE:
      return 2;
    case VTK_TRIANGLE:
      return 3;
    case VTK_PIXEL:
    case VTK_QUAD:
    case VTK_TETRA:
      return 4;
    case VTK_PYRAMID:
      return 5;
    case VTK_WEDGE:
      return 6;
    case VTK_VOXEL:
    case VTK_HEXAHEDRON:
      return 8;
    case VTK_POLY_VERTEX:
    case VTK_POLY_LINE:
    case VTK_POLYGON:
    case VTK_TRIANGLE_STRIP:
      return 0;
    default:
      return -1;
  }
}

Status CheckContent(const std::string& path, vtkUnstructuredGrid* data)
{
  const vtkIdType count = data->GetCells() ? data->GetCells()->GetNumberOfCells() : 0;
  vtkUnsignedCharArray* types = data->GetCellTypesArray();
  if (count > 0 && (!types || types->GetNumberOfValues() != count))
  {
    return Unreadable(path, "the number of cell types is not the number of cells.");
  }
  if (!CellsInRange(data->GetCells(), data->GetNumberOfPoints()))
  {
    return WrongIds(path);
  }
  for (vtkIdType c = 0; c < count; ++c)
  {
    const int points = PointsOfType(types->GetValue(c));
    const vtkIdType size = data->GetCells()->GetCellSize(c);
    if (points < 0 || (points > 0 && points != size))
    {
      return Status(StatusCode::InvalidMesh,
        FileBaseName(path) + ": cell " + std::to_string(c) + " has type " +
          std::to_string(types->GetValue(c)) + " and " + std::to_string(size) +
          " points. Only linear cells are read; hexahedra have type 12 and 8 points.");
    }
  }
  return CheckArrays(path, data);
}

/// @a data is the output of a run of @a reader, null after an error.
template <typename Reader, typename Data>
Status RunReader(const std::string& path, Reader* reader, vtkSmartPointer<Data>& data)
{
  vtkNew<ErrorCollector> errors;
  reader->SetReaderErrorObserver(errors);
  reader->SetParserErrorObserver(errors);
  reader->AddObserver(vtkCommand::ErrorEvent, errors);
  reader->AddObserver(vtkCommand::WarningEvent, errors);
  reader->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  reader->SetFileName(path.c_str());
  reader->Update();
  if (!errors->First().empty() || reader->GetErrorCode() != vtkErrorCode::NoError)
  {
    const std::string why = errors->First().empty()
                              ? vtkErrorCode::GetStringFromErrorCode(reader->GetErrorCode())
                              : errors->First();
    return Unreadable(path, "not readable as a VTK file: " + why + ".");
  }
  data = Data::SafeDownCast(reader->GetOutputDataObject(0));
  return data ? Status() : Unreadable(path, "the file holds another type of data.");
}

/// @a output stays empty unless all is well.
template <typename XMLReader, typename Data>
Status Read(const std::string& path, const char* xmlExtension, Data* output)
{
  std::string bytes;
  Status status = ReadFileBytes(path, bytes);
  if (status.Ok() && bytes.find_first_not_of(" \t\r\n") == std::string::npos)
  {
    status = Status(StatusCode::EmptySurface, FileBaseName(path) + ": the file is empty.");
  }
  if (!status.Ok())
  {
    return status;
  }
  auto data = vtkSmartPointer<Data>::New();
  if (FileExtension(path) == xmlExtension)
  {
    status = CheckXMLCounts(path, bytes);
    status = status.Ok() ? CheckXMLTypes(path, bytes) : status;
    if (status.Ok())
    {
      vtkNew<ObservedReader<XMLReader>> reader;
      status = RunReader(path, reader.Get(), data);
    }
  }
  else
  {
    status = ParseLegacyVTK(bytes, FileBaseName(path), data);
  }
  if (status.Ok())
  {
    status = CheckContent(path, data.Get());
  }
  if (status.Ok())
  {
    output->ShallowCopy(data);
  }
  return status;
}

template <typename Writer>
Status RunWriter(const std::string& path, Writer* writer, vtkUnstructuredGrid* input)
{
  PendingFile pending;
  Status status = pending.Open(path);
  if (!status.Ok())
  {
    return status;
  }
  vtkNew<ErrorCollector> errors;
  writer->AddObserver(vtkCommand::ErrorEvent, errors);
  writer->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  writer->SetInputData(input);
  writer->SetFileName(pending.Name().c_str());
  if (!writer->Write() || !errors->First().empty() ||
      writer->GetErrorCode() != vtkErrorCode::NoError)
  {
    const std::string why = errors->First().empty()
                              ? vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode())
                              : errors->First();
    return Status(StatusCode::UnwritableFile, "Can't write \"" + path + "\": " + why + ".");
  }
  return pending.Commit();
}
} // namespace

unsigned long ErrorCodeOf(const Status& status)
{
  switch (status.Code)
  {
    case StatusCode::Ok:
      return vtkErrorCode::NoError;
    case StatusCode::UnreadableFile:
      return vtkErrorCode::FileFormatError;
    case StatusCode::UnwritableFile:
      return vtkErrorCode::CannotOpenFileError;
    case StatusCode::InvalidOption:
      return vtkErrorCode::NoFileNameError;
    default:
      return static_cast<unsigned long>(vtkErrorCode::UserError) +
             static_cast<unsigned long>(status.Code);
  }
}

Status ReadVTKFile(const std::string& path, vtkPolyData* output)
{
  return Read<vtkXMLPolyDataReader>(path, ".vtp", output);
}

Status ReadVTKFile(const std::string& path, vtkUnstructuredGrid* output)
{
  return Read<vtkXMLUnstructuredGridReader>(path, ".vtu", output);
}

Status WriteVTKFile(const std::string& path, vtkUnstructuredGrid* input)
{
  if (FileExtension(path) == ".vtu")
  {
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetDataModeToBinary();
    return RunWriter(path, writer.Get(), input);
  }
  vtkNew<vtkUnstructuredGridWriter> writer;
  writer->SetFileTypeToBinary();
  writer->SetFileVersion(vtkDataWriter::VTK_LEGACY_READER_VERSION_4_2);
  return RunWriter(path, writer.Get(), input);
}
} // namespace featurehex

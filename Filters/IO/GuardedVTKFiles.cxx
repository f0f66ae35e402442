// SPDX-License-Identifier: BSD-3-Clause
#include "GuardedVTKFiles.h"

#include "FileAccess.h"
#include "TextScanner.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCommand.h"
#include "vtkDataArrayRange.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataReader.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridReader.h"
#include "vtkUnstructuredGridWriter.h"
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

Status Unreadable(const std::string& path, const std::string& what)
{
  return Status(StatusCode::UnreadableFile, FileBaseName(path) + ": " + what);
}

/// A file of n bytes has at most this many values: one bit each (legacy), or what a compressed
/// block can hold at the very best (XML).
std::int64_t MostValues(const std::string& bytes, bool xml)
{
  const bool compressed = xml && bytes.substr(0, 4096).find("compressor=") != std::string::npos;
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
  const std::int64_t most = MostValues(bytes, true);
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

/// Counts in the keyword lines of a legacy file, "POINTS n type" and so on, and in array lines,
/// "name components tuples type". Lines inside binary data rarely look like that, and then hardly
/// ever with a count that is too large.
Status CheckLegacyCounts(const std::string& path, const std::string& bytes)
{
  constexpr std::string_view keywords[] = { "POINTS", "VERTICES", "LINES", "POLYGONS",
    "TRIANGLE_STRIPS", "CELLS", "CELL_TYPES", "POINT_DATA", "CELL_DATA", "FIELD", "SCALARS",
    "LOOKUP_TABLE", "DIMENSIONS" };
  constexpr std::string_view types[] = { "bit", "unsigned_char", "char", "unsigned_short", "short",
    "unsigned_int", "int", "unsigned_long", "long", "float", "double", "vtkIdType", "vtktypeint64",
    "vtktypeuint64", "string" };
  const std::int64_t most = MostValues(bytes, false);
  const std::string_view text(bytes);
  for (std::size_t begin = 0; begin < text.size();)
  {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    TextScanner scanner(text.substr(begin, std::min<std::size_t>(end - begin, 300)), 0);
    begin = end + 1;
    std::string_view words[4];
    int n = 0;
    while (n < 4 && scanner.WordOnLine(words[n]))
    {
      ++n;
    }
    const bool array =
      n == 4 && std::find(std::begin(types), std::end(types), words[3]) != std::end(types);
    if (!array &&
        std::find(std::begin(keywords), std::end(keywords), words[0]) == std::end(keywords))
    {
      continue;
    }
    std::int64_t product = 1;
    for (int i = 1; i < n; ++i)
    {
      std::int64_t count = 0;
      if (ParseInteger(words[i], count))
      {
        if (count < 0 || count > most || (array && count > 0 && product > most / count))
        {
          return TooMany(path, words[0], count);
        }
        product *= array ? std::max<std::int64_t>(count, 1) : 1;
      }
    }
  }
  return {};
}

/// VTK's legacy readers crash without the four lines of the header.
Status CheckLegacyHeader(const std::string& path, const std::string& bytes, const char* dataSet)
{
  TextScanner scanner(bytes, 0);
  std::string_view words[3];
  bool good = true;
  for (const char* expected : { "#", "vtk", "DataFile", "Version" })
  {
    good = good && scanner.WordOnLine(words[0]) && words[0] == expected;
  }
  scanner.SkipLine();
  scanner.SkipLine();
  good = good && scanner.Word(words[0]) && (words[0] == "ASCII" || words[0] == "BINARY") &&
         scanner.Word(words[1]) && words[1] == "DATASET" && scanner.Word(words[2]);
  if (!good)
  {
    return Unreadable(path, "not a legacy VTK file, or truncated in its header.");
  }
  return words[2] == dataSet ? Status()
                             : Unreadable(path, "the file holds " + Quoted(words[2]) + ", not " +
                                                  Quoted(dataSet) + ".");
}

Status CheckCounts(const std::string& path, const char* legacyDataSet)
{
  std::string bytes;
  Status status = ReadFileBytes(path, bytes);
  if (!status.Ok())
  {
    return status;
  }
  if (bytes.find_first_not_of(" \t\r\n") == std::string::npos)
  {
    return Status(StatusCode::EmptySurface, FileBaseName(path) + ": the file is empty.");
  }
  if (!legacyDataSet)
  {
    return CheckXMLCounts(path, bytes);
  }
  status = CheckLegacyHeader(path, bytes, legacyDataSet);
  return status.Ok() ? CheckLegacyCounts(path, bytes) : status;
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

/// @a output stays empty unless all is well.
template <typename Reader, typename Data>
Status RunReader(const std::string& path, Reader* reader, ErrorCollector* errors, Data* output)
{
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
  Data* data = Data::SafeDownCast(reader->GetOutputDataObject(0));
  if (!data)
  {
    return Unreadable(path, "the file holds another type of data.");
  }
  Status status = CheckContent(path, data);
  if (status.Ok())
  {
    output->ShallowCopy(data);
  }
  return status;
}

template <typename XMLReader, typename LegacyReader, typename Data>
Status Read(
  const std::string& path, const char* xmlExtension, const char* legacyDataSet, Data* output)
{
  const bool xml = FileExtension(path) == xmlExtension;
  Status status = CheckCounts(path, xml ? nullptr : legacyDataSet);
  if (!status.Ok())
  {
    return status;
  }
  vtkNew<ErrorCollector> errors;
  if (xml)
  {
    vtkNew<XMLReader> reader;
    reader->SetReaderErrorObserver(errors);
    reader->SetParserErrorObserver(errors);
    return RunReader(path, reader.Get(), errors, output);
  }
  vtkNew<LegacyReader> reader;
  return RunReader(path, reader.Get(), errors, output);
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

Status NoFileName()
{
  return Status(StatusCode::InvalidOption, "FileName is not set.");
}

Status ReadVTKFile(const std::string& path, vtkPolyData* output)
{
  return Read<vtkXMLPolyDataReader, vtkPolyDataReader>(path, ".vtp", "POLYDATA", output);
}

Status ReadVTKFile(const std::string& path, vtkUnstructuredGrid* output)
{
  return Read<vtkXMLUnstructuredGridReader, vtkUnstructuredGridReader>(
    path, ".vtu", "UNSTRUCTURED_GRID", output);
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

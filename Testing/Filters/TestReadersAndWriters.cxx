// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayNames.h"
#include "Status.h"
#include "../Core/SharedData.h"

#include "vtkFeatureGraphReader.h"
#include "vtkFeatureGraphWriter.h"
#include "vtkHexMeshReader.h"
#include "vtkHexMeshWriter.h"
#include "vtkMeditMeshReader.h"
#include "vtkMeditMeshWriter.h"
#include "vtkSurfaceFileReader.h"

#include "vtkCallbackCommand.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkErrorCode.h"
#include "vtkExecutive.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataWriter.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"
#include "vtkStripper.h"
#include "vtkUnstructuredGrid.h"
#include "vtkUnstructuredGridWriter.h"
#include "vtkXMLPolyDataWriter.h"
#include "vtkXMLUnstructuredGridWriter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include <csignal>
#include <sys/resource.h>

#ifdef __SANITIZE_ADDRESS__
#include <sanitizer/lsan_interface.h>
#endif

namespace fs = std::filesystem;
using featurehex::SharedData;
using featurehex::StatusCode;

namespace
{
constexpr unsigned long UserCode(StatusCode code)
{
  return static_cast<unsigned long>(vtkErrorCode::UserError) + static_cast<unsigned long>(code);
}

/// Takes the errors of an algorithm, so that they don't reach the test's output.
class Errors
{
public:
  explicit Errors(vtkAlgorithm* algorithm)
    : Algorithm(algorithm)
  {
    this->Own->SetClientData(this);
    this->Own->SetCallback([](vtkObject*, unsigned long, void* self, void* text)
      { static_cast<Errors*>(self)->Messages.emplace_back(static_cast<const char*>(text)); });
    algorithm->AddObserver(vtkCommand::ErrorEvent, this->Own);
    // "Algorithm returned failure" comes from the executive and repeats what was said.
    this->Repeated->SetCallback([](vtkObject*, unsigned long, void*, void*) {});
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Repeated);
  }
  ~Errors()
  {
    this->Algorithm->RemoveObserver(this->Own);
    this->Algorithm->GetExecutive()->RemoveObserver(this->Repeated);
  }
  Errors(const Errors&) = delete;
  void operator=(const Errors&) = delete;

  std::vector<std::string> Messages;

private:
  vtkAlgorithm* Algorithm;
  vtkNew<vtkCallbackCommand> Own;
  vtkNew<vtkCallbackCommand> Repeated;
};

/// A folder that disappears with the test.
class ReadersAndWriters : public testing::Test
{
protected:
  void SetUp() override
  {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    this->Folder = fs::temp_directory_path() / (std::string("featurehex-io-") + info->name());
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder);
  }
  void TearDown() override { fs::remove_all(this->Folder); }

  std::string File(const std::string& name) const { return (this->Folder / name).string(); }

  std::string Write(const std::string& name, const std::string& text) const
  {
    std::ofstream(this->File(name), std::ios::binary) << text;
    return this->File(name);
  }

  std::size_t NumberOfFiles() const
  {
    return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(this->Folder), fs::directory_iterator()));
  }

  fs::path Folder;
};

std::string Content(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  return { std::istreambuf_iterator<char>(file), {} };
}

/// Reads @a name; checks that there is either data and no error, or exactly one error and none.
template <typename Reader>
vtkSmartPointer<typename std::remove_pointer<decltype(std::declval<Reader>().GetOutput())>::type>
Read(Reader* reader, const std::string& name, std::string* message = nullptr)
{
  Errors errors(reader);
  reader->SetFileName(name.c_str());
  reader->Update();
  const vtkIdType cells = reader->GetOutput()->GetNumberOfCells();
  const bool failed = reader->GetErrorCode() != vtkErrorCode::NoError;
  EXPECT_EQ(errors.Messages.size(), failed ? 1u : 0u) << name;
  if (failed)
  {
    EXPECT_EQ(cells, 0) << name;
    EXPECT_EQ(reader->GetOutput()->GetNumberOfPoints(), 0) << name;
  }
  if (message)
  {
    *message = errors.Messages.empty() ? "" : errors.Messages.front();
  }
  return reader->GetOutput();
}

template <typename Writer, typename Data>
unsigned long WriteWith(Writer* writer, Data* data, const std::string& name)
{
  Errors errors(writer);
  writer->SetInputData(data);
  writer->SetFileName(name.c_str());
  const int result = writer->Write();
  EXPECT_EQ(result != 0, writer->GetErrorCode() == vtkErrorCode::NoError);
  EXPECT_EQ(errors.Messages.size(), result ? 0u : 1u);
  return writer->GetErrorCode();
}

/// Two cubes with labels, and with @a boundary two quads, a line and a vertex.
vtkSmartPointer<vtkUnstructuredGrid> TwoCubes(bool boundary)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int k = 0; k < 3; ++k)
  {
    for (const auto& [x, y] : { std::pair(0., 0.), { 1. / 3, 0. }, { 1., 1e-20 }, { 0., 0.7 } })
    {
      points->InsertNextPoint(x, y, k * M_PI);
    }
  }
  grid->SetPoints(points);
  vtkNew<vtkIntArray> region;
  region->SetName("Region");
  vtkNew<vtkIntArray> patch;
  patch->SetName("PatchId");
  vtkNew<vtkIntArray> curve;
  curve->SetName("CurveId");
  const auto add = [&](int type, const std::vector<vtkIdType>& ids, int r, int p, int c)
  {
    grid->InsertNextCell(type, static_cast<vtkIdType>(ids.size()), ids.data());
    region->InsertNextValue(r);
    patch->InsertNextValue(p);
    curve->InsertNextValue(c);
  };
  add(VTK_HEXAHEDRON, { 0, 1, 2, 3, 4, 5, 6, 7 }, 1, -1, -1);
  add(VTK_HEXAHEDRON, { 4, 5, 6, 7, 8, 9, 10, 11 }, 2, -1, -1);
  if (boundary)
  {
    add(VTK_QUAD, { 0, 3, 2, 1 }, 0, 5, -1);
    add(VTK_QUAD, { 8, 9, 10, 11 }, 0, 6, -1);
    add(VTK_LINE, { 0, 1 }, 0, -1, 7);
    add(VTK_VERTEX, { 11 }, 0, -1, -1);
    grid->GetCellData()->AddArray(patch);
    grid->GetCellData()->AddArray(curve);
  }
  grid->GetCellData()->AddArray(region);
  return grid;
}

void ExpectSameGrid(vtkUnstructuredGrid* a, vtkUnstructuredGrid* b)
{
  ASSERT_EQ(a->GetNumberOfPoints(), b->GetNumberOfPoints());
  ASSERT_EQ(a->GetNumberOfCells(), b->GetNumberOfCells());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_EQ(a->GetPoint(i)[k], b->GetPoint(i)[k]);
    }
  }
  vtkNew<vtkIdList> idsA;
  vtkNew<vtkIdList> idsB;
  for (vtkIdType c = 0; c < a->GetNumberOfCells(); ++c)
  {
    ASSERT_EQ(a->GetCellType(c), b->GetCellType(c));
    a->GetCellPoints(c, idsA);
    b->GetCellPoints(c, idsB);
    ASSERT_EQ(idsA->GetNumberOfIds(), idsB->GetNumberOfIds());
    for (vtkIdType i = 0; i < idsA->GetNumberOfIds(); ++i)
    {
      EXPECT_EQ(idsA->GetId(i), idsB->GetId(i));
    }
  }
  for (int i = 0; i < a->GetCellData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = a->GetCellData()->GetArray(i);
    vtkDataArray* other = b->GetCellData()->GetArray(array->GetName());
    ASSERT_TRUE(other) << array->GetName();
    for (vtkIdType c = 0; c < a->GetNumberOfCells(); ++c)
    {
      EXPECT_EQ(array->GetComponent(c, 0), other->GetComponent(c, 0)) << array->GetName() << c;
    }
  }
}
} // namespace

TEST_F(ReadersAndWriters, HexMeshRoundTrips)
{
  for (const char* name : { "out.vtu", "out.vtk", "out.mesh", "OUT.VTU" })
  {
    const auto grid = TwoCubes(false);
    vtkNew<vtkHexMeshWriter> writer;
    EXPECT_EQ(WriteWith(writer.Get(), grid.Get(), this->File(name)), 0ul);
    vtkNew<vtkHexMeshReader> reader;
    EXPECT_TRUE(reader->CanReadFile(this->File(name).c_str()));
    ExpectSameGrid(grid, Read(reader.Get(), this->File(name)));
  }
  EXPECT_EQ(this->NumberOfFiles(), 4u);
}

TEST_F(ReadersAndWriters, VtuHasNoAppendedData)
{
  vtkNew<vtkHexMeshWriter> writer;
  WriteWith(writer.Get(), TwoCubes(true).Get(), this->File("out.vtu"));
  const std::string text = Content(this->File("out.vtu"));
  EXPECT_EQ(text.find("appended"), std::string::npos);
  EXPECT_NE(text.find("format=\"binary\""), std::string::npos);
}

TEST_F(ReadersAndWriters, MeditRoundTripWithBoundary)
{
  const auto grid = TwoCubes(true);
  vtkNew<vtkMeditMeshWriter> writer;
  EXPECT_EQ(WriteWith(writer.Get(), grid.Get(), this->File("out.mesh")), 0ul);
  vtkNew<vtkMeditMeshReader> reader;
  EXPECT_TRUE(reader->CanReadFile(this->File("out.mesh").c_str()));
  EXPECT_FALSE(reader->CanReadFile(this->Write("other.mesh", "INRIA 3\n").c_str()));
  EXPECT_FALSE(reader->CanReadFile(this->File("none.mesh").c_str()));
  const auto hexes = Read(reader.Get(), this->File("out.mesh"));
  EXPECT_EQ(hexes->GetNumberOfCells(), 2);
  EXPECT_FALSE(hexes->GetCellData()->HasArray("PatchId"));
  reader->BoundaryElementsOn();
  ExpectSameGrid(grid, Read(reader.Get(), this->File("out.mesh")));
}

TEST_F(ReadersAndWriters, WritersSayWhatIsWrongAndLeaveNothingBehind)
{
  vtkNew<vtkHexMeshWriter> writer;
  const auto grid = TwoCubes(false);
  EXPECT_EQ(WriteWith(writer.Get(), grid.Get(), ""), +vtkErrorCode::NoFileNameError);
  EXPECT_EQ(
    WriteWith(writer.Get(), grid.Get(), this->File("x.stl")), +vtkErrorCode::CannotOpenFileError);
  for (const char* name : { "none/x.vtu", "none/x.vtk", "none/x.mesh" })
  {
    EXPECT_EQ(
      WriteWith(writer.Get(), grid.Get(), this->File(name)), +vtkErrorCode::CannotOpenFileError);
  }
  vtkNew<vtkUnstructuredGrid> empty;
  EXPECT_EQ(
    WriteWith(writer.Get(), empty.Get(), this->File("x.vtu")), UserCode(StatusCode::EmptySurface));
  vtkNew<vtkUnstructuredGrid> wedge;
  wedge->DeepCopy(grid);
  const vtkIdType ids[] = { 0, 1, 2, 4, 5, 6 };
  wedge->InsertNextCell(VTK_WEDGE, 6, ids);
  EXPECT_EQ(
    WriteWith(writer.Get(), wedge.Get(), this->File("x.mesh")), UserCode(StatusCode::InvalidMesh));
  vtkNew<vtkUnstructuredGrid> infinite;
  infinite->DeepCopy(grid);
  infinite->GetPoints()->SetPoint(3, 0, NAN, 0);
  EXPECT_EQ(
    WriteWith(writer.Get(), infinite.Get(), this->File("x.mesh")), UserCode(StatusCode::NonFinite));
  EXPECT_EQ(this->NumberOfFiles(), 0u);
}

TEST_F(ReadersAndWriters, AFullDiskKeepsTheOldFile)
{
  // A limit on the size of files stands for the full disk.
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit old{};
  ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &old), 0);
  for (const char* name : { "x.vtu", "x.vtk", "x.mesh" })
  {
    const std::string file = this->Write(name, "old");
    const rlimit small{ 100, old.rlim_max };
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &small), 0);
    vtkNew<vtkHexMeshWriter> writer;
    const unsigned long code = WriteWith(writer.Get(), TwoCubes(false).Get(), file);
    ASSERT_EQ(setrlimit(RLIMIT_FSIZE, &old), 0);
    EXPECT_EQ(code, +vtkErrorCode::CannotOpenFileError) << name;
    EXPECT_EQ(Content(file), "old");
  }
  EXPECT_EQ(this->NumberOfFiles(), 3u);
}

TEST_F(ReadersAndWriters, SurfacesOfEachFormat)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkXMLPolyDataWriter> xml;
  xml->SetInputConnection(strips->GetOutputPort());
  xml->SetFileName(this->File("x.vtp").c_str());
  xml->Write();
  vtkNew<vtkPolyDataWriter> legacy;
  legacy->SetInputConnection(sphere->GetOutputPort());
  legacy->SetFileName(this->File("x.vtk").c_str());
  legacy->Write();
  this->Write("x.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0.1\nv 0 1 0\nf 1 2 3 4\n");
  this->Write("x.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  this->Write("x.stl",
    "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid\n");
  this->Write("x.ply",
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
    "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  for (const char* name : { "x.vtp", "x.vtk", "x.obj", "x.off", "x.stl", "x.ply" })
  {
    vtkNew<vtkSurfaceFileReader> reader;
    EXPECT_TRUE(reader->CanReadFile(this->File(name).c_str()));
    std::string message;
    const auto surface = Read(reader.Get(), this->File(name), &message);
    EXPECT_GT(surface->GetNumberOfCells(), 0) << name << message;
  }
  vtkNew<vtkSurfaceFileReader> reader;
  const auto quad = Read(reader.Get(), this->File("x.obj"));
  EXPECT_EQ(quad->GetNumberOfPolys(), 2);
  EXPECT_EQ(quad->GetPoint(2)[2], 0.1);
  const vtkMTimeType before = reader->GetOutput()->GetMTime();
  reader->Update();
  EXPECT_EQ(reader->GetOutput()->GetMTime(), before) << "executed again without need";
  EXPECT_FALSE(reader->CanReadFile(this->File("none.obj").c_str()));
  EXPECT_FALSE(reader->CanReadFile(nullptr));
}

TEST_F(ReadersAndWriters, ReadersSayWhatIsWrongOnce)
{
  vtkNew<vtkSurfaceFileReader> unset;
  Errors errors(unset);
  unset->Update();
  EXPECT_EQ(errors.Messages.size(), 1u);
  EXPECT_EQ(unset->GetErrorCode(), +vtkErrorCode::NoFileNameError);

  const std::string vtkHead = "# vtk DataFile Version 4.2\nx\nASCII\nDATASET POLYDATA\n";
  const std::string points = "POINTS 3 float\n0 0 0 1 0 0 0 1 0\n";
  const struct
  {
    const char* Name;
    std::string Text;
    const char* Part;
  } cases[] = { { "a.vtp", "", "empty" }, { "b.vtp", "garbage", "not readable" },
    { "c.vtk", "garbage", "this is not a legacy VTK file" },
    { "d.vtk", vtkHead + "POINTS 4000000000 float\n0 0 0\n", "promises 4000000000" },
    { "e.vtk", vtkHead + points + "POLYGONS 1 4\n3 0 1 7\n", "do not exist" },
    { "f.vtk", vtkHead + points + "POLYGONS 1 4\n3 0 1\n", "f.vtk" },
    { "g.vtk", vtkHead + points, "no polygons" },
    { "h.vtk", vtkHead + points + "POLYGONS -1 -4\n3 0 1 2\n", "promises -4" },
    { "i.obj", "f 1 2 3\n", "does not exist" }, { "j.xyz", "hello", "neither OBJ" },
    { "k.vtp",
      "<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData><Piece NumberOfPoints=\"99999999\"/>",
      "promises 99999999" } };
  for (const auto& c : cases)
  {
    std::string message;
    vtkNew<vtkSurfaceFileReader> reader;
    Read(reader.Get(), this->Write(c.Name, c.Text), &message);
    EXPECT_NE(reader->GetErrorCode(), 0ul) << c.Name;
    EXPECT_NE(message.find(c.Part), std::string::npos) << c.Name << message;
  }
  std::string message;
  vtkNew<vtkSurfaceFileReader> reader;
  Read(reader.Get(), this->File("nothing.vtp"), &message);
  EXPECT_NE(message.find("no such file"), std::string::npos) << message;
}

TEST_F(ReadersAndWriters, HexMeshReaderRejectsOtherCellsAndWrongIds)
{
  const std::string head = "# vtk DataFile Version 4.2\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n"
                           "POINTS 4 float\n0 0 0 1 0 0 0 1 0 0 0 1\n";
  const struct
  {
    const char* Name;
    std::string Text;
    const char* Part;
  } cases[] = { { "a.vtk", head + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n12\n", "type 12 and 4" },
    { "b.vtk", head + "CELLS 1 5\n4 0 1 2 3\nCELL_TYPES 1\n24\n", "type 24" },
    { "c.vtk", head + "CELLS 1 5\n4 0 1 2 4\nCELL_TYPES 1\n10\n", "do not exist" },
    { "d.vtk", head + "CELLS 1 5\n4 0 1 2 -1\nCELL_TYPES 1\n10\n", "does not exist" },
    { "e.vtk", head, "no volume cells" }, { "f.mesh", "MeshVersionFormatted 2\n", "no points" },
    { "g.stl", "solid", ".vtu, .vtk and .mesh" },
    { "h.vtu", // VTK 9.1 alone crashes on this
      "<VTKFile type=\"UnstructuredGrid\" version=\"0.1\"><UnstructuredGrid><FieldData>"
      "<DataArray type = 'Float6q' Name=\"type\" NumberOfTuples=\"1\">0</DataArray></FieldData>"
      "<Piece NumberOfPoints=\"0\" NumberOfCells=\"0\"/></UnstructuredGrid></VTKFile>",
      "\"Float6q\"" } };
  for (const auto& c : cases)
  {
    std::string message;
    vtkNew<vtkHexMeshReader> reader;
    Read(reader.Get(), this->Write(c.Name, c.Text), &message);
    EXPECT_NE(reader->GetErrorCode(), 0ul) << c.Name;
    EXPECT_NE(message.find(c.Part), std::string::npos) << c.Name << message;
  }
  std::string message;
  vtkNew<vtkMeditMeshReader> reader;
  Read(reader.Get(),
    this->Write("quad.mesh",
      "MeshVersionFormatted 2\nDimension 3\nVertices 4\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n"
      "Quadrilaterals 1\n1 2 3 4 9\n"),
    &message);
  EXPECT_NE(message.find("BoundaryElements"), std::string::npos) << message;
  reader->BoundaryElementsOn();
  EXPECT_EQ(Read(reader.Get(), this->File("quad.mesh"))->GetNumberOfCells(), 1);
}

TEST_F(ReadersAndWriters, LegacyFilesOfEachKind)
{
  const auto grid = TwoCubes(true);
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("a name");
  vectors->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> scalars;
  scalars->SetName("scalars");
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    vectors->InsertNextTuple3(i, 1e-300, 1. / 7);
    scalars->InsertNextValue(0.5f * static_cast<float>(i));
  }
  grid->GetPointData()->SetVectors(vectors);
  grid->GetPointData()->SetScalars(scalars);
  vtkNew<vtkStringArray> text;
  text->SetName("text");
  text->InsertNextValue("POINTS 7 float");
  text->InsertNextValue(std::string(100, 'x'));
  grid->GetFieldData()->AddArray(text);
  vtkNew<vtkDoubleArray> figure;
  figure->SetName("figure");
  figure->InsertNextValue(42);
  grid->GetFieldData()->AddArray(figure);
  for (const int version : { 42, 51 })
  {
    for (const int type : { VTK_ASCII, VTK_BINARY })
    {
      vtkNew<vtkUnstructuredGridWriter> writer;
      writer->SetInputData(grid);
      writer->SetFileVersion(version);
      writer->SetFileType(type);
      writer->SetFileName(this->File("x.vtk").c_str());
      writer->Write();
      vtkNew<vtkHexMeshReader> reader;
      std::string message;
      const auto copy = Read(reader.Get(), this->File("x.vtk"), &message);
      ASSERT_EQ(message, "") << version << type;
      EXPECT_EQ(copy->GetNumberOfCells(), grid->GetNumberOfCells());
      vtkDataArray* read = copy->GetPointData()->GetArray("a name");
      ASSERT_TRUE(read);
      EXPECT_EQ(read->GetComponent(3, 0), 3.0);
      ASSERT_TRUE(copy->GetPointData()->GetArray("scalars"));
      EXPECT_EQ(copy->GetPointData()->GetArray("scalars")->GetComponent(5, 0), 2.5);
      ASSERT_TRUE(copy->GetFieldData()->GetArray("figure"));
      EXPECT_EQ(copy->GetFieldData()->GetArray("figure")->GetComponent(0, 0), 42.0);
      if (type == VTK_BINARY)
      {
        ExpectSameGrid(grid, copy);
      }
    }
  }
}

TEST_F(ReadersAndWriters, DamagedVTKFilesAreSafe)
{
#ifdef __SANITIZE_ADDRESS__
  // VTK's XML readers leak on damaged files.
  const __lsan::ScopedDisabler noLeakCheck;
#endif
  const auto grid = TwoCubes(true);
  const std::string good = this->File("good.vtu");
  std::vector<std::pair<std::string, std::string>> files;
  for (const int mode : { vtkXMLWriter::Ascii, vtkXMLWriter::Binary })
  {
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(grid);
    writer->SetDataMode(mode);
    writer->SetFileName(good.c_str());
    writer->Write();
    files.emplace_back("bad.vtu", Content(good));
  }
  for (const int version : { 42, 51 })
  {
    for (const int type : { VTK_ASCII, VTK_BINARY })
    {
      vtkNew<vtkUnstructuredGridWriter> writer;
      writer->SetInputData(grid);
      writer->SetFileVersion(version);
      writer->SetFileType(type);
      writer->SetFileName(good.c_str());
      writer->Write();
      files.emplace_back("bad.vtk", Content(good));
    }
  }
  std::mt19937 random(3);
  for (const auto& [name, text] : files)
  {
    const int rounds = name == "bad.vtk" ? 1000 : 100;
    for (int round = 0; round < rounds; ++round)
    {
      std::string damaged = text;
      if (round % 3 == 0)
      {
        damaged.resize(random() % text.size());
      }
      else
      {
        damaged[random() % damaged.size()] = static_cast<char>(random());
        damaged.erase(random() % damaged.size(), random() % 4);
      }
      vtkNew<vtkHexMeshReader> reader;
      Read(reader.Get(), this->Write(name, damaged));
    }
  }
}

TEST_F(ReadersAndWriters, FeatureGraphRoundTrip)
{
  const std::string name = this->Write("x.fgraph", "140 1 0\n1 3\n7\n7 9\n9 4\n4 7\n");
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkFeatureGraphReader> reader;
  EXPECT_TRUE(reader->CanReadFile(name.c_str()));
  EXPECT_FALSE(reader->CanReadFile(this->Write("y.fgraph", "hello").c_str()));
  reader->SetInputConnection(sphere->GetOutputPort());
  const auto graph = Read(reader.Get(), name);
  ASSERT_EQ(graph->GetNumberOfPoints(), 3);
  EXPECT_EQ(graph->GetNumberOfVerts(), 1);
  EXPECT_EQ(graph->GetNumberOfLines(), 3);
  auto* ids = vtkIdTypeArray::SafeDownCast(
    graph->GetPointData()->GetArray(featurehex::ArrayNames::SurfacePointId));
  ASSERT_TRUE(ids);
  EXPECT_EQ(ids->GetValue(0), 4);
  EXPECT_EQ(ids->GetValue(2), 9);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(graph->GetPoint(1)[k], sphere->GetOutput()->GetPoint(7)[k]);
  }
  EXPECT_EQ(graph->GetFieldData()->GetArray("FeatureAngle")->GetComponent(0, 0), 140.0);

  vtkNew<vtkFeatureGraphWriter> writer;
  EXPECT_EQ(WriteWith(writer.Get(), graph.Get(), this->File("z.fgraph")), 0ul);
  EXPECT_EQ(Content(this->File("z.fgraph")), Content(name));

  vtkNew<vtkPolyData> anonymous;
  anonymous->DeepCopy(graph);
  anonymous->GetPointData()->Initialize();
  EXPECT_EQ(WriteWith(writer.Get(), anonymous.Get(), this->File("none.fgraph")),
    +vtkErrorCode::NoFileNameError);
  EXPECT_FALSE(fs::exists(this->File("none.fgraph")));
}

TEST_F(ReadersAndWriters, FeatureGraphOfAnotherSurfaceIsRefused)
{
  const std::string name = this->Write("x.fgraph", "0 1 1\n0 1\n0 1000000\n");
  vtkNew<vtkFeatureGraphReader> alone;
  EXPECT_EQ(Read(alone.Get(), name)->GetNumberOfLines(), 1);
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkFeatureGraphReader> reader;
  reader->SetInputConnection(sphere->GetOutputPort());
  std::string message;
  Read(reader.Get(), name, &message);
  EXPECT_EQ(reader->GetErrorCode(), UserCode(StatusCode::IndexOutOfRange));
  EXPECT_NE(message.find("point 1000000"), std::string::npos) << message;
}

TEST_F(ReadersAndWriters, BrokenFilesOfTheTable)
{
  if (!fs::exists(SharedData() / "bad"))
  {
    GTEST_SKIP() << SharedData() << " is not there";
  }
  for (const auto& entry : fs::directory_iterator(SharedData() / "bad"))
  {
    vtkNew<vtkSurfaceFileReader> reader;
    Read(reader.Get(), entry.path().string());
  }
}

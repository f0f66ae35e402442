// SPDX-License-Identifier: BSD-3-Clause
#include "FilterChecks.h"
#include "Types.h"

#include "vtkAbaqusMeshWriter.h"
#include "vtkExodusMeshWriter.h"
#include "vtkGmshMeshWriter.h"
#include "vtkHexMeshWriter.h"
#include "vtkQuadraticHexFilter.h"
#include "vtkUCDMeshWriter.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace
{
vtkSmartPointer<vtkIntArray> Ints(const char* name, int components, const std::vector<int>& values)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  for (int value : values)
  {
    array->InsertNextValue(value);
  }
  return array;
}

/// One cube as vtkFeatureHexMesher makes it: six patches, twelve curves, eight corners.
vtkSmartPointer<vtkUnstructuredGrid> Cube()
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  std::vector<int> ids, quads, edges;
  for (int i = 0; i < 8; ++i)
  {
    points->InsertNextPoint((i + 1) / 2 % 2, i / 2 % 2, i / 4);
    ids.push_back(i);
  }
  grid->SetPoints(points);
  const vtkIdType hex[] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, hex);
  for (int f = 0; f < 6; ++f)
  {
    quads.insert(
      quads.end(), std::begin(featurehex::HexFaces[f]), std::end(featurehex::HexFaces[f]));
    quads.push_back(f);
  }
  for (int e = 0; e < 12; ++e)
  {
    edges.insert(edges.end(), { featurehex::HexEdges[e][0], featurehex::HexEdges[e][1], e });
  }
  grid->GetPointData()->AddArray(Ints("FeatureKind", 1, std::vector<int>(8, 3)));
  grid->GetPointData()->AddArray(Ints("FeatureId", 1, ids));
  grid->GetCellData()->AddArray(Ints("Region", 1, { 1 }));
  grid->GetFieldData()->AddArray(Ints("FeatureQuads", 5, quads));
  grid->GetFieldData()->AddArray(Ints("FeatureEdges", 3, edges));
  return grid;
}

vtkSmartPointer<vtkUnstructuredGrid> Quadratic(vtkUnstructuredGrid* grid, int type)
{
  vtkNew<vtkQuadraticHexFilter> filter;
  filter->SetInputData(grid);
  filter->SetHexType(type);
  filter->Update();
  return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
}

class SolverWriters : public testing::Test
{
protected:
  void SetUp() override
  {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    this->Folder = fs::temp_directory_path() / (std::string("featurehex-solver-") + info->name());
    fs::remove_all(this->Folder);
    fs::create_directories(this->Folder);
  }
  void TearDown() override { fs::remove_all(this->Folder); }

  std::string File(const std::string& name) const { return (this->Folder / name).string(); }

  template <typename Writer>
  std::string Write(Writer* writer, vtkUnstructuredGrid* grid, const std::string& name)
  {
    writer->SetInputData(grid);
    writer->SetFileName(this->File(name).c_str());
    EXPECT_TRUE(writer->Write()) << name;
    std::ifstream file(this->File(name), std::ios::binary);
    return { std::istreambuf_iterator<char>(file), {} };
  }

  fs::path Folder;
};

std::size_t Count(const std::string& text, const std::string& part)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++count;
  }
  return count;
}
} // namespace

TEST_F(SolverWriters, EachFormatNamesAllGroups)
{
  vtkNew<vtkAbaqusMeshWriter> abaqus;
  const std::string inp = this->Write(abaqus.Get(), Cube(), "x.inp");
  EXPECT_EQ(Count(inp, "*SURFACE, NAME=patch_"), 6u);
  EXPECT_EQ(Count(inp, "*NSET, NSET=curve_"), 12u);
  EXPECT_EQ(Count(inp, "*NSET, NSET=corner_"), 8u);
  vtkNew<vtkGmshMeshWriter> gmsh;
  const std::string msh = this->Write(gmsh.Get(), Cube(), "x.msh");
  EXPECT_EQ(Count(msh, "\"patch_"), 6u);
  EXPECT_EQ(Count(msh, "\"curve_"), 12u);
  EXPECT_EQ(Count(msh, "\"corner_"), 8u);
  EXPECT_EQ(Count(msh, "4.1 0 8"), 1u);
  gmsh->SetFormatVersionToVersion22();
  EXPECT_EQ(Count(this->Write(gmsh.Get(), Cube(), "x.msh"), "2.2 0 8"), 1u);
  vtkNew<vtkExodusMeshWriter> exodus;
  const std::string exo = this->Write(exodus.Get(), Cube(), "x.exo");
  EXPECT_EQ(Count(exo, "patch_"), 6u);
  EXPECT_EQ(Count(exo, "curve_"), 12u);
  EXPECT_EQ(Count(exo, "corner_"), 8u);
  vtkNew<vtkUCDMeshWriter> ucd;
  const std::string avs = this->Write(ucd.Get(), Cube(), "x.ucd");
  EXPECT_EQ(Count(avs, " quad "), 6u);
  EXPECT_EQ(Count(avs, " line "), 12u);
}

TEST_F(SolverWriters, TheHexMeshWriterTakesThemByExtension)
{
  const auto same = [this](auto* writer, const std::string& extension, vtkUnstructuredGrid* grid)
  {
    vtkNew<vtkHexMeshWriter> any;
    EXPECT_EQ(
      this->Write(writer, grid, "a" + extension), this->Write(any.Get(), grid, "b" + extension))
      << extension;
  };
  vtkNew<vtkAbaqusMeshWriter> abaqus;
  vtkNew<vtkGmshMeshWriter> gmsh;
  vtkNew<vtkExodusMeshWriter> exodus;
  vtkNew<vtkUCDMeshWriter> ucd;
  for (int type : { -1, 0, 1 })
  {
    const auto grid = type < 0 ? Cube() : Quadratic(Cube(), type);
    ASSERT_EQ(grid->GetNumberOfPoints(), type < 0 ? 8 : type == 0 ? 20 : 27);
    gmsh->SetFormatVersionToVersion41();
    same(gmsh.Get(), ".msh", grid);
    gmsh->SetFormatVersionToVersion22();
    same(gmsh.Get(), ".msh2", grid);
    same(exodus.Get(), ".exo", grid);
    same(exodus.Get(), ".e", grid);
    if (type < 1)
    {
      same(abaqus.Get(), ".inp", grid);
    }
    if (type < 0)
    {
      same(ucd.Get(), ".ucd", grid);
    }
  }
}

TEST_F(SolverWriters, QuadraticHexesKeepTheirGroups)
{
  for (int type : { 0, 1 })
  {
    const auto grid = Quadratic(Cube(), type);
    EXPECT_EQ(grid->GetCellType(0), type ? VTK_TRIQUADRATIC_HEXAHEDRON : VTK_QUADRATIC_HEXAHEDRON);
    EXPECT_EQ(grid->GetPointData()->GetArray("FeatureKind")->GetNumberOfTuples(), type ? 27 : 20);
    // VTK agrees on the order: at each node its own weight is 1.
    for (vtkIdType i = 8; i < grid->GetNumberOfPoints(); ++i)
    {
      double at[3], parametric[3], weights[27], distance = 0.0;
      int sub = 0;
      grid->GetPoint(grid->GetCell(0)->GetPointId(static_cast<int>(i)), at);
      double closest[3];
      EXPECT_EQ(
        grid->GetCell(0)->EvaluatePosition(at, closest, sub, parametric, distance, weights), 1);
      EXPECT_NEAR(weights[i], 1.0, 1e-2) << i;
    }
    vtkNew<vtkGmshMeshWriter> gmsh;
    const std::string msh = this->Write(gmsh.Get(), grid, "x.msh");
    EXPECT_EQ(Count(msh, "\"patch_"), 6u);
    EXPECT_EQ(Count(msh, "\"curve_"), 12u);
  }
}

TEST_F(SolverWriters, AMeshWithoutArraysIsOneBodyWithOnePatch)
{
  auto grid = Cube();
  grid->GetPointData()->Initialize();
  grid->GetCellData()->Initialize();
  grid->GetFieldData()->Initialize();
  vtkNew<vtkGmshMeshWriter> gmsh;
  const std::string msh = this->Write(gmsh.Get(), grid, "x.msh");
  EXPECT_NE(msh.find("$PhysicalNames\n2\n2 1 \"patch_0\"\n3 1 \"body_1\"\n"), std::string::npos);
}

TEST_F(SolverWriters, SayWhatTheFormatCantHold)
{
  const auto fails = [this](
                       vtkSolverMeshWriter* writer, vtkUnstructuredGrid* grid, const char* words)
  {
    FilterChecks::Messages messages(writer);
    writer->SetInputData(grid);
    writer->SetFileName(this->File("x").c_str());
    EXPECT_FALSE(writer->Write());
    ASSERT_FALSE(messages.Errors.empty());
    EXPECT_NE(messages.Errors[0].find(words), std::string::npos) << messages.Errors[0];
    EXPECT_TRUE(fs::is_empty(this->Folder));
  };
  vtkNew<vtkAbaqusMeshWriter> abaqus;
  vtkNew<vtkUCDMeshWriter> ucd;
  vtkNew<vtkUnstructuredGrid> empty;
  fails(abaqus, empty, "no hexahedra");
  fails(abaqus, Quadratic(Cube(), 1), "27 nodes");
  fails(ucd, Quadratic(Cube(), 0), "linear hexahedra only");
  auto wedge = Cube();
  const vtkIdType ids[] = { 0, 1, 2, 4, 5, 6 };
  wedge->InsertNextCell(VTK_WEDGE, 6, ids);
  fails(abaqus, wedge, "type 13");
  auto mixed = Quadratic(Cube(), 0);
  const vtkIdType hex[] = { 0, 1, 2, 3, 4, 5, 6, 7 };
  mixed->InsertNextCell(VTK_HEXAHEDRON, 8, hex);
  fails(abaqus, mixed, "type 12");
}

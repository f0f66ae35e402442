// SPDX-License-Identifier: BSD-3-Clause
#include "FilterChecks.h"

#include "vtkAppendPolyData.h"
#include "vtkCubeSource.h"
#include "vtkFeatureHexMesher.h"
#include "vtkFloatArray.h"
#include "vtkHexMeshReader.h"
#include "vtkHexMeshWriter.h"
#include "vtkHexValidationFilter.h"
#include "vtkReverseSense.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"

#include <chrono>
#include <cstdio>
#include <set>

using namespace FilterChecks;

namespace
{
/// Coarse: some hundred hexes in a fraction of a second.
vtkSmartPointer<vtkFeatureHexMesher> CoarseMesher(vtkPolyData* surface)
{
  auto mesher = vtkSmartPointer<vtkFeatureHexMesher>::New();
  mesher->SetInputDataObject(0, surface);
  mesher->SetTargetEdgeLength(0.17);
  mesher->SetTolerance(0.02);
  return mesher;
}

vtkUnstructuredGrid* MeshOf(vtkAlgorithm* mesher)
{
  return vtkUnstructuredGrid::SafeDownCast(mesher->GetOutputDataObject(0));
}
vtkSmartPointer<vtkPolyData> Cube()
{
  vtkNew<vtkCubeSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkFeatureHexMesher> CubeMesher()
{
  auto mesher = CoarseMesher(Cube());
  mesher->SetTargetEdgeLength(0.25);
  return mesher;
}

/// The 12 edges of Cube() as lines between points of their own.
vtkSmartPointer<vtkPolyData> EdgesOfCube()
{
  auto lines = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (int k = 0; k < 4; ++k)
    {
      double p[3];
      p[axis] = -0.5;
      p[(axis + 1) % 3] = k % 2 - 0.5;
      p[(axis + 2) % 3] = k / 2 - 0.5;
      const vtkIdType a = points->InsertNextPoint(p);
      p[axis] = 0.5;
      cells->InsertNextCell({ a, points->InsertNextPoint(p) });
    }
  }
  lines->SetPoints(points);
  lines->SetLines(cells);
  return lines;
}

double TableFigure(vtkAlgorithm* algorithm, int port, const char* column)
{
  return vtkTable::SafeDownCast(algorithm->GetOutputDataObject(port))
    ->GetValueByName(0, column)
    .ToDouble();
}

void ExpectCubeCaptured(vtkAlgorithm* algorithm, int port)
{
  EXPECT_EQ(TableFigure(algorithm, port, "FeaturesCaptured"), 1.0);
  EXPECT_EQ(TableFigure(algorithm, port, "CornersCaptured"), 8.0);
  EXPECT_EQ(TableFigure(algorithm, port, "CurvesCaptured"), 12.0);
  EXPECT_EQ(TableFigure(algorithm, port, "PatchesCaptured"), 6.0);
  EXPECT_LE(TableFigure(algorithm, port, "CornerDeviationMaximum"), 1e-9);
  EXPECT_LE(TableFigure(algorithm, port, "CurveVertexDeviationMaximum"), 1e-6);
}
} // namespace

TEST(FeatureHexMesher, SphereIsValidAndComplete)
{
  auto mesher = CoarseMesher(Sphere());
  Messages messages(mesher);
  mesher->Update();
  ASSERT_TRUE(messages.Errors.empty()) << messages.Errors[0];
  EXPECT_TRUE(messages.Warnings.empty()) << messages.Warnings[0];
  vtkUnstructuredGrid* mesh = MeshOf(mesher);
  EXPECT_GT(mesh->GetNumberOfCells(), 50);
  EXPECT_LT(mesh->GetNumberOfCells(), 2000);
  EXPECT_TRUE(mesh->IsHomogeneous());
  EXPECT_EQ(mesh->GetCellType(0), VTK_HEXAHEDRON);
  EXPECT_EQ(ArrayList(mesh->GetCellData()),
    (std::vector<std::string>{ "Region", "Level", "ScaledJacobian" }));
  EXPECT_EQ(mesh->GetCellData()->GetArray("Region")->GetRange()[0], 1.0);
  EXPECT_EQ(mesh->GetCellData()->GetArray("Region")->GetRange()[1], 1.0);
  EXPECT_EQ(mesh->GetCellData()->GetArray("ScaledJacobian")->GetRange()[0],
    Figure(mesh, "MinimumScaledJacobian"));
  EXPECT_GT(Figure(mesh, "MinimumScaledJacobian"), 0.3);
  EXPECT_EQ(Figure(mesh, "Valid"), 1.0);
  EXPECT_LE(Figure(mesh, "HausdorffUpper"), 0.02);

  auto* boundary = vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(1));
  EXPECT_EQ(boundary->GetNumberOfCells(), Figure(mesh, "NumberOfBoundaryQuads"));
  EXPECT_EQ(boundary->GetNumberOfPoints(), boundary->GetNumberOfCells() + 2); // genus 0
  EXPECT_EQ(
    ArrayList(boundary->GetCellData()), (std::vector<std::string>{ "PatchId", "Deviation" }));
  EXPECT_LE(
    boundary->GetCellData()->GetArray("Deviation")->GetRange()[1], 0.02 * Figure(mesh, "Diagonal"));

  EXPECT_TRUE(IsEmpty(mesher->GetOutputDataObject(2)));
  auto* table = vtkTable::SafeDownCast(mesher->GetOutputDataObject(3));
  ASSERT_EQ(table->GetNumberOfRows(), 1);
  EXPECT_EQ(table->GetValueByName(0, "NumberOfHexes").ToDouble(), mesh->GetNumberOfCells());
  for (const char* column : { "Rounds", "RoundReasons", "SecondsFitting", "SecondsSurfaceCheck",
         "SecondsTotal", "PeakMemoryMiB", "Version", "OptionTolerance", "TargetEdgeLength" })
  {
    EXPECT_NE(table->GetColumnByName(column), nullptr) << column;
  }
  std::set<std::string> unique;
  for (const std::string& name : ArrayList(table->GetRowData()))
  {
    EXPECT_TRUE(unique.insert(name).second) << name;
  }
}

TEST(FeatureHexMesher, GoodCitizen)
{
  ExpectGoodCitizen(CoarseMesher(Sphere()));
}

TEST(FeatureHexMesher, StripsPolygonsAndReversedTrianglesGiveAValidTorus)
{
  const vtkSmartPointer<vtkPolyData> quads = Torus();
  vtkNew<vtkTriangleFilter> triangles;
  triangles->SetInputDataObject(quads);
  vtkNew<vtkStripper> strips;
  strips->SetInputConnection(triangles->GetOutputPort());
  vtkNew<vtkReverseSense> reversed;
  reversed->SetInputConnection(triangles->GetOutputPort());
  strips->Update();
  reversed->Update();
  for (vtkPolyData* surface : { quads.GetPointer(), strips->GetOutput(), reversed->GetOutput() })
  {
    auto mesher = CoarseMesher(surface);
    mesher->SetTargetEdgeLength(0.25);
    Messages messages(mesher);
    mesher->Update();
    ASSERT_TRUE(messages.Errors.empty()) << messages.Errors[0];
    EXPECT_EQ(Figure(MeshOf(mesher), "Valid"), 1.0);
    EXPECT_EQ(Figure(MeshOf(mesher), "EulerCharacteristic"), 0.0);
  }
}

TEST(FeatureHexMesher, PatchIdIsTheComponent)
{
  vtkNew<vtkAppendPolyData> both;
  both->AddInputDataObject(Sphere(1.5));
  both->AddInputDataObject(Sphere(0.0));
  both->Update();
  auto mesher = CoarseMesher(both->GetOutput());
  mesher->Update();
  EXPECT_EQ(Figure(MeshOf(mesher), "Bodies"), 2.0);
  EXPECT_EQ(MeshOf(mesher)->GetCellData()->GetArray("Region")->GetRange()[1], 2.0);
  EXPECT_EQ(MeshOf(mesher)->GetPointData()->GetArray("FeatureKind")->GetRange()[1], 1.0);
  EXPECT_EQ(MeshOf(mesher)->GetPointData()->GetArray("FeatureId")->GetRange()[1], 1.0);
  auto* boundary = vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(1));
  for (vtkIdType c = 0; c < boundary->GetNumberOfCells(); ++c)
  {
    double bounds[6];
    boundary->GetCellBounds(c, bounds);
    EXPECT_EQ(
      boundary->GetCellData()->GetArray("PatchId")->GetComponent(c, 0), bounds[0] > 0.7 ? 0 : 1);
  }
}

TEST(FeatureHexMesher, OneErrorForBadInput)
{
  vtkNew<vtkPolyData> empty;
  ExpectFailure(CoarseMesher(empty), "no points");
  ExpectFailure(CoarseMesher(OpenSphere()), "edges");
  ExpectFailure(CoarseMesher(WithNaN(Sphere().GetPointer())), "finite");
  vtkNew<vtkFeatureHexMesher> mesher;
  ExpectTypeErrors(mesher);
}

TEST(FeatureHexMesher, OneErrorForLimits)
{
  auto mesher = CoarseMesher(Sphere());
  mesher->SetMaximumNumberOfCells(10);
  ExpectFailure(mesher, "MaximumNumberOfCells");
  mesher->SetMaximumNumberOfCells(20000000);
  mesher->SetTimeLimit(1e-3);
  ExpectFailure(mesher, "TimeLimit");
  mesher->SetTimeLimit(0);
  mesher->Update();
  EXPECT_FALSE(IsEmpty(mesher->GetOutputDataObject(0)));
}

TEST(FeatureHexMesher, AbortsWithinASecondInEachPhase)
{
  auto mesher = CoarseMesher(Sphere());
  mesher->SetTargetEdgeLength(0.06);
  struct Stopper
  {
    double At;
    std::chrono::steady_clock::time_point Time;
  };
  for (double at : { 0.03, 0.2, 0.5 })
  {
    mesher->Modified();
    Stopper stopper{ at, {} };
    vtkNew<vtkCallbackCommand> stop;
    stop->SetClientData(&stopper);
    stop->SetCallback(
      [](vtkObject* caller, unsigned long, void* data, void*)
      {
        auto* self = static_cast<Stopper*>(data);
        auto* algorithm = static_cast<vtkAlgorithm*>(caller);
        if (algorithm->GetProgress() >= self->At && !algorithm->GetAbortExecute())
        {
          self->Time = std::chrono::steady_clock::now();
          algorithm->SetAbortExecute(1);
        }
      });
    const unsigned long tag = mesher->AddObserver(vtkCommand::ProgressEvent, stop);
    Messages messages(mesher);
    mesher->Update();
    mesher->RemoveObserver(tag);
    ASSERT_NE(stopper.Time, std::chrono::steady_clock::time_point()) << at;
    EXPECT_LT(std::chrono::steady_clock::now() - stopper.Time, std::chrono::seconds(1));
    EXPECT_TRUE(IsEmpty(mesher->GetOutputDataObject(0)));
    EXPECT_TRUE(messages.Errors.empty()) << messages.Errors[0];
    mesher->SetAbortExecute(0);
  }
}

TEST(FeatureHexMesher, FeaturesOfACubeByAnnotation)
{
  auto mesher = CubeMesher();
  mesher->SetInputDataObject(1, EdgesOfCube());
  Messages messages(mesher);
  mesher->Update();
  ASSERT_TRUE(messages.Errors.empty()) << messages.Errors[0];
  EXPECT_TRUE(messages.Warnings.empty()) << messages.Warnings[0];
  ExpectCubeCaptured(mesher, 3);

  // Labels: 8 corners, on their places.
  vtkUnstructuredGrid* mesh = MeshOf(mesher);
  vtkDataArray* kind = mesh->GetPointData()->GetArray("FeatureKind");
  vtkDataArray* id = mesh->GetPointData()->GetArray("FeatureId");
  ASSERT_NE(kind, nullptr);
  ASSERT_NE(id, nullptr);
  std::set<double> corners, curves, patches;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    double x[3];
    mesh->GetPoint(p, x);
    int planes = 0;
    for (double value : x)
    {
      planes += std::abs(value) > 0.5 - 1e-9;
    }
    if (kind->GetComponent(p, 0) >= 2)
    {
      EXPECT_EQ(kind->GetComponent(p, 0), planes);
      (planes == 3 ? corners : curves).insert(id->GetComponent(p, 0));
    }
    else if (kind->GetComponent(p, 0) == 1)
    {
      patches.insert(id->GetComponent(p, 0));
    }
    else
    {
      EXPECT_EQ(id->GetComponent(p, 0), -1);
    }
  }
  EXPECT_EQ(corners.size(), 8u);
  EXPECT_EQ(curves.size(), 12u);
  EXPECT_EQ(patches.size(), 6u);

  auto* boundary = vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(1));
  EXPECT_EQ(boundary->GetCellData()->GetArray("PatchId")->GetRange()[1], 5.0);
  auto* features = vtkPolyData::SafeDownCast(mesher->GetOutputDataObject(2));
  EXPECT_EQ(features->GetNumberOfVerts(), 8);
  EXPECT_EQ(features->GetNumberOfLines(), 12);
  EXPECT_EQ(ArrayList(features->GetCellData()),
    (std::vector<std::string>{ "CornerId", "CurveId", "Captured", "Deviation" }));
  EXPECT_EQ(features->GetCellData()->GetArray("Captured")->GetRange()[0], 1.0);
  vtkDataArray* meshPoint = features->GetPointData()->GetArray("MeshPointId");
  for (vtkIdType p = 0; p < features->GetNumberOfPoints(); ++p)
  {
    double x[3], y[3];
    features->GetPoint(p, x);
    mesh->GetPoint(static_cast<vtkIdType>(meshPoint->GetComponent(p, 0)), y);
    EXPECT_TRUE(std::equal(x, x + 3, y));
  }
  auto* findings = vtkTable::SafeDownCast(mesher->GetOutputDataObject(4));
  ASSERT_EQ(findings->GetNumberOfRows(), 8 + 12 + 6);
  EXPECT_EQ(findings->GetValueByName(8, "Kind").ToString(), "curve");
  EXPECT_EQ(findings->GetValueByName(8, "Outcome").ToString(), "Captured");
}

TEST(FeatureHexMesher, FeaturesByAngleAndNone)
{
  auto given = CubeMesher();
  given->SetInputDataObject(1, EdgesOfCube());
  given->Update();
  auto found = CubeMesher();
  found->SetFeatureModeToAngle();
  found->Update();
  ExpectSameData(given->GetOutputDataObject(0), found->GetOutputDataObject(0));
  ExpectSameData(given->GetOutputDataObject(2), found->GetOutputDataObject(2));

  given->SetFeatureModeToNone();
  given->Update();
  EXPECT_TRUE(IsEmpty(given->GetOutputDataObject(2)));
  EXPECT_EQ(MeshOf(given)->GetPointData()->GetArray("FeatureKind")->GetRange()[1], 1.0);
  EXPECT_FALSE(MeshOf(given)->GetFieldData()->HasArray("FeaturesCaptured"));
}

TEST(FeatureHexMesher, FeaturesSurviveFiles)
{
  auto mesher = CubeMesher();
  mesher->SetInputDataObject(1, EdgesOfCube());
  mesher->Update();
  vtkUnstructuredGrid* mesh = MeshOf(mesher);
  for (const char* extension : { ".vtu", ".vtk", ".mesh" })
  {
    const std::string path = ::testing::TempDir() + "featurehex-cube" + extension;
    vtkNew<vtkHexMeshWriter> writer;
    writer->SetInputDataObject(mesh);
    writer->SetFileName(path.c_str());
    ASSERT_EQ(writer->Write(), 1);
    vtkNew<vtkHexMeshReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    std::remove(path.c_str());
    vtkUnstructuredGrid* read = reader->GetOutput();
    ASSERT_EQ(read->GetNumberOfPoints(), mesh->GetNumberOfPoints());
    for (const char* name : { "FeatureKind", "FeatureId" })
    {
      vtkDataArray* before = mesh->GetPointData()->GetArray(name);
      vtkDataArray* after = read->GetPointData()->GetArray(name);
      ASSERT_NE(after, nullptr) << name << extension;
      for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
      {
        ASSERT_EQ(before->GetComponent(p, 0), after->GetComponent(p, 0)) << name << extension;
      }
    }
    vtkNew<vtkHexValidationFilter> validation;
    validation->SetInputDataObject(0, read);
    validation->SetInputDataObject(1, Cube());
    validation->SetInputDataObject(2, EdgesOfCube());
    validation->SetTolerance(0.02);
    validation->Update();
    ExpectCubeCaptured(validation, 1);
    EXPECT_EQ(vtkTable::SafeDownCast(validation->GetOutput(3))->GetNumberOfRows(), 26);
  }
}

TEST(FeatureHexMesher, AnnotationsThatCanNotBeUsed)
{
  // Cells that are neither lines nor vertices.
  auto mesher = CoarseMesher(Sphere());
  mesher->SetInputDataObject(1, Sphere());
  Messages messages(mesher);
  mesher->Update();
  EXPECT_TRUE(messages.Errors.empty());
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_NE(messages.Warnings[0].find("ignored"), std::string::npos);
  EXPECT_FALSE(IsEmpty(mesher->GetOutputDataObject(0)));
  // Lines of another surface.
  mesher->SetInputDataObject(1, EdgesOfCube());
  ExpectFailure(mesher, "no point of the surface");
}

TEST(FeatureHexMesher, EdgeLengthsOfAPointArray)
{
  vtkNew<vtkPolyData> surface;
  surface->DeepCopy(Sphere());
  vtkNew<vtkFloatArray> lengths;
  lengths->SetName("Size");
  for (vtkIdType p = 0; p < surface->GetNumberOfPoints(); ++p)
  {
    lengths->InsertNextValue(surface->GetPoint(p)[0] > 0 ? 0.1f : 0.0f);
  }
  surface->GetPointData()->AddArray(lengths);
  auto mesher = CoarseMesher(surface);
  mesher->Update();
  const vtkIdType hexes = MeshOf(mesher)->GetNumberOfCells();
  for (const char* none : { "", "None" })
  {
    mesher->SetEdgeLengthArray(none);
    mesher->Update();
    EXPECT_EQ(MeshOf(mesher)->GetNumberOfCells(), hexes);
  }
  mesher->SetEdgeLengthArray("Size");
  mesher->Update();
  EXPECT_GT(MeshOf(mesher)->GetNumberOfCells(), 1.5 * hexes);
  EXPECT_GT(MeshOf(mesher)->GetCellData()->GetArray("Level")->GetRange()[1], 0);
  mesher->SetEdgeLengthArray("Sizes");
  ExpectFailure(mesher, "no point array \"Sizes\"");
}

TEST(FeatureHexMesher, OptionsAreClampedAndPrinted)
{
  vtkNew<vtkFeatureHexMesher> mesher;
  mesher->SetTolerance(7);
  EXPECT_EQ(mesher->GetTolerance(), 0.1);
  mesher->SetMaximumLevel(-1);
  EXPECT_EQ(mesher->GetMaximumLevel(), 0);
  mesher->SetTimeLimit(-1);
  EXPECT_EQ(mesher->GetTimeLimit(), 0.0);
  std::ostringstream text;
  mesher->Print(text);
  EXPECT_NE(text.str().find("MaximumRounds: 12"), std::string::npos);
}

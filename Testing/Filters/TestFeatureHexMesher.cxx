// SPDX-License-Identifier: BSD-3-Clause
#include "FilterChecks.h"

#include "vtkAppendPolyData.h"
#include "vtkFeatureHexMesher.h"
#include "vtkReverseSense.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"

#include <chrono>
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

TEST(FeatureHexMesher, AnnotationWarnsThatItIsNotUsed)
{
  auto mesher = CoarseMesher(Sphere());
  mesher->SetInputDataObject(1, Sphere());
  Messages messages(mesher);
  mesher->Update();
  EXPECT_TRUE(messages.Errors.empty());
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_NE(messages.Warnings[0].find("not used"), std::string::npos);
  EXPECT_FALSE(IsEmpty(mesher->GetOutputDataObject(0)));
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

// SPDX-License-Identifier: BSD-3-Clause
#include "FilterChain.h"

#include "vtkFeatureGraphReader.h"
#include "vtkFeatureGraphWriter.h"

#include "vtkAppendPolyData.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkIdTypeArray.h"
#include "vtkReverseSense.h"

#include <filesystem>

using namespace FilterChecks;

namespace
{
/// Unit cube around the origin; each corner is three points.
vtkSmartPointer<vtkPolyData> Cube()
{
  vtkNew<vtkCubeSource> source;
  source->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  source->Update();
  return source->GetOutput();
}

vtkPolyData* GraphOf(vtkSurfaceFeatureFilter* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutput(1));
}

/// Lines and vertices in single precision, as an extracted selection is one.
vtkSmartPointer<vtkUnstructuredGrid> Selection(
  const std::vector<std::vector<std::array<double, 3>>>& cells)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToFloat();
  grid->SetPoints(points);
  for (const auto& cell : cells)
  {
    vtkNew<vtkIdList> ids;
    for (const auto& p : cell)
    {
      ids->InsertNextId(points->InsertNextPoint(p.data()));
    }
    grid->InsertNextCell(cell.size() == 1   ? VTK_VERTEX
                         : cell.size() == 2 ? VTK_LINE
                                            : VTK_POLY_LINE,
      ids);
  }
  return grid;
}

/// Corners, curves and patches.
std::array<double, 3> Counts(vtkSurfaceFeatureFilter* filter)
{
  filter->Update();
  vtkDataObject* surface = filter->GetOutput();
  EXPECT_EQ(Figure(surface, "NumberOfCorners"), GraphOf(filter)->GetNumberOfVerts());
  EXPECT_EQ(Figure(surface, "NumberOfCurves"), GraphOf(filter)->GetNumberOfLines());
  return { Figure(surface, "NumberOfCorners"), Figure(surface, "NumberOfCurves"),
    Figure(surface, "NumberOfPatches") };
}

using Three = std::array<double, 3>;
} // namespace

TEST(SurfaceFeatureFilter, ComponentsAndCavities)
{
  vtkNew<vtkSphereSource> hole;
  hole->SetRadius(0.2);
  hole->SetThetaResolution(16);
  hole->SetPhiResolution(16);
  vtkNew<vtkAppendPolyData> bodies;
  bodies->AddInputDataObject(Sphere(2.0));
  bodies->AddInputDataObject(Sphere(0.0));
  bodies->AddInputConnection(hole->GetOutputPort());
  vtkNew<vtkSurfaceFeatureFilter> filter;
  filter->SetInputConnection(bodies->GetOutputPort());
  Messages messages(filter);
  filter->Update();
  ASSERT_TRUE(messages.Errors.empty()) << messages.Errors[0];
  ASSERT_EQ(messages.Warnings.size(), 1u); // the hole was oriented outward
  EXPECT_NE(messages.Warnings[0].find("repaired"), std::string::npos);
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutput());
  EXPECT_EQ(Figure(output, "NumberOfComponents"), 3.0);
  EXPECT_EQ(Figure(output, "NumberOfCavities"), 1.0);
  EXPECT_EQ(Figure(output, "Genus"), 0.0);
  EXPECT_GT(Figure(output, "ReorientedTriangles"), 0.0);
  vtkDataArray* patch = output->GetCellData()->GetArray("PatchId");
  ASSERT_NE(patch, nullptr);
  EXPECT_EQ(patch->GetNumberOfTuples(), output->GetNumberOfCells());
  EXPECT_EQ(patch->GetRange()[0], 0.0);
  EXPECT_EQ(patch->GetRange()[1], 2.0);
  EXPECT_TRUE(IsEmpty(filter->GetOutput(1)));
}

TEST(SurfaceFeatureFilter, PolygonsBecomeTriangles)
{
  vtkNew<vtkSurfaceFeatureFilter> filter;
  const auto torus = Torus();
  filter->SetInputDataObject(0, torus);
  filter->Update();
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutput());
  EXPECT_EQ(output->GetNumberOfCells(), 2 * torus->GetNumberOfCells());
  EXPECT_EQ(output->GetMaxCellSize(), 3);
  EXPECT_EQ(Figure(output, "Genus"), 1.0);
}

TEST(SurfaceFeatureFilter, GoodCitizen)
{
  vtkNew<vtkSurfaceFeatureFilter> filter;
  filter->SetInputDataObject(0, Sphere());
  ExpectGoodCitizen(filter);
}

TEST(SurfaceFeatureFilter, OneErrorForBadInput)
{
  vtkNew<vtkSurfaceFeatureFilter> filter;
  ExpectSurfaceErrors(filter, 0);
  auto range = Sphere();
  const vtkIdType triangle[3] = { 0, 1, 100000 };
  range->GetPolys()->InsertNextCell(3, triangle);
  filter->SetInputDataObject(0, range);
  ExpectFailure(filter, "100000");
  ExpectTypeErrors(filter);
}

TEST(SurfaceFeatureFilter, FeaturesByAngle)
{
  vtkNew<vtkSurfaceFeatureFilter> filter;
  filter->SetInputDataObject(0, Cube());
  EXPECT_EQ(Counts(filter), (Three{ 8, 12, 6 }));
  auto* surface = vtkPolyData::SafeDownCast(filter->GetOutput());
  EXPECT_EQ(surface->GetCellData()->GetArray("PatchId")->GetRange()[1], 5.0);
  EXPECT_EQ(surface->GetCellData()->GetArray("ComponentId")->GetRange()[1], 0.0);
  vtkPolyData* graph = GraphOf(filter);
  ASSERT_EQ(graph->GetNumberOfPoints(), 8);
  vtkDataArray* corners = graph->GetCellData()->GetArray("CornerId");
  vtkDataArray* curves = graph->GetCellData()->GetArray("CurveId");
  for (vtkIdType c = 0; c < 20; ++c)
  {
    EXPECT_EQ(corners->GetComponent(c, 0), c < 8 ? c : -1);
    EXPECT_EQ(curves->GetComponent(c, 0), c < 8 ? -1 : c - 8);
  }
  EXPECT_EQ(graph->GetCellData()->GetArray("FeatureValid")->GetRange()[0], 1.0);
  vtkDataArray* ids = graph->GetPointData()->GetArray("SurfacePointId");
  for (vtkIdType p = 0; p < 8; ++p)
  {
    double there[3];
    surface->GetPoint(static_cast<vtkIdType>(ids->GetComponent(p, 0)), there);
    EXPECT_EQ(there[0], graph->GetPoint(p)[0]);
    EXPECT_EQ(there[2], graph->GetPoint(p)[2]);
  }
  filter->SetFeatureAngle(80);
  EXPECT_EQ(Counts(filter), (Three{ 0, 0, 1 }));
  EXPECT_TRUE(IsEmpty(graph));
  filter->SetFeatureAngle(140);
  filter->PreserveFeaturesOff();
  EXPECT_EQ(Counts(filter), (Three{ 0, 0, 1 }));
}

TEST(SurfaceFeatureFilter, GoodCitizenWithFeatures)
{
  vtkNew<vtkSurfaceFeatureFilter> filter;
  filter->SetInputDataObject(0, Cube());
  filter->SetInputDataObject(1, Selection({ { { -0.5, -0.5, -0.5 }, { 0.5, -0.5, -0.5 } } }));
  filter->SetAnnotationModeToAdd();
  ExpectGoodCitizen(filter);
}

TEST(SurfaceFeatureFilter, GraphSurvivesFilesAndItself)
{
  vtkNew<vtkSurfaceFeatureFilter> filter;
  filter->SetInputDataObject(0, Cube());
  filter->Update();
  const auto graph = Result<vtkPolyData>(filter, 1);
  const auto surface = Result<vtkPolyData>(filter, 0);

  vtkNew<vtkSurfaceFeatureFilter> again;
  again->SetInputDataObject(0, surface);
  again->SetInputDataObject(1, graph);
  again->Update();
  ExpectSameData(again->GetOutput(1), graph);
  // Ids of the repaired surface, but the surface as it was: the coordinates say more.
  again->SetInputDataObject(0, Cube());
  again->Update();
  ExpectSameData(again->GetOutput(1), graph);

  const std::string name =
    (std::filesystem::temp_directory_path() / "TestSurfaceFeatureFilter.fgraph").string();
  vtkNew<vtkFeatureGraphWriter> writer;
  writer->SetInputDataObject(graph);
  writer->SetFileName(name.c_str());
  ASSERT_EQ(writer->Write(), 1);
  vtkNew<vtkFeatureGraphReader> reader;
  reader->SetInputDataObject(surface);
  reader->SetFileName(name.c_str());
  again->SetInputDataObject(0, surface);
  again->SetInputConnection(1, reader->GetOutputPort());
  again->Update();
  ExpectSameData(again->GetOutput(1), graph);
  // Without coordinates.
  vtkNew<vtkFeatureGraphReader> alone;
  alone->SetFileName(name.c_str());
  again->SetInputConnection(1, alone->GetOutputPort());
  again->Update();
  ExpectSameData(again->GetOutput(1), graph);
  std::filesystem::remove(name);
}

TEST(SurfaceFeatureFilter, AnnotationReplacesAddsAndRemoves)
{
  vtkNew<vtkSurfaceFeatureFilter> filter;
  filter->SetInputDataObject(0, Cube());
  const std::array<double, 3> a = { -0.5, -0.5, -0.5 }, b = { 0.5, -0.5, -0.5 };
  const std::array<double, 3> c = { 0.5, 0.5, -0.5 }, d = { -0.5, 0.5, -0.5 };
  filter->SetInputDataObject(1, Selection({ { a, b, c, d, a } }));
  EXPECT_EQ(Counts(filter), (Three{ 4, 4, 2 }));
  filter->SetAnnotationModeToAdd();
  EXPECT_EQ(Counts(filter), (Three{ 8, 12, 6 }));
  filter->SetAnnotationModeToRemove();
  EXPECT_EQ(Counts(filter), (Three{ 8, 8, 2 })); // five faces are one

  // One edge less: two faces are one. Its ends are kinks, until they aren't.
  filter->SetInputDataObject(1, Selection({ { a, b } }));
  EXPECT_EQ(Counts(filter), (Three{ 8, 11, 5 }));
  filter->SetInputDataObject(1, Selection({ { a, b }, { a }, { b } }));
  EXPECT_EQ(Counts(filter), (Three{ 6, 9, 5 }));
  // Where three curves meet is a corner anyhow.
  filter->SetInputDataObject(1, Selection({ { a } }));
  EXPECT_EQ(Counts(filter), (Three{ 8, 12, 6 }));

  // No lines: no features, or nothing to change.
  vtkNew<vtkPolyData> nothing;
  filter->SetInputDataObject(1, nothing);
  EXPECT_EQ(Counts(filter), (Three{ 8, 12, 6 }));
  filter->SetAnnotationModeToReplace();
  EXPECT_EQ(Counts(filter), (Three{ 0, 0, 1 }));
  // The gap of a loop.
  filter->SetInputDataObject(1, Selection({ { a, b, c, d } }));
  EXPECT_EQ(Counts(filter), (Three{ 4, 3, 1 }));
}

TEST(SurfaceFeatureFilter, AnnotationThatDoesNotFit)
{
  vtkNew<vtkSurfaceFeatureFilter> filter;
  filter->SetInputDataObject(0, Cube());
  filter->SetInputDataObject(1, Selection({ { { -0.5, -0.5, -0.5 }, { 0.5, -0.5, -0.4 } } }));
  ExpectFailure(filter, "Point 1 of the features, at (0.5, -0.5, -0.400000");
  filter->SetInputDataObject(1, Selection({ { { -0.5, -0.5, -0.5 }, { 0.5, 0.5, 0.5 } } }));
  ExpectFailure(filter, "1 feature edge is not in the surface");
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  filter->SetInputDataObject(1, image);
  ExpectOneError(filter, "is of type vtkImageData");
}

TEST(SurfaceFeatureFilter, CornersThatAreNotEnforced)
{
  vtkNew<vtkConeSource> cone;
  cone->SetResolution(8);
  cone->SetHeight(3);
  cone->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  vtkNew<vtkSurfaceFeatureFilter> filter;
  filter->SetInputConnection(0, cone->GetOutputPort());
  Messages messages(filter);
  EXPECT_EQ(Counts(filter), (Three{ 9, 16, 9 }));
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_NE(messages.Warnings[0].find("more than six curves meet"), std::string::npos);
  EXPECT_EQ(Figure(filter->GetOutput(), "InvalidCorners"), 1.0);
  vtkDataArray* valid = GraphOf(filter)->GetCellData()->GetArray("FeatureValid");
  double sum = 0;
  for (vtkIdType c = 0; c < valid->GetNumberOfTuples(); ++c)
  {
    sum += valid->GetComponent(c, 0);
  }
  EXPECT_EQ(sum, 24.0);
  filter->EnforceAllFeaturesOn();
  EXPECT_EQ(Counts(filter), (Three{ 9, 16, 9 }));
  EXPECT_EQ(messages.Warnings.size(), 1u);
  EXPECT_EQ(Figure(filter->GetOutput(), "InvalidCorners"), 0.0);
}

TEST(SurfaceFeatureFilter, AnnotationOfTrianglesWarns)
{
  vtkNew<vtkSurfaceFeatureFilter> filter;
  filter->SetInputDataObject(0, Sphere());
  filter->SetInputDataObject(1, Sphere());
  Messages messages(filter);
  filter->Update();
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_NE(messages.Warnings[0].find("neither lines nor vertices"), std::string::npos);
  EXPECT_FALSE(IsEmpty(filter->GetOutput()));
}

// SPDX-License-Identifier: BSD-3-Clause
#include "FilterChain.h"

#include "vtkAppendPolyData.h"
#include "vtkReverseSense.h"

using namespace FilterChecks;

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

TEST(SurfaceFeatureFilter, AnnotationWarns)
{
  vtkNew<vtkSurfaceFeatureFilter> filter;
  filter->SetInputDataObject(0, Sphere());
  filter->SetInputDataObject(1, Sphere());
  Messages messages(filter);
  filter->Update();
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_FALSE(IsEmpty(filter->GetOutput()));
}

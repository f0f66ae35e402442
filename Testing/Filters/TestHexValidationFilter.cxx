// SPDX-License-Identifier: BSD-3-Clause
#include "FilterChain.h"

using namespace FilterChecks;

TEST(HexValidationFilter, GoodMesh)
{
  vtkNew<vtkHexValidationFilter> filter;
  filter->SetInputDataObject(0, TwoHexes());
  filter->Update();
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(filter->GetOutput());
  EXPECT_EQ(ArrayList(mesh->GetCellData()),
    (std::vector<std::string>{ "ScaledJacobian", "Certified", "Defects" }));
  EXPECT_EQ(mesh->GetCellData()->GetArray("ScaledJacobian")->GetComponent(1, 0), 1.0);
  EXPECT_EQ(mesh->GetCellData()->GetArray("Certified")->GetComponent(1, 0), 1.0);
  EXPECT_EQ(Figure(mesh, "Valid"), 1.0);
  auto* table = vtkTable::SafeDownCast(filter->GetOutput(1));
  ASSERT_EQ(table->GetNumberOfRows(), 1);
  EXPECT_EQ(table->GetValueByName(0, "NumberOfHexes").ToInt(), 2);
  EXPECT_EQ(table->GetValueByName(0, "Verdict").ToString(), "valid");
  EXPECT_TRUE(IsEmpty(filter->GetOutput(2)));
}

TEST(HexValidationFilter, OffendingHexesHaveReasons)
{
  vtkNew<vtkHexValidationFilter> filter;
  filter->SetInputDataObject(0, TwoHexes(true));
  Messages messages(filter);
  filter->Update();
  EXPECT_TRUE(messages.Errors.empty());
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(filter->GetOutput());
  EXPECT_EQ(Figure(mesh, "Valid"), 0.0);
  EXPECT_EQ(mesh->GetCellData()->GetArray("Certified")->GetComponent(0, 0), 1.0);
  EXPECT_EQ(mesh->GetCellData()->GetArray("Certified")->GetComponent(1, 0), 0.0);
  auto* offending = vtkUnstructuredGrid::SafeDownCast(filter->GetOutput(2));
  ASSERT_GE(offending->GetNumberOfCells(), 1);
  const vtkIdType last = offending->GetNumberOfCells() - 1;
  EXPECT_EQ(offending->GetCellData()->GetArray("OriginalCellId")->GetComponent(last, 0), 1.0);
  EXPECT_NE(
    offending->GetCellData()->GetAbstractArray("Reason")->GetVariantValue(last).ToString().find(
      "NonPositiveCorner"),
    std::string::npos);
}

TEST(HexValidationFilter, NaNIsADefectNotAnError)
{
  vtkNew<vtkHexValidationFilter> filter;
  filter->SetInputDataObject(0, WithNaN(TwoHexes().GetPointer()));
  filter->Update();
  EXPECT_EQ(Figure(filter->GetOutput(), "Valid"), 0.0);
  EXPECT_EQ(Figure(filter->GetOutput(), "NonFinitePoints"), 1.0);
}

TEST(HexValidationFilter, FeaturesNeedSurfaceAndLabels)
{
  vtkNew<vtkPolyData> graph;
  vtkNew<vtkHexValidationFilter> filter;
  filter->SetInputDataObject(0, TwoHexes());
  filter->SetInputDataObject(2, graph);
  ExpectFailure(filter, "surface");
  filter->SetInputDataObject(1, Sphere());
  ExpectFailure(filter, "FeatureKind");
}

TEST(HexValidationFilter, GoodCitizen)
{
  Chain chain(Sphere());
  ExpectGoodCitizen(chain.Validation);
}

TEST(HexValidationFilter, OneErrorForBadInput)
{
  vtkNew<vtkHexValidationFilter> filter;
  ExpectMeshErrors(filter, false);
  filter->SetInputDataObject(0, TwoHexes());
  ExpectSurfaceErrors(filter, 1);
  ExpectTypeErrors(filter);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "FilterChain.h"

#include "vtkFeatureHexMesher.h"
#include "vtkHexQualityFilter.h"

using namespace FilterChecks;

namespace
{
/// A coarse ball, meshed.
vtkSmartPointer<vtkUnstructuredGrid> Ball()
{
  vtkNew<vtkFeatureHexMesher> mesher;
  mesher->SetInputDataObject(Sphere());
  mesher->SetTargetEdgeLength(0.3);
  mesher->SetTolerance(0.02);
  mesher->Update();
  return vtkUnstructuredGrid::SafeDownCast(mesher->GetOutputDataObject(0));
}

vtkTable* Table(vtkAlgorithm* filter, int port)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(port));
}

double Sum(vtkTable* table, const char* name)
{
  double sum = 0.0;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    sum += table->GetValueByName(row, name).ToDouble();
  }
  return sum;
}
} // namespace

TEST(HexQualityFilter, HistogramsCountAllAndWorstComeFirst)
{
  const auto ball = Ball();
  vtkNew<vtkHexQualityFilter> filter;
  filter->SetInputDataObject(0, ball);
  filter->SetInputDataObject(1, Sphere());
  filter->SetTolerance(0.02);
  filter->SetNumberOfBins(10);
  filter->SetNumberOfWorstHexes(7);
  filter->Update();

  vtkTable* quality = Table(filter, 0);
  ASSERT_EQ(quality->GetNumberOfRows(), 10);
  EXPECT_NEAR(quality->GetValueByName(0, "bin_extents").ToDouble(), 0.05, 1e-12);
  EXPECT_EQ(Sum(quality, "Hexes"), ball->GetNumberOfCells());

  auto* boundary = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(3));
  vtkTable* deviation = Table(filter, 1);
  EXPECT_EQ(deviation->GetNumberOfRows(), 10); // All within the tolerance.
  EXPECT_EQ(Sum(deviation, "Quads"), boundary->GetNumberOfCells());
  double range[2];
  boundary->GetCellData()->GetArray("DeviationOfTolerance")->GetRange(range);
  EXPECT_GT(range[0], 0.0);
  EXPECT_LE(range[1], 1.0);
  EXPECT_EQ(range[1], filter->GetLargestDeviation());
  EXPECT_LE(range[1] * 0.02, Figure(ball, "HausdorffUpper"));
  EXPECT_EQ(boundary->GetCellData()->GetScalars()->GetName(), std::string("DeviationOfTolerance"));

  auto* worst = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(2));
  ASSERT_EQ(worst->GetNumberOfCells(), 7);
  vtkDataArray* sorted = worst->GetCellData()->GetArray("ScaledJacobian");
  vtkDataArray* all = ball->GetCellData()->GetArray("ScaledJacobian");
  vtkDataArray* ids = worst->GetCellData()->GetArray("OriginalCellId");
  EXPECT_TRUE(worst->GetCellData()->HasArray("Region"));
  all->GetRange(range);
  EXPECT_EQ(sorted->GetComponent(0, 0), range[0]);
  EXPECT_EQ(filter->GetSmallestScaledJacobian(), range[0]);
  EXPECT_EQ(filter->GetMeanScaledJacobian(), Figure(ball, "MeanScaledJacobian"));
  for (vtkIdType i = 0; i < 7; ++i)
  {
    EXPECT_LE(sorted->GetComponent(std::max<vtkIdType>(0, i - 1), 0), sorted->GetComponent(i, 0));
    EXPECT_EQ(sorted->GetComponent(i, 0),
      all->GetComponent(static_cast<vtkIdType>(ids->GetComponent(i, 0)), 0));
  }
}

TEST(HexQualityFilter, InvertedHexesHaveBinsBelowZero)
{
  vtkNew<vtkHexQualityFilter> filter;
  filter->SetInputDataObject(0, TwoHexes(true));
  filter->Update();
  vtkTable* quality = Table(filter, 0);
  EXPECT_LT(quality->GetValueByName(0, "bin_extents").ToDouble(), 0.0);
  EXPECT_EQ(Sum(quality, "Hexes"), 2.0);
  EXPECT_LT(filter->GetSmallestScaledJacobian(), 0.0);
  // Without a surface there is no deviation.
  EXPECT_EQ(Table(filter, 1)->GetNumberOfRows(), 0);
  EXPECT_TRUE(IsEmpty(filter->GetOutputDataObject(3)));
  EXPECT_EQ(filter->GetLargestDeviation(), 0.0);
}

TEST(HexQualityFilter, GoodCitizen)
{
  vtkNew<vtkHexQualityFilter> filter;
  filter->SetInputDataObject(0, Ball());
  filter->SetInputDataObject(1, Sphere());
  ExpectGoodCitizen(filter);
}

TEST(HexQualityFilter, OneErrorForBadInput)
{
  vtkNew<vtkHexQualityFilter> filter;
  ExpectMeshErrors(filter, false);
  filter->SetInputDataObject(0, TwoHexes());
  ExpectSurfaceErrors(filter, 1);
  ExpectTypeErrors(filter);
}

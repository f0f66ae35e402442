// SPDX-License-Identifier: BSD-3-Clause
#include "FilterChain.h"
#include "HexFitting.h"
#include "HexImprovement.h"

using namespace FilterChecks;

TEST(HexFittingFilter, BoundaryLiesOnTheSurface)
{
  Chain chain(Sphere());
  chain.Fitting->Update();
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(chain.Fitting->GetOutput());
  EXPECT_EQ(Figure(mesh, "WithinTolerance"), 1.0);
  EXPECT_EQ(Figure(mesh, "Improved"), 1.0);
  EXPECT_EQ(Figure(mesh, "HexesBelowMinimum"), 0.0);
  EXPECT_TRUE(IsEmpty(chain.Fitting->GetOutput(1)));
  EXPECT_NE(mesh->GetCellData()->GetArray("Region"), nullptr);
}

TEST(HexFittingFilter, TooCoarseGivesRefinementPointsThatHelp)
{
  Chain chain(Torus(0.4), 0.4, 0.005);
  chain.Octree->SetThicknessSizing(false);
  vtkNew<vtkPolyData> points;
  chain.Octree->SetInputDataObject(2, points);
  chain.Fitting->Update();
  EXPECT_EQ(Figure(chain.Fitting->GetOutput(), "WithinTolerance"), 0.0);
  EXPECT_EQ(Figure(chain.Fitting->GetOutput(), "Improved"), 0.0);
  vtkNew<vtkPolyData> more;
  more->DeepCopy(chain.Fitting->GetOutput(1));
  ASSERT_GT(more->GetNumberOfPoints(), 0);
  EXPECT_EQ(ArrayList(more->GetPointData()), (std::vector<std::string>{ "Level", "Reason" }));
  EXPECT_EQ(more->GetPointData()->GetArray("Level")->GetRange()[1], 1.0);
  chain.Octree->AddInputDataObject(2, more);
  chain.Fitting->Update();
  auto* left = vtkPolyData::SafeDownCast(chain.Fitting->GetOutput(1));
  EXPECT_LT(left->GetNumberOfPoints(), more->GetNumberOfPoints());
}

TEST(HexFittingFilter, DefaultsAreThoseOfTheCore)
{
  vtkNew<vtkHexFittingFilter> filter;
  EXPECT_EQ(filter->GetTolerance(), featurehex::FittingOptions().Tolerance);
  EXPECT_EQ(filter->GetFittingIterations(), featurehex::FittingOptions().Iterations);
  EXPECT_EQ(
    filter->GetMinimumScaledJacobian(), featurehex::ImprovementOptions().MinimumScaledJacobian);
  EXPECT_EQ(filter->GetImprovementRounds(), featurehex::ImprovementOptions().MaximumRounds);
}

TEST(HexFittingFilter, GoodCitizen)
{
  Chain chain(Sphere());
  ExpectGoodCitizen(chain.Fitting);
}

TEST(HexFittingFilter, GoodCitizenWithFeatures)
{
  FeatureChain chain(DataSurface("rotation/cube_xyz_25.obj"));
  ExpectGoodCitizen(chain.Fitting);
}

TEST(HexFittingFilter, OneErrorForBadInput)
{
  vtkNew<vtkHexFittingFilter> filter;
  filter->SetInputDataObject(1, Sphere());
  filter->SetInputDataObject(0, TwoHexes(true));
  ExpectFailure(filter, "1 hexes are inverted");
  ExpectMeshErrors(filter);
  filter->SetInputDataObject(0, TwoHexes());
  ExpectSurfaceErrors(filter, 1);
  ExpectTypeErrors(filter, 1);
}

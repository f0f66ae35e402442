// SPDX-License-Identifier: BSD-3-Clause
#include "FilterChain.h"
#include "HexUntangling.h"

using namespace FilterChecks;

TEST(HexUntangleFilter, BothMethodsLeaveNoInvertedHex)
{
  Chain chain(Torus(), 0.2);
  chain.Padding->SetThickness(0.4);
  for (int method : { vtkHexUntangleFilter::REGULARIZED, vtkHexUntangleFilter::STITCHING })
  {
    chain.Untangle->SetMethod(method);
    chain.Untangle->Update();
    vtkNew<vtkHexValidationFilter> validation;
    validation->SetInputConnection(chain.Untangle->GetOutputPort());
    validation->Update();
    EXPECT_EQ(Figure(validation->GetOutput(), "PositiveCorners"), 1.0) << method;
    EXPECT_GE(Figure(validation->GetOutput(), "InvertedHexesBefore"), 0.0);
    auto* mesh = vtkUnstructuredGrid::SafeDownCast(chain.Untangle->GetOutput());
    EXPECT_NE(mesh->GetCellData()->GetArray("PaddingLayer"), nullptr);
  }
}

TEST(HexUntangleFilter, WithoutSurfaceTheBoundaryStays)
{
  Chain chain(Sphere());
  const auto padded = Result<vtkUnstructuredGrid>(chain.Padding);
  vtkNew<vtkHexUntangleFilter> filter;
  filter->SetInputDataObject(0, padded);
  filter->Update();
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(filter->GetOutput());
  double before[6], after[6];
  padded->GetBounds(before);
  mesh->GetBounds(after);
  for (int k = 0; k < 6; ++k)
  {
    EXPECT_EQ(before[k], after[k]);
  }
}

TEST(HexUntangleFilter, DefaultsAreThoseOfTheCore)
{
  vtkNew<vtkHexUntangleFilter> filter;
  const featurehex::UntangleOptions options;
  EXPECT_EQ(filter->GetMaximumSweeps(), options.MaximumSweeps);
  EXPECT_EQ(filter->GetMethod(), static_cast<int>(options.Method));
}

TEST(HexUntangleFilter, GoodCitizen)
{
  Chain chain(Sphere());
  ExpectGoodCitizen(chain.Untangle);
}

TEST(HexUntangleFilter, GoodCitizenWithFeatures)
{
  FeatureChain chain(DataSurface("rotation/cube_xyz_25.obj"));
  ExpectGoodCitizen(chain.Untangle);
}

TEST(HexUntangleFilter, OneErrorForBadInput)
{
  vtkNew<vtkHexUntangleFilter> filter;
  filter->SetInputDataObject(0, TwoHexes(true)); // all points on the boundary: nothing can move
  ExpectFailure(filter, "1 hexes stay inverted");
  filter->SetInputDataObject(0, TwoHexes());
  ExpectSurfaceErrors(filter, 1);
  filter->SetInputDataObject(1, nullptr);
  ExpectMeshErrors(filter);
  ExpectTypeErrors(filter);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "FilterChain.h"
#include "HexPadding.h"

using namespace FilterChecks;

TEST(HexPaddingFilter, OneQuadOfEachLayerHexIsBoundary)
{
  Chain chain(Torus(), 0.2);
  chain.Padding->Update();
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(chain.Padding->GetOutput());
  EXPECT_EQ(ArrayList(mesh->GetCellData()),
    (std::vector<std::string>{ "Level", "DualHexKind", "Region", "PaddingLayer" }));
  EXPECT_EQ(ArrayList(mesh->GetPointData()), (std::vector<std::string>{ "OctreeIndex" }));
  EXPECT_EQ(mesh->GetCellData()->GetArray("Region")->GetRange()[0], 1.0);
  double layer = 0;
  for (vtkIdType c = 0; c < mesh->GetNumberOfCells(); ++c)
  {
    layer += mesh->GetCellData()->GetArray("PaddingLayer")->GetComponent(c, 0);
  }
  vtkNew<vtkHexValidationFilter> validation;
  validation->SetInputConnection(chain.Padding->GetOutputPort());
  validation->Update();
  EXPECT_EQ(Figure(validation->GetOutput(), "PureConforming"), 1.0);
  EXPECT_EQ(Figure(validation->GetOutput(), "Manifold"), 1.0);
  EXPECT_EQ(Figure(validation->GetOutput(), "NumberOfBoundaryQuads"), layer);
}

TEST(HexPaddingFilter, DefaultsAreThoseOfTheCore)
{
  vtkNew<vtkHexPaddingFilter> filter;
  EXPECT_EQ(filter->GetThickness(), featurehex::PaddingOptions().Thickness);
}

TEST(HexPaddingFilter, GoodCitizen)
{
  Chain chain(Sphere());
  ExpectGoodCitizen(chain.Padding);
}

TEST(HexPaddingFilter, GoodCitizenWithFeatures)
{
  FeatureChain chain(DataSurface("rotation/cube_xyz_25.obj"));
  ExpectGoodCitizen(chain.Padding);
}

TEST(HexPaddingFilter, OneErrorForBadInput)
{
  Chain chain(Sphere());
  const auto domain = Result<vtkUnstructuredGrid>(chain.Domain);
  vtkNew<vtkHexPaddingFilter> filter;
  filter->SetInputDataObject(0, WithoutCellArray(domain, "Region"));
  ExpectFailure(filter, "Region");
  domain->GetCellData()->GetArray("Region")->Fill(0);
  filter->SetInputDataObject(0, domain);
  ExpectFailure(filter, "");
  ExpectMeshErrors(filter);
  ExpectTypeErrors(filter);
}

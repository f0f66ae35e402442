// SPDX-License-Identifier: BSD-3-Clause
#include "FilterChain.h"
#include "HexPadding.h"

#include "vtkCubeSource.h"
#include "vtkTriangleFilter.h"

#include <array>
#include <sstream>

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
  EXPECT_EQ(filter->GetPadEveryPatch(), featurehex::PaddingOptions().EveryGroup);
}

TEST(HexPaddingFilter, PatchesLikeAGridGetALayerOnRequest)
{
  vtkNew<vtkCubeSource> source;
  vtkNew<vtkTriangleFilter> cube;
  cube->SetInputConnection(source->GetOutputPort());
  cube->Update();
  FeatureChain chain(cube->GetOutput(), 0.2);
  chain.Padding->Update();
  const auto layerHexes = [&] {
    chain.Padding->Update();
    vtkDataArray* layer =
      vtkUnstructuredGrid::SafeDownCast(chain.Padding->GetOutput())->GetCellData()->GetArray(
        "PaddingLayer");
    std::array<int, 2> count = { 0, 0 }; // others, layer
    for (vtkIdType c = 0; c < layer->GetNumberOfTuples(); ++c)
    {
      ++count[layer->GetComponent(c, 0) != 0];
    }
    return count;
  };
  const std::array<int, 2> without = layerHexes();
  EXPECT_EQ(without, (std::array<int, 2>{ 125, 0 }));
  chain.Padding->PadEveryPatchOn();
  const std::array<int, 2> with = layerHexes();
  EXPECT_EQ(with, (std::array<int, 2>{ 125, 7 * 7 * 7 - 125 }));
  std::ostringstream text;
  chain.Padding->Print(text);
  EXPECT_NE(text.str().find("PadEveryPatch: on"), std::string::npos) << text.str();
  chain.Padding->PadEveryPatchOff();
  EXPECT_EQ(layerHexes(), without);
  chain.Padding->SetInputConnection(2, nullptr);
  chain.Padding->SetInputConnection(0, chain.Domain->GetOutputPort(0));
  EXPECT_EQ(layerHexes(), (std::array<int, 2>{ 125, 150 }));
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

// SPDX-License-Identifier: BSD-3-Clause
#include "FilterChain.h"
#include "HexDomain.h"

using namespace FilterChecks;

TEST(HexDomainFilter, TorusHasItsTopology)
{
  Chain chain(Torus(), 0.2);
  chain.Domain->Update();
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(chain.Domain->GetOutput());
  EXPECT_EQ(mesh->GetNumberOfCells(),
    vtkUnstructuredGrid::SafeDownCast(chain.Dual->GetOutput())->GetNumberOfCells());
  EXPECT_EQ(mesh->GetCellData()->GetArray("Region")->GetRange()[0], 0.0);
  EXPECT_EQ(mesh->GetCellData()->GetArray("Region")->GetRange()[1], 1.0);
  EXPECT_EQ(Figure(mesh, "NumberOfRegions"), 1.0);
  EXPECT_EQ(Figure(mesh, "TopologyMatches"), 1.0);
  EXPECT_EQ(Figure(mesh, "SurfaceCovered"), 1.0);
  EXPECT_TRUE(IsEmpty(chain.Domain->GetOutput(1)));
}

TEST(HexDomainFilter, CellsThatAreTooCoarseGiveRefinementPointsThatHelp)
{
  Chain chain(Torus(0.12), 0.6);
  chain.Octree->SetThicknessSizing(false);
  vtkNew<vtkPolyData> points;
  chain.Octree->SetInputDataObject(2, points);
  int rounds = 0;
  for (; rounds < 8; ++rounds)
  {
    chain.Domain->Update();
    auto* found = vtkPolyData::SafeDownCast(chain.Domain->GetOutput(1));
    if (found->GetNumberOfPoints() == 0)
    {
      break;
    }
    EXPECT_EQ(found->GetNumberOfVerts(), found->GetNumberOfPoints());
    EXPECT_EQ(ArrayList(found->GetPointData()), (std::vector<std::string>{ "Level", "Reason" }));
    vtkNew<vtkPolyData> more;
    more->DeepCopy(found);
    chain.Octree->AddInputDataObject(2, more);
  }
  EXPECT_GT(rounds, 0);
  EXPECT_EQ(Figure(chain.Domain->GetOutput(), "TopologyMatches"), 1.0);
}

TEST(HexDomainFilter, DefaultsAreThoseOfTheCore)
{
  vtkNew<vtkHexDomainFilter> filter;
  const featurehex::DomainOptions options;
  EXPECT_EQ(filter->GetMaximumLevel(), options.MaximumLevel);
}

TEST(HexDomainFilter, GoodCitizen)
{
  Chain chain(Sphere());
  ExpectGoodCitizen(chain.Domain);
}

TEST(HexDomainFilter, OneErrorForBadInput)
{
  Chain chain(Sphere());
  const auto dual = Result<vtkUnstructuredGrid>(chain.Dual);
  vtkNew<vtkHexDomainFilter> filter;
  filter->SetInputDataObject(0, dual);
  ExpectSurfaceErrors(filter, 1);
  filter->SetInputDataObject(1, Sphere());
  ExpectMeshErrors(filter);
  filter->SetInputDataObject(0, dual);
  filter->SetInputDataObject(1, Torus(0.8)); // reaches out of the hexes
  ExpectFailure(filter, "ends inside");
  ExpectTypeErrors(filter, 1);
}

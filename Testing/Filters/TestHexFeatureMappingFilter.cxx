// SPDX-License-Identifier: BSD-3-Clause
#include "FilterChain.h"
#include "HexFeatureMapping.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

using namespace FilterChecks;

namespace
{
vtkSmartPointer<vtkPolyData> Cube()
{
  return DataSurface("rotation/cube_xyz_25.obj");
}

/// Features of a hex mesh, as its arrays hold them.
struct MeshFeatures
{
  std::map<int, std::set<int>> PointsOfKind;                   ///< kind -> ids
  std::map<int, std::vector<std::array<vtkIdType, 2>>> Curves; ///< edges in their order
  std::map<std::array<vtkIdType, 4>, int> PatchOfQuad;         ///< by sorted points

  explicit MeshFeatures(vtkDataObject* data)
  {
    auto* mesh = vtkUnstructuredGrid::SafeDownCast(data);
    vtkDataArray* kind = mesh->GetPointData()->GetArray("FeatureKind");
    vtkDataArray* id = mesh->GetPointData()->GetArray("FeatureId");
    for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
    {
      this->PointsOfKind[static_cast<int>(kind->GetComponent(p, 0))].insert(
        static_cast<int>(id->GetComponent(p, 0)));
    }
    vtkDataArray* edges = mesh->GetFieldData()->GetArray("FeatureEdges");
    for (vtkIdType e = 0; e < edges->GetNumberOfTuples(); ++e)
    {
      this->Curves[static_cast<int>(edges->GetComponent(e, 2))].push_back(
        { static_cast<vtkIdType>(edges->GetComponent(e, 0)),
          static_cast<vtkIdType>(edges->GetComponent(e, 1)) });
    }
    vtkDataArray* quads = mesh->GetFieldData()->GetArray("FeatureQuads");
    for (vtkIdType q = 0; q < quads->GetNumberOfTuples(); ++q)
    {
      std::array<vtkIdType, 4> points;
      for (int k = 0; k < 4; ++k)
      {
        points[k] = static_cast<vtkIdType>(quads->GetComponent(q, k));
      }
      std::sort(points.begin(), points.end());
      this->PatchOfQuad[points] = static_cast<int>(quads->GetComponent(q, 4));
    }
  }
};

std::set<int> UpTo(int count)
{
  std::set<int> ids;
  for (int i = 0; i < count; ++i)
  {
    ids.insert(ids.end(), i);
  }
  return ids;
}

void ExpectCubeFeatures(const MeshFeatures& features)
{
  EXPECT_EQ(features.PointsOfKind.at(3), UpTo(8));
  EXPECT_EQ(features.PointsOfKind.at(2), UpTo(12));
  EXPECT_EQ(features.PointsOfKind.at(1), UpTo(6));
  EXPECT_EQ(features.PointsOfKind.at(0), std::set<int>{ -1 });
  EXPECT_EQ(features.Curves.size(), 12u);
  for (const auto& [curve, edges] : features.Curves)
  {
    for (std::size_t e = 1; e < edges.size(); ++e)
    {
      EXPECT_EQ(edges[e - 1][1], edges[e][0]) << "curve " << curve;
    }
  }
}
} // namespace

TEST(HexFeatureMappingFilter, EachFeatureOfACubeHasItsImage)
{
  FeatureChain chain(Cube(), 0.1);
  chain.Refine();
  ASSERT_EQ(Figure(chain.Mapping->GetOutput(), "FeaturesMapped"), 1.0);
  EXPECT_EQ(Figure(chain.Mapping->GetOutput(), "MappingFailures"), 0.0);
  ExpectCubeFeatures(MeshFeatures(chain.Mapping->GetOutput()));
  EXPECT_TRUE(IsEmpty(chain.Mapping->GetOutput(1)));
  EXPECT_EQ(vtkUnstructuredGrid::SafeDownCast(chain.Mapping->GetOutput())->GetNumberOfCells(),
    vtkUnstructuredGrid::SafeDownCast(chain.Domain->GetOutput())->GetNumberOfCells());
}

TEST(HexFeatureMappingFilter, FeaturesTravelThroughTheStages)
{
  FeatureChain chain(Cube(), 0.1);
  chain.Refine();
  const MeshFeatures mapped(chain.Mapping->GetOutput());

  // Padding renames points, quads come in another order: the same features all the same.
  chain.Padding->LocalPaddingOff();
  chain.Padding->Update();
  const MeshFeatures padded(chain.Padding->GetOutput());
  ExpectCubeFeatures(padded);
  ASSERT_EQ(padded.PatchOfQuad.size(), mapped.PatchOfQuad.size());
  for (const auto& [curve, edges] : mapped.Curves)
  {
    EXPECT_EQ(padded.Curves.at(curve).size(), edges.size());
  }
  vtkDataArray* kind = vtkUnstructuredGrid::SafeDownCast(chain.Padding->GetOutput())
                         ->GetPointData()
                         ->GetArray("FeatureKind");
  for (const auto& [curve, edges] : padded.Curves)
  {
    EXPECT_EQ(kind->GetComponent(edges.front()[0], 0), 3.0) << "curve " << curve;
    EXPECT_EQ(kind->GetComponent(edges.back()[1], 0), 3.0) << "curve " << curve;
  }

  const vtkIdType oneLayer =
    chain.Padding->GetOutput()->GetNumberOfElements(vtkDataObject::CELL);
  chain.Padding->LocalPaddingOn();
  chain.Untangle->Update();
  const MeshFeatures local(chain.Padding->GetOutput());
  ExpectCubeFeatures(local);
  // The layers of the six sides cross: one more hex at each crease edge and each corner.
  vtkIdType crossings = 8;
  for (const auto& [curve, edges] : padded.Curves)
  {
    crossings += static_cast<vtkIdType>(edges.size());
  }
  vtkDataObject* crossed = chain.Padding->GetOutput();
  EXPECT_EQ(crossed->GetNumberOfElements(vtkDataObject::CELL), oneLayer + crossings);
  EXPECT_EQ(Figure(crossed, "DegenerateQuads"), 0.0);
  EXPECT_EQ(Figure(crossed, "LocalPaddingHexes"), 0.0);
  EXPECT_GT(local.PatchOfQuad.size(), padded.PatchOfQuad.size());
  const MeshFeatures untangled(chain.Untangle->GetOutput());
  EXPECT_EQ(untangled.PatchOfQuad, local.PatchOfQuad);
  EXPECT_EQ(untangled.Curves, local.Curves);
  EXPECT_EQ(untangled.PointsOfKind, local.PointsOfKind);
}

TEST(HexFeatureMappingFilter, CellsThatAreTooCoarseGiveRefinementPointsThatHelp)
{
  FeatureChain chain(DataSurface("rotation/bracket.obj"), 0.6, 0.1);
  chain.Octree->SetThicknessSizing(false);
  chain.Octree->SetFeatureSizing(false);
  chain.Mapping->Update();
  EXPECT_EQ(Figure(chain.Mapping->GetOutput(), "FeaturesMapped"), 0.0);
  EXPECT_GT(Figure(chain.Mapping->GetOutput(), "MappingFailures"), 0.0);
  auto* points = vtkPolyData::SafeDownCast(chain.Mapping->GetOutput(1));
  ASSERT_GT(points->GetNumberOfPoints(), 0);
  EXPECT_EQ(points->GetNumberOfVerts(), points->GetNumberOfPoints());
  EXPECT_EQ(ArrayList(points->GetPointData()), (std::vector<std::string>{ "Level", "Reason" }));
  EXPECT_GE(points->GetPointData()->GetArray("Level")->GetRange()[0], 1.0);
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(chain.Mapping->GetOutput());
  EXPECT_FALSE(mesh->GetFieldData()->HasArray("FeatureQuads"));
  {
    // Stages that can't use the features say so.
    Messages messages(chain.Padding);
    chain.Padding->Update();
    ASSERT_EQ(messages.Warnings.size(), 1u);
    EXPECT_NE(messages.Warnings[0].find("no features"), std::string::npos);
  }
  chain.Mapping->SetMaximumLevel(0);
  chain.Mapping->Update();
  EXPECT_TRUE(IsEmpty(chain.Mapping->GetOutput(1)));
  chain.Mapping->SetMaximumLevel(4);
  chain.Refine();
  EXPECT_EQ(Figure(chain.Mapping->GetOutput(), "FeaturesMapped"), 1.0);
}

TEST(HexFeatureMappingFilter, WithoutFeaturesTheMeshPasses)
{
  FeatureChain chain(Sphere());
  chain.Mapping->Update();
  ExpectSameData(chain.Mapping->GetOutput(), chain.Domain->GetOutput());
  EXPECT_EQ(Figure(chain.Mapping->GetOutput(), "FeaturesMapped"), 1.0);
  EXPECT_TRUE(IsEmpty(chain.Mapping->GetOutput(1)));
}

TEST(HexFeatureMappingFilter, DefaultsAreThoseOfTheCore)
{
  vtkNew<vtkHexFeatureMappingFilter> filter;
  const featurehex::FeatureMappingOptions options;
  EXPECT_EQ(filter->GetCornerReach(), options.CornerReach);
  EXPECT_EQ(filter->GetCurveReach(), options.CurveReach);
  EXPECT_EQ(filter->GetMaximumAttempts(), options.MaximumAttempts);
}

TEST(HexFeatureMappingFilter, GoodCitizen)
{
  FeatureChain chain(Cube());
  ExpectGoodCitizen(chain.Mapping);
}

TEST(HexFeatureMappingFilter, OneErrorForBadInput)
{
  FeatureChain chain(Cube());
  const auto domain = Result<vtkUnstructuredGrid>(chain.Domain);
  vtkNew<vtkHexFeatureMappingFilter> filter;
  filter->SetInputDataObject(0, domain);
  filter->SetInputConnection(2, chain.Surface->GetOutputPort(1));
  ExpectSurfaceErrors(filter, 1);
  filter->SetInputDataObject(1, Sphere()); // not the surface of the graph
  ExpectFailure(filter, "surface");
  filter->SetInputDataObject(1, Cube());
  ExpectMeshErrors(filter);
  filter->SetInputDataObject(0, WithoutCellArray(domain, "Region"));
  ExpectFailure(filter, "Region");
  auto touching = vtkSmartPointer<vtkUnstructuredGrid>::New();
  touching->DeepCopy(domain);
  vtkDataArray* region = touching->GetCellData()->GetArray("Region");
  region->Fill(0);
  filter->SetInputDataObject(0, touching);
  ExpectFailure(filter, "No hex");
  region->SetComponent(0, 0, 1);
  vtkNew<vtkIdList> first, other;
  domain->GetCellPoints(0, first);
  for (vtkIdType c = 1; c < domain->GetNumberOfCells(); ++c)
  {
    domain->GetCellPoints(c, other);
    other->IntersectWith(first);
    if (other->GetNumberOfIds() == 1)
    {
      region->SetComponent(c, 0, 1);
      break;
    }
  }
  touching->Modified();
  ExpectFailure(filter, "no manifold");
  filter->SetInputDataObject(0, domain);
  ExpectTypeErrors(filter, 1);
  filter->SetInputDataObject(1, Cube());
  ExpectTypeErrors(filter, 2);
}

TEST(HexFeatureMappingFilter, StagesRefuseFeaturesThatAreDamagedOrOfAnotherSurface)
{
  FeatureChain chain(Cube(), 0.1);
  chain.Refine();
  const auto padded = Result<vtkUnstructuredGrid>(chain.Padding);
  vtkNew<vtkHexUntangleFilter> filter;
  filter->SetInputDataObject(0, padded);
  filter->SetInputConnection(2, chain.Surface->GetOutputPort(1));
  ExpectFailure(filter, "input 1");
  filter->SetInputConnection(1, chain.Surface->GetOutputPort(0));

  const auto expect = [&](const char* array, vtkIdType tuple, int component, double value,
                        const char* text) {
    SCOPED_TRACE(std::string(array) + ": " + text);
    auto damaged = vtkSmartPointer<vtkUnstructuredGrid>::New();
    damaged->DeepCopy(padded);
    damaged->GetFieldData()->GetArray(array)->SetComponent(tuple, component, value);
    filter->SetInputDataObject(0, damaged);
    ExpectFailure(filter, text);
  };
  expect("FeatureQuads", 3, 0, 1e9, "no id");
  expect("FeatureQuads", 3, 4, 77, "not those of the feature graph");
  expect("FeatureQuads", 3, 4, -1, "no id");
  vtkDataArray* edges = padded->GetFieldData()->GetArray("FeatureEdges");
  expect("FeatureEdges", 1, 0, edges->GetComponent(1, 1), "no chain");
  expect("FeatureEdges", 1, 2, 2000000000.0, "no curve");
  auto unlabelled = vtkSmartPointer<vtkUnstructuredGrid>::New();
  unlabelled->DeepCopy(padded);
  unlabelled->GetPointData()->GetArray("FeatureKind")->Fill(0);
  filter->SetInputDataObject(0, unlabelled);
  ExpectFailure(filter, "not those of the feature graph");

  vtkNew<vtkPolyData> none;
  filter->SetInputDataObject(0, padded);
  filter->SetInputDataObject(2, none);
  Messages messages(filter);
  filter->Update();
  ASSERT_EQ(messages.Warnings.size(), 1u);
  EXPECT_NE(messages.Warnings[0].find("feature graph"), std::string::npos);
}

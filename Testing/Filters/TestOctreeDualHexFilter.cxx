// SPDX-License-Identifier: BSD-3-Clause
#include "FilterChain.h"

using namespace FilterChecks;

TEST(OctreeDualHexFilter, ConformingWithItsArrays)
{
  Chain chain(Sphere());
  chain.Octree->SetTargetEdgeLength(0.025); // enough cells for coarser ones inside
  vtkNew<vtkHexValidationFilter> validation;
  validation->SetInputConnection(chain.Dual->GetOutputPort());
  validation->Update();
  EXPECT_EQ(Figure(validation->GetOutput(), "Valid"), 1.0);
  EXPECT_GT(Figure(validation->GetOutput(), "MinimumScaledJacobian"), 0.43);
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(chain.Dual->GetOutput());
  EXPECT_EQ(ArrayList(mesh->GetCellData()), (std::vector<std::string>{ "Level", "DualHexKind" }));
  EXPECT_EQ(ArrayList(mesh->GetPointData()), (std::vector<std::string>{ "OctreeIndex" }));
  EXPECT_EQ(mesh->GetCellData()->GetArray("Level")->GetRange()[1], 0.0);
  EXPECT_LT(mesh->GetCellData()->GetArray("Level")->GetRange()[0], 0.0);
  EXPECT_EQ(mesh->GetCellData()->GetArray("DualHexKind")->GetRange()[0], 0.0);
  EXPECT_EQ(mesh->GetCellData()->GetArray("DualHexKind")->GetRange()[1], 3.0);
  EXPECT_EQ(Figure(mesh, "TargetEdgeLength"), 0.025);
}

TEST(OctreeDualHexFilter, OrderOfCellsDoesNotMatter)
{
  Chain chain(Sphere());
  const auto octree = Result<vtkUnstructuredGrid>(chain.Octree);
  auto reversed = vtkSmartPointer<vtkUnstructuredGrid>::New();
  reversed->SetPoints(octree->GetPoints());
  reversed->GetFieldData()->ShallowCopy(octree->GetFieldData());
  reversed->GetCellData()->CopyAllocate(octree->GetCellData());
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = octree->GetNumberOfCells(); c-- > 0;)
  {
    octree->GetCellPoints(c, ids);
    const vtkIdType to = reversed->InsertNextCell(VTK_VOXEL, ids);
    reversed->GetCellData()->CopyData(octree->GetCellData(), c, to);
  }
  vtkNew<vtkOctreeDualHexFilter> filter;
  filter->SetInputDataObject(0, reversed);
  filter->Update();
  chain.Dual->Update();
  ExpectSameData(filter->GetOutput(), chain.Dual->GetOutput());
}

TEST(OctreeDualHexFilter, GoodCitizen)
{
  Chain chain(Sphere());
  ExpectGoodCitizen(chain.Dual);
}

TEST(OctreeDualHexFilter, OneErrorForBadInput)
{
  Chain chain(Sphere());
  const auto octree = Result<vtkUnstructuredGrid>(chain.Octree);
  vtkNew<vtkOctreeDualHexFilter> filter;
  vtkNew<vtkUnstructuredGrid> empty;
  filter->SetInputDataObject(0, empty);
  ExpectFailure(filter, "OctreeOrigin");
  for (const char* name : { "Level", "OctreeIndex" })
  {
    filter->SetInputDataObject(0, WithoutCellArray(octree, name));
    ExpectFailure(filter, name);
  }
  for (const char* name :
    { "OctreeOrigin", "OctreeAxes", "OctreeFinestCellSize", "OctreeDepth", "OctreeBaseLevel" })
  {
    auto copy = WithoutCellArray(octree, "");
    copy->GetFieldData()->RemoveArray(name);
    filter->SetInputDataObject(0, copy);
    ExpectFailure(filter, name);
  }
  auto damaged = WithoutCellArray(octree, "");
  damaged->GetCellData()->GetArray("OctreeIndex")->SetComponent(5, 0, -3);
  filter->SetInputDataObject(0, damaged);
  ExpectFailure(filter, "");
  damaged = WithoutCellArray(octree, "");
  damaged->GetFieldData()->GetArray("OctreeAxes")->SetComponent(0, 4, std::nan(""));
  filter->SetInputDataObject(0, damaged);
  ExpectFailure(filter, "no proper array");
  ExpectTypeErrors(filter);
}

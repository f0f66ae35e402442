// SPDX-License-Identifier: BSD-3-Clause
#include "FilterChain.h"
#include "AutomaticSizing.h"
#include "SurfaceSizing.h"

using namespace FilterChecks;

namespace
{
vtkSmartPointer<vtkPolyData> RefinementPoint(double x, int level)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(x, 0, 0);
  data->SetPoints(points);
  vtkNew<vtkIntArray> levels;
  levels->SetName("Level");
  levels->InsertNextValue(level);
  data->GetPointData()->AddArray(levels);
  return data;
}

vtkUnstructuredGrid* GridOf(vtkAlgorithm* filter)
{
  return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
}
} // namespace

TEST(SurfaceOctreeFilter, VoxelsTileTheBoxWithTheirArrays)
{
  vtkNew<vtkSurfaceOctreeFilter> filter;
  filter->SetInputDataObject(0, Sphere());
  filter->SetTargetEdgeLength(0.125);
  filter->Update();
  vtkUnstructuredGrid* grid = GridOf(filter);
  EXPECT_EQ(ArrayList(grid->GetCellData()), (std::vector<std::string>{ "OctreeIndex", "Level" }));
  EXPECT_EQ(Figure(grid, "TargetEdgeLength"), 0.125);
  EXPECT_EQ(grid->GetFieldData()->GetArray("OctreeOrigin")->GetNumberOfComponents(), 3);
  EXPECT_EQ(grid->GetFieldData()->GetArray("OctreeAxes")->GetNumberOfComponents(), 9);
  EXPECT_EQ(filter->GetPredictedNumberOfCells(), grid->GetNumberOfCells());
  const double finest = Figure(grid, "OctreeFinestCellSize");
  const double* origin = grid->GetFieldData()->GetArray("OctreeOrigin")->GetTuple3(0);
  const double o[3] = { origin[0], origin[1], origin[2] };
  double volume = 0;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    ASSERT_EQ(grid->GetCellType(c), VTK_VOXEL);
    double b[6];
    grid->GetCellBounds(c, b);
    volume += (b[1] - b[0]) * (b[3] - b[2]) * (b[5] - b[4]);
    const double size =
      0.125 * std::pow(0.5, grid->GetCellData()->GetArray("Level")->GetComponent(c, 0));
    EXPECT_NEAR(b[1] - b[0], size, 1e-12);
    for (int k = 0; k < 3; ++k)
    {
      EXPECT_NEAR(b[2 * k],
        o[k] + finest * grid->GetCellData()->GetArray("OctreeIndex")->GetComponent(c, k), 1e-12);
    }
  }
  double box[6];
  grid->GetBounds(box);
  EXPECT_NEAR(volume, (box[1] - box[0]) * (box[3] - box[2]) * (box[5] - box[4]), 1e-9 * volume);
}

TEST(SurfaceOctreeFilter, RefinementPointsOfSeveralSources)
{
  vtkNew<vtkSurfaceOctreeFilter> filter;
  filter->SetInputDataObject(0, Sphere());
  filter->SetTargetEdgeLength(0.2);
  filter->SetThicknessSizing(false);
  filter->Update();
  const vtkIdType without = GridOf(filter)->GetNumberOfCells();
  EXPECT_EQ(GridOf(filter)->GetCellData()->GetArray("Level")->GetRange()[1], 0.0);
  filter->AddInputDataObject(2, RefinementPoint(0.5, 1));
  filter->Update();
  EXPECT_EQ(GridOf(filter)->GetCellData()->GetArray("Level")->GetRange()[1], 1.0);
  const vtkIdType one = GridOf(filter)->GetNumberOfCells();
  EXPECT_GT(one, without);
  filter->AddInputDataObject(2, RefinementPoint(-0.5, 2));
  filter->Update();
  EXPECT_EQ(GridOf(filter)->GetCellData()->GetArray("Level")->GetRange()[1], 2.0);
  EXPECT_GT(GridOf(filter)->GetNumberOfCells(), one);
  filter->SetMaximumLevel(0);
  filter->Update();
  EXPECT_EQ(GridOf(filter)->GetCellData()->GetArray("Level")->GetRange()[1], 0.0);

  filter->SetInputDataObject(2, RefinementPoint(std::nan(""), 1));
  ExpectFailure(filter, "Refinement point 0 is not finite");
}

TEST(SurfaceOctreeFilter, TurnedOctreesAreHexahedra)
{
  auto rod = Sphere();
  for (vtkIdType p = 0; p < rod->GetNumberOfPoints(); ++p)
  {
    double x[3];
    rod->GetPoint(p, x);
    rod->GetPoints()->SetPoint(p, 4 * x[0] - x[1], 4 * x[0] + x[1], x[2]); // 45 degrees
  }
  vtkNew<vtkSurfaceOctreeFilter> filter;
  filter->SetInputDataObject(0, rod);
  filter->SetTargetEdgeLength(0.4);
  filter->AlignToPrincipalAxesOn();
  filter->Update();
  EXPECT_EQ(GridOf(filter)->GetCellType(0), VTK_HEXAHEDRON);
  vtkNew<vtkOctreeDualHexFilter> dual;
  dual->SetInputConnection(filter->GetOutputPort());
  vtkNew<vtkHexValidationFilter> validation;
  validation->SetInputConnection(dual->GetOutputPort());
  validation->Update();
  EXPECT_EQ(Figure(validation->GetOutput(), "Valid"), 1.0);
}

TEST(SurfaceOctreeFilter, DefaultsAreThoseOfTheCore)
{
  vtkNew<vtkSurfaceOctreeFilter> filter;
  const featurehex::SizingOptions sizing;
  const featurehex::OctreeOptions octree;
  EXPECT_EQ(filter->GetCellsPerGap(), sizing.CellsPerGap);
  EXPECT_EQ(filter->GetMaximumNumberOfCells(), octree.MaximumNumberOfCells);
}

TEST(SurfaceOctreeFilter, AutomaticSizingIsThatOfTheCore)
{
  vtkNew<vtkSurfaceFeatureFilter> features;
  vtkSmartPointer<vtkPolyData> surface = DataSurface("rotation/cube_x_10.obj");
  features->SetInputData(surface);
  const double* bounds = surface->GetBounds();
  const double side = std::max(
    { bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] });
  for (bool withGraph : { false, true })
  {
    const featurehex::AutomaticSizing automatic = featurehex::AutomaticSizingFor(withGraph);
    vtkIdType cells[2];
    double edgeLength = 0;
    for (bool explicitly : { false, true })
    {
      vtkNew<vtkSurfaceOctreeFilter> filter;
      filter->SetInputConnection(0, features->GetOutputPort(0));
      if (withGraph)
      {
        filter->SetInputConnection(1, features->GetOutputPort(1));
      }
      if (explicitly)
      {
        filter->SetTargetEdgeLength(edgeLength);
        filter->SetCellsPerThickness(automatic.CellsPerThickness);
        filter->SetMaximumSizingLevel(automatic.MaximumSizingLevel);
      }
      filter->Update();
      cells[explicitly] = GridOf(filter)->GetNumberOfCells();
      edgeLength = Figure(GridOf(filter), "TargetEdgeLength");
    }
    EXPECT_GT(cells[0], 0);
    EXPECT_EQ(cells[0], cells[1]) << withGraph;
    if (withGraph)
    {
      EXPECT_LT(side / edgeLength, 0.8 * automatic.CellsPerSide); // a cube needs no more
    }
    else
    {
      EXPECT_GT(side / edgeLength, 0.8 * automatic.CellsPerSide);
      EXPECT_LE(side / edgeLength, automatic.CellsPerSide + 1e-9);
    }
  }
}

TEST(SurfaceOctreeFilter, GoodCitizen)
{
  vtkNew<vtkSurfaceOctreeFilter> filter;
  filter->SetInputDataObject(0, Sphere());
  filter->SetTargetEdgeLength(0.1);
  ExpectGoodCitizen(filter);
}

TEST(SurfaceOctreeFilter, OneErrorForBadInput)
{
  vtkNew<vtkSurfaceOctreeFilter> filter;
  filter->SetMaximumNumberOfCells(100);
  filter->SetInputDataObject(0, Sphere());
  ExpectFailure(filter, "MaximumNumberOfCells");
  EXPECT_GT(filter->GetPredictedNumberOfCells(), 100);
  ExpectSurfaceErrors(filter, 0);
  ExpectTypeErrors(filter);
}

TEST(SurfaceOctreeFilter, FeaturesThatAreShortOrCloseGetSmallerCells)
{
  FeatureChain chain(DataSurface("rotation/bracket.obj"), 0.9);
  chain.Octree->SetThicknessSizing(false);
  // Coarser ones are where there are no features, if the mesh is large enough.
  const auto smallerCells = [&] {
    chain.Octree->Update();
    vtkDataArray* level = GridOf(chain.Octree)->GetCellData()->GetArray("Level");
    vtkIdType count = 0;
    for (vtkIdType c = 0; c < level->GetNumberOfTuples(); ++c)
    {
      count += level->GetComponent(c, 0) > 0;
    }
    return count;
  };
  const vtkIdType with = smallerCells();
  EXPECT_GT(with, 0);
  chain.Octree->FeatureSizingOff();
  EXPECT_EQ(smallerCells(), 0);
  chain.Octree->FeatureSizingOn();
  EXPECT_EQ(smallerCells(), with);
  chain.Octree->SetInputConnection(1, nullptr);
  EXPECT_EQ(smallerCells(), 0);
  FeatureChain other(DataSurface("rotation/cube_mixed.obj"));
  chain.Octree->SetInputConnection(1, other.Surface->GetOutputPort(1));
  ExpectFailure(chain.Octree, "surface");
}

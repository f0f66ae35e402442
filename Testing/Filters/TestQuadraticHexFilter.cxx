// SPDX-License-Identifier: BSD-3-Clause
#include "FilterChain.h"

#include "vtkFeatureHexMesher.h"
#include "vtkQuadraticHexFilter.h"

#include <cmath>

using namespace FilterChecks;

namespace
{
/// A coarse ball, meshed.
vtkSmartPointer<vtkDataObject> Ball()
{
  vtkNew<vtkFeatureHexMesher> mesher;
  mesher->SetInputDataObject(Sphere());
  mesher->SetTargetEdgeLength(0.3);
  mesher->SetTolerance(0.02);
  mesher->Update();
  return mesher->GetOutputDataObject(0);
}
} // namespace

TEST(QuadraticHexFilter, NodesOfTheBoundaryAreOnTheSurface)
{
  const auto ball = Ball();
  const vtkIdType linear = vtkUnstructuredGrid::SafeDownCast(ball)->GetNumberOfPoints();
  for (int type : { 0, 1 })
  {
    vtkNew<vtkQuadraticHexFilter> filter;
    filter->SetInputDataObject(0, ball);
    filter->SetInputDataObject(1, Sphere());
    filter->SetHexType(type);
    filter->Update();
    auto* mesh = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
    EXPECT_GT(Figure(mesh, "SmallestJacobianRatio"), 0.0);
    const double nodes = Figure(mesh, "BoundaryNodes"), onSurface = Figure(mesh, "NodesOnSurface");
    EXPECT_GT(onSurface, 0.9 * nodes);
    EXPECT_EQ(mesh->GetCellData()->GetNumberOfArrays(),
      vtkUnstructuredGrid::SafeDownCast(ball)->GetCellData()->GetNumberOfArrays());
    vtkDataArray* kinds = mesh->GetPointData()->GetArray("FeatureKind");
    ASSERT_EQ(kinds->GetNumberOfTuples(), mesh->GetNumberOfPoints());
    int good = 0;
    for (vtkIdType v = linear; v < mesh->GetNumberOfPoints(); ++v)
    {
      const double* p = mesh->GetPoint(v);
      const double radius = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
      // The sphere has 24 facets round.
      good += kinds->GetComponent(v, 0) == 1.0 && radius > 0.49 && radius < 0.5 + 1e-6;
    }
    EXPECT_GE(good, onSurface);
  }
}

TEST(QuadraticHexFilter, StraightWithoutSurface)
{
  vtkNew<vtkQuadraticHexFilter> filter;
  filter->SetInputDataObject(0, TwoHexes());
  filter->Update();
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
  EXPECT_EQ(mesh->GetNumberOfPoints(), 12 + 20);
  EXPECT_EQ(mesh->GetCellType(1), VTK_QUADRATIC_HEXAHEDRON);
  EXPECT_EQ(Figure(mesh, "NodesOnSurface"), 0.0);
}

TEST(QuadraticHexFilter, FeaturesNeedSurface)
{
  vtkNew<vtkPolyData> graph;
  vtkNew<vtkQuadraticHexFilter> filter;
  filter->SetInputDataObject(0, TwoHexes());
  filter->SetInputDataObject(2, graph);
  ExpectFailure(filter, "surface");
}

TEST(QuadraticHexFilter, GoodCitizen)
{
  vtkNew<vtkQuadraticHexFilter> filter;
  filter->SetInputDataObject(0, Ball());
  filter->SetInputDataObject(1, Sphere());
  ExpectGoodCitizen(filter);
}

TEST(QuadraticHexFilter, OneErrorForBadInput)
{
  vtkNew<vtkQuadraticHexFilter> filter;
  ExpectMeshErrors(filter, true);
  filter->SetInputDataObject(0, TwoHexes(true));
  ExpectFailure(filter, "valid");
  filter->SetInputDataObject(0, TwoHexes());
  ExpectSurfaceErrors(filter, 1);
  ExpectTypeErrors(filter);
}

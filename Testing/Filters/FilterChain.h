// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// All stages connected, at a resolution of some hundred hexes.

#ifndef FilterChain_h
#define FilterChain_h

#include "FilterChecks.h"

#include "vtkHexDomainFilter.h"
#include "vtkHexFeatureMappingFilter.h"
#include "vtkHexFittingFilter.h"
#include "vtkHexPaddingFilter.h"
#include "vtkHexUntangleFilter.h"
#include "vtkHexValidationFilter.h"
#include "vtkOctreeDualHexFilter.h"
#include "vtkSurfaceFeatureFilter.h"
#include "vtkSurfaceFileReader.h"
#include "vtkSurfaceOctreeFilter.h"

namespace FilterChecks
{
struct Chain
{
  explicit Chain(vtkPolyData* input, double edge = 0.17, double tolerance = 0.02)
  {
    this->Surface->SetInputDataObject(0, input);
    this->Octree->SetInputConnection(0, this->Surface->GetOutputPort(0));
    this->Octree->SetTargetEdgeLength(edge);
    this->Octree->SetTolerance(tolerance);
    this->Dual->SetInputConnection(this->Octree->GetOutputPort());
    this->Domain->SetInputConnection(0, this->Dual->GetOutputPort());
    this->Domain->SetInputConnection(1, this->Surface->GetOutputPort(0));
    this->Domain->SetTolerance(tolerance);
    this->Padding->SetInputConnection(this->Domain->GetOutputPort(0));
    this->Untangle->SetInputConnection(0, this->Padding->GetOutputPort());
    this->Untangle->SetInputConnection(1, this->Surface->GetOutputPort(0));
    this->Fitting->SetInputConnection(0, this->Untangle->GetOutputPort());
    this->Fitting->SetInputConnection(1, this->Surface->GetOutputPort(0));
    this->Fitting->SetTolerance(tolerance);
    this->Validation->SetInputConnection(0, this->Fitting->GetOutputPort(0));
    this->Validation->SetInputConnection(1, this->Surface->GetOutputPort(0));
    this->Validation->SetTolerance(tolerance);
  }

  std::vector<vtkAlgorithm*> All() const
  {
    return { this->Surface, this->Octree, this->Dual, this->Domain, this->Padding, this->Untangle,
      this->Fitting, this->Validation };
  }

  vtkNew<vtkSurfaceFeatureFilter> Surface;
  vtkNew<vtkSurfaceOctreeFilter> Octree;
  vtkNew<vtkOctreeDualHexFilter> Dual;
  vtkNew<vtkHexDomainFilter> Domain;
  vtkNew<vtkHexPaddingFilter> Padding;
  vtkNew<vtkHexUntangleFilter> Untangle;
  vtkNew<vtkHexFittingFilter> Fitting;
  vtkNew<vtkHexValidationFilter> Validation;
};

/// With sharp features, by angle.
struct FeatureChain : Chain
{
  explicit FeatureChain(vtkPolyData* input, double edge = 0.17, double tolerance = 0.02)
    : Chain(input, edge, tolerance)
  {
    vtkAlgorithmOutput* graph = this->Surface->GetOutputPort(1);
    this->Octree->SetInputConnection(1, graph);
    this->Mapping->SetInputConnection(0, this->Domain->GetOutputPort(0));
    this->Mapping->SetInputConnection(1, this->Surface->GetOutputPort(0));
    this->Mapping->SetInputConnection(2, graph);
    this->Padding->SetInputConnection(0, this->Mapping->GetOutputPort(0));
    this->Padding->SetInputConnection(1, this->Surface->GetOutputPort(0));
    this->Padding->SetInputConnection(2, graph);
    this->Untangle->SetInputConnection(2, graph);
    this->Fitting->SetInputConnection(2, graph);
    this->Validation->SetInputConnection(2, graph);
  }

  /// Gives the octree what the other stages ask for, until they are content. @return rounds
  int Refine(int maximum = 8)
  {
    vtkNew<vtkPolyData> none;
    this->Octree->SetInputDataObject(2, none);
    for (int round = 1; round < maximum; ++round)
    {
      vtkPolyData* wanted = nullptr;
      for (vtkAlgorithm* stage :
        { static_cast<vtkAlgorithm*>(this->Domain), static_cast<vtkAlgorithm*>(this->Mapping),
          static_cast<vtkAlgorithm*>(this->Fitting) })
      {
        stage->Update();
        wanted = vtkPolyData::SafeDownCast(stage->GetOutputDataObject(1));
        if (wanted->GetNumberOfPoints() > 0)
        {
          break;
        }
      }
      if (wanted->GetNumberOfPoints() == 0)
      {
        return round;
      }
      vtkNew<vtkPolyData> points;
      points->DeepCopy(wanted);
      this->Octree->AddInputDataObject(2, points);
    }
    return maximum;
  }

  vtkNew<vtkHexFeatureMappingFilter> Mapping;
};

/// A surface of Data/, by its path there.
inline vtkSmartPointer<vtkPolyData> DataSurface(const std::string& path)
{
  vtkNew<vtkSurfaceFileReader> reader;
  reader->SetFileName((FEATUREHEX_SOURCE_DIR "/Data/" + path).c_str());
  reader->Update();
  return reader->GetOutput();
}

/// The result of @a filter in a chain as data of its own.
template <typename DataSet>
vtkSmartPointer<DataSet> Result(vtkAlgorithm* filter, int port = 0)
{
  filter->Update();
  auto copy = vtkSmartPointer<DataSet>::New();
  copy->DeepCopy(filter->GetOutputDataObject(port));
  return copy;
}

inline vtkSmartPointer<vtkUnstructuredGrid> WithoutCellArray(
  vtkUnstructuredGrid* grid, const char* name)
{
  auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
  copy->DeepCopy(grid);
  copy->GetCellData()->RemoveArray(name);
  return copy;
}

/// Two hexes; the second one is inverted when @a inverted.
inline vtkSmartPointer<vtkUnstructuredGrid> TwoHexes(bool inverted = false)
{
  auto grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (int z = 0; z < 3; ++z)
  {
    const double height = inverted && z == 2 ? 0.5 : z;
    points->InsertNextPoint(0, 0, height);
    points->InsertNextPoint(1, 0, height);
    points->InsertNextPoint(1, 1, height);
    points->InsertNextPoint(0, 1, height);
  }
  grid->SetPoints(points);
  const vtkIdType hexes[2][8] = { { 0, 1, 2, 3, 4, 5, 6, 7 }, { 4, 5, 6, 7, 8, 9, 10, 11 } };
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, hexes[0]);
  grid->InsertNextCell(VTK_HEXAHEDRON, 8, hexes[1]);
  return grid;
}

inline vtkSmartPointer<vtkUnstructuredGrid> OneTetrahedron()
{
  auto grid = TwoHexes();
  const vtkIdType tetrahedron[4] = { 0, 1, 3, 4 };
  grid->InsertNextCell(VTK_TETRA, 4, tetrahedron);
  return grid;
}

/// What each filter says to hex meshes that can't be used. @a nan: it doesn't take NaN either.
inline void ExpectMeshErrors(vtkAlgorithm* filter, bool nan = true)
{
  vtkNew<vtkUnstructuredGrid> empty;
  filter->SetInputDataObject(0, empty);
  ExpectFailure(filter, "no cells");
  filter->SetInputDataObject(0, OneTetrahedron());
  ExpectFailure(filter, "cell 2 is a vtkTetra");
  auto broken = TwoHexes();
  const vtkIdType hex[8] = { 0, 1, 2, 3, 4, 5, 6, 77 };
  broken->InsertNextCell(VTK_HEXAHEDRON, 8, hex);
  filter->SetInputDataObject(0, broken);
  ExpectFailure(filter, "refers to point 77");
  if (nan)
  {
    filter->SetInputDataObject(0, WithNaN(TwoHexes().GetPointer()));
    ExpectFailure(filter, "not finite");
    auto overused = TwoHexes();
    const vtkIdType third[8] = { 4, 5, 6, 7, 0, 1, 2, 3 };
    overused->InsertNextCell(VTK_HEXAHEDRON, 8, third);
    filter->SetInputDataObject(0, overused);
    ExpectFailure(filter, "not conforming");
  }
}

inline void ExpectSurfaceErrors(vtkAlgorithm* filter, int port)
{
  vtkNew<vtkPolyData> empty;
  filter->SetInputDataObject(port, empty);
  ExpectFailure(filter, "no points");
  filter->SetInputDataObject(port, OpenSphere());
  ExpectFailure(filter, "edges");
  filter->SetInputDataObject(port, WithNaN(Sphere().GetPointer()));
  ExpectFailure(filter, "finite");
}
} // namespace FilterChecks

#endif

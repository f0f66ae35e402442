// SPDX-License-Identifier: BSD-3-Clause
#include "SolverConversion.h"

#include "ArrayNames.h"
#include "HexFeatures.h"
#include "MeditConversion.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>

namespace featurehex
{
namespace
{
/// Nodes of VTK_TRIQUADRATIC_HEXAHEDRON in the order of SolverMesh. VTK's mid-face nodes are those
/// of -x, +x, -y, +y, -z, +z; HexFaces are -z, +z, -y, +x, +y, -x.
constexpr int VTKNodes[27] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19,
  24, 25, 22, 21, 23, 20, 26 };

int NodesOfType(int type)
{
  return type == VTK_HEXAHEDRON                ? 8
         : type == VTK_QUADRATIC_HEXAHEDRON    ? 20
         : type == VTK_TRIQUADRATIC_HEXAHEDRON ? 27
                                               : 0;
}

Status WrongCell(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  return Status(StatusCode::InvalidMesh,
    "Cell " + std::to_string(cell) + " has type " + std::to_string(grid->GetCellType(cell)) +
      ". Solver meshes hold hexahedra, all with as many nodes (8, 20 or 27), and with linear ones "
      "quads, lines and vertices.");
}

/// A grid of quadratic hexahedra alone.
Status ReadQuadratic(vtkUnstructuredGrid* grid, int nodesPerHex, SolverMesh& mesh)
{
  mesh.NodesPerHex = nodesPerHex;
  vtkDataArray* regions = grid->GetCellData()->GetArray(ArrayNames::Region);
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    if (NodesOfType(grid->GetCellType(c)) != nodesPerHex)
    {
      return WrongCell(grid, c);
    }
    grid->GetCellPoints(c, ids);
    for (int k = 0; k < nodesPerHex; ++k)
    {
      mesh.HexNodes.push_back(static_cast<Index>(ids->GetId(VTKNodes[k])));
    }
    mesh.Regions.push_back(regions ? static_cast<std::int32_t>(regions->GetComponent(c, 0)) : 1);
  }
  mesh.Points.resize(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    grid->GetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
  }
  return {};
}

/// The linear hexes of a quadratic grid with its feature arrays, to read the labels from.
void LinearGrid(vtkUnstructuredGrid* grid, const SolverMesh& mesh, vtkUnstructuredGrid* linear)
{
  linear->SetPoints(grid->GetPoints());
  linear->GetPointData()->ShallowCopy(grid->GetPointData());
  linear->GetFieldData()->ShallowCopy(grid->GetFieldData());
  linear->Allocate(mesh.NumberOfHexes());
  for (Index hex = 0; hex < mesh.NumberOfHexes(); ++hex)
  {
    vtkIdType corners[8];
    std::copy_n(mesh.Nodes(hex), 8, corners);
    linear->InsertNextCell(VTK_HEXAHEDRON, 8, corners);
  }
}

/// FeatureKind and FeatureId.
void LabelsOfPoints(vtkUnstructuredGrid* grid, bool givenCorners, SolverLabels& labels)
{
  vtkDataArray* kinds = grid->GetPointData()->GetArray(ArrayNames::FeatureKind);
  vtkDataArray* ids = grid->GetPointData()->GetArray(ArrayNames::FeatureId);
  if (!kinds || !ids)
  {
    return;
  }
  labels.PatchOfPoint.assign(static_cast<std::size_t>(grid->GetNumberOfPoints()), -1);
  for (vtkIdType v = 0; v < grid->GetNumberOfPoints(); ++v)
  {
    const double kind = kinds->GetComponent(v, 0);
    const auto id = static_cast<std::int32_t>(ids->GetComponent(v, 0));
    if (kind == static_cast<double>(FeatureKind::Surface))
    {
      labels.PatchOfPoint[v] = id;
    }
    else if (kind == static_cast<double>(FeatureKind::Corner) && !givenCorners)
    {
      labels.Corners.push_back({ static_cast<Index>(v), id });
    }
  }
}

/// Quads, edges and corners of @a medit.
SolverLabels LabelsOf(const MeditMesh& medit, vtkUnstructuredGrid* grid)
{
  SolverLabels labels;
  labels.Quads = medit.Quads;
  labels.Patches = medit.QuadReferences;
  labels.Edges = medit.Edges;
  labels.Curves = medit.EdgeReferences;
  vtkDataArray* kinds = grid->GetPointData()->GetArray(ArrayNames::FeatureKind);
  vtkDataArray* ids = grid->GetPointData()->GetArray(ArrayNames::FeatureId);
  for (std::size_t i = 0; i < medit.Corners.size(); ++i)
  {
    const Index v = medit.Corners[i];
    const bool known =
      kinds && ids && kinds->GetComponent(v, 0) == static_cast<double>(FeatureKind::Corner);
    labels.Corners.push_back(
      { v, static_cast<std::int32_t>(known ? ids->GetComponent(v, 0) : static_cast<double>(i)) });
  }
  LabelsOfPoints(grid, !medit.Corners.empty(), labels);
  return labels;
}
} // namespace

Status SolverMeshFromGrid(vtkUnstructuredGrid* grid, SolverMesh& mesh)
{
  mesh = {};
  if (std::max(grid->GetNumberOfPoints(), grid->GetNumberOfCells()) >
      std::numeric_limits<Index>::max())
  {
    return Status(StatusCode::InvalidMesh, "The mesh has more than 2147483647 points or cells.");
  }
  const int nodesPerHex = grid->GetNumberOfCells() > 0 ? NodesOfType(grid->GetCellType(0)) : 8;
  MeditMesh medit;
  if (nodesPerHex <= 8)
  {
    // A mesh of Medit's elements has the very labels that solvers want.
    Status status = MeditFromGrid(grid, medit);
    if (!status.Ok())
    {
      return status;
    }
    for (const Hex& hex : medit.Hexes)
    {
      mesh.HexNodes.insert(mesh.HexNodes.end(), hex.begin(), hex.end());
    }
    mesh.Points = medit.Points;
    mesh.Regions = medit.HexReferences;
    return LabelSolverMesh(LabelsOf(medit, grid), mesh);
  }
  Status status = ReadQuadratic(grid, nodesPerHex, mesh);
  if (!status.Ok())
  {
    return status;
  }
  vtkNew<vtkUnstructuredGrid> linear;
  LinearGrid(grid, mesh, linear);
  status = MeditFromGrid(linear, medit);
  return status.Ok() ? LabelSolverMesh(LabelsOf(medit, linear), mesh) : status;
}
} // namespace featurehex

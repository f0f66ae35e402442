// SPDX-License-Identifier: BSD-3-Clause
#include "MeditConversion.h"

#include "ArrayNames.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>
#include <string>

namespace featurehex
{
namespace
{
/// Label of a cell as a 32-bit integer.
class Labels
{
public:
  Labels(vtkUnstructuredGrid* grid, const char* name, std::int32_t fallback)
    : Array(grid->GetCellData()->GetArray(name))
    , Fallback(fallback)
  {
  }

  std::int32_t Get(vtkIdType cell) const
  {
    if (!this->Array)
    {
      return this->Fallback;
    }
    const double value = this->Array->GetComponent(cell, 0);
    return value >= std::numeric_limits<std::int32_t>::min() &&
               value <= std::numeric_limits<std::int32_t>::max()
             ? static_cast<std::int32_t>(value)
             : this->Fallback;
  }

private:
  vtkDataArray* Array;
  std::int32_t Fallback;
};

template <std::size_t Size>
void Append(vtkIdList* ids, std::vector<std::array<Index, Size>>& elements)
{
  std::array<Index, Size> element;
  for (std::size_t i = 0; i < Size; ++i)
  {
    element[i] = static_cast<Index>(ids->GetId(static_cast<vtkIdType>(i)));
  }
  elements.push_back(element);
}

/// Cells of a grid in the making, with their labels.
class GridBuilder
{
public:
  GridBuilder()
  {
    this->Region->SetName(ArrayNames::Region);
    this->PatchId->SetName(ArrayNames::PatchId);
    this->CurveId->SetName(ArrayNames::CurveId);
  }

  template <typename Element>
  void Add(int type, const Element& element, int region, int patch, int curve)
  {
    this->Cells->InsertNextCell(static_cast<vtkIdType>(element.size()));
    for (Index id : element)
    {
      this->Cells->InsertCellPoint(id);
    }
    this->Types->InsertNextValue(static_cast<unsigned char>(type));
    this->Region->InsertNextValue(region);
    this->PatchId->InsertNextValue(patch);
    this->CurveId->InsertNextValue(curve);
  }

  void Finish(bool boundary, vtkUnstructuredGrid* grid)
  {
    grid->SetCells(this->Types, this->Cells);
    grid->GetCellData()->AddArray(this->Region);
    if (boundary)
    {
      grid->GetCellData()->AddArray(this->PatchId);
      grid->GetCellData()->AddArray(this->CurveId);
    }
  }

private:
  vtkNew<vtkCellArray> Cells;
  vtkNew<vtkUnsignedCharArray> Types;
  vtkNew<vtkIntArray> Region;
  vtkNew<vtkIntArray> PatchId;
  vtkNew<vtkIntArray> CurveId;
};
} // namespace

Status MeditFromGrid(vtkUnstructuredGrid* grid, MeditMesh& mesh)
{
  mesh = {};
  if (std::max(grid->GetNumberOfPoints(), grid->GetNumberOfCells()) >
      std::numeric_limits<Index>::max())
  {
    return Status(StatusCode::InvalidMesh, "The mesh has more than 2147483647 points or cells.");
  }
  mesh.Points.resize(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    grid->GetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
  }
  const Labels regions(grid, ArrayNames::Region, 1);
  const Labels patches(grid, ArrayNames::PatchId, 0);
  const Labels curves(grid, ArrayNames::CurveId, 0);
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    grid->GetCellPoints(c, ids);
    switch (grid->GetCellType(c))
    {
      case VTK_HEXAHEDRON:
        Append(ids, mesh.Hexes);
        mesh.HexReferences.push_back(regions.Get(c));
        break;
      case VTK_QUAD:
        Append(ids, mesh.Quads);
        mesh.QuadReferences.push_back(patches.Get(c));
        break;
      case VTK_LINE:
        Append(ids, mesh.Edges);
        mesh.EdgeReferences.push_back(curves.Get(c));
        mesh.Ridges.push_back(static_cast<Index>(mesh.Edges.size()) - 1);
        break;
      case VTK_VERTEX:
        mesh.Corners.push_back(static_cast<Index>(ids->GetId(0)));
        break;
      default:
        return Status(StatusCode::InvalidMesh,
          "Cell " + std::to_string(c) + " has type " + std::to_string(grid->GetCellType(c)) +
            ". A .mesh file of FeatureHex holds hexahedra, quads, lines and vertices.");
    }
  }
  return mesh.Hexes.empty() ? Status(StatusCode::EmptySurface, "There are no hexahedra to write.")
                            : Status();
}

void GridFromMedit(const MeditMesh& mesh, bool boundary, vtkUnstructuredGrid* grid)
{
  grid->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.Points.size()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
  }
  grid->SetPoints(points);

  GridBuilder builder;
  for (std::size_t i = 0; i < mesh.Hexes.size(); ++i)
  {
    builder.Add(VTK_HEXAHEDRON, mesh.Hexes[i], mesh.HexReferences[i], -1, -1);
  }
  if (boundary)
  {
    for (std::size_t i = 0; i < mesh.Quads.size(); ++i)
    {
      builder.Add(VTK_QUAD, mesh.Quads[i], 0, mesh.QuadReferences[i], -1);
    }
    for (std::size_t i = 0; i < mesh.Edges.size(); ++i)
    {
      builder.Add(VTK_LINE, mesh.Edges[i], 0, -1, mesh.EdgeReferences[i]);
    }
    for (Index corner : mesh.Corners)
    {
      builder.Add(VTK_VERTEX, std::array<Index, 1>{ corner }, 0, -1, -1);
    }
  }
  builder.Finish(boundary, grid);
}
} // namespace featurehex

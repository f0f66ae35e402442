// SPDX-License-Identifier: BSD-3-Clause
#include "MeditConversion.h"

#include "ArrayNames.h"
#include "HexFeatures.h"
#include "MeshTopology.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSmartPointer.h"
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
/// Rows of an integer array; false when it isn't there or of another shape.
template <std::size_t Size>
bool Rows(vtkUnstructuredGrid* grid, const char* name, std::vector<std::array<Index, Size>>& rows)
{
  vtkDataArray* array = grid->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfComponents() != static_cast<int>(Size))
  {
    return false;
  }
  rows.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    for (std::size_t k = 0; k < Size; ++k)
    {
      const double value = array->GetComponent(static_cast<vtkIdType>(i), static_cast<int>(k));
      rows[i][k] = value >= -1.0 && value <= std::numeric_limits<Index>::max()
                     ? static_cast<Index>(value)
                     : -1;
    }
  }
  return true;
}

std::array<Index, 4> SortedQuad(Quad quad)
{
  std::sort(quad.begin(), quad.end());
  return quad;
}

/// The quads are those of the boundary, the edges are edges of them.
bool Fit(const MeditMesh& mesh, const std::vector<std::array<Index, 5>>& quads,
  const std::vector<std::array<Index, 3>>& edges)
{
  const auto count = static_cast<Index>(mesh.Points.size());
  for (const Hex& hex : mesh.Hexes)
  {
    if (std::any_of(hex.begin(), hex.end(), [&](Index v) { return v < 0 || v >= count; }))
    {
      return false;
    }
  }
  std::vector<Quad> boundary, given;
  std::vector<std::array<Index, 2>> sides;
  for (const Quad& quad : ExtractBoundary({ mesh.Points, mesh.Hexes }).Quads)
  {
    boundary.push_back(SortedQuad(quad));
    for (int k = 0; k < 4; ++k)
    {
      sides.push_back(
        { std::min(quad[k], quad[(k + 1) % 4]), std::max(quad[k], quad[(k + 1) % 4]) });
    }
  }
  for (const auto& row : quads)
  {
    given.push_back(SortedQuad({ row[0], row[1], row[2], row[3] }));
  }
  std::sort(boundary.begin(), boundary.end());
  std::sort(given.begin(), given.end());
  std::sort(sides.begin(), sides.end());
  return boundary == given &&
         std::all_of(edges.begin(), edges.end(),
           [&](const std::array<Index, 3>& e)
           {
             return std::binary_search(sides.begin(), sides.end(),
               std::array<Index, 2>{ std::min(e[0], e[1]), std::max(e[0], e[1]) });
           });
}

void AddFeatures(vtkUnstructuredGrid* grid, MeditMesh& mesh)
{
  std::vector<std::array<Index, 5>> quads;
  std::vector<std::array<Index, 3>> edges;
  vtkDataArray* kinds = grid->GetPointData()->GetArray(ArrayNames::FeatureKind);
  vtkDataArray* ids = grid->GetPointData()->GetArray(ArrayNames::FeatureId);
  if (!kinds || !ids || !Rows(grid, ArrayNames::FeatureQuads, quads) ||
      !Rows(grid, ArrayNames::FeatureEdges, edges) || !Fit(mesh, quads, edges))
  {
    return;
  }
  for (const auto& row : quads)
  {
    mesh.Quads.push_back({ row[0], row[1], row[2], row[3] });
    mesh.QuadReferences.push_back(row[4]);
  }
  for (const auto& row : edges)
  {
    mesh.Ridges.push_back(static_cast<Index>(mesh.Edges.size()));
    mesh.Edges.push_back({ row[0], row[1] });
    mesh.EdgeReferences.push_back(row[2]);
  }
  mesh.PointReferences.assign(mesh.Points.size(), 0);
  for (vtkIdType v = 0; v < grid->GetNumberOfPoints(); ++v)
  {
    if (kinds->GetComponent(v, 0) == static_cast<double>(FeatureKind::Corner))
    {
      mesh.Corners.push_back(static_cast<Index>(v));
      mesh.PointReferences[v] = static_cast<std::int32_t>(ids->GetComponent(v, 0));
    }
  }
}

vtkSmartPointer<vtkIntArray> IntArray(const char* name, int components, std::size_t tuples)
{
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples));
  return array;
}

/// The arrays that AddFeatures() was made of.
void RestoreFeatures(const MeditMesh& mesh, vtkUnstructuredGrid* grid)
{
  auto kinds = IntArray(ArrayNames::FeatureKind, 1, mesh.Points.size());
  auto ids = IntArray(ArrayNames::FeatureId, 1, mesh.Points.size());
  kinds->Fill(static_cast<double>(FeatureKind::Interior));
  ids->Fill(-1);
  const auto label = [&](Index v, FeatureKind kind, int id)
  {
    kinds->SetValue(v, static_cast<int>(kind));
    ids->SetValue(v, id);
  };
  auto quads = IntArray(ArrayNames::FeatureQuads, 5, mesh.Quads.size());
  for (std::size_t q = 0; q < mesh.Quads.size(); ++q)
  {
    for (int k = 0; k < 4; ++k)
    {
      label(mesh.Quads[q][k], FeatureKind::Surface, mesh.QuadReferences[q]);
      quads->SetTypedComponent(static_cast<vtkIdType>(q), k, mesh.Quads[q][k]);
    }
    quads->SetTypedComponent(static_cast<vtkIdType>(q), 4, mesh.QuadReferences[q]);
  }
  auto edges = IntArray(ArrayNames::FeatureEdges, 3, mesh.Edges.size());
  for (std::size_t e = 0; e < mesh.Edges.size(); ++e)
  {
    for (int k = 0; k < 2; ++k)
    {
      label(mesh.Edges[e][k], FeatureKind::Curve, mesh.EdgeReferences[e]);
      edges->SetTypedComponent(static_cast<vtkIdType>(e), k, mesh.Edges[e][k]);
    }
    edges->SetTypedComponent(static_cast<vtkIdType>(e), 2, mesh.EdgeReferences[e]);
  }
  for (Index corner : mesh.Corners)
  {
    label(corner, FeatureKind::Corner, mesh.PointReferences[corner]);
  }
  grid->GetPointData()->AddArray(kinds);
  grid->GetPointData()->AddArray(ids);
  grid->GetFieldData()->AddArray(quads);
  grid->GetFieldData()->AddArray(edges);
}
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
  if (static_cast<vtkIdType>(mesh.Hexes.size()) == grid->GetNumberOfCells())
  {
    AddFeatures(grid, mesh);
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
  if (!mesh.Quads.empty())
  {
    RestoreFeatures(mesh, grid);
  }
}

Status ReadMeditGrid(const std::string& path, bool boundary, vtkUnstructuredGrid* grid)
{
  MeditMesh mesh;
  const Status status = ReadMedit(path, mesh);
  if (status.Ok())
  {
    GridFromMedit(mesh, boundary, grid);
  }
  return status;
}

Status WriteMeditGrid(const std::string& path, vtkUnstructuredGrid* grid)
{
  MeditMesh mesh;
  const Status status = MeditFromGrid(grid, mesh);
  return status.Ok() ? WriteMedit(path, mesh) : status;
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause
#include "DataConversion.h"

#include "ArrayNames.h"
#include "MeshTopology.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCellTypes.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkTriangleFilter.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

namespace featurehex
{
namespace
{
std::vector<Vec3> PointsFrom(vtkPointSet* input)
{
  std::vector<Vec3> points(static_cast<std::size_t>(input->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    input->GetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return points;
}

vtkSmartPointer<vtkPoints> PointsTo(const std::vector<Vec3>& points)
{
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetDataTypeToDouble();
  result->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    result->SetPoint(static_cast<vtkIdType>(i), points[i].data());
  }
  return result;
}

template <typename Cell>
vtkSmartPointer<vtkCellArray> CellsTo(const std::vector<Cell>& cells)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  const vtkIdType size = static_cast<vtkIdType>(std::tuple_size<Cell>::value);
  result->AllocateExact(
    static_cast<vtkIdType>(cells.size()), size * static_cast<vtkIdType>(cells.size()));
  std::array<vtkIdType, std::tuple_size<Cell>::value> ids;
  for (const Cell& cell : cells)
  {
    std::copy(cell.begin(), cell.end(), ids.begin());
    result->InsertNextCell(size, ids.data());
  }
  return result;
}

/// Calls visit(ids, count) for each cell.
template <typename Visit>
void ForEachCell(vtkCellArray* cells, const Visit& visit)
{
  auto iterator = vtk::TakeSmartPointer(cells->NewIterator());
  for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
  {
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    iterator->GetCurrentCell(count, ids);
    visit(ids, count);
  }
}

/// Polygons with more than three corners that can be cut by their shape: all ids and coordinates
/// good.
bool NeedsTriangulation(vtkPolyData* input, const std::vector<Vec3>& points)
{
  bool polygons = false;
  bool sound =
    std::all_of(points.begin(), points.end(), [](const Vec3& p) { return p.allFinite(); });
  ForEachCell(input->GetPolys(),
    [&](const vtkIdType* ids, vtkIdType count)
    {
      polygons = polygons || count > 3;
      sound =
        sound && count > 2 &&
        std::all_of(ids, ids + count,
          [&](vtkIdType id) { return id >= 0 && id < static_cast<vtkIdType>(points.size()); });
    });
  return polygons && sound;
}

/// Ids beyond 32 bits must not become ids of other points.
Index ShortId(vtkIdType id)
{
  return id >= 0 && id <= std::numeric_limits<Index>::max() ? static_cast<Index>(id) : -1;
}

std::string CellName(vtkUnstructuredGrid* grid, vtkIdType cell)
{
  const char* name = vtkCellTypes::GetClassNameFromTypeId(grid->GetCellType(cell));
  return "cell " + std::to_string(cell) + " is a " + (name ? name : "cell of unknown type");
}

/// Gives points an id in the order in which they are first used.
class PointPicker
{
public:
  explicit PointPicker(const std::vector<Vec3>& points)
    : Points(points)
    , NewId(points.size(), -1)
  {
  }
  Index operator()(Index id)
  {
    if (this->NewId[id] < 0)
    {
      this->NewId[id] = static_cast<Index>(this->Picked.size());
      this->Picked.push_back(this->Points[id]);
    }
    return this->NewId[id];
  }

  const std::vector<Vec3>& Points;
  std::vector<Vec3> Picked;

private:
  std::vector<Index> NewId;
};
} // namespace

//--- surfaces -------------------------------------------------------------------------------------
SurfaceMesh SurfaceFromPolyData(vtkPolyData* input)
{
  SurfaceMesh surface;
  surface.Points = PointsFrom(input);
  vtkSmartPointer<vtkCellArray> polygons = input->GetPolys();
  if (NeedsTriangulation(input, surface.Points))
  {
    vtkNew<vtkPolyData> only;
    only->SetPoints(input->GetPoints());
    only->SetPolys(polygons);
    vtkNew<vtkTriangleFilter> cut;
    cut->SetInputData(only);
    cut->Update();
    polygons = cut->GetOutput()->GetPolys();
  }
  surface.Triangles.reserve(static_cast<std::size_t>(polygons->GetNumberOfCells()));
  const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c) {
    surface.Triangles.push_back({ ShortId(a), ShortId(b), ShortId(c) });
  };
  ForEachCell(polygons,
    [&](const vtkIdType* ids, vtkIdType n)
    {
      for (vtkIdType i = 2; i < n; ++i)
      {
        add(ids[0], ids[i - 1], ids[i]);
      }
    });
  ForEachCell(input->GetStrips(),
    [&](const vtkIdType* ids, vtkIdType n)
    {
      for (vtkIdType i = 2; i < n; ++i)
      {
        add(ids[i - 2], ids[i % 2 ? i : i - 1], ids[i % 2 ? i - 1 : i]);
      }
    });
  return surface;
}

Status CheckedSurface(vtkPolyData* input, SurfaceMesh& surface, Monitor& monitor)
{
  surface = SurfaceFromPolyData(input);
  SurfaceCheckReport report;
  return CheckSurface(surface, SurfaceCheckOptions(), report, monitor);
}

void PolyDataFromSurface(const SurfaceMesh& surface, vtkPolyData* output)
{
  output->SetPoints(PointsTo(surface.Points));
  output->SetPolys(CellsTo(surface.Triangles));
}

void PolyDataFromQuads(
  const std::vector<Vec3>& points, const std::vector<Quad>& quads, vtkPolyData* output)
{
  PointPicker pick(points);
  std::vector<Quad> picked = quads;
  for (Quad& quad : picked)
  {
    std::transform(quad.begin(), quad.end(), quad.begin(), std::ref(pick));
  }
  output->SetPoints(PointsTo(pick.Picked));
  output->SetPolys(CellsTo(picked));
}

//--- hex meshes -----------------------------------------------------------------------------------
Status MeshFromGrid(vtkUnstructuredGrid* grid, MeshCheck check, HexMesh& mesh)
{
  const vtkIdType cells = grid->GetNumberOfCells();
  const vtkIdType count = grid->GetNumberOfPoints();
  if (cells == 0)
  {
    return Status(StatusCode::InvalidMesh, "The hex mesh has no cells.");
  }
  if (std::max(cells, count) > std::numeric_limits<Index>::max())
  {
    return Status(
      StatusCode::InvalidMesh, "The hex mesh has more than 2,147,483,647 cells or points.");
  }
  mesh.Points = PointsFrom(grid);
  mesh.Hexes.resize(static_cast<std::size_t>(cells));
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < cells; ++c)
  {
    const int type = grid->GetCellType(c);
    if (type != VTK_HEXAHEDRON && type != VTK_VOXEL)
    {
      return Status(StatusCode::InvalidMesh, "The mesh is not all-hex: " + CellName(grid, c) +
                                               ". Give linear hexahedra or voxels only.");
    }
    grid->GetCellPoints(c, ids);
    Hex& hex = mesh.Hexes[c];
    for (int i = 0; i < 8; ++i)
    {
      const vtkIdType id = i < ids->GetNumberOfIds() ? ids->GetId(i) : -1;
      if (id < 0 || id >= count)
      {
        return Status(StatusCode::IndexOutOfRange, "Hex " + std::to_string(c) +
                                                     " refers to point " + std::to_string(id) +
                                                     " of " + std::to_string(count) + ".");
      }
      hex[i] = static_cast<Index>(id);
    }
    if (type == VTK_VOXEL)
    {
      std::swap(hex[2], hex[3]);
      std::swap(hex[6], hex[7]);
    }
  }
  if (check == MeshCheck::Ids)
  {
    return Status();
  }
  for (std::size_t p = 0; p < mesh.Points.size(); ++p)
  {
    if (!mesh.Points[p].allFinite())
    {
      return Status(StatusCode::NonFinite,
        "Point " + std::to_string(p) + " of the hex mesh is not finite (NaN or infinite).");
    }
  }
  const HexTopology topology = AnalyzeHexMesh(mesh);
  if (!topology.Conforming())
  {
    return Status(StatusCode::InvalidMesh,
      "The hex mesh is not conforming: " + std::to_string(topology.DegenerateHexes) +
        " hexes repeat a point, " + std::to_string(topology.DuplicateHexes) + " are duplicates, " +
        std::to_string(topology.OverusedFaces) + " faces have more than two hexes, " +
        std::to_string(topology.TwistedFaces + topology.MisorientedFaces) +
        " faces are twisted. The Hex Validation filter shows where.");
  }
  return Status();
}

void GridFromMesh(const HexMesh& mesh, vtkUnstructuredGrid* output)
{
  output->SetPoints(PointsTo(mesh.Points));
  output->SetCells(VTK_HEXAHEDRON, CellsTo(mesh.Hexes));
}

void GridFromHexes(const HexMesh& mesh, const std::vector<Index>& ids, vtkUnstructuredGrid* grid,
  vtkUnstructuredGrid* output)
{
  PointPicker pick(mesh.Points);
  HexMesh part;
  part.Hexes.reserve(ids.size());
  for (Index id : ids)
  {
    part.Hexes.push_back(mesh.Hexes[id]);
    Hex& hex = part.Hexes.back();
    std::transform(hex.begin(), hex.end(), hex.begin(), std::ref(pick));
  }
  part.Points = std::move(pick.Picked);
  GridFromMesh(part, output);
  CopyRows(grid->GetCellData(), ids, output->GetCellData());
}

void PassArrays(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output)
{
  output->GetPointData()->PassData(input->GetPointData());
  output->GetCellData()->PassData(input->GetCellData());
  output->GetFieldData()->PassData(input->GetFieldData());
  for (const char* name :
    { ArrayNames::ScaledJacobian, ArrayNames::Certified, ArrayNames::Defects })
  {
    output->GetCellData()->RemoveArray(name);
  }
}

void CopyRows(
  vtkDataSetAttributes* from, const std::vector<Index>& source, vtkDataSetAttributes* to)
{
  to->CopyAllOn();
  to->CopyAllocate(from, static_cast<vtkIdType>(source.size()));
  for (std::size_t i = 0; i < source.size(); ++i)
  {
    to->CopyData(from, source[i], static_cast<vtkIdType>(i));
  }
}

//--- octrees and refinement points ----------------------------------------------------------------
void GridFromOctree(const BlockOctree& octree, vtkUnstructuredGrid* output)
{
  const OctreeCells cells = ListOctreeCells(octree);
  const bool turned = octree.Axes != Mat3(Mat3::Identity());
  // Corners are integers below 2^21: they pack into one key. Ids by first use, so that the order
  // doesn't depend on the hash.
  std::unordered_map<std::uint64_t, Index> idOf;
  std::vector<Vec3> points;
  std::vector<Hex> voxels(cells.Level.size());
  std::vector<int> level(cells.Level.size());
  vtkNew<vtkIntArray> index;
  index->SetName(ArrayNames::OctreeIndex);
  index->SetNumberOfComponents(3);
  index->SetNumberOfTuples(static_cast<vtkIdType>(voxels.size()));
  for (std::size_t c = 0; c < voxels.size(); ++c)
  {
    const std::array<int, 3>& low = cells.OctreeIndex[c];
    const int size = 1 << (octree.Depth - cells.Level[c]);
    for (int i = 0; i < 8; ++i)
    {
      const std::array<std::uint64_t, 3> corner = { std::uint64_t(low[0] + (i & 1 ? size : 0)),
        std::uint64_t(low[1] + (i & 2 ? size : 0)), std::uint64_t(low[2] + (i & 4 ? size : 0)) };
      const auto [place, isNew] = idOf.try_emplace(
        corner[0] | corner[1] << 21 | corner[2] << 42, static_cast<Index>(points.size()));
      if (isNew)
      {
        points.push_back(octree.ToModel(Vec3(corner[0], corner[1], corner[2])));
      }
      voxels[c][i] = place->second;
    }
    if (turned) // A voxel is axis-parallel by definition.
    {
      std::swap(voxels[c][2], voxels[c][3]);
      std::swap(voxels[c][6], voxels[c][7]);
    }
    index->SetTypedTuple(static_cast<vtkIdType>(c), low.data());
    level[c] = cells.Level[c] - octree.BaseLevel;
  }
  output->SetPoints(PointsTo(points));
  output->SetCells(turned ? VTK_HEXAHEDRON : VTK_VOXEL, CellsTo(voxels));
  output->GetCellData()->AddArray(index);
  AddArray(output->GetCellData(), ArrayNames::Level, level);

  vtkFieldData* field = output->GetFieldData();
  const auto addVector = [field](const char* name, const double* values, int count)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(count);
    array->InsertNextTuple(values);
    field->AddArray(array);
  };
  addVector(ArrayNames::OctreeOrigin, octree.Origin.data(), 3);
  addVector(ArrayNames::OctreeAxes, octree.Axes.data(), 9); // columns first: one axis after another
  AddArray(field, ArrayNames::OctreeFinestCellSize, std::vector<double>{ octree.FinestCellSize });
  AddArray(field, ArrayNames::OctreeDepth, std::vector<int>{ octree.Depth });
  AddArray(field, ArrayNames::OctreeBaseLevel, std::vector<int>{ octree.BaseLevel });
  AddArray(
    field, ArrayNames::TargetEdgeLength, std::vector<double>{ octree.CellSize(octree.BaseLevel) });
}

Status OctreeFromGrid(vtkUnstructuredGrid* grid, BlockOctree& octree)
{
  const auto missing = [](const char* name)
  {
    return Status(StatusCode::InvalidMesh, std::string("The octree has no proper array ") + name +
                                             ". Give the output of the Surface Octree filter.");
  };
  vtkFieldData* field = grid->GetFieldData();
  vtkDataArray* origin = field->GetArray(ArrayNames::OctreeOrigin);
  vtkDataArray* axes = field->GetArray(ArrayNames::OctreeAxes);
  if (!origin || origin->GetNumberOfValues() != 3)
  {
    return missing(ArrayNames::OctreeOrigin);
  }
  if (!axes || axes->GetNumberOfValues() != 9)
  {
    return missing(ArrayNames::OctreeAxes);
  }
  for (int i = 0; i < 9; ++i)
  {
    octree.Axes.data()[i] = axes->GetVariantValue(i).ToDouble();
    octree.Origin[i % 3] = origin->GetVariantValue(i % 3).ToDouble();
  }
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double depth = FieldValue(field, ArrayNames::OctreeDepth, none);
  const double base = FieldValue(field, ArrayNames::OctreeBaseLevel, none);
  octree.FinestCellSize = FieldValue(field, ArrayNames::OctreeFinestCellSize, none);
  if (!(octree.FinestCellSize > 0) || !octree.Origin.allFinite() || !octree.Axes.allFinite())
  {
    return missing(ArrayNames::OctreeFinestCellSize);
  }
  if (!(depth >= 0 && depth < 32))
  {
    return missing(ArrayNames::OctreeDepth);
  }
  if (!(base >= 0 && base <= depth))
  {
    return missing(ArrayNames::OctreeBaseLevel);
  }
  octree.Depth = static_cast<int>(depth);
  octree.BaseLevel = static_cast<int>(base);

  OctreeCells cells;
  const char* hint = "the Surface Octree filter makes it";
  const Status status = ReadCellArray(grid, ArrayNames::Level, hint, cells.Level);
  if (!status.Ok())
  {
    return status;
  }
  vtkDataArray* index = grid->GetCellData()->GetArray(ArrayNames::OctreeIndex);
  if (!index || index->GetNumberOfComponents() != 3)
  {
    return missing(ArrayNames::OctreeIndex);
  }
  cells.OctreeIndex.resize(cells.Level.size());
  for (std::size_t c = 0; c < cells.Level.size(); ++c)
  {
    cells.Level[c] += octree.BaseLevel;
    double tuple[3];
    index->GetTuple(static_cast<vtkIdType>(c), tuple);
    for (int i = 0; i < 3; ++i)
    {
      if (!(std::abs(tuple[i]) < 1e9))
      {
        return missing(ArrayNames::OctreeIndex);
      }
      cells.OctreeIndex[c][i] = static_cast<int>(tuple[i]);
    }
  }
  return RebuildBlockOctree(cells, octree);
}

Status AppendRefinementPoints(vtkPolyData* input, std::vector<RefinementPoint>& points)
{
  vtkDataArray* level = input->GetPointData()->GetArray(ArrayNames::Level);
  for (vtkIdType i = 0; i < input->GetNumberOfPoints(); ++i)
  {
    RefinementPoint point;
    input->GetPoint(i, point.Position.data());
    const double wanted = level ? level->GetComponent(i, 0) : 1.0;
    if (!point.Position.allFinite() || !std::isfinite(wanted))
    {
      return Status(StatusCode::NonFinite,
        "Refinement point " + std::to_string(i) + " is not finite (NaN or infinite).");
    }
    point.Level = static_cast<int>(std::clamp(wanted, 0.0, 30.0));
    points.push_back(point);
  }
  return Status();
}

void PolyDataFromRefinementPoints(
  const std::vector<std::pair<RefinementPoint, std::string>>& points, vtkPolyData* output)
{
  std::vector<Vec3> positions;
  std::vector<std::array<Index, 1>> vertices;
  std::vector<int> levels;
  std::vector<std::string> reasons;
  for (const auto& [point, reason] : points)
  {
    vertices.push_back({ static_cast<Index>(positions.size()) });
    positions.push_back(point.Position);
    levels.push_back(point.Level);
    reasons.push_back(reason);
  }
  output->SetPoints(PointsTo(positions));
  output->SetVerts(CellsTo(vertices));
  AddArray(output->GetPointData(), ArrayNames::Level, levels);
  AddArray(output->GetPointData(), ArrayNames::Reason, reasons);
}

//--- arrays and figures ---------------------------------------------------------------------------
void AddArray(vtkFieldData* data, const char* name, const std::vector<int>& values)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data->AddArray(array);
}

void AddArray(vtkFieldData* data, const char* name, const std::vector<double>& values)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data->AddArray(array);
}

void AddArray(vtkFieldData* data, const char* name, const std::vector<std::string>& values)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& value : values)
  {
    array->InsertNextValue(value);
  }
  data->AddArray(array);
}

Status ReadCellArray(
  vtkUnstructuredGrid* grid, const char* name, const char* hint, std::vector<int>& values)
{
  vtkDataArray* array = grid->GetCellData()->GetArray(name);
  if (!array || array->GetNumberOfComponents() != 1)
  {
    return Status(StatusCode::InvalidMesh,
      std::string("The cells have no array ") + name + " of one number per cell: " + hint + ".");
  }
  values.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const double value = array->GetComponent(static_cast<vtkIdType>(i), 0);
    if (!(std::abs(value) < 2e9))
    {
      return Status(StatusCode::InvalidMesh, std::string("The cell array ") + name +
                                               " has no usable number for cell " +
                                               std::to_string(i) + ".");
    }
    values[i] = static_cast<int>(value);
  }
  return Status();
}

double FieldValue(vtkFieldData* data, const char* name, double otherwise)
{
  vtkDataArray* array = data->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : otherwise;
}

void FigureRow::Write(vtkFieldData* data) const
{
  for (const auto& [name, value] : this->Numbers)
  {
    AddArray(data, name.c_str(), std::vector<double>{ value });
  }
  for (const auto& [name, value] : this->Texts)
  {
    AddArray(data, name.c_str(), std::vector<std::string>{ value });
  }
}

void FigureRow::Write(vtkTable* table) const
{
  this->Write(table->GetRowData());
}
} // namespace featurehex

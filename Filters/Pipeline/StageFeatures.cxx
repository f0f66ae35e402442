// SPDX-License-Identifier: BSD-3-Clause
#include "StageFeatures.h"

#include "ArrayNames.h"
#include "FeatureConversion.h"
#include "HexFeatureConversion.h"

#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <limits>
#include <map>
#include <string>

namespace featurehex
{
namespace
{
Status Damaged(const std::string& what)
{
  return Status(StatusCode::InvalidMesh,
    "The features of the hex mesh can't be used: " + what +
      ". Take the mesh as Hex Feature Mapping or a stage after it made it.");
}

/// Rows of integers; ids of points below @a points, the last number of a row below a limit of
/// sanity.
template <std::size_t Size>
Status ReadRows(vtkUnstructuredGrid* grid, const char* name,
  std::vector<std::array<Index, Size>>& rows)
{
  vtkDataArray* array = grid->GetFieldData()->GetArray(name);
  if (!array || array->GetNumberOfComponents() != static_cast<int>(Size))
  {
    return Damaged(std::string("no field data array ") + name + " of " + std::to_string(Size) +
      " components");
  }
  const double points = static_cast<double>(grid->GetNumberOfPoints());
  rows.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    for (std::size_t k = 0; k < Size; ++k)
    {
      const double value = array->GetComponent(static_cast<vtkIdType>(i), static_cast<int>(k));
      const double limit = k + 1 < Size ? points : std::numeric_limits<Index>::max();
      if (!(value >= 0.0 && value < limit))
      {
        return Damaged(std::string("row ") + std::to_string(i) + " of " + name +
          " has a number that is no id");
      }
      rows[i][k] = static_cast<Index>(value);
    }
  }
  return Status();
}

Quad Sorted(Quad quad)
{
  std::sort(quad.begin(), quad.end());
  return quad;
}

Status ReadPatches(
  vtkUnstructuredGrid* grid, const std::vector<Quad>& quads, HexFeatures& features)
{
  std::vector<std::array<Index, 5>> rows;
  const Status status = ReadRows(grid, ArrayNames::FeatureQuads, rows);
  if (!status.Ok())
  {
    return status;
  }
  std::map<Quad, int> patches;
  for (const auto& row : rows)
  {
    patches[Sorted({ row[0], row[1], row[2], row[3] })] = row[4];
  }
  for (const Quad& quad : quads)
  {
    const auto found = patches.find(Sorted(quad));
    if (found == patches.end())
    {
      return Damaged("the quad of points " + std::to_string(quad[0]) + ", " +
        std::to_string(quad[1]) + ", " + std::to_string(quad[2]) + ", " +
        std::to_string(quad[3]) + " has no patch");
    }
    features.PatchOfQuad.push_back(found->second);
  }
  return Status();
}

Status ReadPaths(vtkUnstructuredGrid* grid, HexFeatures& features)
{
  std::vector<std::array<Index, 3>> rows;
  const Status status = ReadRows(grid, ArrayNames::FeatureEdges, rows);
  if (!status.Ok())
  {
    return status;
  }
  for (const auto& [first, second, curve] : rows)
  {
    // A curve has an edge at least: a higher id would only cost memory.
    if (static_cast<vtkIdType>(curve) >= grid->GetNumberOfPoints())
    {
      return Damaged("there is no curve " + std::to_string(curve));
    }
    features.CurvePaths.resize(std::max<std::size_t>(features.CurvePaths.size(), curve + 1));
    std::vector<Index>& path = features.CurvePaths[curve];
    if (path.empty())
    {
      path.push_back(first);
    }
    if (path.back() != first)
    {
      return Damaged("the edges of curve " + std::to_string(curve) + " are no chain");
    }
    path.push_back(second);
  }
  return Status();
}

Status ReadCorners(vtkUnstructuredGrid* grid, HexFeatures& features)
{
  FeatureLabels labels;
  const Status status = LabelsFromGrid(grid, labels);
  if (!status.Ok())
  {
    return status;
  }
  for (std::size_t v = 0; v < labels.Kind.size(); ++v)
  {
    if (labels.Kind[v] != FeatureKind::Corner)
    {
      continue;
    }
    const Index corner = labels.Id[v];
    if (corner < 0 || static_cast<vtkIdType>(corner) >= grid->GetNumberOfPoints())
    {
      return Damaged("there is no corner " + std::to_string(corner));
    }
    features.CornerVertices.resize(
      std::max<std::size_t>(features.CornerVertices.size(), corner + 1), -1);
    if (features.CornerVertices[corner] >= 0)
    {
      return Damaged("two points are corner " + std::to_string(corner));
    }
    features.CornerVertices[corner] = static_cast<Index>(v);
  }
  return Status();
}
} // namespace

bool HasHexFeatures(vtkUnstructuredGrid* grid)
{
  return grid->GetFieldData()->HasArray(ArrayNames::FeatureQuads) != 0;
}

Status HexFeaturesFromGrid(
  vtkUnstructuredGrid* grid, const std::vector<Quad>& quads, HexFeatures& features)
{
  features = HexFeatures();
  Status status = ReadPatches(grid, quads, features);
  if (status.Ok())
  {
    status = ReadPaths(grid, features);
  }
  if (status.Ok())
  {
    status = ReadCorners(grid, features);
  }
  return status;
}

Status StageFeatures::Read(const SurfaceMesh& surface, vtkPolyData* graph, double edgeLength)
{
  const Status status = graph ? FeaturesFromPolyData(surface, graph, this->Graph) : Status();
  if (status.Ok() && !this->Graph.Curves.empty())
  {
    this->Prepared =
      std::make_unique<FeatureGeometry>(surface, this->Graph, TrimCells * edgeLength);
  }
  return status;
}

bool StageFeatures::Agree() const
{
  const std::vector<Index>& corners = this->OfMesh.CornerVertices;
  const std::vector<std::vector<Index>>& paths = this->OfMesh.CurvePaths;
  if (corners.size() > this->Graph.Corners.size() || paths.size() > this->Graph.Curves.size())
  {
    return false;
  }
  for (std::size_t c = 0; c < this->Graph.Corners.size(); ++c)
  {
    const bool mapped = c < corners.size() && corners[c] >= 0;
    if (mapped != this->Prepared->Enforced(static_cast<Index>(c)))
    {
      return false;
    }
  }
  for (std::size_t c = 0; c < this->Graph.Curves.size(); ++c)
  {
    const bool mapped = c < paths.size() && !paths[c].empty();
    if (mapped == this->Prepared->Curves()[c].Points.empty())
    {
      return false;
    }
  }
  const std::vector<int>& patches = this->OfMesh.PatchOfQuad;
  return std::all_of(patches.begin(), patches.end(),
    [this](int patch) { return patch < this->Graph.NumberOfPatches; });
}

Status StageFeatures::ReadMapped(
  vtkUnstructuredGrid* grid, const std::vector<Quad>& quads, std::string& warning)
{
  const bool mapped = HasHexFeatures(grid);
  if (!mapped || !this->Any())
  {
    warning =
      mapped ? "The features of the mesh are not used: connect the surface and its feature graph."
      : this->Any()
        ? "The feature graph is not used: the mesh has no features. Hex Feature Mapping, "
          "before Hex Padding, gives it some."
        : "";
    return Status();
  }
  const Status status = HexFeaturesFromGrid(grid, quads, this->OfMesh);
  if (!status.Ok())
  {
    return status;
  }
  if (!this->Agree())
  {
    return Damaged(
      "they are not those of the feature graph, which has to be the same for all stages");
  }
  this->OfMesh.CornerVertices.resize(this->Graph.Corners.size(), -1);
  this->OfMesh.CurvePaths.resize(this->Graph.Curves.size());
  return Status();
}

Status StageFeatures::ReadTargets(
  vtkObject* stage, vtkUnstructuredGrid* grid, const HexMesh& mesh, const HexStars& stars)
{
  std::string warning;
  const Status status = this->ReadMapped(grid, stars.Quads, warning);
  if (!status.Ok())
  {
    return status;
  }
  if (!warning.empty())
  {
    vtkWarningWithObjectMacro(stage, << warning);
  }
  if (!this->OfMesh.Empty())
  {
    this->OfPoints =
      std::make_unique<FeatureTargets>(*this->Prepared, this->OfMesh, stars, mesh.Points);
  }
  return status;
}
} // namespace featurehex

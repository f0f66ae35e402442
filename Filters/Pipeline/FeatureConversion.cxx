// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureConversion.h"

#include "ArrayNames.h"
#include "DataConversion.h"
#include "SurfacePoints.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>

namespace featurehex
{
namespace
{
/// SurfacePointId of each point, -1 where it can't be one; empty without the array.
std::vector<Index> NamedIds(vtkPointSet* input)
{
  vtkDataArray* array = input->GetPointData()->GetArray(ArrayNames::SurfacePointId);
  std::vector<Index> ids;
  if (array)
  {
    ids.resize(static_cast<std::size_t>(input->GetNumberOfPoints()), -1);
    for (std::size_t i = 0; i < ids.size(); ++i)
    {
      const double id = array->GetComponent(static_cast<vtkIdType>(i), 0);
      if (id >= 0.0 && id < std::numeric_limits<Index>::max())
      {
        ids[i] = static_cast<Index>(id);
      }
    }
  }
  return ids;
}

/// What keeps a corner of the graph enforced: its FeatureValid.
void RestoreValidity(vtkPolyData* graph, const std::vector<Index>& corners, std::size_t points,
  SurfaceFeatures& features)
{
  vtkDataArray* valid = graph->GetCellData()->GetArray(ArrayNames::FeatureValid);
  if (!valid || graph->GetNumberOfVerts() != static_cast<vtkIdType>(corners.size()))
  {
    return;
  }
  const std::vector<Index> cornerOfPoint = CornersOfPoints(features, points);
  for (std::size_t c = 0; c < corners.size(); ++c)
  {
    if (valid->GetComponent(static_cast<vtkIdType>(c), 0) != 0.0)
    {
      features.Corners[cornerOfPoint[corners[c]]].Flaw = CornerFlaw::None;
    }
  }
}
} // namespace

void PolyDataFromFeatures(
  const SurfaceMesh& surface, const SurfaceFeatures& features, vtkPolyData* output)
{
  std::vector<Index> used;
  for (const FeatureCorner& corner : features.Corners)
  {
    used.push_back(corner.Point);
  }
  for (const FeatureCurve& curve : features.Curves)
  {
    used.insert(used.end(), curve.Points.begin(), curve.Points.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  const auto local = [&used](Index id)
  { return static_cast<vtkIdType>(std::lower_bound(used.begin(), used.end(), id) - used.begin()); };

  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(ArrayNames::SurfacePointId);
  for (const Index id : used)
  {
    points->InsertNextPoint(surface.Points[id].data());
    ids->InsertNextValue(id);
  }
  std::vector<int> cornerIds, curveIds, valid;
  vtkNew<vtkCellArray> corners;
  for (const FeatureCorner& corner : features.Corners)
  {
    corners->InsertNextCell({ local(corner.Point) });
    cornerIds.push_back(static_cast<int>(cornerIds.size()));
    curveIds.push_back(-1);
    valid.push_back(corner.Valid());
  }
  vtkNew<vtkCellArray> curves;
  for (std::size_t c = 0; c < features.Curves.size(); ++c)
  {
    curves->InsertNextCell(static_cast<int>(features.Curves[c].Points.size()));
    for (const Index id : features.Curves[c].Points)
    {
      curves->InsertCellPoint(local(id));
    }
    cornerIds.push_back(-1);
    curveIds.push_back(static_cast<int>(c));
    valid.push_back(1);
  }
  output->SetPoints(points);
  output->GetPointData()->AddArray(ids);
  output->SetVerts(corners);
  output->SetLines(curves);
  AddArray(output->GetCellData(), ArrayNames::CornerId, cornerIds);
  AddArray(output->GetCellData(), ArrayNames::CurveId, curveIds);
  AddArray(output->GetCellData(), ArrayNames::FeatureValid, valid);
}

Status AnnotationFromPointSet(
  const SurfaceMesh& surface, vtkPointSet* input, FeatureAnnotation& annotation, Index& otherCells)
{
  annotation = FeatureAnnotation();
  otherCells = 0;
  if (input->GetNumberOfCells() == 0)
  {
    return Status();
  }
  std::vector<Vec3> places(static_cast<std::size_t>(input->GetNumberOfPoints()));
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    input->GetPoint(static_cast<vtkIdType>(i), places[i].data());
  }
  const std::vector<Index> ids = RecognizeSurfacePoints(surface, places, NamedIds(input));
  vtkIdType unknown = -1;
  const auto resolve = [&](vtkIdType point)
  {
    const bool exists = point >= 0 && point < static_cast<vtkIdType>(ids.size());
    const Index id = exists ? ids[point] : -1;
    unknown = id < 0 && unknown < 0 ? std::max<vtkIdType>(point, 0) : unknown;
    return id;
  };
  vtkNew<vtkIdList> cell;
  for (vtkIdType c = 0; c < input->GetNumberOfCells(); ++c)
  {
    const int type = input->GetCellType(c);
    input->GetCellPoints(c, cell);
    if (type == VTK_VERTEX || type == VTK_POLY_VERTEX)
    {
      for (vtkIdType i = 0; i < cell->GetNumberOfIds(); ++i)
      {
        annotation.Corners.push_back(resolve(cell->GetId(i)));
      }
    }
    else if (type == VTK_LINE || type == VTK_POLY_LINE)
    {
      for (vtkIdType i = 1; i < cell->GetNumberOfIds(); ++i)
      {
        annotation.Edges.push_back({ resolve(cell->GetId(i - 1)), resolve(cell->GetId(i)) });
      }
    }
    else
    {
      ++otherCells;
    }
  }
  if (unknown >= 0)
  {
    return UnknownSurfacePoint(unknown, places);
  }
  return Status();
}

Status FeaturesFromPolyData(
  const SurfaceMesh& surface, vtkPolyData* graph, SurfaceFeatures& features)
{
  FeatureAnnotation annotation;
  FeatureGraphOptions options;
  Index otherCells = 0;
  if (graph)
  {
    const Status status = AnnotationFromPointSet(surface, graph, annotation, otherCells);
    if (!status.Ok())
    {
      return status;
    }
    // A graph that lists its corners has all of them.
    options.CornerAngle =
      graph->GetCellData()->HasArray(ArrayNames::CornerId) ? 0.0 : options.CornerAngle;
  }
  FeatureGraphReport report;
  const Status status =
    BuildSurfaceFeatures(surface, annotation.Edges, annotation.Corners, options, features, report);
  if (status.Ok() && graph)
  {
    RestoreValidity(graph, annotation.Corners, surface.Points.size(), features);
  }
  return status;
}
} // namespace featurehex

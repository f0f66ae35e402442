// SPDX-License-Identifier: BSD-3-Clause
#include "HexFeatureConversion.h"

#include "ArrayNames.h"
#include "DataConversion.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <limits>
#include <map>

namespace featurehex
{
namespace
{
/// Cells of a feature graph in the making.
class GraphBuilder
{
public:
  GraphBuilder(const std::vector<Vec3>& points, vtkPolyData* output)
    : MeshPoints(points)
    , Output(output)
  {
    this->Points->SetDataTypeToDouble();
    this->PointIds->SetName(ArrayNames::MeshPointId);
  }

  void Add(vtkCellArray* cells, const std::vector<Index>& chain)
  {
    cells->InsertNextCell(static_cast<int>(chain.size()));
    for (Index v : chain)
    {
      const auto [it, fresh] = this->Local.insert({ v, this->Points->GetNumberOfPoints() });
      if (fresh)
      {
        this->Points->InsertNextPoint(this->MeshPoints[v].data());
        this->PointIds->InsertNextValue(v);
      }
      cells->InsertCellPoint(it->second);
    }
  }

  void Label(int corner, int curve, const FeatureFinding& finding)
  {
    this->CornerId.push_back(corner);
    this->CurveId.push_back(curve);
    this->Captured.push_back(finding.Captured());
    this->Deviation.push_back(finding.Deviation);
  }

  void Finish(vtkCellArray* corners, vtkCellArray* curves)
  {
    this->Output->SetPoints(this->Points);
    this->Output->SetVerts(corners);
    this->Output->SetLines(curves);
    this->Output->GetPointData()->AddArray(this->PointIds);
    AddArray(this->Output->GetCellData(), ArrayNames::CornerId, this->CornerId);
    AddArray(this->Output->GetCellData(), ArrayNames::CurveId, this->CurveId);
    AddArray(this->Output->GetCellData(), ArrayNames::Captured, this->Captured);
    AddArray(this->Output->GetCellData(), ArrayNames::Deviation, this->Deviation);
  }

private:
  const std::vector<Vec3>& MeshPoints;
  vtkPolyData* Output;
  vtkNew<vtkPoints> Points;
  vtkNew<vtkIdTypeArray> PointIds;
  std::map<Index, vtkIdType> Local;
  std::vector<int> CornerId, CurveId, Captured;
  std::vector<double> Deviation;
};

Status MissingLabels(const char* name)
{
  return Status(StatusCode::InvalidMesh,
    std::string("Features are measured by the point arrays FeatureKind and FeatureId of the mesh, "
                "but ") +
      name + ". Use a mesh that FeatureHex made, in .vtu, .vtk or .mesh.");
}
} // namespace

void AddLabels(const FeatureLabels& labels, vtkFieldData* points)
{
  std::vector<int> kinds;
  kinds.reserve(labels.Kind.size());
  for (FeatureKind kind : labels.Kind)
  {
    kinds.push_back(static_cast<int>(kind));
  }
  AddArray(points, ArrayNames::FeatureKind, kinds);
  AddArray(points, ArrayNames::FeatureId, labels.Id);
}

void AddElements(
  const HexFeatures& features, const std::vector<Quad>& quads, vtkFieldData* fields)
{
  vtkNew<vtkIntArray> quadRows;
  quadRows->SetName(ArrayNames::FeatureQuads);
  quadRows->SetNumberOfComponents(5);
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    for (Index v : quads[q])
    {
      quadRows->InsertNextValue(v);
    }
    quadRows->InsertNextValue(features.PatchOfQuad[q]);
  }
  vtkNew<vtkIntArray> edgeRows;
  edgeRows->SetName(ArrayNames::FeatureEdges);
  edgeRows->SetNumberOfComponents(3);
  for (std::size_t c = 0; c < features.CurvePaths.size(); ++c)
  {
    for (std::size_t i = 1; i < features.CurvePaths[c].size(); ++i)
    {
      edgeRows->InsertNextValue(features.CurvePaths[c][i - 1]);
      edgeRows->InsertNextValue(features.CurvePaths[c][i]);
      edgeRows->InsertNextValue(static_cast<int>(c));
    }
  }
  fields->AddArray(quadRows);
  fields->AddArray(edgeRows);
}

Status LabelsFromGrid(vtkUnstructuredGrid* grid, FeatureLabels& labels)
{
  vtkDataArray* kinds = grid->GetPointData()->GetArray(ArrayNames::FeatureKind);
  vtkDataArray* ids = grid->GetPointData()->GetArray(ArrayNames::FeatureId);
  if (!kinds || !ids)
  {
    return MissingLabels("one is missing");
  }
  const vtkIdType count = grid->GetNumberOfPoints();
  labels.Kind.resize(static_cast<std::size_t>(count));
  labels.Id.resize(static_cast<std::size_t>(count));
  for (vtkIdType v = 0; v < count; ++v)
  {
    const double kind = kinds->GetComponent(v, 0);
    const double id = ids->GetComponent(v, 0);
    if (!(kind >= 0.0 && kind <= 3.0))
    {
      return MissingLabels("a value of FeatureKind is not 0, 1, 2 or 3");
    }
    labels.Kind[v] = static_cast<FeatureKind>(static_cast<int>(kind));
    labels.Id[v] =
      id >= 0.0 && id < std::numeric_limits<Index>::max() ? static_cast<Index>(id) : -1;
  }
  return Status();
}

void PolyDataFromHexFeatures(const std::vector<Vec3>& points, const HexFeatures& features,
  const FeatureValidationReport& report, vtkPolyData* output)
{
  GraphBuilder graph(points, output);
  vtkNew<vtkCellArray> corners, curves;
  for (std::size_t c = 0; c < features.CornerVertices.size(); ++c)
  {
    if (features.CornerVertices[c] >= 0)
    {
      graph.Add(corners, { features.CornerVertices[c] });
      graph.Label(static_cast<int>(c), -1, report.Corners[c]);
    }
  }
  for (std::size_t c = 0; c < features.CurvePaths.size(); ++c)
  {
    if (!features.CurvePaths[c].empty())
    {
      graph.Add(curves, features.CurvePaths[c]);
      graph.Label(-1, static_cast<int>(c), report.Curves[c]);
    }
  }
  graph.Finish(corners, curves);
}

void TableFromFindings(const FeatureValidationReport& report, vtkTable* table)
{
  std::vector<std::string> kinds, outcomes, reasons;
  std::vector<int> ids;
  std::vector<double> deviations, vertexDeviations, places[3];
  const auto add = [&](const char* kind, const std::vector<FeatureFinding>& findings) {
    for (std::size_t i = 0; i < findings.size(); ++i)
    {
      kinds.emplace_back(kind);
      ids.push_back(static_cast<int>(i));
      outcomes.emplace_back(FeatureOutcomeName(findings[i].Outcome));
      reasons.push_back(findings[i].Reason);
      deviations.push_back(findings[i].Deviation);
      vertexDeviations.push_back(findings[i].VertexDeviation);
      for (int k = 0; k < 3; ++k)
      {
        places[k].push_back(findings[i].Where[k]);
      }
    }
  };
  add("corner", report.Corners);
  add("curve", report.Curves);
  add("patch", report.Patches);
  vtkFieldData* rows = table->GetRowData();
  AddArray(rows, "Kind", kinds);
  AddArray(rows, "Id", ids);
  AddArray(rows, "Outcome", outcomes);
  AddArray(rows, ArrayNames::Reason, reasons);
  AddArray(rows, ArrayNames::Deviation, deviations);
  AddArray(rows, "VertexDeviation", vertexDeviations);
  const char* axes[] = { "X", "Y", "Z" };
  for (int k = 0; k < 3; ++k)
  {
    AddArray(rows, axes[k], places[k]);
  }
}
} // namespace featurehex

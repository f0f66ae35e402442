// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureGraphReader.h"

#include "ArrayNames.h"
#include "FeatureGraphFile.h"
#include "FileAccess.h"
#include "GuardedVTKFiles.h"
#include "TextScanner.h"

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkFeatureGraphReader);

namespace
{
std::vector<featurehex::Index> UsedPoints(const featurehex::FeatureGraph& graph)
{
  std::vector<featurehex::Index> used = graph.Corners;
  for (const auto& edge : graph.Edges)
  {
    used.insert(used.end(), edge.begin(), edge.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  return used;
}

template <typename ArrayType, typename Value>
void AddFieldValue(vtkPolyData* output, const char* name, Value value)
{
  vtkNew<ArrayType> array;
  array->SetName(name);
  array->InsertNextValue(value);
  output->GetFieldData()->AddArray(array);
}

void ToPolyData(const featurehex::FeatureGraph& graph, vtkPolyData* surface, vtkPolyData* output)
{
  const std::vector<featurehex::Index> used = UsedPoints(graph);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName(featurehex::ArrayNames::SurfacePointId);
  for (const featurehex::Index id : used)
  {
    double point[3] = {};
    if (surface)
    {
      surface->GetPoint(id, point);
    }
    points->InsertNextPoint(point);
    ids->InsertNextValue(id);
  }
  const auto local = [&used](featurehex::Index id)
  { return static_cast<vtkIdType>(std::lower_bound(used.begin(), used.end(), id) - used.begin()); };
  vtkNew<vtkCellArray> corners;
  for (const featurehex::Index corner : graph.Corners)
  {
    corners->InsertNextCell({ local(corner) });
  }
  vtkNew<vtkCellArray> edges;
  for (const auto& edge : graph.Edges)
  {
    edges->InsertNextCell({ local(edge[0]), local(edge[1]) });
  }
  output->SetPoints(points);
  output->GetPointData()->AddArray(ids);
  output->SetVerts(corners);
  output->SetLines(edges);
  AddFieldValue<vtkDoubleArray>(output, featurehex::ArrayNames::FeatureAngle, graph.Angle);
  AddFieldValue<vtkIntArray>(output, featurehex::ArrayNames::OrphanCurve, graph.OrphanCurve);
  AddFieldValue<vtkIntArray>(
    output, featurehex::ArrayNames::OrphanCurveSingle, graph.OrphanCurveSingle);
}

featurehex::Status ReadInto(const char* fileName, vtkPolyData* surface, vtkPolyData* output)
{
  featurehex::FeatureGraph graph;
  featurehex::Status status =
    featurehex::ReadFeatureGraph(fileName, surface ? surface->GetNumberOfPoints() : -1, graph);
  if (status.Ok())
  {
    ToPolyData(graph, surface, output);
  }
  return status;
}
} // namespace

vtkFeatureGraphReader::vtkFeatureGraphReader()
{
  this->SetNumberOfInputPorts(1);
}

vtkFeatureGraphReader::~vtkFeatureGraphReader()
{
  this->SetFileName(nullptr);
}

int vtkFeatureGraphReader::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  return 1;
}

int vtkFeatureGraphReader::CanReadFile(const char* name)
{
  std::string head;
  if (!name || !featurehex::ReadFileHead(name, head))
  {
    return 0;
  }
  featurehex::TextScanner scanner(head);
  std::string_view word;
  double angle = 0.0;
  bool good = scanner.Word(word) && featurehex::ParseReal(word, angle);
  for (int i = 0; i < 4 && good; ++i)
  {
    std::int64_t value = 0;
    good = scanner.Word(word) && featurehex::ParseInteger(word, value) && value >= 0 &&
           (i >= 2 || value <= 1);
  }
  return good;
}

int vtkFeatureGraphReader::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector);
  vtkPolyData* surface = vtkPolyData::GetData(inputVector[0]);
  const featurehex::Status status =
    featurehex::Guarded(this->FileName, [&] { return ReadInto(this->FileName, surface, output); });
  this->SetErrorCode(featurehex::ErrorCodeOf(status));
  if (!status.Ok())
  {
    output->Initialize();
    vtkErrorMacro(<< status.Message);
    return 0;
  }
  return 1;
}

void vtkFeatureGraphReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}

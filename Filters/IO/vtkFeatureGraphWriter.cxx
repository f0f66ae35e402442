// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureGraphWriter.h"

#include "ArrayNames.h"
#include "FeatureGraphFile.h"
#include "GuardedVTKFiles.h"

#include "vtkCellArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <limits>
#include <vector>

vtkStandardNewMacro(vtkFeatureGraphWriter);

namespace
{
double FieldValue(vtkPolyData* input, const char* name, double fallback)
{
  vtkDataArray* array = input->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 ? array->GetComponent(0, 0) : fallback;
}

/// Ids of the surface for the points of the input; -1 where there is none.
std::vector<featurehex::Index> SurfaceIds(vtkDataArray* array)
{
  std::vector<featurehex::Index> ids(static_cast<std::size_t>(array->GetNumberOfTuples()), -1);
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const double id = array->GetComponent(static_cast<vtkIdType>(i), 0);
    if (id >= 0 && id < std::numeric_limits<featurehex::Index>::max())
    {
      ids[i] = static_cast<featurehex::Index>(id);
    }
  }
  return ids;
}

featurehex::Status WriteFrom(const char* fileName, vtkPolyData* input)
{
  vtkDataArray* array = input->GetPointData()->GetArray(featurehex::ArrayNames::SurfacePointId);
  if (!array && input->GetNumberOfPoints() > 0)
  {
    return featurehex::Status(featurehex::StatusCode::InvalidOption,
      "The feature graph has no point array SurfacePointId, which says to what points of the "
      "surface the features belong.");
  }
  std::vector<featurehex::Index> ids;
  if (array)
  {
    ids = SurfaceIds(array);
  }
  featurehex::FeatureGraph graph;
  vtkNew<vtkIdList> cell;
  vtkCellArray* corners = input->GetVerts();
  for (vtkIdType c = 0; c < corners->GetNumberOfCells(); ++c)
  {
    corners->GetCellAtId(c, cell);
    for (vtkIdType i = 0; i < cell->GetNumberOfIds(); ++i)
    {
      graph.Corners.push_back(ids[cell->GetId(i)]);
    }
  }
  vtkCellArray* curves = input->GetLines();
  for (vtkIdType c = 0; c < curves->GetNumberOfCells(); ++c)
  {
    curves->GetCellAtId(c, cell);
    for (vtkIdType i = 1; i < cell->GetNumberOfIds(); ++i)
    {
      graph.Edges.push_back({ ids[cell->GetId(i - 1)], ids[cell->GetId(i)] });
    }
  }
  graph.Angle = FieldValue(input, featurehex::ArrayNames::FeatureAngle, 0.0);
  graph.OrphanCurve = FieldValue(input, featurehex::ArrayNames::OrphanCurve, 1.0) != 0.0;
  graph.OrphanCurveSingle =
    FieldValue(input, featurehex::ArrayNames::OrphanCurveSingle, 1.0) != 0.0;
  return featurehex::WriteFeatureGraph(fileName, graph);
}
} // namespace

vtkFeatureGraphWriter::vtkFeatureGraphWriter() = default;

vtkFeatureGraphWriter::~vtkFeatureGraphWriter()
{
  this->SetFileName(nullptr);
}

int vtkFeatureGraphWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

void vtkFeatureGraphWriter::WriteData()
{
  vtkPolyData* input = vtkPolyData::SafeDownCast(this->GetInput());
  const featurehex::Status status =
    featurehex::Guarded(this->FileName, [&] { return WriteFrom(this->FileName, input); });
  this->SetErrorCode(featurehex::ErrorCodeOf(status));
  if (!status.Ok())
  {
    vtkErrorMacro(<< status.Message);
  }
}

void vtkFeatureGraphWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}

// SPDX-License-Identifier: BSD-3-Clause
#include "ReadFeatures.h"

#include "RunAlgorithm.h"

#include "vtkFeatureGraphReader.h"
#include "vtkSurfaceFeatureFilter.h"

#include <vtkNew.h>
#include <vtkPolyData.h>

namespace featurehex
{
Status ReadFeatures(
  const FeatureArguments& arguments, vtkPolyData* surface, RunLog& log, vtkPolyData* graph)
{
  vtkNew<vtkFeatureGraphReader> reader;
  Status status;
  if (!arguments.File.empty())
  {
    reader->SetInputDataObject(surface);
    reader->SetFileName(arguments.File.c_str());
    status = RunAlgorithm(reader, StatusCode::UnreadableFile, log);
    graph->ShallowCopy(reader->GetOutput());
  }
  if (status.Ok() && arguments.ByAngle)
  {
    vtkNew<vtkSurfaceFeatureFilter> features;
    features->SetInputDataObject(0, surface);
    features->SetFeatureAngle(arguments.Angle);
    features->SetEnforceAllFeatures(arguments.EnforceAll);
    if (!arguments.File.empty())
    {
      features->SetInputDataObject(1, reader->GetOutput());
      features->SetAnnotationModeToAdd();
    }
    status = RunAlgorithm(features, StatusCode::Validation, log);
    graph->ShallowCopy(features->GetOutputDataObject(1));
  }
  return status;
}
} // namespace featurehex

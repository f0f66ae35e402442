// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "Figures.h"
#include "ReadFeatures.h"
#include "Report.h"
#include "RunAlgorithm.h"
#include "Threads.h"

#include "vtkHexMeshReader.h"
#include "vtkHexValidationFilter.h"
#include "vtkSurfaceFileReader.h"

#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <cstdio>

namespace featurehex
{
namespace
{
/// Reads and measures; prints the table.
Status Measure(const CheckArguments& arguments, RunLog& log, Report& report)
{
  vtkNew<vtkHexMeshReader> meshReader;
  meshReader->SetFileName(arguments.Mesh.c_str());
  Status status = RunAlgorithm(meshReader, StatusCode::UnreadableFile, log);
  vtkNew<vtkSurfaceFileReader> surfaceReader;
  if (status.Ok() && !arguments.Surface.empty())
  {
    surfaceReader->SetFileName(arguments.Surface.c_str());
    status = RunAlgorithm(surfaceReader, StatusCode::UnreadableFile, log);
  }
  const bool withFeatures = !arguments.Features.File.empty() || arguments.Features.ByAngle;
  vtkNew<vtkPolyData> graph;
  if (status.Ok() && withFeatures)
  {
    status = ReadFeatures(arguments.Features, surfaceReader->GetOutput(), log, graph);
  }
  report.AddStage("Reading", report.Seconds());
  if (!status.Ok())
  {
    return status;
  }

  const double before = report.Seconds();
  vtkNew<vtkHexValidationFilter> validation;
  validation->SetTolerance(arguments.Tolerance);
  validation->SetInputDataObject(0, meshReader->GetOutput());
  if (!arguments.Surface.empty())
  {
    validation->SetInputDataObject(1, surfaceReader->GetOutput());
  }
  if (withFeatures)
  {
    validation->SetInputDataObject(2, graph);
    validation->SetEnforceAllFeatures(arguments.Features.EnforceAll);
  }
  status = RunAlgorithm(validation, StatusCode::Validation, log);
  report.AddStage("Validation", report.Seconds() - before);
  auto* table = vtkTable::SafeDownCast(validation->GetOutputDataObject(1));
  for (const auto& [name, value] : FiguresOf(table))
  {
    report.AddFigure(name, value);
  }
  report.AddFeatures(vtkTable::SafeDownCast(validation->GetOutputDataObject(3)));
  if (!status.Ok())
  {
    return status;
  }
  std::fputs(PromiseTable(table).c_str(), stdout);
  if (FigureOf(table, "Valid") == 0.0)
  {
    return Status(StatusCode::Validation, TextOf(table, "Verdict"));
  }
  const std::string missed = TextOf(table, "FeaturesMissed");
  return missed.empty() ? status
                        : Status(StatusCode::Features, "Features of the surface: " + missed + ".");
}
} // namespace

Status RunCheck(const CheckArguments& arguments)
{
  Report report("check");
  UseThreads(arguments.Threads);
  report["input"] = { { "mesh", arguments.Mesh }, { "surface", arguments.Surface } };
  report["options"] = { { "tolerance", arguments.Tolerance },
    { "features", arguments.Features.File },
    { "feature-angle", arguments.Features.ByAngle ? arguments.Features.Angle : 0.0 },
    { "enforce-all-features", arguments.Features.EnforceAll }, { "threads", arguments.Threads } };
  RunLog log;
  const Status status = Measure(arguments, log, report);
  report.AddLog(log);
  const Status written = report.Write(arguments.Report, status);
  return status.Ok() ? written : status;
}
} // namespace featurehex

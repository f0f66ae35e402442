// SPDX-License-Identifier: BSD-3-Clause
#include "Commands.h"

#include "Figures.h"
#include "FileAccess.h"
#include "ReadFeatures.h"
#include "Report.h"
#include "RunAlgorithm.h"
#include "Threads.h"

#include "vtkFeatureGraphReader.h"
#include "vtkFeatureHexMesher.h"
#include "vtkHexMeshWriter.h"
#include "vtkQuadraticHexFilter.h"
#include "vtkSurfaceFileReader.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <system_error>

namespace featurehex
{
namespace
{
namespace fs = std::filesystem;

/// Writable without touching what is there.
Status CheckWritable(const std::string& path)
{
  PendingFile file;
  return file.Open(path); // the destructor removes it
}

Status CheckDifferent(const std::string& a, const std::string& b)
{
  std::error_code ignored;
  const bool same = a == b || fs::equivalent(a, b, ignored);
  return same ? Status(StatusCode::InvalidOption,
                  "\"" + a + "\" can't be two files of this run; give them different names.")
              : Status();
}

/// Everything that can be said about the names before hours of work.
Status CheckFiles(const MeshArguments& arguments)
{
  const std::string extension = FileExtension(arguments.Output);
  const char* const formats[] = { ".vtu", ".vtk", ".mesh", ".inp", ".msh", ".msh2", ".exo", ".e",
    ".ucd" };
  if (std::find(std::begin(formats), std::end(formats), extension) == std::end(formats))
  {
    return Status(StatusCode::InvalidOption,
      "\"" + arguments.Output +
        "\": hex meshes are written as .vtu, .vtk, .mesh, .inp, .msh, .msh2, .exo, .e or .ucd.");
  }
  const int most = extension == ".mesh" || extension == ".ucd" ? 8 : extension == ".inp" ? 20 : 27;
  if (arguments.NodesPerHex > most)
  {
    return Status(StatusCode::InvalidOption,
      "\"" + arguments.Output + "\": " + extension + " holds hexes of at most " +
        std::to_string(most) + " nodes; --nodes-per-hex asks for " +
        std::to_string(arguments.NodesPerHex) + ".");
  }
  Status status = CheckDifferent(arguments.Input, arguments.Output);
  if (status.Ok())
  {
    status = CheckDifferent(arguments.Features.File, arguments.Output);
  }
  if (status.Ok())
  {
    status = CheckWritable(arguments.Output);
  }
  if (!status.Ok() || arguments.Report.empty())
  {
    return status;
  }
  for (const std::string& other : { arguments.Input, arguments.Features.File, arguments.Output })
  {
    status = CheckDifferent(other, arguments.Report);
    if (!status.Ok())
    {
      return status;
    }
  }
  return CheckWritable(arguments.Report);
}

void AddOptions(const MeshArguments& arguments, Report& report)
{
  report["input"] = { { "file", arguments.Input } };
  report["output"] = { { "file", arguments.Output } };
  report["options"] = { { "tolerance", arguments.Tolerance },
    { "edge-length", arguments.EdgeLength }, { "edge-length-array", arguments.EdgeLengthArray },
    { "features", arguments.Features.File },
    { "feature-angle", arguments.Features.ByAngle ? arguments.Features.Angle : 0.0 },
    { "enforce-all-features", arguments.Features.EnforceAll },
    { "max-level", arguments.MaximumLevel }, { "max-cells", arguments.MaximumNumberOfCells },
    { "max-rounds", arguments.MaximumRounds },
    { "min-scaled-jacobian", arguments.MinimumScaledJacobian }, { "align", arguments.Align },
    { "time-limit", arguments.TimeLimit }, { "nodes-per-hex", arguments.NodesPerHex },
    { "threads", arguments.Threads } };
}

void SetOptions(const MeshArguments& arguments, vtkFeatureHexMesher* mesher)
{
  mesher->SetTolerance(arguments.Tolerance);
  mesher->SetTargetEdgeLength(arguments.EdgeLength);
  mesher->SetEdgeLengthArray(arguments.EdgeLengthArray.c_str());
  mesher->SetMaximumLevel(arguments.MaximumLevel);
  mesher->SetMaximumNumberOfCells(arguments.MaximumNumberOfCells);
  mesher->SetMaximumRounds(arguments.MaximumRounds);
  mesher->SetMinimumScaledJacobian(arguments.MinimumScaledJacobian);
  mesher->SetAlignToPrincipalAxes(arguments.Align);
  mesher->SetTimeLimit(arguments.TimeLimit);
  mesher->SetEnforceAllFeatures(arguments.Features.EnforceAll);
  if (arguments.Features.ByAngle)
  {
    mesher->SetFeatureModeToAngle();
    mesher->SetFeatureAngle(arguments.Features.Angle);
  }
}

bool StartsWith(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}

/// Times and memory: in the report, not among the figures, and not in the file of the mesh, which
/// shall be the same bytes on each run.
bool Measured(const std::string& name)
{
  return StartsWith(name, "Seconds") || name == "PeakMemoryMiB";
}

void AddStatistics(vtkTable* table, Report& report)
{
  for (const auto& [name, value] : FiguresOf(table))
  {
    if (StartsWith(name, "Seconds") && name != "SecondsTotal")
    {
      report.AddStage(name.substr(7), value);
    }
    else if (!Measured(name) && !StartsWith(name, "Option"))
    {
      report.AddFigure(name, value);
    }
  }
}

/// What goes into the file. Many programs that read legacy VTK stumble over strings.
void CopyForFile(vtkUnstructuredGrid* mesh, bool legacy, vtkUnstructuredGrid* copy)
{
  copy->ShallowCopy(mesh);
  vtkFieldData* fields = copy->GetFieldData();
  for (int i = fields->GetNumberOfArrays() - 1; i >= 0; --i)
  {
    const std::string name = fields->GetArrayName(i) ? fields->GetArrayName(i) : "";
    const bool text = vtkStringArray::SafeDownCast(fields->GetAbstractArray(i)) != nullptr;
    if (Measured(name) || (legacy && text))
    {
      fields->RemoveArray(i);
    }
  }
}

/// Replaces the linear hexes of @a mesh when @a arguments ask for more nodes.
Status AddNodes(const MeshArguments& arguments, vtkPolyData* surface, RunLog& log,
  Report& report, vtkUnstructuredGrid* mesh)
{
  if (arguments.NodesPerHex == 8)
  {
    return Status();
  }
  const double before = report.Seconds();
  vtkNew<vtkPolyData> graph;
  Status status = ReadFeatures(arguments.Features, surface, log, graph);
  if (!status.Ok())
  {
    return status;
  }
  vtkNew<vtkQuadraticHexFilter> quadratic;
  quadratic->SetHexType(arguments.NodesPerHex == 27 ? vtkQuadraticHexFilter::Nodes27
                                                    : vtkQuadraticHexFilter::Nodes20);
  quadratic->SetInputDataObject(0, mesh);
  quadratic->SetInputDataObject(1, surface);
  quadratic->SetInputDataObject(2, graph);
  status = RunAlgorithm(quadratic, StatusCode::Validation, log);
  auto* result = vtkUnstructuredGrid::SafeDownCast(quadratic->GetOutputDataObject(0));
  for (const char* name : { "BoundaryNodes", "NodesOnSurface", "NodesShortened", "NodesTooFar",
         "SmallestJacobianRatio" })
  {
    vtkDataArray* figure = result->GetFieldData()->GetArray(name);
    if (figure)
    {
      report.AddFigure(name, figure->GetComponent(0, 0));
    }
  }
  report.AddStage("QuadraticHexes", report.Seconds() - before);
  mesh->ShallowCopy(result);
  return status;
}

/// Reads, meshes, writes; @a summary is for people.
Status MakeMesh(const MeshArguments& arguments, RunLog& log, Report& report, std::string& summary)
{
  double before = report.Seconds();
  vtkNew<vtkSurfaceFileReader> reader;
  reader->SetFileName(arguments.Input.c_str());
  Status status = RunAlgorithm(reader, StatusCode::UnreadableFile, log);
  vtkNew<vtkFeatureGraphReader> features;
  if (status.Ok() && !arguments.Features.File.empty())
  {
    features->SetInputDataObject(reader->GetOutput());
    features->SetFileName(arguments.Features.File.c_str());
    status = RunAlgorithm(features, StatusCode::UnreadableFile, log);
  }
  report.AddStage("Reading", report.Seconds() - before);
  if (!status.Ok())
  {
    return status;
  }
  report["input"]["points"] = reader->GetOutput()->GetNumberOfPoints();
  report["input"]["faces"] = reader->GetOutput()->GetNumberOfCells();

  vtkNew<vtkFeatureHexMesher> mesher;
  mesher->SetInputDataObject(reader->GetOutput());
  if (!arguments.Features.File.empty())
  {
    mesher->SetInputDataObject(1, features->GetOutput());
  }
  SetOptions(arguments, mesher);
  status = RunAlgorithm(mesher, StatusCode::Validation, log);
  auto* statistics = vtkTable::SafeDownCast(mesher->GetOutputDataObject(3));
  AddStatistics(statistics, report);
  report.AddFeatures(vtkTable::SafeDownCast(mesher->GetOutputDataObject(4)));
  report["rounds"] = { { "count", FigureOf(statistics, "Rounds") },
    { "reasons", TextOf(statistics, "RoundReasons") } };
  if (!status.Ok())
  {
    return status;
  }

  summary = SummaryLine(statistics);
  vtkNew<vtkUnstructuredGrid> mesh;
  CopyForFile(vtkUnstructuredGrid::SafeDownCast(mesher->GetOutputDataObject(0)),
    FileExtension(arguments.Output) == ".vtk", mesh);
  status = AddNodes(arguments, reader->GetOutput(), log, report, mesh);
  if (!status.Ok())
  {
    return status;
  }
  before = report.Seconds();
  vtkNew<vtkHexMeshWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(arguments.Output.c_str());
  status = RunAlgorithm(writer, StatusCode::UnwritableFile, log);
  report.AddStage("Writing", report.Seconds() - before);
  return status;
}
} // namespace

Status RunMesh(const MeshArguments& arguments)
{
  Report report("mesh");
  const Status files = CheckFiles(arguments);
  if (!files.Ok())
  {
    return files;
  }
  UseThreads(arguments.Threads);
  AddOptions(arguments, report);
  RunLog log;
  std::string summary;
  Status status = MakeMesh(arguments, log, report, summary);
  report.AddLog(log);
  const Status written = report.Write(arguments.Report, status);
  if (status.Ok())
  {
    status = written;
  }
  if (status.Ok())
  {
    for (const std::string& warning : log.Warnings)
    {
      PrintWarning(warning);
    }
    std::printf("%s: %s, %.1f s, %.0f MB\n", FileBaseName(arguments.Output).c_str(),
      summary.c_str(), report.Seconds(), 1e-6 * PeakMemory());
  }
  return status;
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause
// The command line: featurehex mesh, featurehex check.
#include "Arguments.h"
#include "Commands.h"
#include "Console.h"
#include "ExitCode.h"
#include "RunAlgorithm.h"

#include "vtkFeatureHexMesher.h"
#include "vtkFeatureHexVersion.h"
#include "vtkHexValidationFilter.h"
#include "vtkSurfaceFeatureFilter.h"

#include <vtkNew.h>

#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>
#include <new>
#include <set>
#include <string>

namespace
{
using featurehex::ExitCode;
using featurehex::Status;
using featurehex::StatusCode;

/// A number between @a low and @a high; NaN is none.
CLI::Validator Within(double low, double high)
{
  return CLI::Validator(
    [=](const std::string& word)
    {
      double value = 0.0;
      if (CLI::detail::lexical_cast(word, value) && value >= low && value <= high)
      {
        return std::string();
      }
      char range[80];
      std::snprintf(range, sizeof range, "a number from %.10g to %.10g", low, high);
      return "\"" + word + "\" is not " + range;
    },
    "", "");
}

template <typename Value>
void AddNumber(CLI::App* command, const std::string& name, Value& value, double low, double high,
  const std::string& type, const std::string& text)
{
  command->add_option(name, value, text)
    ->type_name(type)
    ->capture_default_str()
    ->check(Within(low, high));
}

void AddReportAndThreads(CLI::App* command, std::string& report, int& threads)
{
  command->add_option("--report", report, "Write all figures, options and times as JSON")
    ->type_name("FILE");
  AddNumber(command, "--threads", threads, 0, 1024, "N", "Number of threads; 0: all cores");
}

const char* const ToleranceHelp =
  "Largest distance between mesh and surface, as a fraction of the bounding box's diagonal";

/// The options --features, --feature-angle and so on.
void AddFeatures(
  CLI::App* command, featurehex::FeatureArguments& arguments, double low, double high)
{
  command
    ->add_option("--features", arguments.File, "Sharp features: a .fgraph file with point ids of IN")
    ->type_name("FILE");
  command
    ->add_option_function<double>("--feature-angle",
      [&arguments](const double& angle)
      {
        arguments.ByAngle = true;
        arguments.Angle = angle;
      },
      "Find sharp features: edges with an interior angle below DEG (140 is usual); with --features: "
      "both")
    ->type_name("DEG")
    ->check(Within(low, high));
  command->add_flag("--enforce-all-features", arguments.EnforceAll,
    "Also corners where more than six curves, or two at less than 30 degrees meet");
}

CLI::App* AddMesh(CLI::App& app, featurehex::MeshArguments& arguments)
{
  CLI::App* command = app.add_subcommand("mesh", "Make a hex mesh from a closed surface");
  command->footer(featurehex::ExitCodeHelp());
  command->add_option("surface", arguments.Input, "STL, OBJ, PLY, OFF, VTP or legacy VTK")
    ->type_name("IN")
    ->required();
  command
    ->add_option("-o,--output", arguments.Output,
      "By extension: .vtu, .vtk (legacy), .mesh (Medit), .inp (Abaqus, CalculiX), .msh, .msh2 "
      "(Gmsh 4.1, 2.2), .exo, .e (Exodus), .ucd (AVS UCD, deal.II)")
    ->type_name("OUT")
    ->required();

  // Defaults and ranges in one place.
  vtkNew<vtkFeatureHexMesher> mesher;
  arguments.Tolerance = mesher->GetTolerance();
  AddNumber(command, "--tolerance", arguments.Tolerance, mesher->GetToleranceMinValue(),
    mesher->GetToleranceMaxValue(), "E", ToleranceHelp);
  arguments.EdgeLength = mesher->GetTargetEdgeLength();
  AddNumber(command, "--edge-length", arguments.EdgeLength, mesher->GetTargetEdgeLengthMinValue(),
    mesher->GetTargetEdgeLengthMaxValue(), "L",
    "Size of the hexes at the surface, model units; 0: longest side of the bounding box / 20, "
    "with sharp features / 18, or larger where nothing asks for as small ones");
  command
    ->add_option("--edge-length-array", arguments.EdgeLengthArray,
      "Point array of IN (VTP, VTK) with the largest size wanted there, model units; 0: no wish")
    ->type_name("NAME");
  AddFeatures(command, arguments.Features, mesher->GetFeatureAngleMinValue(),
    mesher->GetFeatureAngleMaxValue());
  // Nothing to store.
  CLI::Option* none = command->add_flag(
    "--no-features", "No sharp features; the default without --features and --feature-angle");
  none->excludes("--features")->excludes("--feature-angle");
  AddReportAndThreads(command, arguments.Report, arguments.Threads);
  arguments.TimeLimit = mesher->GetTimeLimit();
  AddNumber(command, "--time-limit", arguments.TimeLimit, mesher->GetTimeLimitMinValue(),
    mesher->GetTimeLimitMaxValue(), "S", "Give up after S seconds; 0: never");
  arguments.MaximumLevel = mesher->GetMaximumLevel();
  AddNumber(command, "--max-level", arguments.MaximumLevel, mesher->GetMaximumLevelMinValue(),
    mesher->GetMaximumLevelMaxValue(), "N",
    "Hexes are refined at most this many halvings below the edge length");
  arguments.MaximumNumberOfCells = mesher->GetMaximumNumberOfCells();
  AddNumber(command, "--max-cells", arguments.MaximumNumberOfCells,
    static_cast<double>(mesher->GetMaximumNumberOfCellsMinValue()),
    static_cast<double>(mesher->GetMaximumNumberOfCellsMaxValue()), "N",
    "Largest number of octree cells");
  arguments.MaximumRounds = mesher->GetMaximumRounds();
  AddNumber(command, "--max-rounds", arguments.MaximumRounds, mesher->GetMaximumRoundsMinValue(),
    mesher->GetMaximumRoundsMaxValue(), "N", "Rounds of refinement before giving up");
  arguments.MinimumScaledJacobian = mesher->GetMinimumScaledJacobian();
  AddNumber(command, "--min-scaled-jacobian", arguments.MinimumScaledJacobian,
    mesher->GetMinimumScaledJacobianMinValue(), mesher->GetMinimumScaledJacobianMaxValue(), "Q",
    "Wanted smallest scaled Jacobian; best effort");
  command->add_flag("--align", arguments.Align, "Align the hexes with the principal axes");
  command
    ->add_option("--nodes-per-hex", arguments.NodesPerHex,
      "8: linear; 20 or 27: quadratic, boundary nodes on the surface (not for .mesh and .ucd; .inp "
      "up to 20)")
    ->type_name("N")
    ->capture_default_str()
    ->check(CLI::IsMember(std::set<int>{ 8, 20, 27 }));
  return command;
}

CLI::App* AddCheck(CLI::App& app, featurehex::CheckArguments& arguments)
{
  CLI::App* command = app.add_subcommand("check", "Measure every promise about a hex mesh");
  command->footer(featurehex::ExitCodeHelp());
  command->add_option("mesh", arguments.Mesh, "VTU, legacy VTK or Medit .mesh")
    ->type_name("MESH")
    ->required();
  command
    ->add_option("--surface", arguments.Surface,
      "The surface it was made from; without it distance and topology are not compared")
    ->type_name("IN");
  vtkNew<vtkSurfaceFeatureFilter> features;
  AddFeatures(command, arguments.Features, features->GetFeatureAngleMinValue(),
    features->GetFeatureAngleMaxValue());
  command->get_option("--features")->needs("--surface");
  command->get_option("--feature-angle")->needs("--surface");
  vtkNew<vtkHexValidationFilter> validation;
  arguments.Tolerance = validation->GetTolerance();
  AddNumber(command, "--tolerance", arguments.Tolerance, validation->GetToleranceMinValue(),
    validation->GetToleranceMaxValue(), "E", ToleranceHelp);
  AddReportAndThreads(command, arguments.Report, arguments.Threads);
  return command;
}

ExitCode Run(int argc, char** argv)
{
  CLI::App app(
    "FeatureHex: hexahedral meshes from closed surfaces, valid with proof", "featurehex");
  app.require_subcommand(1);
  app.set_version_flag(
    "--version", std::string("featurehex ") + vtkFeatureHexVersion::GetVersion());
  app.footer("featurehex COMMAND --help shows the options of a command.\n\n" +
             std::string(featurehex::ExitCodeHelp()));
  featurehex::MeshArguments mesh;
  featurehex::CheckArguments check;
  const CLI::App* meshCommand = AddMesh(app, mesh);
  AddCheck(app, check);

  try
  {
    app.parse(argc, argv);
  }
  catch (const CLI::ParseError& error)
  {
    if (error.get_exit_code() == 0)
    {
      app.exit(error); // prints the help or the version
      return ExitCode::Success;
    }
    featurehex::PrintError(Status(StatusCode::InvalidOption,
      std::string(error.what()) + ". featurehex --help and featurehex COMMAND --help explain."));
    return ExitCode::BadArguments;
  }
  featurehex::SilenceVTK();
  featurehex::CatchStopSignals();
  const Status status =
    meshCommand->parsed() ? featurehex::RunMesh(mesh) : featurehex::RunCheck(check);
  if (!status.Ok())
  {
    featurehex::PrintError(status);
  }
  return featurehex::ExitCodeOf(status.Code);
}
} // namespace

int main(int argc, char** argv)
{
  try
  {
    return static_cast<int>(Run(argc, argv));
  }
  catch (const std::bad_alloc&)
  {
    std::fputs("featurehex: out of memory. Raise the edge length, or lower --max-cells.\n", stderr);
  }
  catch (const std::exception& error)
  {
    std::fprintf(
      stderr, "featurehex: unexpected failure: %s\n", featurehex::OneLine(error.what()).c_str());
  }
  return static_cast<int>(ExitCode::Internal);
}

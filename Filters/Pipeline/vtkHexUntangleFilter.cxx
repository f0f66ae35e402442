// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexUntangleFilter.h"

#include "ArrayNames.h"
#include "DataConversion.h"
#include "HexUntangling.h"
#include "StageCheck.h"
#include "StageFeatures.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <memory>
#include <sstream>
#include <string>

vtkStandardNewMacro(vtkHexUntangleFilter);

namespace
{
using namespace featurehex;

std::string Place(const Vec3& p)
{
  std::ostringstream text;
  text << "(" << p[0] << ", " << p[1] << ", " << p[2] << ")";
  return text.str();
}
} // namespace

//------------------------------------------------------------------------------
vtkHexUntangleFilter::vtkHexUntangleFilter()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(1);
}

//------------------------------------------------------------------------------
vtkHexUntangleFilter::~vtkHexUntangleFilter() = default;

//------------------------------------------------------------------------------
int vtkHexUntangleFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  if (port >= 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkHexUntangleFilter::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
featurehex::Status vtkHexUntangleFilter::Compute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, featurehex::Monitor& monitor)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputs[0]);
  monitor.BeginPhase("checking the hexes", 0.0, 0.1);
  HexMesh mesh;
  Status status = MeshFromGrid(input, MeshCheck::Conforming, mesh);
  std::unique_ptr<SurfaceGeometry> surface;
  if (vtkPolyData* data = vtkPolyData::GetData(inputs[1]); data && status.Ok())
  {
    monitor.BeginPhase("checking the surface", 0.1, 0.3);
    SurfaceMesh checked;
    status = CheckedSurface(data, checked, monitor);
    if (status.Ok())
    {
      surface = std::make_unique<SurfaceGeometry>(std::move(checked));
    }
  }
  if (!status.Ok())
  {
    return status;
  }
  const HexStars stars(mesh);
  StageFeatures features;
  if (vtkPolyData* graph = vtkPolyData::GetData(inputs[2]); graph && !surface)
  {
    status = Status(StatusCode::InvalidOption,
      "A feature graph (input 2) is of use only together with its surface (input 1).");
  }
  else if (surface)
  {
    status = features.Read(surface->Mesh(), graph,
      FieldValue(input->GetFieldData(), ArrayNames::TargetEdgeLength, 0.0));
  }
  if (status.Ok())
  {
    status = features.ReadTargets(this, input, mesh, stars);
  }
  if (!status.Ok())
  {
    return status;
  }

  monitor.BeginPhase("untangling", 0.3, 1.0);
  UntangleOptions options;
  options.Method =
    this->Method == STITCHING ? UntangleMethod::Stitching : UntangleMethod::Regularized;
  options.MaximumSweeps = this->MaximumSweeps;
  options.Features = features.Targets();
  UntangleReport report;
  status = UntangleHexes(mesh, stars, surface.get(), options, report, monitor);
  if (status.Ok() && report.InvertedAfter > 0)
  {
    const std::vector<Index> inverted = InvertedHexes(mesh);
    const Vec3& where = mesh.Points[mesh.Hexes[inverted.front()][0]];
    return Status(StatusCode::Untangling,
      std::to_string(report.InvertedAfter) + " hexes stay inverted after " +
        std::to_string(report.Sweeps) + " sweeps, first hex " + std::to_string(inverted.front()) +
        " at " + Place(where) +
        ". Raise MaximumSweeps, try the other Method, or make the octree finer there.",
      { where });
  }
  if (status.Ok())
  {
    status = CheckStageOutput({ "untangling", StagePromise::PositiveCorners }, mesh);
  }
  if (!status.Ok())
  {
    return status;
  }

  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs);
  GridFromMesh(mesh, output);
  PassArrays(input, output);
  FigureRow row;
  row.Numbers = { { "InvertedHexesBefore", report.InvertedBefore },
    { "UntanglingSweeps", report.Sweeps } };
  row.Write(output->GetFieldData());
  return status;
}

//------------------------------------------------------------------------------
void vtkHexUntangleFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumSweeps: " << this->MaximumSweeps << "\n";
  os << indent << "Method: " << (this->Method == STITCHING ? "stitching" : "regularized") << "\n";
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexDomainFilter.h"

#include "ArrayNames.h"
#include "DataConversion.h"
#include "HexDomain.h"
#include "StageCheck.h"
#include "SurfaceGeometry.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkHexDomainFilter);

using namespace featurehex;

//------------------------------------------------------------------------------
vtkHexDomainFilter::vtkHexDomainFilter()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkHexDomainFilter::~vtkHexDomainFilter() = default;

//------------------------------------------------------------------------------
int vtkHexDomainFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHexDomainFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
featurehex::Status vtkHexDomainFilter::Compute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, featurehex::Monitor& monitor)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputs[0]);
  monitor.BeginPhase("checking the surface", 0.0, 0.2);
  SurfaceMesh checked;
  Status status = CheckedSurface(vtkPolyData::GetData(inputs[1]), checked, monitor);
  HexMesh mesh;
  if (status.Ok())
  {
    monitor.BeginPhase("checking the hexes", 0.2, 0.3);
    status = MeshFromGrid(input, MeshCheck::Conforming, mesh);
  }
  if (!status.Ok())
  {
    return status;
  }
  monitor.BeginPhase("finding inside and outside", 0.3, 1.0);
  const SurfaceGeometry surface(std::move(checked));
  DomainOptions options;
  options.LabelBias = this->LabelBias;
  options.MaximumLevel = this->MaximumLevel;
  options.Slack = this->Tolerance * surface.Diagonal();
  options.TargetEdgeLength = FieldValue(input->GetFieldData(), ArrayNames::TargetEdgeLength, 0.0);
  HexDomain domain;
  status = ComputeHexDomain(mesh, surface.Mesh(), surface.Search(), WindingNumber(surface.Mesh()),
    options, monitor, domain);
  if (status.Ok())
  {
    status =
      CheckStageOutput({ "hex domain", StagePromise::Conforming,
                         { { ArrayNames::Region, domain.Region.size(), mesh.Hexes.size() } } },
        mesh);
  }
  if (!status.Ok())
  {
    return status;
  }

  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs, 0);
  output->ShallowCopy(input);
  AddArray(output->GetCellData(), ArrayNames::Region, domain.Region);
  FigureRow row;
  row.Numbers = { { "NumberOfRegions", domain.NumberOfRegions },
    { "TopologyMatches", domain.Topology.Same() },
    { "SurfaceCovered", domain.MissingPoints.empty() }, { "LonelyFlips", domain.LonelyFlips },
    { "RepairFlips", domain.RepairFlips }, { "IslandFlips", domain.IslandFlips },
    { "HandleFlips", domain.HandleFlips } };
  row.Write(output->GetFieldData());

  std::vector<std::pair<RefinementPoint, std::string>> points;
  for (const RefinementPoint& point : domain.TopologyPoints)
  {
    points.emplace_back(point, "topology");
  }
  for (const RefinementPoint& point : domain.MissingPoints)
  {
    points.emplace_back(point, "missing surface");
  }
  PolyDataFromRefinementPoints(points, vtkPolyData::GetData(outputs, 1));
  return status;
}

//------------------------------------------------------------------------------
void vtkHexDomainFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LabelBias: " << this->LabelBias << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
}

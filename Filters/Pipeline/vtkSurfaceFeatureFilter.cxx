// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceFeatureFilter.h"

#include "ArrayNames.h"
#include "DataConversion.h"
#include "StageCheck.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkSurfaceFeatureFilter);

using namespace featurehex;

//------------------------------------------------------------------------------
vtkSurfaceFeatureFilter::vtkSurfaceFeatureFilter()
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkSurfaceFeatureFilter::~vtkSurfaceFeatureFilter() = default;

//------------------------------------------------------------------------------
int vtkSurfaceFeatureFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port >= 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceFeatureFilter::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
featurehex::Status vtkSurfaceFeatureFilter::Compute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, featurehex::Monitor& monitor)
{
  this->WarnAboutFeatures(inputs[1]);
  monitor.BeginPhase("checking the surface");
  SurfaceMesh surface = SurfaceFromPolyData(vtkPolyData::GetData(inputs[0]));
  SurfaceCheckReport report;
  Status status = CheckSurface(surface, SurfaceCheckOptions(), report, monitor);
  if (status.Ok())
  {
    status = CheckStageOutput({ "surface check", StagePromise::Conforming,
                                { { ArrayNames::PatchId, report.ComponentOfTriangle.size(),
                                  surface.Triangles.size() } } },
      surface);
  }
  if (!status.Ok())
  {
    return status;
  }
  FigureRow row;
  std::string repairs;
  for (const std::string& warning : report.Warnings)
  {
    repairs += (repairs.empty() ? "" : " ") + warning;
  }
  if (!repairs.empty())
  {
    vtkWarningMacro("The surface was repaired: " << repairs);
  }
  int cavities = 0;
  int genus = 0;
  for (const SurfaceComponent& component : report.Components)
  {
    cavities += component.Cavity ? 1 : 0;
    genus += component.Genus;
  }
  row.Numbers = { { "NumberOfComponents", static_cast<double>(report.Components.size()) },
    { "NumberOfCavities", cavities }, { "Genus", genus }, { "Volume", report.Volume },
    { "Diagonal", report.Diagonal }, { "MergedPoints", report.NumberOfMergedPoints },
    { "UnusedPoints", report.NumberOfUnusedPoints },
    { "CollapsedTriangles", report.NumberOfCollapsedTriangles },
    { "DuplicateTriangles", report.NumberOfDuplicateTriangles },
    { "FlippedEdges", report.NumberOfFlippedEdges },
    { "ReorientedTriangles", report.NumberOfReorientedTriangles } };
  row.Texts = { { "SurfaceRepairs", repairs } };

  vtkPolyData* output = vtkPolyData::GetData(outputs, 0);
  PolyDataFromSurface(surface, output);
  AddArray(output->GetCellData(), ArrayNames::PatchId, report.ComponentOfTriangle);
  row.Write(output->GetFieldData());
  return status;
}

//------------------------------------------------------------------------------
void vtkSurfaceFeatureFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexPaddingFilter.h"

#include "ArrayNames.h"
#include "DataConversion.h"
#include "HexPadding.h"
#include "StageCheck.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkHexPaddingFilter);

using namespace featurehex;

//------------------------------------------------------------------------------
vtkHexPaddingFilter::vtkHexPaddingFilter()
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(1);
}

//------------------------------------------------------------------------------
vtkHexPaddingFilter::~vtkHexPaddingFilter() = default;

//------------------------------------------------------------------------------
int vtkHexPaddingFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHexPaddingFilter::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
featurehex::Status vtkHexPaddingFilter::Compute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, featurehex::Monitor& monitor)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputs[0]);
  monitor.BeginPhase("checking the hexes", 0.0, 0.5);
  HexMesh mesh;
  Status status = MeshFromGrid(input, MeshCheck::Conforming, mesh);
  std::vector<int> region;
  if (status.Ok())
  {
    status = ReadCellArray(input, ArrayNames::Region, "the Hex Domain filter makes it", region);
  }
  if (!status.Ok())
  {
    return status;
  }
  monitor.BeginPhase("padding", 0.5, 1.0);
  PaddingOptions options;
  options.Thickness = this->Thickness;
  PaddedMesh padded;
  status = PadInterface(mesh, region, options, padded);
  if (status.Ok())
  {
    const std::size_t hexes = padded.Mesh.Hexes.size();
    status = CheckStageOutput({ "padding", StagePromise::Conforming,
                                { { ArrayNames::Region, padded.Region.size(), hexes },
                                  { ArrayNames::PaddingLayer, padded.IsLayer.size(), hexes },
                                  { "SourceHex", padded.SourceHex.size(), hexes },
                                  { "SourcePoint", padded.SourcePoint.size(),
                                    padded.Mesh.Points.size() } } },
      padded.Mesh);
  }
  if (!status.Ok())
  {
    return status;
  }

  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs);
  GridFromMesh(padded.Mesh, output);
  CopyRows(input->GetPointData(), padded.SourcePoint, output->GetPointData());
  CopyRows(input->GetCellData(), padded.SourceHex, output->GetCellData());
  output->GetFieldData()->PassData(input->GetFieldData());
  AddArray(output->GetCellData(), ArrayNames::PaddingLayer,
    std::vector<int>(padded.IsLayer.begin(), padded.IsLayer.end()));
  monitor.Update(1.0);
  return status;
}

//------------------------------------------------------------------------------
void vtkHexPaddingFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Thickness: " << this->Thickness << "\n";
}

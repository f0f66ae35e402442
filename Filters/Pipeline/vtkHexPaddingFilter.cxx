// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexPaddingFilter.h"

#include "ArrayNames.h"
#include "DataConversion.h"
#include "HexFeatureConversion.h"
#include "HexLocalPadding.h"
#include "InterfaceRepair.h"
#include "StageCheck.h"
#include "StageFeatures.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <string>

vtkStandardNewMacro(vtkHexPaddingFilter);

namespace
{
using namespace featurehex;

/// In the order of PadInterface().
std::vector<Quad> InterfaceOf(const HexMesh& mesh, const std::vector<int>& region)
{
  std::vector<Quad> quads;
  for (const InterfaceQuad& quad : InterfaceQuads(mesh, HexGraph(mesh).Neighbors, region))
  {
    quads.push_back(quad.Vertices);
  }
  return quads;
}

/// The padding of a mesh that may have features.
struct FeaturePadding
{
  PaddingOptions Options;
  bool Local = true;
  HexFeatures Features; ///< of the padded mesh; empty without
  LocalPaddingReport Report;
  std::string Warning;

  Status Run(vtkInformationVector** inputs, const HexMesh& mesh, const std::vector<int>& region,
    PaddedMesh& padded, Monitor& monitor);
};

Status FeaturePadding::Run(vtkInformationVector** inputs, const HexMesh& mesh,
  const std::vector<int>& region, PaddedMesh& padded, Monitor& monitor)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputs[0]);
  vtkPolyData* surfaceData = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* graph = vtkPolyData::GetData(inputs[2]);
  if (!graph && !HasHexFeatures(input))
  {
    return PadInterface(mesh, region, this->Options, padded);
  }
  if (graph && !surfaceData)
  {
    return Status(StatusCode::InvalidOption,
      "A feature graph (input 2) is of use only together with its surface (input 1).");
  }
  const std::vector<Quad> interface = InterfaceOf(mesh, region);
  Status status;
  SurfaceMesh surface;
  StageFeatures features;
  if (graph && this->Local)
  {
    monitor.BeginPhase("checking the surface", 0.3, 0.8);
    status = CheckedSurface(surfaceData, surface, monitor);
    if (status.Ok())
    {
      status = features.Read(surface, graph,
        FieldValue(input->GetFieldData(), ArrayNames::TargetEdgeLength, 0.0));
    }
  }
  if (status.Ok() && this->Local)
  {
    status = features.ReadMapped(input, interface, this->Warning);
  }
  this->Features = features.Mapped();
  if (status.Ok() && this->Features.Empty() && HasHexFeatures(input))
  {
    status = HexFeaturesFromGrid(input, interface, this->Features);
  }
  if (!status.Ok())
  {
    return status;
  }
  monitor.BeginPhase("padding at features", 0.8, 0.9);
  const bool mapped = !features.Mapped().Empty();
  status = PadInterface(mesh, region, this->Options, padded,
    this->Features.Empty() ? nullptr : &this->Features, mapped ? &features.Geometry() : nullptr);
  if (status.Ok() && mapped)
  {
    this->Report =
      PadDegenerateQuads(padded, this->Features, features.Geometry(), LocalPaddingOptions());
  }
  return status;
}
} // namespace

//------------------------------------------------------------------------------
vtkHexPaddingFilter::vtkHexPaddingFilter()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(1);
}

//------------------------------------------------------------------------------
vtkHexPaddingFilter::~vtkHexPaddingFilter() = default;

//------------------------------------------------------------------------------
int vtkHexPaddingFilter::FillInputPortInformation(int port, vtkInformation* info)
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
  monitor.BeginPhase("checking the hexes", 0.0, 0.3);
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
  PaddedMesh padded;
  FeaturePadding features;
  features.Options.Thickness = this->Thickness;
  features.Options.EveryGroup = this->PadEveryPatch;
  features.Local = this->LocalPadding;
  status = features.Run(inputs, mesh, region, padded, monitor);
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
  if (!features.Warning.empty())
  {
    vtkWarningMacro(<< features.Warning);
  }

  monitor.BeginPhase("copying the arrays", 0.9, 1.0);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs);
  GridFromMesh(padded.Mesh, output);
  CopyRows(input->GetPointData(), padded.SourcePoint, output->GetPointData());
  CopyRows(input->GetCellData(), padded.SourceHex, output->GetCellData());
  output->GetFieldData()->PassData(input->GetFieldData());
  AddArray(output->GetCellData(), ArrayNames::PaddingLayer,
    std::vector<int>(padded.IsLayer.begin(), padded.IsLayer.end()));
  // Labels of the unpadded mesh are copied to points below the boundary too.
  output->GetPointData()->RemoveArray(ArrayNames::FeatureKind);
  output->GetPointData()->RemoveArray(ArrayNames::FeatureId);
  if (!features.Features.Empty())
  {
    const HexStars stars(padded.Mesh);
    AddLabels(FeatureLabels(features.Features, stars), output->GetPointData());
    AddElements(features.Features, stars.Quads, output->GetFieldData());
    FigureRow row;
    row.Numbers = { { "DegenerateQuads", features.Report.DegenerateQuads },
      { "LocalPaddingHexes", features.Report.AddedHexes } };
    row.Write(output->GetFieldData());
  }
  monitor.Update(1.0);
  return status;
}

//------------------------------------------------------------------------------
void vtkHexPaddingFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LocalPadding: " << (this->LocalPadding ? "on" : "off") << "\n";
  os << indent << "PadEveryPatch: " << (this->PadEveryPatch ? "on" : "off") << "\n";
  os << indent << "Thickness: " << this->Thickness << "\n";
}

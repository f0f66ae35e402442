// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexFeatureMappingFilter.h"

#include "ArrayNames.h"
#include "DataConversion.h"
#include "HexFeatureConversion.h"
#include "HexFeatureMapping.h"
#include "RefinementConversion.h"
#include "StageCheck.h"
#include "StageFeatures.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkHexFeatureMappingFilter);

namespace
{
using namespace featurehex;

/// What the filter reads at input 0.
struct LabelledMesh
{
  HexMesh Mesh;
  std::vector<int> Region;
  std::vector<int> Level; ///< empty without the array
  double EdgeLength = 0.0;
  std::vector<InterfaceQuad> Interface;

  Status Read(vtkUnstructuredGrid* input);
};

Status LabelledMesh::Read(vtkUnstructuredGrid* input)
{
  Status status = MeshFromGrid(input, MeshCheck::Conforming, this->Mesh);
  if (status.Ok())
  {
    status =
      ReadCellArray(input, ArrayNames::Region, "the Hex Domain filter makes it", this->Region);
  }
  if (status.Ok() && input->GetCellData()->HasArray(ArrayNames::Level))
  {
    status =
      ReadCellArray(input, ArrayNames::Level, "the Octree Dual Hex filter makes it", this->Level);
  }
  if (!status.Ok())
  {
    return status;
  }
  this->EdgeLength = FieldValue(input->GetFieldData(), ArrayNames::TargetEdgeLength, 0.0);
  const HexGraph graph(this->Mesh);
  this->Interface = InterfaceQuads(this->Mesh, graph.Neighbors, this->Region);
  if (this->Interface.empty())
  {
    return Status(StatusCode::InvalidMesh,
      "No hex has a Region above 0. The Hex Domain filter finds the hexes of the bodies.");
  }
  std::vector<char> inside;
  for (int region : this->Region)
  {
    inside.push_back(region > 0);
  }
  const std::vector<Index> bad = NonManifoldVertices(graph, inside);
  return bad.empty() ? Status()
                     : Status(StatusCode::InvalidMesh,
                         "The interface of the hexes with a Region above 0 is no manifold at " +
                           std::to_string(bad.size()) + " points, first point " +
                           std::to_string(bad.front()) +
                           ". The Hex Domain filter makes one that is.");
}

std::vector<std::pair<RefinementPoint, std::string>> PlacesOfFailures(
  const LabelledMesh& labelled, const std::vector<MappingFailure>& failures, int maximumLevel)
{
  std::vector<Quad> quads;
  std::vector<Index> owners;
  for (const InterfaceQuad& quad : labelled.Interface)
  {
    quads.push_back(quad.Vertices);
    owners.push_back(quad.Inside);
  }
  std::vector<std::pair<RefinementPoint, std::string>> points;
  for (const MappingFailure& failure : failures)
  {
    AppendPlaces({ labelled.Mesh.Points, quads, owners, labelled.Level, labelled.EdgeLength },
      failure.Places, maximumLevel, failure.Reason, points);
  }
  return points;
}

/// Labels and, when all features are mapped, elements.
void AddFeatures(const LabelledMesh& labelled, FeatureMapping& mapping, vtkUnstructuredGrid* output)
{
  std::vector<Quad> quads;
  for (const InterfaceQuad& quad : labelled.Interface)
  {
    quads.push_back(quad.Vertices);
  }
  HexFeatures& features = mapping.Features;
  features.PatchOfQuad.resize(quads.size(), -1); // matched last: none when something failed before
  AddLabels(
    FeatureLabels(features, quads, labelled.Mesh.Points.size()), output->GetPointData());
  if (mapping.Complete())
  {
    AddElements(features, quads, output->GetFieldData());
  }
}
} // namespace

//------------------------------------------------------------------------------
vtkHexFeatureMappingFilter::vtkHexFeatureMappingFilter()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(2);
}

//------------------------------------------------------------------------------
vtkHexFeatureMappingFilter::~vtkHexFeatureMappingFilter() = default;

//------------------------------------------------------------------------------
int vtkHexFeatureMappingFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(
    vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
int vtkHexFeatureMappingFilter::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkUnstructuredGrid" : "vtkPolyData");
  return 1;
}

//------------------------------------------------------------------------------
featurehex::Status vtkHexFeatureMappingFilter::Compute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, featurehex::Monitor& monitor)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputs[0]);
  monitor.BeginPhase("checking the surface", 0.0, 0.5);
  SurfaceMesh surface;
  Status status = CheckedSurface(vtkPolyData::GetData(inputs[1]), surface, monitor);
  LabelledMesh labelled;
  if (status.Ok())
  {
    monitor.BeginPhase("checking the hexes", 0.5, 0.6);
    status = labelled.Read(input);
  }
  StageFeatures features;
  if (status.Ok())
  {
    status = features.Read(surface, vtkPolyData::GetData(inputs[2]), labelled.EdgeLength);
  }
  monitor.BeginPhase("mapping the features", 0.6, 1.0);
  FeatureMapping mapping;
  if (status.Ok() && features.Any())
  {
    FeatureMappingOptions options;
    options.CornerReach = this->CornerReach;
    options.CurveReach = this->CurveReach;
    options.MaximumAttempts = this->MaximumAttempts;
    status = MapFeaturesToInterface(
      labelled.Mesh, labelled.Interface, features.Geometry(), options, monitor, mapping);
  }
  if (status.Ok())
  {
    status = CheckStageOutput({ "feature mapping", StagePromise::Conforming }, labelled.Mesh);
  }
  if (!status.Ok())
  {
    return status;
  }

  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs, 0);
  output->ShallowCopy(input);
  if (features.Any())
  {
    AddFeatures(labelled, mapping, output);
  }
  FigureRow row;
  row.Numbers = { { "FeaturesMapped", mapping.Complete() },
    { "MappingFailures", static_cast<double>(mapping.Failures.size()) },
    { "ReroutedCurves", mapping.Reroutes } };
  row.Write(output->GetFieldData());
  PolyDataFromRefinementPoints(PlacesOfFailures(labelled, mapping.Failures, this->MaximumLevel),
    vtkPolyData::GetData(outputs, 1));
  monitor.Update(1.0);
  return status;
}

//------------------------------------------------------------------------------
void vtkHexFeatureMappingFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "CornerReach: " << this->CornerReach << "\n";
  os << indent << "CurveReach: " << this->CurveReach << "\n";
  os << indent << "MaximumAttempts: " << this->MaximumAttempts << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
}

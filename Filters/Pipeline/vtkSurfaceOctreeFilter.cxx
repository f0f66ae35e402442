// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceOctreeFilter.h"

#include "AutomaticSizing.h"
#include "DataConversion.h"
#include "FeatureConversion.h"
#include "FeatureSizing.h"
#include "StageCheck.h"
#include "StageFeatures.h"
#include "SurfaceGeometry.h"
#include "SurfaceSizing.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>

vtkStandardNewMacro(vtkSurfaceOctreeFilter);

namespace
{
using namespace featurehex;

} // namespace

//------------------------------------------------------------------------------
vtkSurfaceOctreeFilter::vtkSurfaceOctreeFilter()
{
  this->SetNumberOfInputPorts(3);
  this->SetNumberOfOutputPorts(1);
}

//------------------------------------------------------------------------------
vtkSurfaceOctreeFilter::~vtkSurfaceOctreeFilter() = default;

//------------------------------------------------------------------------------
int vtkSurfaceOctreeFilter::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  if (port >= 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  if (port == 2)
  {
    info->Set(vtkAlgorithm::INPUT_IS_REPEATABLE(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkSurfaceOctreeFilter::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
void vtkSurfaceOctreeFilter::RemoveAllRefinementPoints()
{
  this->RemoveAllInputConnections(2);
}

//------------------------------------------------------------------------------
featurehex::Status vtkSurfaceOctreeFilter::Compute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, featurehex::Monitor& monitor)
{
  this->PredictedNumberOfCells = 0;
  monitor.BeginPhase("checking the surface", 0.0, 0.2);
  SurfaceMesh checked;
  Status status = CheckedSurface(vtkPolyData::GetData(inputs[0]), checked, monitor);
  if (!status.Ok())
  {
    return status;
  }
  std::vector<RefinementPoint> asked;
  for (int i = 0; i < inputs[2]->GetNumberOfInformationObjects(); ++i)
  {
    status = AppendRefinementPoints(vtkPolyData::GetData(inputs[2], i), asked);
    if (!status.Ok())
    {
      return status;
    }
  }

  const SurfaceGeometry surface(std::move(checked));
  const double slack = this->Tolerance * surface.Diagonal();
  OctreeOptions options;
  options.TargetEdgeLength = this->TargetEdgeLength;
  vtkPolyData* graph = vtkPolyData::GetData(inputs[1]);
  if (options.TargetEdgeLength <= 0)
  {
    SurfaceFeatures toReproduce;
    status = graph ? FeaturesFromPolyData(surface.Mesh(), graph, toReproduce) : Status();
    options.TargetEdgeLength = AutomaticEdgeLength(surface, toReproduce,
      GridAxes(surface.Mesh(), this->AlignToPrincipalAxes), slack, monitor);
  }
  StageFeatures features;
  if (status.Ok())
  {
    status = features.Read(surface.Mesh(), graph, options.TargetEdgeLength);
  }
  if (!status.Ok())
  {
    return status;
  }
  options.CoarseLevels =
    AutomaticCoarseLevels(surface, options.TargetEdgeLength, features.Any());
  options.MaximumLevel = this->MaximumLevel;
  options.MaximumNumberOfCells = this->MaximumNumberOfCells;
  options.AlignToPrincipalAxes = this->AlignToPrincipalAxes;
  std::vector<RefinementPoint> points;
  if (this->ThicknessSizing)
  {
    monitor.BeginPhase("measuring thickness and gaps", 0.2, 0.7);
    SizingOptions sizing =
      AutomaticSizingOptions(features.Any(), options.TargetEdgeLength, slack);
    sizing.CellsPerGap = this->CellsPerGap;
    if (this->CellsPerThickness > 0)
    {
      sizing.CellsPerThickness = this->CellsPerThickness;
    }
    if (this->MaximumSizingLevel >= 0)
    {
      sizing.MaximumSizingLevel = this->MaximumSizingLevel;
    }
    sizing.MaximumSizingLevel = std::min(sizing.MaximumSizingLevel, this->MaximumLevel);
    points = ComputeSizing(surface.Mesh(), surface.Search(), sizing, monitor);
  }
  if (this->FeatureSizing && features.Any())
  {
    FeatureSizingOptions sizing;
    sizing.TargetEdgeLength = options.TargetEdgeLength;
    sizing.MaximumLevel = this->MaximumLevel;
    const std::vector<RefinementPoint> near = ThinRefinementPoints(
      ComputeFeatureSizing(features.Geometry(), sizing), options.TargetEdgeLength);
    points.insert(points.end(), near.begin(), near.end());
  }
  points.insert(points.end(), asked.begin(), asked.end());

  monitor.BeginPhase("building the octree", 0.7, 1.0);
  BlockOctree octree;
  OctreePrediction prediction;
  status = BuildBlockOctree(surface.Mesh(), points, options, octree, &prediction, monitor);
  this->PredictedNumberOfCells = prediction.Cells;
  if (status.Ok())
  {
    status = CheckStageOutput({ "octree", StagePromise::Conforming }, octree);
  }
  if (status.Ok())
  {
    GridFromOctree(octree, vtkUnstructuredGrid::GetData(outputs));
  }
  return status;
}

//------------------------------------------------------------------------------
void vtkSurfaceOctreeFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "TargetEdgeLength: " << this->TargetEdgeLength << "\n";
  os << indent << "MaximumLevel: " << this->MaximumLevel << "\n";
  os << indent << "MaximumNumberOfCells: " << this->MaximumNumberOfCells << "\n";
  os << indent << "AlignToPrincipalAxes: " << (this->AlignToPrincipalAxes ? "on" : "off") << "\n";
  os << indent << "ThicknessSizing: " << (this->ThicknessSizing ? "on" : "off") << "\n";
  os << indent << "CellsPerThickness: " << this->CellsPerThickness << "\n";
  os << indent << "CellsPerGap: " << this->CellsPerGap << "\n";
  os << indent << "MaximumSizingLevel: " << this->MaximumSizingLevel << "\n";
  os << indent << "FeatureSizing: " << (this->FeatureSizing ? "on" : "off") << "\n";
  os << indent << "Tolerance: " << this->Tolerance << "\n";
  os << indent << "PredictedNumberOfCells: " << this->PredictedNumberOfCells << "\n";
}

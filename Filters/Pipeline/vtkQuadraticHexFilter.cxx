// SPDX-License-Identifier: BSD-3-Clause
#include "vtkQuadraticHexFilter.h"

#include "ArrayNames.h"
#include "DataConversion.h"
#include "FeatureConversion.h"
#include "FeatureRecovery.h"
#include "HexFeatureConversion.h"
#include "MeshTopology.h"
#include "QuadraticHexes.h"

#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkQuadraticHexFilter);

namespace
{
using namespace featurehex;

/// Nodes of SolverMesh in VTK's order: mid-face nodes of -x, +x, -y, +y, -z, +z.
constexpr int VTKNodes[27] = { 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19,
  25, 23, 22, 24, 20, 21, 26 };

/// Points and cells.
void GridFromQuadratic(const QuadraticMesh& mesh, vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.Points.size()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
  }
  output->SetPoints(points);
  const std::size_t count = mesh.HexNodes.size() / mesh.NodesPerHex;
  output->Allocate(static_cast<vtkIdType>(count));
  vtkIdType ids[27];
  for (std::size_t h = 0; h < count; ++h)
  {
    for (int k = 0; k < mesh.NodesPerHex; ++k)
    {
      ids[k] = mesh.HexNodes[h * mesh.NodesPerHex + VTKNodes[k]];
    }
    output->InsertNextCell(
      mesh.NodesPerHex == 20 ? VTK_QUADRATIC_HEXAHEDRON : VTK_TRIQUADRATIC_HEXAHEDRON,
      mesh.NodesPerHex, ids);
  }
}

/// FeatureKind and FeatureId of old and added points, where the old ones have them.
void AddPointArrays(
  vtkUnstructuredGrid* input, const QuadraticMesh& mesh, vtkUnstructuredGrid* output)
{
  FeatureLabels labels;
  if (!LabelsFromGrid(input, labels).Ok())
  {
    return;
  }
  labels.Kind.insert(labels.Kind.end(), mesh.Added.Kind.begin(), mesh.Added.Kind.end());
  labels.Id.insert(labels.Id.end(), mesh.Added.Id.begin(), mesh.Added.Id.end());
  AddLabels(labels, output->GetPointData());
}
} // namespace

//------------------------------------------------------------------------------
vtkQuadraticHexFilter::vtkQuadraticHexFilter()
{
  this->SetNumberOfInputPorts(3);
}

//------------------------------------------------------------------------------
vtkQuadraticHexFilter::~vtkQuadraticHexFilter() = default;

//------------------------------------------------------------------------------
int vtkQuadraticHexFilter::FillInputPortInformation(int port, vtkInformation* info)
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
int vtkQuadraticHexFilter::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
featurehex::Status vtkQuadraticHexFilter::Compute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, featurehex::Monitor& monitor)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputs[0]);
  vtkPolyData* surfaceData = vtkPolyData::GetData(inputs[1]);
  vtkPolyData* graph = vtkPolyData::GetData(inputs[2]);
  HexMesh mesh;
  SurfaceMesh surface;
  SurfaceFeatures ofSurface;
  HexFeatures ofMesh;
  QuadraticTargets targets;
  Status status = MeshFromGrid(input, MeshCheck::Conforming, mesh);
  if (status.Ok() && graph && !surfaceData)
  {
    status =
      Status(StatusCode::InvalidOption, "Features need the surface they belong to (input 1).");
  }
  if (status.Ok() && surfaceData)
  {
    status = CheckedSurface(surfaceData, surface, monitor);
    targets.Surface = &surface;
  }
  if (status.Ok() && graph && graph->GetNumberOfCells() > 0)
  {
    FeatureLabels labels;
    status = LabelsFromGrid(input, labels);
    status = status.Ok() ? FeaturesFromPolyData(surface, graph, ofSurface) : status;
    if (status.Ok())
    {
      ofMesh = RecoverFeatures(mesh, ExtractBoundary(mesh), surface, ofSurface, labels);
      targets.SurfaceGraph = &ofSurface;
      targets.MeshFeatures = &ofMesh;
    }
  }
  QuadraticMesh result;
  if (status.Ok())
  {
    QuadraticOptions options;
    options.NodesPerHex = this->HexType == Nodes27 ? 27 : 20;
    status = MakeQuadratic(mesh, targets, options, monitor, result);
  }
  if (!status.Ok())
  {
    return status;
  }
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs, 0);
  GridFromQuadratic(result, output);
  AddPointArrays(input, result, output);
  output->GetCellData()->ShallowCopy(input->GetCellData());
  output->GetFieldData()->ShallowCopy(input->GetFieldData());
  FigureRow row;
  row.Numbers = { { "BoundaryNodes", result.Report.BoundaryNodes },
    { "NodesOnSurface", result.Report.OnSurface }, { "NodesShortened", result.Report.Shortened },
    { "NodesTooFar", result.Report.TooFar },
    { "SmallestJacobianRatio", result.Report.SmallestRatio } };
  row.Write(output->GetFieldData());
  return Status();
}

//------------------------------------------------------------------------------
void vtkQuadraticHexFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "HexType: " << (this->HexType == Nodes27 ? "Nodes27" : "Nodes20") << "\n";
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkOctreeDualHexFilter.h"

#include "ArrayNames.h"
#include "DataConversion.h"
#include "OctreeDual.h"
#include "StageCheck.h"

#include "vtkCellData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkOctreeDualHexFilter);

using namespace featurehex;

//------------------------------------------------------------------------------
vtkOctreeDualHexFilter::vtkOctreeDualHexFilter()
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(1);
}

//------------------------------------------------------------------------------
vtkOctreeDualHexFilter::~vtkOctreeDualHexFilter() = default;

//------------------------------------------------------------------------------
int vtkOctreeDualHexFilter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
int vtkOctreeDualHexFilter::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkUnstructuredGrid");
  return 1;
}

//------------------------------------------------------------------------------
featurehex::Status vtkOctreeDualHexFilter::Compute(
  vtkInformationVector** inputs, vtkInformationVector* outputs, featurehex::Monitor& monitor)
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::GetData(inputs[0]);
  monitor.BeginPhase("reading the octree", 0.0, 0.2);
  BlockOctree octree;
  Status status = OctreeFromGrid(input, octree);
  if (!status.Ok())
  {
    return status;
  }
  monitor.BeginPhase("converting the octree to hexes", 0.2, 1.0);
  HexMesh mesh;
  OctreeDualArrays arrays;
  status = ConvertOctreeToHexes(octree, mesh, &arrays, monitor);
  if (status.Ok())
  {
    status = CheckStageOutput(
      { "octree dual", StagePromise::PositiveCorners,
        { { ArrayNames::Level, arrays.HexLevel.size(), mesh.Hexes.size() },
          { ArrayNames::DualHexKind, arrays.HexKind.size(), mesh.Hexes.size() },
          { ArrayNames::OctreeIndex, arrays.PointOctreeIndex.size(), mesh.Points.size() } } },
      mesh);
  }
  if (!status.Ok())
  {
    return status;
  }

  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs);
  GridFromMesh(mesh, output);
  output->GetFieldData()->PassData(input->GetFieldData());
  for (int& level : arrays.HexLevel)
  {
    level -= octree.BaseLevel;
  }
  std::vector<int> kind;
  for (DualHexKind k : arrays.HexKind)
  {
    kind.push_back(static_cast<int>(k));
  }
  AddArray(output->GetCellData(), ArrayNames::Level, arrays.HexLevel);
  AddArray(output->GetCellData(), ArrayNames::DualHexKind, kind);
  vtkNew<vtkIntArray> index;
  index->SetName(ArrayNames::OctreeIndex);
  index->SetNumberOfComponents(3);
  index->SetNumberOfTuples(output->GetNumberOfPoints());
  for (std::size_t i = 0; i < arrays.PointOctreeIndex.size(); ++i)
  {
    index->SetTypedTuple(static_cast<vtkIdType>(i), arrays.PointOctreeIndex[i].data());
  }
  output->GetPointData()->AddArray(index);
  return status;
}

//------------------------------------------------------------------------------
void vtkOctreeDualHexFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

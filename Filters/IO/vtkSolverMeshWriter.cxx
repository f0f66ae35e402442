// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSolverMeshWriter.h"

#include "GuardedVTKFiles.h"
#include "SolverConversion.h"

#include "vtkInformation.h"
#include "vtkUnstructuredGrid.h"

vtkSolverMeshWriter::vtkSolverMeshWriter() = default;

vtkSolverMeshWriter::~vtkSolverMeshWriter()
{
  this->SetFileName(nullptr);
}

int vtkSolverMeshWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

void vtkSolverMeshWriter::WriteData()
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::SafeDownCast(this->GetInput());
  const featurehex::Status status = featurehex::Guarded(this->FileName,
    [&]
    {
      featurehex::SolverMesh mesh;
      const featurehex::Status read = featurehex::SolverMeshFromGrid(input, mesh);
      return read.Ok() ? this->WriteSolverMesh(this->FileName, mesh) : read;
    });
  this->SetErrorCode(featurehex::ErrorCodeOf(status));
  if (!status.Ok())
  {
    vtkErrorMacro(<< status.Message);
  }
}

void vtkSolverMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}

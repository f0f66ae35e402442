// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeditMeshWriter.h"

#include "GuardedVTKFiles.h"
#include "MeditConversion.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkMeditMeshWriter);

vtkMeditMeshWriter::vtkMeditMeshWriter() = default;

vtkMeditMeshWriter::~vtkMeditMeshWriter()
{
  this->SetFileName(nullptr);
}

int vtkMeditMeshWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

void vtkMeditMeshWriter::WriteData()
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::SafeDownCast(this->GetInput());
  const featurehex::Status status = featurehex::Guarded(
    this->FileName, [&] { return featurehex::WriteMeditGrid(this->FileName, input); });
  this->SetErrorCode(featurehex::ErrorCodeOf(status));
  if (!status.Ok())
  {
    vtkErrorMacro(<< status.Message);
  }
}

void vtkMeditMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}

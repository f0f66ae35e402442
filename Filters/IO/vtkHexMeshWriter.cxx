// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexMeshWriter.h"

#include "FileAccess.h"
#include "GuardedVTKFiles.h"
#include "MeditConversion.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <string>

vtkStandardNewMacro(vtkHexMeshWriter);

namespace
{
featurehex::Status WriteFrom(const char* fileName, vtkUnstructuredGrid* input)
{
  const std::string extension = featurehex::FileExtension(fileName);
  if (input->GetNumberOfCells() == 0)
  {
    return featurehex::Status(featurehex::StatusCode::EmptySurface, "There are no cells to write.");
  }
  if (extension == ".vtu" || extension == ".vtk")
  {
    return featurehex::WriteVTKFile(fileName, input);
  }
  if (extension != ".mesh")
  {
    return featurehex::Status(featurehex::StatusCode::UnwritableFile,
      std::string("Can't write \"") + fileName +
        "\": volume meshes are written as .vtu, .vtk or .mesh.");
  }
  return featurehex::WriteMeditGrid(fileName, input);
}
} // namespace

vtkHexMeshWriter::vtkHexMeshWriter() = default;

vtkHexMeshWriter::~vtkHexMeshWriter()
{
  this->SetFileName(nullptr);
}

int vtkHexMeshWriter::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid");
  return 1;
}

void vtkHexMeshWriter::WriteData()
{
  vtkUnstructuredGrid* input = vtkUnstructuredGrid::SafeDownCast(this->GetInput());
  const featurehex::Status status =
    featurehex::Guarded(this->FileName, [&] { return WriteFrom(this->FileName, input); });
  this->SetErrorCode(featurehex::ErrorCodeOf(status));
  if (!status.Ok())
  {
    vtkErrorMacro(<< status.Message);
  }
}

void vtkHexMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexMeshReader.h"

#include "FileAccess.h"
#include "GuardedVTKFiles.h"
#include "MeditConversion.h"

#include "vtkMeditMeshReader.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <string>

vtkStandardNewMacro(vtkHexMeshReader);

namespace
{
featurehex::Status ReadInto(const char* fileName, vtkUnstructuredGrid* output)
{
  const std::string extension = featurehex::FileExtension(fileName);
  if (extension != ".mesh" && extension != ".vtu" && extension != ".vtk")
  {
    return featurehex::Status(featurehex::StatusCode::UnreadableFile,
      featurehex::FileBaseName(fileName) + ": volume meshes are read from .vtu, .vtk and .mesh.");
  }
  featurehex::Status status = extension == ".mesh"
    ? featurehex::ReadMeditGrid(fileName, false, output)
    : featurehex::ReadVTKFile(fileName, output);
  if (status.Ok() && output->GetNumberOfCells() == 0)
  {
    status = featurehex::Status(featurehex::StatusCode::EmptySurface,
      featurehex::FileBaseName(fileName) + ": the file has no volume cells.");
  }
  return status;
}
} // namespace

vtkHexMeshReader::vtkHexMeshReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkHexMeshReader::~vtkHexMeshReader()
{
  this->SetFileName(nullptr);
}

int vtkHexMeshReader::CanReadFile(const char* name)
{
  std::string head;
  if (!name || !featurehex::ReadFileHead(name, head))
  {
    return 0;
  }
  const std::string extension = featurehex::FileExtension(name);
  if (extension == ".mesh")
  {
    vtkNew<vtkMeditMeshReader> reader;
    return reader->CanReadFile(name);
  }
  return extension == ".vtu" || extension == ".vtk";
}

int vtkHexMeshReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  const featurehex::Status status =
    featurehex::Guarded(this->FileName, [&] { return ReadInto(this->FileName, output); });
  this->SetErrorCode(featurehex::ErrorCodeOf(status));
  if (!status.Ok())
  {
    output->Initialize();
    vtkErrorMacro(<< status.Message);
    return 0;
  }
  return 1;
}

void vtkHexMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}

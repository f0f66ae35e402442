// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMeditMeshReader.h"

#include "FileAccess.h"
#include "GuardedVTKFiles.h"
#include "MeditConversion.h"
#include "TextScanner.h"

#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <string>

vtkStandardNewMacro(vtkMeditMeshReader);

namespace
{
featurehex::Status ReadInto(const char* fileName, bool boundary, vtkUnstructuredGrid* output)
{
  featurehex::Status status = featurehex::ReadMeditGrid(fileName, boundary, output);
  if (status.Ok() && output->GetNumberOfCells() == 0)
  {
    status = featurehex::Status(featurehex::StatusCode::EmptySurface,
      featurehex::FileBaseName(fileName) + ": the file has no hexahedra" +
        (boundary ? " and no boundary elements." : ". BoundaryElements reads its other elements."));
  }
  return status;
}
} // namespace

vtkMeditMeshReader::vtkMeditMeshReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkMeditMeshReader::~vtkMeditMeshReader()
{
  this->SetFileName(nullptr);
}

int vtkMeditMeshReader::CanReadFile(const char* name)
{
  std::string head;
  if (!name || !featurehex::ReadFileHead(name, head))
  {
    return 0;
  }
  std::string_view word;
  featurehex::TextScanner scanner(head);
  return scanner.Word(word) && word == "MeshVersionFormatted";
}

int vtkMeditMeshReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputVector);
  const featurehex::Status status = featurehex::Guarded(
    this->FileName, [&] { return ReadInto(this->FileName, this->BoundaryElements, output); });
  this->SetErrorCode(featurehex::ErrorCodeOf(status));
  if (!status.Ok())
  {
    output->Initialize();
    vtkErrorMacro(<< status.Message);
    return 0;
  }
  return 1;
}

void vtkMeditMeshReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "BoundaryElements: " << (this->BoundaryElements ? "on" : "off") << "\n";
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHexMeshWriter.h"

#include "AbaqusWriter.h"
#include "ExodusWriter.h"
#include "FileAccess.h"
#include "GmshWriter.h"
#include "GuardedVTKFiles.h"
#include "MeditConversion.h"
#include "SolverConversion.h"
#include "UcdWriter.h"

#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include <string>

vtkStandardNewMacro(vtkHexMeshWriter);

namespace
{
using SolverWriter = featurehex::Status (*)(const std::string&, const featurehex::SolverMesh&);

/// Null: no format of a solver.
SolverWriter WriterOf(const std::string& extension)
{
  using namespace featurehex;
  if (extension == ".inp")
  {
    return WriteAbaqus;
  }
  if (extension == ".ucd")
  {
    return WriteUcd;
  }
  if (extension == ".exo" || extension == ".e")
  {
    return WriteExodus;
  }
  if (extension == ".msh")
  {
    return [](const std::string& path, const SolverMesh& mesh)
    { return WriteGmsh(path, mesh, GmshVersion::V41); };
  }
  if (extension == ".msh2")
  {
    return [](const std::string& path, const SolverMesh& mesh)
    { return WriteGmsh(path, mesh, GmshVersion::V22); };
  }
  return nullptr;
}

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
  if (extension == ".mesh")
  {
    return featurehex::WriteMeditGrid(fileName, input);
  }
  const SolverWriter write = WriterOf(extension);
  if (!write)
  {
    return featurehex::Status(featurehex::StatusCode::UnwritableFile,
      std::string("Can't write \"") + fileName +
        "\": volume meshes are written as .vtu, .vtk, .mesh, .inp, .msh, .msh2, .exo, .e or .ucd.");
  }
  featurehex::SolverMesh mesh;
  const featurehex::Status status = featurehex::SolverMeshFromGrid(input, mesh);
  return status.Ok() ? write(fileName, mesh) : status;
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

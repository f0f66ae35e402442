// SPDX-License-Identifier: BSD-3-Clause
#include "vtkGmshMeshWriter.h"

#include "GmshWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkGmshMeshWriter);

vtkGmshMeshWriter::vtkGmshMeshWriter() = default;

vtkGmshMeshWriter::~vtkGmshMeshWriter() = default;

featurehex::Status vtkGmshMeshWriter::WriteSolverMesh(
  const std::string& path, const featurehex::SolverMesh& mesh)
{
  return featurehex::WriteGmsh(path, mesh,
    this->FormatVersion == Version22 ? featurehex::GmshVersion::V22 : featurehex::GmshVersion::V41);
}

void vtkGmshMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FormatVersion: " << (this->FormatVersion == Version22 ? "2.2" : "4.1") << "\n";
}

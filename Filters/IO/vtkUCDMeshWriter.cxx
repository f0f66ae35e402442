// SPDX-License-Identifier: BSD-3-Clause
#include "vtkUCDMeshWriter.h"

#include "UcdWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkUCDMeshWriter);

vtkUCDMeshWriter::vtkUCDMeshWriter() = default;

vtkUCDMeshWriter::~vtkUCDMeshWriter() = default;

featurehex::Status vtkUCDMeshWriter::WriteSolverMesh(
  const std::string& path, const featurehex::SolverMesh& mesh)
{
  return featurehex::WriteUcd(path, mesh);
}

void vtkUCDMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

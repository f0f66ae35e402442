// SPDX-License-Identifier: BSD-3-Clause
#include "vtkAbaqusMeshWriter.h"

#include "AbaqusWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkAbaqusMeshWriter);

vtkAbaqusMeshWriter::vtkAbaqusMeshWriter() = default;

vtkAbaqusMeshWriter::~vtkAbaqusMeshWriter() = default;

featurehex::Status vtkAbaqusMeshWriter::WriteSolverMesh(
  const std::string& path, const featurehex::SolverMesh& mesh)
{
  return featurehex::WriteAbaqus(path, mesh);
}

void vtkAbaqusMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "vtkExodusMeshWriter.h"

#include "ExodusWriter.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkExodusMeshWriter);

vtkExodusMeshWriter::vtkExodusMeshWriter() = default;

vtkExodusMeshWriter::~vtkExodusMeshWriter() = default;

featurehex::Status vtkExodusMeshWriter::WriteSolverMesh(
  const std::string& path, const featurehex::SolverMesh& mesh)
{
  return featurehex::WriteExodus(path, mesh);
}

void vtkExodusMeshWriter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

// SPDX-License-Identifier: BSD-3-Clause
// Meshes a surface file: consumer IN OUT. The C++ example of FeatureHex.
#include "ArrayNames.h"
#include "vtkFeatureHexMesher.h"
#include "vtkHexMeshWriter.h"
#include "vtkSurfaceFileReader.h"

#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: consumer IN OUT\n";
    return 2;
  }

  vtkNew<vtkSurfaceFileReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkFeatureHexMesher> mesher;
  mesher->SetInputConnection(reader->GetOutputPort());
  mesher->SetTolerance(0.005); // of the diagonal of the bounding box
  mesher->Update();

  // Empty output: an error has been reported through vtkErrorMacro, with what to do about it.
  auto* mesh = vtkUnstructuredGrid::SafeDownCast(mesher->GetOutputDataObject(0));
  if (mesh->GetNumberOfCells() == 0)
  {
    return 1;
  }
  double quality[2];
  mesh->GetCellData()->GetArray(featurehex::ArrayNames::ScaledJacobian)->GetRange(quality);
  std::cout << mesh->GetNumberOfCells() << " hexahedra, scaled Jacobian " << quality[0] << " to "
            << quality[1] << "\n";

  vtkNew<vtkHexMeshWriter> writer;
  writer->SetInputData(mesh);
  writer->SetFileName(argv[2]);
  return writer->Write() && quality[0] > 0 ? 0 : 1;
}

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkAbaqusMeshWriter
 * @brief Writes hexes for Abaqus and CalculiX, .inp.
 *
 * <b>Output:</b> nodes and elements C3D8 or C3D20, with ids from 1 in the order of the input.
 * Element sets body_#; for each patch the surface patch_#, the element set patch_# and those of its
 * face numbers, patch_#_S1 to patch_#_S6, and the node set patch_#; node sets curve_# and corner_#.
 * No material, step or load: another file has them and an *INCLUDE of this one. Numbers have at
 * most 20 characters, because solvers read no more: 13 to 17 digits. 27 nodes are an error.
 *
 * Input, errors and cost: vtkSolverMeshWriter.
 *
 * @sa vtkSolverMeshWriter vtkQuadraticHexFilter
 */

#ifndef vtkAbaqusMeshWriter_h
#define vtkAbaqusMeshWriter_h

#include "vtkFeatureHexIOModule.h" // For export macro
#include "vtkSolverMeshWriter.h"

class VTKFEATUREHEXIO_EXPORT vtkAbaqusMeshWriter : public vtkSolverMeshWriter
{
public:
  static vtkAbaqusMeshWriter* New();
  vtkTypeMacro(vtkAbaqusMeshWriter, vtkSolverMeshWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkAbaqusMeshWriter();
  ~vtkAbaqusMeshWriter() override;

  featurehex::Status WriteSolverMesh(
    const std::string& path, const featurehex::SolverMesh& mesh) override;

private:
  vtkAbaqusMeshWriter(const vtkAbaqusMeshWriter&) = delete;
  void operator=(const vtkAbaqusMeshWriter&) = delete;
};

#endif

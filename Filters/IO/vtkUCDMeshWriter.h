// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkUCDMeshWriter
 * @brief Writes hexes as AVS UCD, .ucd, which deal.II reads.
 *
 * <b>Output:</b> hexahedra with the body as material; boundary quads with PatchId + 1 and feature
 * edges with CurveId + 1 as material, which deal.II (GridIn::read_ucd) takes as boundary ids; 0 is
 * what it gives to faces without any. Linear only: quadratic hexahedra are an error.
 *
 * Input, errors and cost: vtkSolverMeshWriter.
 *
 * @sa vtkSolverMeshWriter vtkQuadraticHexFilter
 */

#ifndef vtkUCDMeshWriter_h
#define vtkUCDMeshWriter_h

#include "vtkFeatureHexIOModule.h" // For export macro
#include "vtkSolverMeshWriter.h"

class VTKFEATUREHEXIO_EXPORT vtkUCDMeshWriter : public vtkSolverMeshWriter
{
public:
  static vtkUCDMeshWriter* New();
  vtkTypeMacro(vtkUCDMeshWriter, vtkSolverMeshWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkUCDMeshWriter();
  ~vtkUCDMeshWriter() override;

  featurehex::Status WriteSolverMesh(
    const std::string& path, const featurehex::SolverMesh& mesh) override;

private:
  vtkUCDMeshWriter(const vtkUCDMeshWriter&) = delete;
  void operator=(const vtkUCDMeshWriter&) = delete;
};

#endif

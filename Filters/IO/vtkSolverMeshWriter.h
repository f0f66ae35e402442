// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSolverMeshWriter
 * @brief Abstract base of the writers for solvers: bodies, patches, curves and corners by name.
 *
 * <b>Input:</b> vtkUnstructuredGrid of hexahedra: VTK_HEXAHEDRON, or all VTK_QUADRATIC_HEXAHEDRON
 * or all VTK_TRIQUADRATIC_HEXAHEDRON (vtkQuadraticHexFilter). Optional arrays: Region of the cells
 * (the body, 1 and up); with linear hexahedra also VTK_QUAD with PatchId, VTK_LINE with CurveId and
 * VTK_VERTEX. What vtkFeatureHexMesher made has its patches, curves and corners in point arrays
 * (FeatureKind, FeatureId) and field data (FeatureQuads, FeatureEdges). When a filter took a part
 * of the mesh the field data no longer fits: the point arrays still give patches and corners, and
 * the cut is one more patch with the next number. Without any arrays all of the boundary is patch
 * 0.
 *
 * <b>Output:</b> the file, with groups named body_1, patch_0, curve_0, corner_0 after Region,
 * PatchId, CurveId and CornerId. It is written under another name first and renamed when complete:
 * there is never half a file, and an existing one stays when writing fails.
 *
 * <b>Errors:</b> one: no hexahedra, another type of cell, what the format doesn't have, a
 * coordinate that is not finite, a file that can't be written. Write() returns 0 then.
 * GetErrorCode() is a code of vtkErrorCode, or vtkErrorCode::UserError + featurehex::StatusCode.
 *
 * <b>Cost:</b> n log n; a text is put together in memory, some 150 bytes a hexahedron.
 *
 * @sa vtkAbaqusMeshWriter vtkGmshMeshWriter vtkUCDMeshWriter vtkExodusMeshWriter vtkHexMeshWriter
 */

#ifndef vtkSolverMeshWriter_h
#define vtkSolverMeshWriter_h

#include "vtkFeatureHexIOModule.h" // For export macro
#include "vtkWriter.h"

#include <string> // For WriteSolverMesh

namespace featurehex
{
struct SolverMesh;
struct Status;
} // namespace featurehex

class VTKFEATUREHEXIO_EXPORT vtkSolverMeshWriter : public vtkWriter
{
public:
  vtkTypeMacro(vtkSolverMeshWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * File to write. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkSolverMeshWriter();
  ~vtkSolverMeshWriter() override;

  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

  /// Writes @a mesh, which is checked, in the format of the class.
  virtual featurehex::Status WriteSolverMesh(
    const std::string& path, const featurehex::SolverMesh& mesh) = 0;

private:
  vtkSolverMeshWriter(const vtkSolverMeshWriter&) = delete;
  void operator=(const vtkSolverMeshWriter&) = delete;

  char* FileName = nullptr;
};

#endif

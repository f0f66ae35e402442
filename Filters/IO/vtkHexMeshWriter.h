// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHexMeshWriter
 * @brief Writes a volume mesh in the format that the extension says: VTK, Medit, or for solvers.
 *
 * <b>Input:</b> vtkUnstructuredGrid; for .mesh see vtkMeditMeshWriter, for the formats of solvers
 * vtkSolverMeshWriter.
 *
 * <b>Output:</b> the file. It is written under another name first and renamed when complete, so
 * that there is never half a file; an existing one stays when writing fails.
 * - .vtu: all arrays; inline base64 and compressed, because the ParaView of Debian 12 can't read
 *   appended data;
 * - .vtk: all arrays; legacy version 4.2, binary, which most other programs can read;
 * - .mesh: ASCII, with the references that vtkMeditMeshWriter writes;
 * - .inp: Abaqus, vtkAbaqusMeshWriter;
 * - .msh, .msh2: Gmsh, version 4.1 and 2.2, vtkGmshMeshWriter;
 * - .exo, .e: Exodus II, vtkExodusMeshWriter;
 * - .ucd: AVS UCD, vtkUCDMeshWriter.
 *
 * <b>Errors:</b> one: no cells, another extension, a file that can't be written. Write() returns 0
 * then. GetErrorCode() is a code of
 * vtkErrorCode, or vtkErrorCode::UserError + featurehex::StatusCode.
 *
 * <b>Cost:</b> linear.
 *
 * @sa vtkHexMeshReader vtkMeditMeshWriter vtkSolverMeshWriter
 */

#ifndef vtkHexMeshWriter_h
#define vtkHexMeshWriter_h

#include "vtkFeatureHexIOModule.h" // For export macro
#include "vtkWriter.h"

class VTKFEATUREHEXIO_EXPORT vtkHexMeshWriter : public vtkWriter
{
public:
  static vtkHexMeshWriter* New();
  vtkTypeMacro(vtkHexMeshWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * File to write. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkHexMeshWriter();
  ~vtkHexMeshWriter() override;

  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkHexMeshWriter(const vtkHexMeshWriter&) = delete;
  void operator=(const vtkHexMeshWriter&) = delete;

  char* FileName = nullptr;
};

#endif

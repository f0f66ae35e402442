// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkGmshMeshWriter
 * @brief Writes hexes as Gmsh .msh, ASCII, version 4.1 or 2.2.
 *
 * <b>Output:</b> hexahedra of 8, 20 or 27 nodes, boundary quads, feature edges and corners in named
 * physical groups body_#, patch_#, curve_#, corner_#. Physical tags start at 1 in Gmsh: that of
 * patch_0 is 1, of body_1 is 1. Coordinates read back with the same bits.
 *
 * Input, errors and cost: vtkSolverMeshWriter.
 *
 * @sa vtkSolverMeshWriter vtkQuadraticHexFilter
 */

#ifndef vtkGmshMeshWriter_h
#define vtkGmshMeshWriter_h

#include "vtkFeatureHexIOModule.h" // For export macro
#include "vtkSolverMeshWriter.h"

class VTKFEATUREHEXIO_EXPORT vtkGmshMeshWriter : public vtkSolverMeshWriter
{
public:
  static vtkGmshMeshWriter* New();
  vtkTypeMacro(vtkGmshMeshWriter, vtkSolverMeshWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Versions of the format.
   */
  enum FormatVersions
  {
    Version22 = 0, ///< 2.2, which more programs read
    Version41 = 1  ///< 4.1
  };

  ///@{
  /**
   * Version of the format. Default: 4.1.
   */
  vtkSetClampMacro(FormatVersion, int, Version22, Version41);
  vtkGetMacro(FormatVersion, int);
  void SetFormatVersionToVersion22() { this->SetFormatVersion(Version22); }
  void SetFormatVersionToVersion41() { this->SetFormatVersion(Version41); }
  ///@}

protected:
  vtkGmshMeshWriter();
  ~vtkGmshMeshWriter() override;

  featurehex::Status WriteSolverMesh(
    const std::string& path, const featurehex::SolverMesh& mesh) override;

private:
  vtkGmshMeshWriter(const vtkGmshMeshWriter&) = delete;
  void operator=(const vtkGmshMeshWriter&) = delete;

  int FormatVersion = Version41;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkExodusMeshWriter
 * @brief Writes hexes as Exodus II, .exo or .e, with side sets and node sets.
 *
 * <b>Output:</b> an element block body_# (HEX8, HEX20 or HEX27) for each body, a side set patch_#
 * with id PatchId + 1 for each patch, a node set curve_# with id CurveId + 1 for each curve and a
 * node set corner_# for each corner (ids after the highest of a curve). netCDF classic, 64-bit
 * offsets, double precision; the same mesh gives the same bytes, which vtkExodusIIWriter doesn't.
 *
 * Input, errors and cost: vtkSolverMeshWriter.
 *
 * @sa vtkSolverMeshWriter vtkQuadraticHexFilter
 */

#ifndef vtkExodusMeshWriter_h
#define vtkExodusMeshWriter_h

#include "vtkFeatureHexIOModule.h" // For export macro
#include "vtkSolverMeshWriter.h"

class VTKFEATUREHEXIO_EXPORT vtkExodusMeshWriter : public vtkSolverMeshWriter
{
public:
  static vtkExodusMeshWriter* New();
  vtkTypeMacro(vtkExodusMeshWriter, vtkSolverMeshWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkExodusMeshWriter();
  ~vtkExodusMeshWriter() override;

  featurehex::Status WriteSolverMesh(
    const std::string& path, const featurehex::SolverMesh& mesh) override;

private:
  vtkExodusMeshWriter(const vtkExodusMeshWriter&) = delete;
  void operator=(const vtkExodusMeshWriter&) = delete;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkOctreeDualHexFilter
 * @brief The dual of a block octree: a conforming all-hex mesh of its whole domain.
 *
 * Cell centres become vertices; where levels meet, templates with new vertices keep all cells
 * hexahedra.
 *
 * <b>Input:</b> vtkUnstructuredGrid, an octree of vtkSurfaceOctreeFilter; cell order doesn't
 * matter. Needs the cell arrays Level and OctreeIndex and the field data with the octree's frame.
 *
 * <b>Output:</b> vtkUnstructuredGrid of VTK_HEXAHEDRON, points in double precision. Cells: Level
 * (int, halvings of the target edge length, of the finest cells at the hex), DualHexKind (int, 0
 * cube, 1 mixed corner, 2 frustum, 3 mixed edge). Points: OctreeIndex (3 int, lowest corner of the
 * octree cell of the vertex). Field data: TargetEdgeLength and what else the octree has.
 *
 * <b>Guarantees:</b> conforming; the smallest scaled Jacobian of all possible neighbourhoods is
 * 0.4386 (enumerated). The mesh ends half a cell inside the octree's border.
 *
 * <b>Errors:</b> missing arrays, cells that are no balanced block octree (give the octree filter's
 * output), more than 2^31 hexes.
 *
 * <b>Units:</b> model units.
 *
 * <b>Threads and determinism:</b> vtkSMPTools; the same bits for any number of threads.
 *
 * <b>Cost:</b> linear; 3 microseconds a hex.
 *
 * <b>References:</b> X. Gao, H. Shen, D. Panozzo, "Feature Preserving Octree-Based Hexahedral
 * Meshing", Computer Graphics Forum 38(5), 2019, doi:10.1111/cgf.13795.
 *
 * @sa vtkSurfaceOctreeFilter vtkHexDomainFilter
 */

#ifndef vtkOctreeDualHexFilter_h
#define vtkOctreeDualHexFilter_h

#include "vtkFeatureHexAlgorithm.h"
#include "vtkFeatureHexPipelineModule.h" // For export macro

class VTKFEATUREHEXPIPELINE_EXPORT vtkOctreeDualHexFilter : public vtkFeatureHexAlgorithm
{
public:
  static vtkOctreeDualHexFilter* New();
  vtkTypeMacro(vtkOctreeDualHexFilter, vtkFeatureHexAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkOctreeDualHexFilter();
  ~vtkOctreeDualHexFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  featurehex::Status Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
    featurehex::Monitor& monitor) override;

private:
  vtkOctreeDualHexFilter(const vtkOctreeDualHexFilter&) = delete;
  void operator=(const vtkOctreeDualHexFilter&) = delete;
};

#endif

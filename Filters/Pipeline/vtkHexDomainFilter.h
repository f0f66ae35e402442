// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHexDomainFilter
 * @brief Which hexes lie in the body: manifold interface, and the topology of the surface or where
 * it isn't reached.
 *
 * Hexes are labelled by the sign of the distance of their centres (winding number). Then hexes are
 * added and removed until the interface is a manifold and pieces and handles that the cells tore
 * off are mended as far as possible. Components, cavities and genus are compared with the surface.
 *
 * <b>Input 0:</b> vtkUnstructuredGrid, hex mesh (hexahedra or voxels) that reaches beyond the
 * surface on all sides, such as that of vtkOctreeDualHexFilter. Cells: Level (optional). Field
 * data: TargetEdgeLength (optional; without it the largest cells near the surface count as level
 * 0).
 *
 * <b>Input 1:</b> vtkPolyData, the surface (triangles, strips or polygons): closed, without
 * self-intersections; vtkSurfaceFeatureFilter says what that means.
 *
 * <b>Output 0:</b> vtkUnstructuredGrid, all hexes with all arrays. Cells: Region (int, 0 outside, 1
 * and up: body). Field data, one double each: NumberOfRegions, TopologyMatches (1: components,
 * cavities and genus are those of the surface), SurfaceCovered (1: no part of the surface is far
 * from the hexes), LonelyFlips, RepairFlips, IslandFlips, HandleFlips (hexes changed by each
 * repair).
 *
 * <b>Output 1:</b> vtkPolyData, refinement points as vertices for input 2 of
 * vtkSurfaceOctreeFilter. Points: Level (int, wanted), Reason (string: "topology" or "missing
 * surface"). Empty when all is well.
 *
 * <b>Guarantees:</b> the interface is a manifold. Topology is only measured: when TopologyMatches
 * is 0, refine at output 1.
 *
 * <b>Errors:</b> what vtkSurfaceFeatureFilter reports; a hex mesh that is not conforming or ends
 * inside the body; an interface that could not be made a manifold (lower TargetEdgeLength).
 *
 * <b>Units:</b> model units.
 *
 * <b>Threads and determinism:</b> vtkSMPTools; the same bits for any number of threads.
 *
 * <b>Cost:</b> 20 microseconds a hex near the surface.
 *
 * <b>References:</b> G. Barill, N. Dickson, R. Schmidt, D. Levin, A. Jacobson, "Fast Winding
 * Numbers for Soups and Clouds", ACM TOG 37(4), 2018, doi:10.1145/3197517.3201337.
 *
 * @sa vtkOctreeDualHexFilter vtkHexPaddingFilter
 */

#ifndef vtkHexDomainFilter_h
#define vtkHexDomainFilter_h

#include "vtkFeatureHexAlgorithm.h"
#include "vtkFeatureHexPipelineModule.h" // For export macro

class VTKFEATUREHEXPIPELINE_EXPORT vtkHexDomainFilter : public vtkFeatureHexAlgorithm
{
public:
  static vtkHexDomainFilter* New();
  vtkTypeMacro(vtkHexDomainFilter, vtkFeatureHexAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * A hex belongs to the body when its centre is inside, or outside by less than this many local
   * cell sizes where gaps allow it. Small positive values fit better at the cost of more hexes;
   * negative ones lose thin parts. Default: 0.1. Range: -1 to 1.
   */
  vtkSetClampMacro(LabelBias, double, -1.0, 1.0);
  vtkGetMacro(LabelBias, double);
  ///@}

  ///@{
  /**
   * Refinement points ask for at most this many halvings of the target edge length. Default: 4.
   * Range: 0 to 12.
   */
  vtkSetClampMacro(MaximumLevel, int, 0, 12);
  vtkGetMacro(MaximumLevel, int);
  ///@}

  ///@{
  /**
   * Details of the surface smaller than this count for nothing when thickness and gaps are
   * measured; fraction of the diagonal of the bounding box. Default: 0.005. Range: 0.00001 to 0.1.
   */
  vtkSetClampMacro(Tolerance, double, 1e-5, 0.1);
  vtkGetMacro(Tolerance, double);
  ///@}

protected:
  vtkHexDomainFilter();
  ~vtkHexDomainFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  featurehex::Status Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
    featurehex::Monitor& monitor) override;

private:
  vtkHexDomainFilter(const vtkHexDomainFilter&) = delete;
  void operator=(const vtkHexDomainFilter&) = delete;

  double LabelBias = 0.1;
  int MaximumLevel = 4;
  double Tolerance = 0.005;
};

#endif

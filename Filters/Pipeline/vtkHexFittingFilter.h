// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHexFittingFilter
 * @brief Draws the boundary of a hex mesh onto the surface and raises the worst hexes.
 *
 * Minimises distortion and the distance to the closest points, both ways, over all vertices; no
 * step leaves validity. Vertices of sharp features go to their own corner, curve or patch, not to
 * the closest one, and stay there. Then the worst hexes are improved inside the tolerance, unless
 * the boundary is still farther than 1.4 tolerances from the surface somewhere: there the octree
 * has to be refined first.
 *
 * <b>Input 0:</b> vtkUnstructuredGrid, conforming mesh of the bodies (hexahedra or voxels) without
 * inverted hexes, near the surface: that of vtkHexUntangleFilter. Cells: Level (optional, for
 * output 1). Points FeatureKind, FeatureId and field data FeatureQuads, FeatureEdges (optional):
 * the features of vtkHexFeatureMappingFilter. Field data: TargetEdgeLength (optional, thins output
 * 1).
 *
 * <b>Input 1:</b> vtkPolyData, the surface (triangles, strips or polygons): closed, without
 * self-intersections; vtkSurfaceFeatureFilter says what that means.
 *
 * <b>Input 2 (optional):</b> vtkPolyData, the feature graph that vtkHexFeatureMappingFilter had. A
 * warning says when the mesh has no features, or has some and there is no graph.
 *
 * <b>Output 0:</b> vtkUnstructuredGrid of VTK_HEXAHEDRON: the same hexes and arrays, moved points.
 * ScaledJacobian, Certified and Defects of the input are left out. Field data, one double each:
 * WithinTolerance (1: proven), Improved (1: the worst-element stage ran), HexesBelowMinimum (left
 * below MinimumScaledJacobian by it), VerticesOffFeatures (with features: vertices of corners and
 * curves that could not be put on them without an invalid hex).
 *
 * <b>Output 1:</b> vtkPolyData, refinement points as vertices for input 2 of
 * vtkSurfaceOctreeFilter, where the tolerance is exceeded. Points: Level (int, one more than the
 * hex there), Reason (string, "distance"). Empty when WithinTolerance is 1.
 *
 * <b>Guarantees:</b> no corner is inverted; when output 1 is empty, the Jacobian of each element
 * is proven positive. The distance is only measured here: when WithinTolerance is 0, refine at
 * output 1.
 *
 * <b>Errors:</b> inverted hexes (untangle first); features of the mesh that are not those of the
 * graph; a mesh that is not conforming; a hex inside the tolerance that is not proven valid (refine
 * the octree there); what vtkSurfaceFeatureFilter reports.
 *
 * <b>Units:</b> Tolerance is a fraction of the bounding-box diagonal.
 *
 * <b>Threads and determinism:</b> vtkSMPTools; the same bits for any number of threads.
 *
 * <b>Cost:</b> about 0.5 ms a hex on one core; memory grows with (diagonal / Tolerance)^2 for the
 * samples of the surface.
 *
 * <b>References:</b> Gao, Shen, Panozzo 2019 (see vtkFeatureHexMesher); X.-M. Fu, Y. Liu, B. Guo,
 * "Computing Locally Injective Mappings by Advanced MIPS", ACM TOG 34(4), 2015,
 * doi:10.1145/2766938.
 *
 * @sa vtkHexUntangleFilter vtkHexValidationFilter
 */

#ifndef vtkHexFittingFilter_h
#define vtkHexFittingFilter_h

#include "vtkFeatureHexAlgorithm.h"
#include "vtkFeatureHexPipelineModule.h" // For export macro

class VTKFEATUREHEXPIPELINE_EXPORT vtkHexFittingFilter : public vtkFeatureHexAlgorithm
{
public:
  static vtkHexFittingFilter* New();
  vtkTypeMacro(vtkHexFittingFilter, vtkFeatureHexAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Largest distance between boundary and surface, both ways, as a fraction of the diagonal of the
   * surface's bounding box. Default: 0.005. Range: 0.00001 to 0.1.
   */
  vtkSetClampMacro(Tolerance, double, 1e-5, 0.1);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /**
   * Scaled Jacobian that the worst hexes are raised to, best effort; 0: no such stage. Default:
   * 0.55. Range: 0 to 1; more than 0.6 costs time and is seldom reached.
   */
  vtkSetClampMacro(MinimumScaledJacobian, double, 0.0, 1.0);
  vtkGetMacro(MinimumScaledJacobian, double);
  ///@}

  ///@{
  /**
   * Projections of the boundary to the surface. Default: 14. Range: 1 to 1000.
   */
  vtkSetClampMacro(FittingIterations, int, 1, 1000);
  vtkGetMacro(FittingIterations, int);
  ///@}

  ///@{
  /**
   * Rounds of the worst-element stage. Default: 8. Range: 1 to 1000.
   */
  vtkSetClampMacro(ImprovementRounds, int, 1, 1000);
  vtkGetMacro(ImprovementRounds, int);
  ///@}

protected:
  vtkHexFittingFilter();
  ~vtkHexFittingFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  featurehex::Status Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
    featurehex::Monitor& monitor) override;

private:
  vtkHexFittingFilter(const vtkHexFittingFilter&) = delete;
  void operator=(const vtkHexFittingFilter&) = delete;

  double Tolerance = 0.005;
  double MinimumScaledJacobian = 0.55;
  int FittingIterations = 14;
  int ImprovementRounds = 8;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHexFeatureMappingFilter
 * @brief Which vertices, edges and quads of the interface become the corners, curves and patches of
 * the surface.
 *
 * Corners become interface vertices, one to one. Curves become paths of interface edges: shortest
 * ones near the curve that keep their cyclic order at the corners and touch nowhere else; a path
 * that blocks another one is given up and looked for again. Patches are the pieces between the
 * paths, matched one to one by the curves that bound them. No point moves.
 *
 * <b>Input 0:</b> vtkUnstructuredGrid, hex mesh of vtkHexDomainFilter. Cells: Region (0 outside, 1
 * and up: body) with a manifold interface, Level (optional, for output 1). Field data:
 * TargetEdgeLength (optional: thins output 1; curves are cut short by three of it at corners that
 * are not enforced).
 *
 * <b>Input 1:</b> vtkPolyData, the surface (triangles, strips or polygons): closed, without
 * self-intersections; vtkSurfaceFeatureFilter says what that means.
 *
 * <b>Input 2:</b> vtkPolyData, its feature graph: lines and vertices, points of the surface
 * (output 1 of vtkSurfaceFeatureFilter, vtkFeatureGraphReader). Without curves the mesh passes as
 * it is.
 *
 * <b>Output 0:</b> vtkUnstructuredGrid, all hexes with all arrays. Points: FeatureKind (int, 0
 * interior, 1 surface, 2 curve, 3 corner), FeatureId (int, patch, curve or corner; -1 interior, or
 * between patches that no curve parts). Field data, when all features are mapped: FeatureQuads (5
 * int: the four points of each interface quad, its patch), FeatureEdges (3 int: two points, curve;
 * edge by edge along each path); vtkHexPaddingFilter and the stages after it need them. One double
 * each: FeaturesMapped (1: all), MappingFailures (features that could not be mapped),
 * ReroutedCurves (paths that were given up for others).
 *
 * <b>Output 1:</b> vtkPolyData, refinement points as vertices for input 2 of
 * vtkSurfaceOctreeFilter, where features could not be mapped. Points: Level (int, one more than the
 * hex there), Reason (string, names the feature). Empty when FeaturesMapped is 1, or where
 * MaximumLevel is reached.
 *
 * <b>Guarantees:</b> with FeaturesMapped = 1 every enforced corner, curve and patch has exactly one
 * image, and these meet as on the surface.
 *
 * <b>Errors:</b> no array Region, no hex in a body, an interface that is no manifold, a mesh that
 * is not conforming; points of the graph that are none of the surface; what
 * vtkSurfaceFeatureFilter reports.
 *
 * <b>Units:</b> model units.
 *
 * <b>Threads and determinism:</b> sequential; always the same bits.
 *
 * <b>Cost:</b> n log n in the interface edges near each curve; milliseconds beside the surface
 * check.
 *
 * <b>References:</b> X. Gao, H. Shen, D. Panozzo, "Feature Preserving Octree-Based Hexahedral
 * Meshing", Computer Graphics Forum 38(5), 2019, doi:10.1111/cgf.13795.
 *
 * @sa vtkSurfaceFeatureFilter vtkHexDomainFilter vtkHexPaddingFilter
 */

#ifndef vtkHexFeatureMappingFilter_h
#define vtkHexFeatureMappingFilter_h

#include "vtkFeatureHexAlgorithm.h"
#include "vtkFeatureHexPipelineModule.h" // For export macro

class VTKFEATUREHEXPIPELINE_EXPORT vtkHexFeatureMappingFilter : public vtkFeatureHexAlgorithm
{
public:
  static vtkHexFeatureMappingFilter* New();
  vtkTypeMacro(vtkHexFeatureMappingFilter, vtkFeatureHexAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * A corner goes to an interface vertex within this many local edge lengths, if there is one.
   * Default: 1.8. Range: 0.5 to 10.
   */
  vtkSetClampMacro(CornerReach, double, 0.5, 10.0);
  vtkGetMacro(CornerReach, double);
  ///@}

  ///@{
  /**
   * The path of a curve stays within this many local edge lengths of it. Default: 2.5. Range: 0.5
   * to 10.
   */
  vtkSetClampMacro(CurveReach, double, 0.5, 10.0);
  vtkGetMacro(CurveReach, double);
  ///@}

  ///@{
  /**
   * A curve that finds no way takes it from others, which look for another one; this often.
   * Default: 20. Range: 0 to 1000.
   */
  vtkSetClampMacro(MaximumAttempts, int, 0, 1000);
  vtkGetMacro(MaximumAttempts, int);
  ///@}

  ///@{
  /**
   * Refinement points ask for at most this many halvings of the target edge length. Default: 4.
   * Range: 0 to 12.
   */
  vtkSetClampMacro(MaximumLevel, int, 0, 12);
  vtkGetMacro(MaximumLevel, int);
  ///@}

protected:
  vtkHexFeatureMappingFilter();
  ~vtkHexFeatureMappingFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  featurehex::Status Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
    featurehex::Monitor& monitor) override;

private:
  vtkHexFeatureMappingFilter(const vtkHexFeatureMappingFilter&) = delete;
  void operator=(const vtkHexFeatureMappingFilter&) = delete;

  double CornerReach = 1.8;
  double CurveReach = 2.5;
  int MaximumAttempts = 20;
  int MaximumLevel = 4;
};

#endif

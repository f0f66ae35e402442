// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHexUntangleFilter
 * @brief Moves points until no hex is inverted.
 *
 * <b>Input 0:</b> vtkUnstructuredGrid, conforming hex mesh (hexahedra or voxels) with inverted
 * hexes or without. Points FeatureKind, FeatureId and field data FeatureQuads, FeatureEdges
 * (optional): the features of vtkHexFeatureMappingFilter.
 *
 * <b>Input 1 (optional):</b> vtkPolyData, the surface (triangles, strips or polygons): closed,
 * without self-intersections; vtkSurfaceFeatureFilter says what that means. The boundary is held
 * near it; without it boundary vertices don't move, and a padded mesh can seldom be freed.
 *
 * <b>Input 2 (optional):</b> vtkPolyData, the feature graph that vtkHexFeatureMappingFilter had:
 * vertices of features are held near their own corner, curve or patch. A warning says when the mesh
 * has no features, or has some and there is no graph.
 *
 * <b>Output:</b> vtkUnstructuredGrid of VTK_HEXAHEDRON: the same hexes and arrays, moved points.
 * ScaledJacobian, Certified and Defects of the input are left out. Field data, one double each:
 * InvertedHexesBefore, UntanglingSweeps.
 *
 * <b>Guarantees:</b> no corner of a hex is inverted.
 *
 * <b>Errors:</b> hexes that stay inverted (how many, where; raise MaximumSweeps, try the other
 * method, or refine there); features of the mesh that are not those of the graph; a mesh that is
 * not conforming; what vtkSurfaceFeatureFilter reports.
 *
 * <b>Units:</b> model units.
 *
 * <b>Threads and determinism:</b> vtkSMPTools; the same bits for any number of threads.
 *
 * <b>Cost:</b> 2 microseconds a vertex and sweep; 3 sweeps for most padded meshes. Stitching: 8
 * times as much (Documentation/untangling.md).
 *
 * <b>References:</b> V. Garanzha, I. Kaporin, L. Kudryavtseva, F. Protais, N. Ray, D. Sokolov,
 * "Foldover-free maps in 50 lines of code", ACM TOG 40(4), 2021, doi:10.1145/3450626.3459847;
 * stitching: X. Gao, H. Shen, D. Panozzo, "Feature Preserving Octree-Based Hexahedral Meshing",
 * Computer Graphics Forum 38(5), 2019, doi:10.1111/cgf.13795.
 *
 * @sa vtkHexPaddingFilter vtkHexFittingFilter
 */

#ifndef vtkHexUntangleFilter_h
#define vtkHexUntangleFilter_h

#include "vtkFeatureHexAlgorithm.h"
#include "vtkFeatureHexPipelineModule.h" // For export macro

class VTKFEATUREHEXPIPELINE_EXPORT vtkHexUntangleFilter : public vtkFeatureHexAlgorithm
{
public:
  static vtkHexUntangleFilter* New();
  vtkTypeMacro(vtkHexUntangleFilter, vtkFeatureHexAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * How hexes are untangled.
   */
  enum Methods
  {
    REGULARIZED = 0, ///< the mesh stays connected, the determinant is regularised
    STITCHING = 1    ///< hexes are taken apart and sewn together (the paper's)
  };

  ///@{
  /**
   * Regularized: the mesh stays connected and the determinant is regularised, which is faster and
   * leaves better hexes. Stitching: hexes are taken apart and sewn together. Default: REGULARIZED.
   */
  vtkSetClampMacro(Method, int, REGULARIZED, STITCHING);
  vtkGetMacro(Method, int);
  void SetMethodToRegularized() { this->SetMethod(REGULARIZED); }
  void SetMethodToStitching() { this->SetMethod(STITCHING); }
  ///@}

  ///@{
  /**
   * Sweeps over the mesh before the filter gives up. Default: 60. Range: 1 to 10,000.
   */
  vtkSetClampMacro(MaximumSweeps, int, 1, 10000);
  vtkGetMacro(MaximumSweeps, int);
  ///@}

protected:
  vtkHexUntangleFilter();
  ~vtkHexUntangleFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  featurehex::Status Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
    featurehex::Monitor& monitor) override;

private:
  vtkHexUntangleFilter(const vtkHexUntangleFilter&) = delete;
  void operator=(const vtkHexUntangleFilter&) = delete;

  int MaximumSweeps = 60;
  int Method = REGULARIZED;
};

#endif

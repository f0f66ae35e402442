// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFeatureHexMesher
 * @brief Closed triangle surface in, valid all-hex mesh out.
 *
 * The composite of all stages: checks and repairs the surface, builds an octree around it, converts
 * it to hexes, keeps those inside, pads, untangles and fits them, raises the worst ones, and proves
 * the result. Where a stage finds that the cells are too coarse, the octree is refined there and
 * the stages run again, at most MaximumRounds times. For scans and organic shapes: sharp edges are
 * met within the tolerance, but no mesh edges follow them.
 *
 * <b>Input 0:</b> vtkPolyData: triangles, strips or polygons of a closed surface, any number of
 * components and cavities; orientation doesn't matter, points of equal coordinates are merged.
 *
 * <b>Input 1 (optional):</b> vtkPolyData, annotation of sharp features. Not used yet: a warning
 * says so.
 *
 * <b>Output 0:</b> vtkUnstructuredGrid of VTK_HEXAHEDRON, points in double precision. Cells: Region
 * (int, 1 and up: the body), Level (int, halvings of the target edge length at this hex),
 * ScaledJacobian (double, smallest of the 8 corners). Field data: the columns of output 3.
 *
 * <b>Output 1:</b> vtkPolyData, the boundary quads, outward. Cells: PatchId (int, 0 and up: the
 * component of the input surface, in the order of their first triangles), Deviation (double, model
 * units: no point of the quad is farther from the input; proven).
 *
 * <b>Output 2:</b> vtkPolyData, feature polylines of the result. Empty without features.
 *
 * <b>Output 3:</b> vtkTable with one row: all figures of vtkHexValidationFilter; TargetEdgeLength
 * (the one used, model units); Rounds and RoundReasons; WantedScaledJacobianMissed (hexes left
 * below MinimumScaledJacobian); SurfaceRepairs (in words); Seconds… for each stage; PeakMemoryMiB
 * (of the process); Version; Option… for each property.
 *
 * <b>Guarantees:</b> the mesh is all-hex and conforming; its boundary is a manifold without
 * self-intersections and has the components, cavities and genus of the input; every Jacobian is
 * proven positive in the whole element; the Hausdorff distance to the input is proven to be at most
 * Tolerance, both ways. What can't be guaranteed is no mesh: one error, empty outputs.
 * MinimumScaledJacobian is best effort.
 *
 * <b>Errors:</b> a surface that is open, non-manifold, self-intersecting, not orientable, not
 * finite, empty or without volume (repair it: the message says where); CellLimit, TimeLimit; a
 * topology or a distance that MaximumLevel or MaximumRounds don't allow to reach (raise them or
 * Tolerance, or lower TargetEdgeLength).
 *
 * <b>Units:</b> Tolerance is a fraction of the bounding-box diagonal, lengths are in model units,
 * times in seconds.
 *
 * <b>Threads and determinism:</b> vtkSMPTools; the same bits for any number of threads.
 *
 * <b>Cost:</b> 1 to 2 ms per output hex on 2 cores; 160 MB for 7,000 hexes.
 *
 * <b>References:</b> X. Gao, H. Shen, D. Panozzo, "Feature Preserving Octree-Based Hexahedral
 * Meshing", Computer Graphics Forum 38(5), 2019, doi:10.1111/cgf.13795.
 *
 * @sa vtkSurfaceFeatureFilter vtkSurfaceOctreeFilter vtkOctreeDualHexFilter vtkHexDomainFilter
 * vtkHexPaddingFilter vtkHexUntangleFilter vtkHexFittingFilter vtkHexValidationFilter
 */

#ifndef vtkFeatureHexMesher_h
#define vtkFeatureHexMesher_h

#include "vtkFeatureHexAlgorithm.h"
#include "vtkFeatureHexPipelineModule.h" // For export macro

class VTKFEATUREHEXPIPELINE_EXPORT vtkFeatureHexMesher : public vtkFeatureHexAlgorithm
{
public:
  static vtkFeatureHexMesher* New();
  vtkTypeMacro(vtkFeatureHexMesher, vtkFeatureHexAlgorithm);
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
   * Edge length of the cells at the surface, model units; finer where thickness, gaps or the
   * tolerance ask for it. 0: the longest side of the bounding box / 26. Default: 0. Range: 0 and
   * up.
   */
  vtkSetClampMacro(TargetEdgeLength, double, 0.0, 1e100);
  vtkGetMacro(TargetEdgeLength, double);
  ///@}

  ///@{
  /**
   * Cells are refined at most this many halvings below the target edge length. Default: 4. Range: 0
   * to 12.
   */
  vtkSetClampMacro(MaximumLevel, int, 0, 12);
  vtkGetMacro(MaximumLevel, int);
  ///@}

  ///@{
  /**
   * An octree with more cells is an error, found before it is built. Default: 20,000,000. Range: 1
   * to 1,000,000,000.
   */
  vtkSetClampMacro(MaximumNumberOfCells, vtkIdType, 1, 1000000000);
  vtkGetMacro(MaximumNumberOfCells, vtkIdType);
  ///@}

  ///@{
  /**
   * Scaled Jacobian that the worst hexes are raised to, best effort. Default: 0.55. Range: 0 to 1;
   * more than 0.6 costs time and is seldom reached.
   */
  vtkSetClampMacro(MinimumScaledJacobian, double, 0.0, 1.0);
  vtkGetMacro(MinimumScaledJacobian, double);
  ///@}

  ///@{
  /**
   * Turn the octree into the principal axes of the surface where its box is smaller there: fewer
   * hexes for long shapes that lie askew. Default: off.
   */
  vtkSetMacro(AlignToPrincipalAxes, bool);
  vtkGetMacro(AlignToPrincipalAxes, bool);
  vtkBooleanMacro(AlignToPrincipalAxes, bool);
  ///@}

  ///@{
  /**
   * Rounds of refinement before the filter gives up with an error. Default: 12. Range: 1 to 100.
   */
  vtkSetClampMacro(MaximumRounds, int, 1, 100);
  vtkGetMacro(MaximumRounds, int);
  ///@}

  ///@{
  /**
   * Wall time in seconds after which the filter stops with an error; 0: none. Default: 0. Range: 0
   * and up.
   */
  vtkSetClampMacro(TimeLimit, double, 0.0, 1e9);
  vtkGetMacro(TimeLimit, double);
  ///@}

protected:
  vtkFeatureHexMesher();
  ~vtkFeatureHexMesher() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  featurehex::Status Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
    featurehex::Monitor& monitor) override;

private:
  vtkFeatureHexMesher(const vtkFeatureHexMesher&) = delete;
  void operator=(const vtkFeatureHexMesher&) = delete;

  double Tolerance = 0.005;
  double TargetEdgeLength = 0.0;
  int MaximumLevel = 4;
  vtkIdType MaximumNumberOfCells = 20000000;
  double MinimumScaledJacobian = 0.55;
  bool AlignToPrincipalAxes = false;
  int MaximumRounds = 12;
  double TimeLimit = 0.0;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHexValidationFilter
 * @brief Measures every promise about a hex mesh, with code that shares nothing with the optimiser.
 *
 * Scaled Jacobians (guarded: a broken hex never looks good), certified positivity of every Jacobian
 * over the whole element, conformity, manifold boundary, components, genus and cavities, exact
 * self-intersection test, singular edges; with a surface also its topology, volume and the
 * certified Hausdorff distance, both ways. An invalid mesh is a result here, no error.
 *
 * <b>Input 0:</b> vtkUnstructuredGrid, hexahedra or voxels.
 *
 * <b>Input 1 (optional):</b> vtkPolyData, the surface (triangles, strips or polygons): closed,
 * without self-intersections; vtkSurfaceFeatureFilter says what that means.
 *
 * <b>Input 2 (optional):</b> vtkPolyData, the feature graph of the surface, from
 * vtkFeatureGraphReader or output 1 of vtkSurfaceFeatureFilter. Whether the mesh reproduces it is
 * measured by the point arrays FeatureKind and FeatureId of input 0, which vtkFeatureHexMesher
 * makes. Needs input 1.
 *
 * <b>Output 0:</b> vtkUnstructuredGrid, the mesh with its arrays. Cells: ScaledJacobian (double,
 * smallest of the 8 corners, -1 for a broken hex), Certified (int, 1: Jacobian proven positive in
 * the whole hex), Defects (int, bits, 0: none). Field data: the columns of output 1.
 *
 * <b>Output 1:</b> vtkTable with one row: Valid (1: all promises that could be checked are kept)
 * and every figure behind it (double), Verdict (string: what is wrong). HausdorffUpper and the like
 * are fractions of the bounding-box diagonal, MeshToSurface… and SurfaceToMesh… too; areas and
 * volumes in model units.
 *
 * With features also FeaturesCaptured (no part of Valid), and of CornersFound, CornersEnforced,
 * CornersCaptured, CornerDeviationMaximum (fraction of the diagonal) and the same for curves and
 * patches.
 *
 * <b>Output 2:</b> vtkUnstructuredGrid, the offending hexes with their arrays. Cells: Defects,
 * Reason (string: NonFinitePoint, RepeatedId, DuplicateHex, NonPositiveCorner, NotCertified,
 * OverusedFace, TwistedFace, MisorientedFace, NonManifoldBoundary, SelfIntersecting,
 * BeyondTolerance), OriginalCellId (int).
 *
 * <b>Output 3:</b> vtkTable, one row for each corner, curve and patch: output 4 of
 * vtkFeatureHexMesher. Empty without features.
 *
 * <b>Guarantees:</b> bounds are proven, not sampled (mean distances are sampled).
 *
 * <b>Errors:</b> no cells, cells that are not hexahedra, ids out of range; a surface that can't be
 * compared with (what vtkSurfaceFeatureFilter reports).
 *
 * <b>Units:</b> Tolerance is a fraction of the bounding-box diagonal.
 *
 * <b>Threads and determinism:</b> vtkSMPTools; the same bits for any number of threads.
 *
 * <b>Cost:</b> 10 microseconds a hex, and the distance: about 1 s for 100,000 triangles.
 *
 * <b>References:</b> A. Johnen, J.-C. Weill, J.-F. Remacle, "Robust and efficient validation of the
 * linear hexahedral element", Procedia Engineering 203, 2017, doi:10.1016/j.proeng.2017.09.809; L.
 * Sacht, A. Jacobson, "Cascading upper bounds for triangle soup Pompeiu-Hausdorff distance",
 * Computer Graphics Forum 43(5), 2024, doi:10.1111/cgf.15129.
 *
 * @sa vtkFeatureHexMesher
 */

#ifndef vtkHexValidationFilter_h
#define vtkHexValidationFilter_h

#include "vtkFeatureHexAlgorithm.h"
#include "vtkFeatureHexPipelineModule.h" // For export macro

class VTKFEATUREHEXPIPELINE_EXPORT vtkHexValidationFilter : public vtkFeatureHexAlgorithm
{
public:
  static vtkHexValidationFilter* New();
  vtkTypeMacro(vtkHexValidationFilter, vtkFeatureHexAlgorithm);
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
   * Corners where more than six curves, or two at less than 30 degrees meet, count like others.
   * As it was when the mesh was made. Default: off.
   */
  vtkSetMacro(EnforceAllFeatures, bool);
  vtkGetMacro(EnforceAllFeatures, bool);
  vtkBooleanMacro(EnforceAllFeatures, bool);
  ///@}

  /**
   * 1: the last mesh keeps all promises that could be checked; 0: it does not, or there was none
   * yet.
   */
  vtkGetMacro(Valid, int);

  /**
   * Scaled Jacobian of the worst hex of the last mesh; 0 before.
   */
  vtkGetMacro(SmallestScaledJacobian, double);

  /**
   * Mean scaled Jacobian of the last mesh; 0 before.
   */
  vtkGetMacro(MeanScaledJacobian, double);

  /**
   * Proven bound of the distance between boundary and surface, as a fraction of the diagonal of
   * the bounding box; 0 without a surface.
   */
  vtkGetMacro(HausdorffBound, double);

protected:
  vtkHexValidationFilter();
  ~vtkHexValidationFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  featurehex::Status Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
    featurehex::Monitor& monitor) override;

private:
  vtkHexValidationFilter(const vtkHexValidationFilter&) = delete;
  void operator=(const vtkHexValidationFilter&) = delete;

  double Tolerance = 0.005;
  bool EnforceAllFeatures = false;
  int Valid = 0;
  double SmallestScaledJacobian = 0.0;
  double MeanScaledJacobian = 0.0;
  double HausdorffBound = 0.0;
};

#endif

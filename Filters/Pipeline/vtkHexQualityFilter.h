// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHexQualityFilter
 * @brief Charts and pictures of the quality of a hex mesh: histograms, worst hexes, deviation.
 *
 * For the eye; vtkHexValidationFilter proves. The scaled Jacobian of a hex is the smallest of its 8
 * corners, -1 for a broken hex.
 *
 * <b>Input 0:</b> vtkUnstructuredGrid, hexahedra or voxels.
 *
 * <b>Input 1 (optional):</b> vtkPolyData, the surface (triangles, strips or polygons): closed,
 * without self-intersections. With it the deviation is measured.
 *
 * <b>Output 0:</b> vtkTable, histogram of the scaled Jacobian. bin_extents: middle of the bin
 * (double; ParaView's bar charts take a column of this name as the axis), Hexes: how many (double).
 * NumberOfBins bins from 0 to 1; where hexes are inverted, more bins of the same width below 0.
 *
 * <b>Output 1:</b> vtkTable, histogram of the deviation. bin_extents: middle of the bin, a
 * fraction of the tolerance; Quads: how many boundary quads (double). NumberOfBins bins from 0 to
 * 1; where quads are beyond the tolerance, more of the same width up to 2, and what is beyond 2 in
 * the last one. Empty without a surface.
 *
 * <b>Output 2:</b> vtkUnstructuredGrid, the NumberOfWorstHexes hexes with the smallest scaled
 * Jacobians, the worst first, with the cell arrays of the input. Cells: ScaledJacobian (double),
 * OriginalCellId (int).
 *
 * <b>Output 3:</b> vtkPolyData, the boundary quads, outward. Cells: Deviation (double, model units,
 * distance to the surface: the greatest of the points that were looked at), DeviationOfTolerance
 * (double, Deviation as a fraction of the tolerance: 1 is as far as allowed). Empty without a
 * surface.
 *
 * <b>Guarantees:</b> none about the deviation: it is a measured value, at least the distance of
 * each corner of the quad; the proven bound is a figure of vtkHexValidationFilter.
 *
 * <b>Errors:</b> no cells, cells that are not hexahedra, ids out of range; with a surface also
 * points that are not finite, faces of more than two hexes, and a surface that can't be compared
 * with (what vtkSurfaceFeatureFilter reports).
 *
 * <b>Units:</b> Tolerance is a fraction of the diagonal of the surface's bounding box.
 *
 * <b>Threads and determinism:</b> vtkSMPTools; the same bits for any number of threads.
 *
 * <b>Cost:</b> linear; the distance about 1 s for 100,000 triangles.
 *
 * <b>References:</b> P. Knupp, "Algebraic mesh quality metrics for unstructured initial meshes",
 * Finite Elements in Analysis and Design 39, 2003, doi:10.1016/S0168-874X(02)00070-7.
 *
 * @sa vtkHexValidationFilter vtkFeatureHexMesher
 */

#ifndef vtkHexQualityFilter_h
#define vtkHexQualityFilter_h

#include "vtkFeatureHexAlgorithm.h"
#include "vtkFeatureHexPipelineModule.h" // For export macro

namespace featurehex
{
struct HexMesh;
struct SurfaceMesh;
} // namespace featurehex

class VTKFEATUREHEXPIPELINE_EXPORT vtkHexQualityFilter : public vtkFeatureHexAlgorithm
{
public:
  static vtkHexQualityFilter* New();
  vtkTypeMacro(vtkHexQualityFilter, vtkFeatureHexAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Bins of the histograms from 0 to 1. Default: 20. Range: 1 to 1,000.
   */
  vtkSetClampMacro(NumberOfBins, int, 1, 1000);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  ///@{
  /**
   * Hexes of the output Worst Hexes (2). Default: 50. Range: 0 to 1,000,000.
   */
  vtkSetClampMacro(NumberOfWorstHexes, int, 0, 1000000);
  vtkGetMacro(NumberOfWorstHexes, int);
  ///@}

  ///@{
  /**
   * The unit of deviations, as a fraction of the diagonal of the surface's bounding box: as the
   * mesh was made with. Default: 0.005. Range: 0.00001 to 0.1.
   */
  vtkSetClampMacro(Tolerance, double, 1e-5, 0.1);
  vtkGetMacro(Tolerance, double);
  ///@}

  /**
   * Scaled Jacobian of the worst hex of the last mesh; 0 before.
   */
  vtkGetMacro(SmallestScaledJacobian, double);

  /**
   * Mean scaled Jacobian of the last mesh; 0 before.
   */
  vtkGetMacro(MeanScaledJacobian, double);

  /**
   * Largest deviation that was found, as a fraction of the tolerance; 0 without a surface.
   */
  vtkGetMacro(LargestDeviation, double);

protected:
  vtkHexQualityFilter();
  ~vtkHexQualityFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  featurehex::Status Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
    featurehex::Monitor& monitor) override;

private:
  /// Outputs 1 and 3.
  void MeasureDeviation(const featurehex::HexMesh& mesh, const featurehex::SurfaceMesh& surface,
    vtkInformationVector* outputs, featurehex::Monitor& monitor);

  vtkHexQualityFilter(const vtkHexQualityFilter&) = delete;
  void operator=(const vtkHexQualityFilter&) = delete;

  int NumberOfBins = 20;
  int NumberOfWorstHexes = 50;
  double Tolerance = 0.005;
  double SmallestScaledJacobian = 0.0;
  double MeanScaledJacobian = 0.0;
  double LargestDeviation = 0.0;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceOctreeFilter
 * @brief Octree of 2x2x2 blocks around a surface, ready to become hexes.
 *
 * Cells that meet the surface have the target edge length, or less where the solid or a gap is thin
 * (sizing), where sharp features are short or close to each other, and where refinement points ask
 * for it. Blocks are split as a whole (pairing) and
 * neighbours differ by one level at most, across edges and vertices too (strong balance).
 *
 * <b>Input 0:</b> vtkPolyData, the surface (triangles, strips or polygons): closed, without
 * self-intersections; vtkSurfaceFeatureFilter says what that means.
 *
 * <b>Input 1 (optional):</b> vtkPolyData, feature graph: lines and vertices, points of the surface
 * (output 1 of vtkSurfaceFeatureFilter, vtkFeatureGraphReader).
 *
 * <b>Input 2 (optional, repeatable):</b> vtkPolyData, refinement points as vtkHexDomainFilter,
 * vtkHexFeatureMappingFilter and vtkHexFittingFilter make them. Points: Level (wanted halvings of
 * the target edge length; 1 without this array).
 *
 * <b>Output:</b> vtkUnstructuredGrid, the leaves as VTK_VOXEL (VTK_HEXAHEDRON where the axes are
 * turned), along the Z curve. Cells: Level (int, halvings of the target edge length, negative:
 * coarser), OctreeIndex (3 int, lowest corner in units of the finest cell). Field data:
 * OctreeOrigin (3 double), OctreeAxes (9 double, one unit axis after another), OctreeFinestCellSize
 * (double), OctreeDepth and OctreeBaseLevel (int, levels of the finest cells and of the target edge
 * length, root 0), TargetEdgeLength (double).
 *
 * <b>Guarantees:</b> every place that meets the surface has cells of the target edge length or
 * finer (exact triangle-box test); at least two cells of margin.
 *
 * <b>Errors:</b> what vtkSurfaceFeatureFilter reports; points of the feature graph that are none of
 * the surface; CellLimit (raise MaximumNumberOfCells or
 * TargetEdgeLength).
 *
 * <b>Units:</b> model units.
 *
 * <b>Threads and determinism:</b> vtkSMPTools; the same bits for any number of threads.
 *
 * <b>Cost:</b> O(triangles x levels + cells); the sizing is most of it.
 *
 * <b>References:</b> X. Gao, H. Shen, D. Panozzo, "Feature Preserving Octree-Based Hexahedral
 * Meshing", Computer Graphics Forum 38(5), 2019, doi:10.1111/cgf.13795.
 *
 * @sa vtkOctreeDualHexFilter
 */

#ifndef vtkSurfaceOctreeFilter_h
#define vtkSurfaceOctreeFilter_h

#include "vtkFeatureHexAlgorithm.h"
#include "vtkFeatureHexPipelineModule.h" // For export macro

class VTKFEATUREHEXPIPELINE_EXPORT vtkSurfaceOctreeFilter : public vtkFeatureHexAlgorithm
{
public:
  static vtkSurfaceOctreeFilter* New();
  vtkTypeMacro(vtkSurfaceOctreeFilter, vtkFeatureHexAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Edge length of the cells at the surface, model units. 0: the longest side of the bounding box /
   * 20, with a feature graph / 18, fitted to flat faces, or more where nothing asks for as small
   * cells. Default: 0. Range: 0 and up.
   */
  vtkSetClampMacro(TargetEdgeLength, double, 0.0, 1e100);
  vtkGetMacro(TargetEdgeLength, double);
  ///@}

  ///@{
  /**
   * Thickness, gaps and refinement points get cells at most this many halvings below the target
   * edge length. Default: 4. Range: 0 to 12.
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
   * Turn the octree into the principal axes of the surface where its box is smaller there: fewer
   * cells for long shapes that lie askew. Default: off.
   */
  vtkSetMacro(AlignToPrincipalAxes, bool);
  vtkGetMacro(AlignToPrincipalAxes, bool);
  vtkBooleanMacro(AlignToPrincipalAxes, bool);
  ///@}

  ///@{
  /**
   * Smaller cells where the solid or a gap is thin. Default: on.
   */
  vtkSetMacro(ThicknessSizing, bool);
  vtkGetMacro(ThicknessSizing, bool);
  vtkBooleanMacro(ThicknessSizing, bool);
  ///@}

  ///@{
  /**
   * Cells across the solid, at least, as far as MaximumSizingLevel allows. 0: 2, with a feature
   * graph 1 (layers under both sides of a wall add hexes). Default: 0. Range: 0 to 10.
   */
  vtkSetClampMacro(CellsPerThickness, double, 0.0, 10.0);
  vtkGetMacro(CellsPerThickness, double);
  ///@}

  ///@{
  /**
   * Cells across gaps, at least. Default: 1. Range: 0.1 to 10.
   */
  vtkSetClampMacro(CellsPerGap, double, 0.1, 10.0);
  vtkGetMacro(CellsPerGap, double);
  ///@}

  ///@{
  /**
   * Thickness and gaps get cells at most this many halvings below the target edge length. -1: 2,
   * with a feature graph 3. Default: -1. Range: -1 to 12.
   */
  vtkSetClampMacro(MaximumSizingLevel, int, -1, 12);
  vtkGetMacro(MaximumSizingLevel, int);
  ///@}

  ///@{
  /**
   * With a feature graph: smaller cells along curves that are short, form small loops, or run close
   * to others that they don't meet. Default: on.
   */
  vtkSetMacro(FeatureSizing, bool);
  vtkGetMacro(FeatureSizing, bool);
  vtkBooleanMacro(FeatureSizing, bool);
  ///@}

  ///@{
  /**
   * Details of the surface smaller than this count for nothing when thickness and gaps are
   * measured; fraction of the diagonal of the bounding box. Default: 0.005. Range: 0.00001 to 0.1.
   */
  vtkSetClampMacro(Tolerance, double, 1e-5, 0.1);
  vtkGetMacro(Tolerance, double);
  ///@}

  /**
   * Disconnects input 2; ParaView's proxies need it.
   */
  void RemoveAllRefinementPoints();

  /**
   * Cells of the last octree: counted when it was built, estimated when MaximumNumberOfCells
   * forbade it; 0 before.
   */
  vtkGetMacro(PredictedNumberOfCells, vtkIdType);

protected:
  vtkSurfaceOctreeFilter();
  ~vtkSurfaceOctreeFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  featurehex::Status Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
    featurehex::Monitor& monitor) override;

private:
  vtkSurfaceOctreeFilter(const vtkSurfaceOctreeFilter&) = delete;
  void operator=(const vtkSurfaceOctreeFilter&) = delete;

  double TargetEdgeLength = 0.0;
  int MaximumLevel = 4;
  vtkIdType MaximumNumberOfCells = 20000000;
  bool AlignToPrincipalAxes = false;
  bool ThicknessSizing = true;
  double CellsPerThickness = 0.0;
  double CellsPerGap = 1.0;
  int MaximumSizingLevel = -1;
  bool FeatureSizing = true;
  double Tolerance = 0.005;
  vtkIdType PredictedNumberOfCells = 0;
};

#endif

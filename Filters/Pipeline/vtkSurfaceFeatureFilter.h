// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceFeatureFilter
 * @brief Checks and repairs a surface, and finds its sharp features.
 *
 * Merges points of equal coordinates, drops unused points, collapsed and duplicate triangles, flips
 * triangles with collinear corners away, and orients each component outward, or inward where its
 * nesting makes it a cavity. Anything else is an error that says what is wrong and where.
 *
 * Sharp edges are those whose interior dihedral angle is below FeatureAngle, convex or concave,
 * plus slightly less sharp ones that continue a chain to another one (AngleHysteresis). Gaps of few
 * edges are closed, short chains with a loose end dropped. An annotation replaces these edges, adds
 * to them or removes some. Corners are points where other than two sharp edges meet, where two meet
 * at less than CornerAngle, and vertex cells of the annotation. Curves are the chains between
 * corners, and loops. Patches are what the curves cut the surface into.
 *
 * A corner where more than six curves meet, or two at less than 30 degrees, is found but not
 * enforced: FeatureValid is 0, a warning says how many and where. EnforceAllFeatures switches that
 * off.
 *
 * <b>Input 0:</b> vtkPolyData: triangles, strips or polygons (these are triangulated).
 *
 * <b>Input 1 (optional):</b> vtkPointSet, annotation: lines and polylines are sharp edges, vertices
 * are corners. A feature graph that vtkFeatureGraphReader has read, a selection of edges or points
 * that was extracted from an output of this filter or from the edges of the surface, or anything
 * that a script makes. Points are recognised by the point array SurfacePointId (ids of input 0), or
 * by their coordinates within 1e-6 of the diagonal. Lines may span several edges of the surface
 * that lie exactly on them. Other cells are ignored with a warning.
 *
 * <b>Output 0:</b> vtkPolyData, triangles, points in double precision in the order of the input.
 * Cells: PatchId (int, 0 and up: the patch between feature curves, in the order of their first
 * triangles), ComponentId (int, 0 and up: the connected piece). Field data, one value each:
 * NumberOfComponents, NumberOfCavities, Genus (sum), Volume (of the material), Diagonal (of the
 * bounding box), MergedPoints, UnusedPoints, CollapsedTriangles, DuplicateTriangles, FlippedEdges,
 * ReorientedTriangles, NumberOfCorners, NumberOfCurves, NumberOfPatches, InvalidCorners,
 * ContinuedEdges, ClosedGaps, DroppedSpurs, RedundantCurves (double), SurfaceRepairs,
 * FeatureRepairs (string, in words).
 *
 * <b>Output 1:</b> vtkPolyData, the feature graph: a vertex cell for each corner, a polyline for
 * each curve. Cells: CornerId, CurveId (int, -1 for the other kind), FeatureValid (int, 0: found
 * but not enforced). Points: SurfacePointId (vtkIdType, of output 0). Field data: FeatureAngle
 * (double). vtkFeatureGraphWriter writes it. Empty without features.
 *
 * <b>Guarantees:</b> output 0 is a closed, oriented manifold without self-intersections (exact
 * tests). The shape is not changed. Curves are chains of edges of output 0, each edge in one curve.
 * What an angle can't tell is not guaranteed: look at the curves.
 *
 * <b>Errors:</b> an empty surface, ids out of range, coordinates that are not finite, open or
 * non-manifold edges, non-manifold vertices, a surface that can't be oriented, zero volume,
 * self-intersections: repair the surface in the program it comes from; the message names the first
 * places. Repairs other than merging give a warning. An annotation with points or edges that the
 * surface doesn't have: use that of this very surface.
 *
 * <b>Units:</b> model units, degrees.
 *
 * <b>Threads and determinism:</b> vtkSMPTools; the same bits for any number of threads.
 *
 * <b>Cost:</b> n log n; 0.5 s for 100,000 triangles on one core, of which 0.1 s for the features.
 *
 * @sa vtkFeatureGraphReader vtkFeatureGraphWriter vtkSurfaceOctreeFilter vtkFeatureHexMesher
 */

#ifndef vtkSurfaceFeatureFilter_h
#define vtkSurfaceFeatureFilter_h

#include "vtkFeatureHexAlgorithm.h"
#include "vtkFeatureHexPipelineModule.h" // For export macro

namespace featurehex
{
struct FeatureExtractionOptions;
}

class VTKFEATUREHEXPIPELINE_EXPORT vtkSurfaceFeatureFilter : public vtkFeatureHexAlgorithm
{
public:
  static vtkSurfaceFeatureFilter* New();
  vtkTypeMacro(vtkSurfaceFeatureFilter, vtkFeatureHexAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Find sharp features. Off: none, whatever the annotation says; the patches are the components.
   * Organic shapes, scans above all, are best meshed without. Default: on.
   */
  vtkSetMacro(PreserveFeatures, bool);
  vtkGetMacro(PreserveFeatures, bool);
  vtkBooleanMacro(PreserveFeatures, bool);
  ///@}

  ///@{
  /**
   * Edges with an interior dihedral angle below this are sharp, degrees; concave edges when they
   * deviate as much from a plane. Default: 140. Range: 0 to 180.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
  ///@}

  /**
   * What the annotation does.
   */
  enum AnnotationModes
  {
    Replace = 0, ///< it is used instead of the edges found by angle
    Add = 1,     ///< it is used together with them
    Remove = 2   ///< its edges are no features; its vertices are no corners where two curves meet
  };

  ///@{
  /**
   * What the annotation does, if there is one. One without cells that replaces: no features.
   * Default: Replace.
   */
  vtkSetClampMacro(AnnotationMode, int, Replace, Remove);
  vtkGetMacro(AnnotationMode, int);
  void SetAnnotationModeToReplace() { this->SetAnnotationMode(Replace); }
  void SetAnnotationModeToAdd() { this->SetAnnotationMode(Add); }
  void SetAnnotationModeToRemove() { this->SetAnnotationMode(Remove); }
  ///@}

  ///@{
  /**
   * Gaps of at most this many edges between the loose end of a chain and another feature are
   * closed, where the chain needn't turn by more than 45 degrees. 0: none. Default: 2. Range: 0
   * to 8.
   */
  vtkSetClampMacro(MaximumGap, int, 0, 8);
  vtkGetMacro(MaximumGap, int);
  ///@}

  ///@{
  /**
   * Chains with a loose end that are shorter than this are dropped, and single edges and pairs on
   * their own, which are noise; fraction of the diagonal of the bounding box. 0: none. Default:
   * 0.01. Range: 0 to 1.
   */
  vtkSetClampMacro(MinimumChainLength, double, 0.0, 1.0);
  vtkGetMacro(MinimumChainLength, double);
  ///@}

  ///@{
  /**
   * Enforce corners where more than six curves, or two at less than 30 degrees meet, like others.
   * The hexes there can't be good. Default: off.
   */
  vtkSetMacro(EnforceAllFeatures, bool);
  vtkGetMacro(EnforceAllFeatures, bool);
  vtkBooleanMacro(EnforceAllFeatures, bool);
  ///@}

  ///@{
  /**
   * Edges up to this much less sharp than FeatureAngle asks for are sharp where they lead a sharp
   * chain to another one, degrees. 0: none. Default: 15. Range: 0 to 90.
   */
  vtkSetClampMacro(AngleHysteresis, double, 0.0, 90.0);
  vtkGetMacro(AngleHysteresis, double);
  ///@}

  ///@{
  /**
   * A point where two sharp edges meet at less than this is a corner, degrees. Default: 140. Range:
   * 0 to 180.
   */
  vtkSetClampMacro(CornerAngle, double, 0.0, 180.0);
  vtkGetMacro(CornerAngle, double);
  ///@}

  ///@{
  /**
   * Close gaps and drop short chains in what the annotation gives, too. Default: off.
   */
  vtkSetMacro(CleanUpAnnotation, bool);
  vtkGetMacro(CleanUpAnnotation, bool);
  vtkBooleanMacro(CleanUpAnnotation, bool);
  ///@}

protected:
  vtkSurfaceFeatureFilter();
  ~vtkSurfaceFeatureFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  featurehex::Status Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
    featurehex::Monitor& monitor) override;

private:
  vtkSurfaceFeatureFilter(const vtkSurfaceFeatureFilter&) = delete;
  void operator=(const vtkSurfaceFeatureFilter&) = delete;

  featurehex::FeatureExtractionOptions Options() const;

  bool PreserveFeatures = true;
  double FeatureAngle = 140.0;
  int AnnotationMode = Replace;
  int MaximumGap = 2;
  double MinimumChainLength = 0.01;
  bool EnforceAllFeatures = false;
  double AngleHysteresis = 15.0;
  double CornerAngle = 140.0;
  bool CleanUpAnnotation = false;
};

#endif

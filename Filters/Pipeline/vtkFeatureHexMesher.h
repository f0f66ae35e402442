// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFeatureHexMesher
 * @brief Closed triangle surface in, valid all-hex mesh out.
 *
 * The composite of all stages: checks and repairs the surface, builds an octree around it, converts
 * it to hexes, keeps those inside, pads, untangles and fits them, raises the worst ones, and proves
 * the result. Where a stage finds that the cells are too coarse, the octree is refined there and
 * the stages run again, at most MaximumRounds times.
 *
 * Sharp features are reproduced one to one: corners become points of the mesh, curves chains of its
 * edges, patches sets of boundary quads. They come from input 1, or are found by angle
 * (FeatureMode). Without features, for scans and organic shapes, sharp edges are met within the
 * tolerance, but no mesh edges follow them.
 *
 * <b>Input 0:</b> vtkPolyData: triangles, strips or polygons of a closed surface, any number of
 * components and cavities; orientation doesn't matter, points of equal coordinates are merged.
 *
 * <b>Input 1 (optional):</b> vtkPointSet, annotation of sharp features: lines and polylines are
 * sharp edges, vertices are corners; what vtkFeatureGraphReader reads, output 1 of
 * vtkSurfaceFeatureFilter, or anything that a script makes. Points are recognised by the point
 * array SurfacePointId (ids of input 0), or by their coordinates within 1e-6 of the diagonal. Other
 * cells are ignored with a warning.
 *
 * <b>Output 0:</b> vtkUnstructuredGrid of VTK_HEXAHEDRON, points in double precision. Points:
 * FeatureKind (int, 0 interior, 1 surface, 2 curve, 3 corner), FeatureId (int: of the patch, curve
 * or corner; -1 interior). Ids are those of vtkSurfaceFeatureFilter with the same features. Cells:
 * Region (int, 1 and up: the body), Level (int, halvings of the target edge length at this hex),
 * ScaledJacobian (double, smallest of the 8 corners). Field data: the columns of output 3; with
 * features also FeatureQuads (int, 5 components: four points of a boundary quad and its patch) and
 * FeatureEdges (int, 3 components: two points and the curve), which the writer of .mesh files uses.
 *
 * <b>Output 1:</b> vtkPolyData, the boundary quads, outward. Cells: PatchId (int, 0 and up: the
 * patch between feature curves; without features the component of the input surface; in the order
 * of their first triangles. Near a corner that is not enforced no curve parts the patches, the
 * nearest counts), Deviation (double, model units: no point of the quad is farther from the input;
 * proven).
 *
 * <b>Output 2:</b> vtkPolyData, the features of the result: a vertex cell for each corner, a
 * polyline for each curve. Cells: CornerId, CurveId (int, -1 for the other kind), Captured (int, 1:
 * one to one), Deviation (double, model units). Points: MeshPointId (vtkIdType, of output 0). Empty
 * without features.
 *
 * <b>Output 3:</b> vtkTable with one row: all figures of vtkHexValidationFilter; TargetEdgeLength
 * (the one used, model units); Rounds and RoundReasons; WantedScaledJacobianMissed (hexes left
 * below MinimumScaledJacobian); SurfaceRepairs (in words); Seconds… for each stage; PeakMemoryMiB
 * (of the process); Version; Option… for each property.
 *
 * <b>Output 4:</b> vtkTable, one row for each corner, curve and patch of the surface: Kind
 * (string), Id (int), Outcome (string: Captured, NotEnforced, NotMapped, OffPosition, BrokenPath,
 * WrongEnd, BeyondTolerance, InPieces, WrongBoundary, WrongTopology), Reason (string, in words),
 * Deviation, VertexDeviation (double, model units), X, Y, Z (where). Empty without features.
 *
 * <b>Guarantees:</b> the mesh is all-hex and conforming; its boundary is a manifold without
 * self-intersections and has the components, cavities and genus of the input; every Jacobian is
 * proven positive in the whole element; the Hausdorff distance to the input is proven to be at most
 * Tolerance, both ways. What can't be guaranteed is no mesh: one error, empty outputs.
 * MinimumScaledJacobian is best effort. Features are measured (output 4): corner points are within
 * 1e-9 and curve points within 1e-6 of the diagonal of theirs, or a warning names what is missed.
 * Corners where more than six curves, or two at less than 30 degrees meet, are not enforced; a
 * warning says where.
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

#include <vector> // For edge lengths

class vtkPolyData;

namespace featurehex
{
struct FeatureInput;
struct MeshingOptions;
struct MeshingResult;
struct SurfaceMesh;
} // namespace featurehex

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
   * tolerance ask for it. 0: the longest side of the bounding box / 20, with
   * sharp features / 18, fitted to flat faces, or more where nothing asks for as small cells.
   * Default: 0. Range: 0 and
   * up.
   */
  vtkSetClampMacro(TargetEdgeLength, double, 0.0, 1e100);
  vtkGetMacro(TargetEdgeLength, double);
  ///@}

  ///@{
  /**
   * Name of a point array of the surface with one component: the largest edge length wanted there,
   * model units; 0: no wish. TargetEdgeLength is the largest anywhere, cells are at most
   * MaximumLevel halvings smaller. Empty or None: no such array. Default: None.
   */
  vtkSetStringMacro(EdgeLengthArray);
  vtkGetStringMacro(EdgeLengthArray);
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

  /**
   * Where the sharp features come from.
   */
  enum FeatureModes
  {
    FeaturesOfAnnotation = 0, ///< input 1; none without it
    FeaturesByAngle = 1,      ///< edges sharper than FeatureAngle, together with input 1
    NoFeatures = 2            ///< none, whatever input 1 says
  };

  ///@{
  /**
   * Where the sharp features come from. Default: Annotation, so that a surface alone is meshed
   * without any.
   */
  vtkSetClampMacro(FeatureMode, int, FeaturesOfAnnotation, NoFeatures);
  vtkGetMacro(FeatureMode, int);
  void SetFeatureModeToAnnotation() { this->SetFeatureMode(FeaturesOfAnnotation); }
  void SetFeatureModeToAngle() { this->SetFeatureMode(FeaturesByAngle); }
  void SetFeatureModeToNone() { this->SetFeatureMode(NoFeatures); }
  ///@}

  ///@{
  /**
   * Edges with an interior dihedral angle below this are sharp, degrees; concave edges when they
   * deviate as much from a plane. Used by FeatureMode Angle. vtkSurfaceFeatureFilter has more
   * settings. Default: 140. Range: 0 to 180.
   */
  vtkSetClampMacro(FeatureAngle, double, 0.0, 180.0);
  vtkGetMacro(FeatureAngle, double);
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
   * Wall time in seconds after which the filter stops with an error; 0: none. Default: 0. Range: 0
   * and up.
   */
  vtkSetClampMacro(TimeLimit, double, 0.0, 1e9);
  vtkGetMacro(TimeLimit, double);
  ///@}

  /**
   * Hexes of the last mesh; 0 before.
   */
  vtkGetMacro(NumberOfHexes, vtkIdType);

  /**
   * Scaled Jacobian of the worst hex of the last mesh; 0 before.
   */
  vtkGetMacro(SmallestScaledJacobian, double);

  /**
   * Mean scaled Jacobian of the last mesh; 0 before.
   */
  vtkGetMacro(MeanScaledJacobian, double);

  /**
   * Proven bound of the distance between boundary and surface of the last mesh, as a fraction of
   * the diagonal of the bounding box; 0 before.
   */
  vtkGetMacro(HausdorffBound, double);

protected:
  vtkFeatureHexMesher();
  ~vtkFeatureHexMesher() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  featurehex::Status Compute(vtkInformationVector** inputs, vtkInformationVector* outputs,
    featurehex::Monitor& monitor) override;

private:
  /// Options for the core, without features.
  featurehex::MeshingOptions Options() const;
  /// EdgeLengthArray of the surface.
  featurehex::Status ReadEdgeLengths(vtkPolyData* surface, std::vector<double>& lengths);
  /// FeatureMode and input 1.
  featurehex::Status ReadFeatures(const featurehex::SurfaceMesh& surface,
    vtkInformationVector* input, featurehex::FeatureInput& features);
  void Warn(const featurehex::MeshingResult& result);

  vtkFeatureHexMesher(const vtkFeatureHexMesher&) = delete;
  void operator=(const vtkFeatureHexMesher&) = delete;

  double Tolerance = 0.005;
  double TargetEdgeLength = 0.0;
  char* EdgeLengthArray = nullptr;
  int MaximumLevel = 4;
  vtkIdType MaximumNumberOfCells = 20000000;
  double MinimumScaledJacobian = 0.55;
  bool AlignToPrincipalAxes = false;
  int MaximumRounds = 12;
  int FeatureMode = FeaturesOfAnnotation;
  double FeatureAngle = 140.0;
  bool EnforceAllFeatures = false;
  double TimeLimit = 0.0;
  vtkIdType NumberOfHexes = 0;
  double SmallestScaledJacobian = 0.0;
  double MeanScaledJacobian = 0.0;
  double HausdorffBound = 0.0;
};

#endif

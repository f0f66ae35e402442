// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The whole method: from a triangle surface to a hex mesh that keeps every promise (design 1,
/// 3.10).

#ifndef featurehex_FeatureHexMesher_h
#define featurehex_FeatureHexMesher_h

#include "FeatureExtraction.h"
#include "HexFeatures.h"
#include "HexImprovement.h"
#include "HexValidation.h"
#include "Monitor.h"
#include "SurfaceCheck.h"

#include <string>

namespace featurehex
{
/// Where the sharp features come from.
enum class FeatureMode
{
  None,
  Angle, ///< edges found by their dihedral angle, and those of FeatureInput
  Given  ///< the edges and corners of FeatureInput
};

/// The sharp features that are asked for.
struct FeatureInput
{
  FeatureMode Mode = FeatureMode::None;
  std::vector<PointPair> Edges; ///< point ids of the input surface
  std::vector<Index> Corners;   ///< further ones; where curves meet or kink there is one anyway
  double CornerAngle = 140.0;   ///< kinks: FeatureGraphOptions
  FeatureDetectionOptions Detection; ///< Angle
  bool EnforceAll = false; ///< also corners with many or acute curves
};

/// All options of the composite.
struct MeshingOptions
{
  FeatureInput Features;
  /// Largest Hausdorff distance between boundary and surface, fraction of the diagonal of the
  /// bounding box.
  double Tolerance = 0.005;
  /// Cell size at the surface, model units; 0: automatic (AutomaticSizing.h): longest side
  /// of the bounding box / 20, with sharp features / 18, or fewer.
  double TargetEdgeLength = 0.0;
  /// Smaller cells where wanted: for each point of the surface the largest edge length there, model
  /// units; 0: no wish. Empty: none at all.
  std::vector<double> EdgeLengths;
  /// Refinement goes at most this many halvings below the target edge length.
  int MaximumLevel = 4;
  /// Of the octree.
  std::int64_t MaximumNumberOfCells = 20000000;
  bool AlignToPrincipalAxes = false;
  /// Wanted, best effort.
  double MinimumScaledJacobian = 0.55;
  /// Refinement rounds before the method gives up.
  int MaximumRounds = 12;
};

/// One pass of the refinement loop and why it had to be repeated (empty: it was the last).
struct MeshingRound
{
  std::string Reason;
  Index OctreeLeaves = 0;
  Index Hexes = 0;            ///< of the body, padded; 0 when the round ended before
  Index RefinementPoints = 0; ///< added for the next round
};

/// How long a stage took.
struct StageTiming
{
  std::string Stage;
  double Seconds = 0.0; ///< wall time, all rounds
};

/// The mesh, and all that is known about it.
struct MeshingResult
{
  HexMesh Mesh;
  std::vector<int> Region; ///< per hex, 1 and up: which body
  SurfaceFeatures SurfaceGraph; ///< features of the checked surface
  FeatureExtractionReport FeatureReport;
  HexFeatures Features;         ///< of the mesh; empty without features
  std::vector<int> Level;  ///< per hex: octree level relative to the target edge length
  double TargetEdgeLength = 0.0;
  SurfaceCheckReport Check;
  ImprovementReport Improvement;
  HexValidationReport Validation;
  std::vector<MeshingRound> Rounds;
  std::vector<StageTiming> Timings;
};

/// Runs all stages with the refinement loop. When the status is not Ok, the mesh of the result is
/// empty.
Status MeshSurface(const SurfaceMesh& surface, const MeshingOptions& options, Monitor& monitor,
  MeshingResult& result);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Finds the sharp edges of a surface by angle, and cleans edges that were found or given.

#ifndef featurehex_FeatureDetection_h
#define featurehex_FeatureDetection_h

#include "SurfaceFeatures.h"

namespace featurehex
{
/// Which edges of a surface are sharp.
struct FeatureDetectionOptions
{
  /// Edges with an interior dihedral angle below this are sharp, degrees; concave ones as much:
  /// what counts is the deviation of the two triangles from a plane, above 180 - FeatureAngle.
  double FeatureAngle = 140.0;
  /// Edges whose deviation is up to this much smaller are sharp where they continue a sharp chain
  /// and lead it to another one, degrees. 0: none.
  double Hysteresis = 15.0;
  /// Gaps of at most this many edges between the end of a chain and another feature are closed. 0:
  /// none.
  int MaximumGap = 2;
  /// Chains with a loose end that are shorter than this are dropped, fraction of the diagonal of
  /// the bounding box. 0: none.
  double MinimumLength = 0.01;
};

/// What happened to the edges.
struct FeatureDetectionReport
{
  Index NumberOfSharpEdges = 0;     ///< by FeatureAngle alone
  Index NumberOfContinuedEdges = 0; ///< by Hysteresis
  Index NumberOfGaps = 0;           ///< closed
  Index NumberOfGapEdges = 0;
  Index NumberOfSpurs = 0; ///< chains dropped
  Index NumberOfSpurEdges = 0;
  std::vector<Vec3> Continued; ///< middle of each edge added by Hysteresis
  std::vector<Vec3> Gaps;      ///< middle of each gap edge
  std::vector<Vec3> Spurs;     ///< middle of each edge dropped
};

/// Sharp edges of a checked surface, sorted.
///
/// Noise of the tessellation makes edges of a crease fall short of the angle, and edges of a smooth
/// part exceed it. So a chain that ends without reaching another feature is continued along
/// slightly less sharp edges, the sharpest first, without turning by more than 45 degrees at a
/// point; what doesn't arrive anywhere is given up. The same from a kink of a chain to another
/// corner. Then CleanFeatureEdges(). Normals of slivers lower than 1e-6 of the diagonal aren't
/// believed: a sliver has the normal of its neighbour at the longest edge. Cost: n log n.
std::vector<PointPair> FindSharpEdges(const SurfaceMesh& surface,
  const FeatureDetectionOptions& options, FeatureDetectionReport& report);

/// Closes gaps, then drops short chains with a loose end: those that end at a junction and those on
/// their own. One edge or two on their own are dropped whatever their length; closed loops never.
/// @a edges: of the surface; sorted afterwards. What is done is added to @a report.
/// A gap doesn't turn by more than 45 degrees at a point, nor in all.
void CleanFeatureEdges(const SurfaceMesh& surface, const FeatureDetectionOptions& options,
  std::vector<PointPair>& edges, FeatureDetectionReport& report);

/// Deviation of the two triangles at each edge from a plane, degrees; edges ascend by EdgeKey().
struct SurfaceEdge
{
  Index Low = -1, High = -1;
  double Deviation = 0.0;
};
std::vector<SurfaceEdge> MeasureEdges(const SurfaceMesh& surface);
} // namespace featurehex

#endif

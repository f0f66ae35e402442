// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How small the cells have to be before any mesh exists: local thickness and local gaps.

#ifndef featurehex_SurfaceSizing_h
#define featurehex_SurfaceSizing_h

#include "BlockOctree.h"
#include "Monitor.h"
#include "TriangleSearch.h"
#include "Types.h"

namespace featurehex
{
/// A point of the surface and the triangle it lies on.
struct SurfaceSample
{
  Vec3 Position;
  Index Triangle;
};

/// Samples at about @a spacing (model units): in rows along the longest edge of each triangle, at
/// least one; of samples that share a grid cell of that size and the main direction of the normal
/// only the first stays. Ordered by triangle. The spacing grows where it would make more than 2e7
/// samples.
std::vector<SurfaceSample> SampleSurface(const SurfaceMesh& surface, double spacing);

/// Of points of the same level in the same grid cell (edge = @a baseSize halved level times) only
/// the first stays; order kept. The octree refines more than one cell round a point, so nothing is
/// lost.
std::vector<RefinementPoint> ThinRefinementPoints(
  const std::vector<RefinementPoint>& points, double baseSize);

/// Which side of the surface.
enum class SurfaceSide
{
  Inside, ///< half the local thickness
  Outside ///< half the local gap
};

/// Of the search for the largest ball beside the surface.
struct ClearanceOptions
{
  double MaximumRadius = 0.0; ///< model units; larger balls are not looked for
  double Slack = 0.0;         ///< model units: how far the ball may stay away from the sample
  /// The same as a fraction of the ball's radius. A ball reaches the edges of a cube to 0.414, its
  /// corners to 0.732 of its radius: with the default no right angle counts as thin.
  double RelativeSlack = 0.75;
};

/// Radius of the largest ball on one side of the surface that the surface doesn't cut and that
/// comes within max(Slack, RelativeSlack * radius) of the sample, at most MaximumRadius. A
/// scratch, a pore or a ridge shallower than the slack doesn't make it small, nor does a wedge
/// wider than 2 asin(1 / (1 + RelativeSlack)); thin walls, limbs and narrow gaps do. The first
/// ball is the shrinking ball of J. Ma, S. Bae, S. Choi, "3D medial axis point approximation using
/// nearest neighbors and the normal field", The Visual Computer 28, 2012,
/// doi:10.1007/s00371-011-0594-7; from there the centre climbs the distance field in steps that
/// stay in the current ball, so it can't pass through the surface. A lower bound, some percent
/// short at most unless the way up is a maze: the climb ends after 30 steps.
double ClearanceRadius(const TriangleSearch& search, const SurfaceSample& sample, SurfaceSide side,
  const ClearanceOptions& options);

/// How far a flat quad with edges of @a size round the sample stays from the surface at its corners
/// and at as many points between them, when it lies best: half the difference of their heights over
/// a fitted plane. Model units. @a sharp: whether the surface turns by more than 45 degrees there.
double QuadSag(
  const TriangleSearch& search, const SurfaceSample& sample, double size, bool* sharp = nullptr);

/// Cell sizes that thickness, gaps and curvature ask for.
struct SizingOptions
{
  double TargetEdgeLength = 0.0; ///< model units, edge length of cells of level 0
  double Slack = 0.0;            ///< model units, usually the tolerance
  double RelativeSlack = 0.75;   ///< as in ClearanceOptions; smaller: finer cells at ridges
  double CellsPerThickness = 2.0; ///< at least this many cells across the solid
  double CellsPerGap = 1.0;       ///< and across gaps
  int MaximumSizingLevel = 2;     ///< at most this many halvings
  /// Model units: flat quads of the size of the cells should follow the surface as closely as this;
  /// 0: any curvature.
  double Sag = 0.0;
  int MaximumCurvatureLevel = 1; ///< at most this many halvings for it
  double SampleSpacing = 0.5;     ///< in target edge lengths
};

/// Share of the samples where the sag (QuadSag()) of cells as small as thickness and gaps ask for
/// is beyond @a options.Sag, of those without a sharp edge near by. 0..1.
double SaggingShare(const std::vector<SurfaceSample>& samples, const TriangleSearch& search,
  const SizingOptions& options, Monitor& monitor);

/// Refinement points where cells of @a targetEdgeLength (model units) are larger than @a lengths
/// wants: one per point of the surface, model units, 0: no wish; linear in each triangle. At most
/// @a maximumLevel halvings. Empty when the monitor stops it.
std::vector<RefinementPoint> ComputeWantedSizing(const SurfaceMesh& surface,
  const TriangleSearch& search, const std::vector<double>& lengths, double targetEdgeLength,
  int maximumLevel, Monitor& monitor);

/// Refinement points where cells of the target edge length are too large for the local thickness or
/// gap, with the level they need, in sample order.
/// Parallel; the result does not depend on the number of threads. Empty when the monitor stops it.
std::vector<RefinementPoint> ComputeSizing(const SurfaceMesh& surface,
  const TriangleSearch& search, const SizingOptions& options, Monitor& monitor);
}

#endif

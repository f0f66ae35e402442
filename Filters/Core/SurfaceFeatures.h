// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sharp features of a surface: corners, curves between them, and the patches that they bound.

#ifndef featurehex_SurfaceFeatures_h
#define featurehex_SurfaceFeatures_h

#include "Status.h"
#include "Types.h"

#include <array>
#include <vector>

namespace featurehex
{
/// Why a corner is not enforced (design 3.1).
enum class CornerFlaw : std::uint8_t
{
  None,
  ManyCurves, ///< more than six curves meet
  AcuteCurves ///< two curves meet at less than 30 degrees
};

/// A surface point where a curve ends, curves meet, or a curve has a kink.
struct FeatureCorner
{
  Index Point = -1;
  CornerFlaw Flaw = CornerFlaw::None;
  bool Valid() const { return this->Flaw == CornerFlaw::None; }
};

/// A chain of sharp edges. Closed ones (a loop without or with one corner) repeat their first point
/// at the end.
struct FeatureCurve
{
  std::vector<Index> Points;               ///< surface points, at least two
  Index FirstCorner = -1, LastCorner = -1; ///< -1: a loop without corner
  int LeftPatch = -1, RightPatch = -1;     ///< seen from outside, walking along Points
  bool Closed() const
  {
    return this->Points.size() > 1 && this->Points.front() == this->Points.back();
  }
};

/// The feature graph of a checked surface (SurfaceCheck.h) and the patches between its curves. Ids
/// are positions in the lists. Order: corners by point id, curves by their lowest point pair,
/// patches by their first triangle.
struct SurfaceFeatures
{
  std::vector<FeatureCorner> Corners;
  std::vector<FeatureCurve> Curves;
  std::vector<int> PatchOfTriangle; ///< of each triangle of the surface
  int NumberOfPatches = 0;
};

/// More curves than this at a corner can't be enforced (design 3.1).
constexpr int MaximumCurvesAtCorner = 6;
/// Nor can two curves that leave a corner at less than this angle, degrees (design 3.1).
constexpr double MinimumAngleOfCurves = 30.0;

/// How edges become curves and corners.
struct FeatureGraphOptions
{
  /// A point between two feature edges is a corner when they meet at less than this interior angle,
  /// degrees.
  double CornerAngle = 140.0;
  /// True: corners with many or acute curves are enforced like others, Flaw stays None.
  bool EnforceAll = false;
  /// True: an explicit corner point on no edge becomes a corner without curves (the tip of a cone).
  bool KeepIsolatedCorners = true;
};

/// What was done to the input of BuildSurfaceFeatures().
struct FeatureGraphReport
{
  Index NumberOfDuplicateEdges = 0;   ///< dropped
  Index NumberOfSplitEdges = 0;       ///< replaced by the edges that lie on them
  Index NumberOfDroppedCorners = 0;   ///< explicit ones on no edge, without KeepIsolatedCorners
  Index NumberOfManyCurveCorners = 0; ///< more than MaximumCurvesAtCorner curve ends
  Index NumberOfAcuteCorners = 0;     ///< two curve ends at less than MinimumAngleOfCurves
  std::vector<Index> Flawed;          ///< corners of these two kinds, also with EnforceAll
};

/// An edge of a surface: two point ids.
using PointPair = std::array<Index, 2>;

/// Corners, curves and patches of a checked @a surface from its sharp @a edges and explicit
/// @a corners (point ids; the order doesn't matter).
///
/// Corners are the explicit ones, points with other than two feature edges, and points whose two
/// edges meet at less than CornerAngle. An edge that isn't in the surface is replaced by the
/// surface edges that cover it, if they lie on it exactly: CheckSurface() flips triangles with
/// collinear corners.
///
/// The angle of two curves at a corner is that of their directions there. A direction is that of
/// the first edge, or of a piece of 1/500 of the diagonal of the box when the first edge is
/// shorter: the direction of a very short edge is noise.
///
/// @return IndexOutOfRange (a point id, or an edge that the surface doesn't have), Degenerate (from
/// a point to itself), with ids and coordinates; @a features is empty then. Cost: n log n.
Status BuildSurfaceFeatures(const SurfaceMesh& surface, const std::vector<PointPair>& edges,
  const std::vector<Index>& corners, const FeatureGraphOptions& options, SurfaceFeatures& features,
  FeatureGraphReport& report);

/// Translates ids of an input surface to those of the checked one. Edges whose two points were
/// merged vanish, duplicates stay.
/// @param pointMap SurfaceCheckReport::Points
/// @return IndexOutOfRange: an id that the input doesn't have, or of a point that no triangle uses.
Status MapFeatures(
  const std::vector<Index>& pointMap, std::vector<PointPair>& edges, std::vector<Index>& corners);

/// All edges of the curves.
std::vector<PointPair> FeatureEdges(const SurfaceFeatures& features);

/// For each point of the surface its corner, -1: none.
std::vector<Index> CornersOfPoints(const SurfaceFeatures& features, std::size_t numberOfPoints);

/// Interior angle at @a b of the polyline a b c, degrees.
double AngleAt(const Vec3& a, const Vec3& b, const Vec3& c);
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The features that a mesh has to reproduce, with closest points on each curve and each patch.

#ifndef featurehex_FeatureGeometry_h
#define featurehex_FeatureGeometry_h

#include "SurfaceFeatures.h"
#include "SurfaceGeometry.h"

#include <memory>
#include <set>

namespace featurehex
{
/// Closest point on a curve.
struct CurvePoint
{
  Vec3 Point = Vec3::Zero();
  Vec3 Tangent = Vec3::Zero(); ///< unit
  double Distance = 1e300;
  double Arc = 0.0; ///< length of the curve up to the point
};

/// A polyline that a chain of mesh edges has to follow. At a corner that is not enforced it is cut
/// short.
struct EnforcedCurve
{
  std::vector<Vec3> Points;  ///< empty: nothing of the curve is enforced
  std::vector<double> Arcs;  ///< length up to each point
  Index FirstCorner = -1, LastCorner = -1; ///< -1: a free end, or a loop without corner
  int LeftPatch = -1, RightPatch = -1;     ///< of the surface, before merging
  bool Closed = false;

  double Length() const { return this->Arcs.empty() ? 0.0 : this->Arcs.back(); }
  /// Point at @a arc; a loop goes round and round.
  Vec3 At(double arc) const;
  /// Closest point with an arc in [@a from, @a to]; on a loop the range may extend over its end.
  CurvePoint Closest(const Vec3& p, double from, double to) const;
  CurvePoint Closest(const Vec3& p) const { return this->Closest(p, 0.0, this->Length()); }
};

/// Where the curves leave a corner, seen from outside, counter-clockwise.
struct CornerFan
{
  /// One end of a curve at the corner.
  struct Spoke
  {
    Index Curve;
    bool AtEnd;      ///< the curve ends here (a loop has two spokes)
    double Angle;    ///< position round the corner, radians on the surface, from the first spoke
  };
  std::vector<Spoke> Spokes;
  double FullAngle = 0.0; ///< sum of the triangle angles round the corner
};

/// Features that no mesh of this run could reproduce.
struct GivenUpFeatures
{
  std::set<Index> Corners, Curves;
  bool Empty() const { return this->Corners.empty() && this->Curves.empty(); }
};

/// Curves end this many target edge lengths before a corner that is not enforced (the paper's three
/// rings).
constexpr double TrimCells = 3.0;

/// Prepared once for a surface and its features; const queries may run in parallel.
class FeatureGeometry
{
public:
  /// @a trim: length (model units) by which curves are cut short at corners that are not enforced.
  /// The patches round such a corner are merged: nothing separates them there; so are those beside
  /// a curve that is given up. @a givenUp: corners and curves that are not enforced although they
  /// have no flaw.
  FeatureGeometry(const SurfaceMesh& surface, const SurfaceFeatures& features, double trim,
    const GivenUpFeatures& givenUp = GivenUpFeatures());

  const SurfaceMesh& Surface() const { return this->Mesh; }
  const SurfaceFeatures& Features() const { return this->Graph; }
  const std::vector<EnforcedCurve>& Curves() const { return this->EnforcedCurves; }
  const std::vector<CornerFan>& Fans() const { return this->CornerFans; }
  bool Enforced(Index corner) const
  {
    return this->Graph.Corners[corner].Valid() && this->GivenUp.Corners.count(corner) == 0;
  }
  const Vec3& CornerPoint(Index corner) const
  {
    return this->Mesh.Points[this->Graph.Corners[corner].Point];
  }

  /// Patch that stands for @a patch: its own id, or the lowest of those merged with it.
  int PatchOf(int patch) const { return this->MergedPatch[patch]; }
  const SurfaceGeometry& Patch(int patch) const { return *this->Patches[patch]; }

private:
  void MergePatches();
  void BuildCurves(double trim);
  void BuildFans();
  void BuildPatches();

  const SurfaceMesh& Mesh;
  const SurfaceFeatures& Graph;
  GivenUpFeatures GivenUp;
  std::vector<int> MergedPatch;
  std::vector<EnforcedCurve> EnforcedCurves;
  std::vector<CornerFan> CornerFans;
  std::vector<std::unique_ptr<SurfaceGeometry>> Patches;
};
} // namespace featurehex

#endif

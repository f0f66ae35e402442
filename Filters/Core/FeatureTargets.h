// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where the boundary vertices of a hex mesh belong: matched corners, curves and patches
/// (design 3.8).

#ifndef featurehex_FeatureTargets_h
#define featurehex_FeatureTargets_h

#include "FeatureGeometry.h"
#include "HexFeatures.h"

namespace featurehex
{
/// Connects a mesh whose points move with the features it reproduces. A vertex that has reached its
/// corner or curve is locked: corners stay, curve vertices slide along their curve.
class FeatureTargets
{
public:
  /// Keeps the references.
  FeatureTargets(const FeatureGeometry& geometry, const HexFeatures& features,
    const HexStars& stars, const std::vector<Vec3>& points);

  FeatureKind KindOf(Index v) const { return this->Labels.Kind[v]; }
  bool OnFeature(Index v) const { return this->Labels.Kind[v] >= FeatureKind::Curve; }

  /// Patch of a surface vertex; @a whole for one that may be on several.
  const SurfaceGeometry& PatchAt(Index v, const SurfaceGeometry& whole) const
  {
    return this->Labels.Id[v] < 0 ? whole : this->Geometry.Patch(this->Labels.Id[v]);
  }
  const SurfaceGeometry& PatchOfQuad(Index q) const
  {
    return this->Geometry.Patch(this->Features.PatchOfQuad[q]);
  }

  /// Closest point of the curve of @a v near where it was before. Precondition: a curve vertex.
  CurvePoint OnCurve(Index v, const Vec3& p) const;

  /// Length of the curve from @a arc to where the vertex would be if its path were spread more
  /// evenly; positive: ahead.
  double SpreadFrom(Index v, double arc) const;

  /// The corner, or the closest point of the curve.
  Vec3 Project(Index v, const Vec3& p) const;

  /// The part of @a direction in which a locked vertex may move: along its curve; zero for a
  /// corner.
  Vec3 Allowed(Index v, const Vec3& p, const Vec3& direction) const;

  bool Locked(Index v) const { return this->IsLocked[v] != 0; }
  void Lock(Index v) { this->IsLocked[v] = 1; }
  void Unlock(Index v) { this->IsLocked[v] = 0; }

  /// Follow the points: the search for curve points starts from here. Keeps the order of the
  /// vertices of each path.
  void FollowCurves(const std::vector<Vec3>& points);

  /// Feature vertices, ascending.
  const std::vector<Index>& Vertices() const { return this->FeatureVertices; }
  const HexFeatures& Mapped() const { return this->Features; }
  const FeatureGeometry& Surface() const { return this->Geometry; }

private:
  struct Window
  {
    double From = 0, To = 0;
    double Spread = 0; ///< arc of the vertex if the path were spread more evenly
  };

  const FeatureGeometry& Geometry;
  const HexFeatures& Features;
  FeatureLabels Labels;
  std::vector<Window> Windows; ///< of each vertex: arcs in which its curve point is looked for
  std::vector<char> IsLocked;
  std::vector<Index> FeatureVertices;
};
} // namespace featurehex

#endif

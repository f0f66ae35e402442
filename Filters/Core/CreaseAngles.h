// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Dihedral angles of the surface along its curves.

#ifndef featurehex_CreaseAngles_h
#define featurehex_CreaseAngles_h

#include "FeatureGeometry.h"

#include <map>
#include <utility>
#include <vector>

namespace featurehex
{
/// The curves of a surface with their dihedral angles. Slivers of CAD exports point anywhere: the
/// normals on the two sides are those of all triangles of the patch round a curve point, weighted
/// by area.
class CreaseAngles
{
public:
  /// Keeps a reference.
  explicit CreaseAngles(const FeatureGeometry& geometry);

  /// An edge of a curve.
  struct Piece
  {
    double Angle;  ///< of the solid, radians, in (0, 2 pi)
    double Length; ///< model units
  };

  /// The edges of the curve by ascending angle.
  std::vector<Piece> Pieces(Index curve) const;

private:
  double InteriorAngle(const FeatureCurve& curve, Index a, Index b) const;

  const FeatureGeometry& Geometry;
  std::map<std::pair<Index, int>, Vec3> Normals; ///< (point, patch)
};

/// How many hexes or quads share an angle best: each about a right one.
int RightAnglesIn(double angle);
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Polylines measured against each other, for the validation of feature curves.

#ifndef featurehex_PolylineDistance_h
#define featurehex_PolylineDistance_h

#include "Types.h"

#include <vector>

namespace featurehex
{
/// Closest point of a polyline.
struct PolylinePoint
{
  Vec3 Point = Vec3::Zero();
  double Distance = 1e300;
  double Arc = 0.0; ///< length of the polyline up to the point
};

/// A chain of straight segments. Segments without length are allowed.
class Polyline
{
public:
  explicit Polyline(std::vector<Vec3> points);

  const std::vector<Vec3>& Points() const { return this->Chain; }
  /// Length up to each point.
  const std::vector<double>& Arcs() const { return this->Lengths; }
  double Length() const { return this->Lengths.empty() ? 0.0 : this->Lengths.back(); }

  /// Of several equally close points that of the lowest arc. Linear in the segments.
  PolylinePoint Closest(const Vec3& p) const;

  /// The piece between two arcs, @a from <= @a to.
  Polyline Between(double from, double to) const;

  /// The points at these arcs, ascending; not empty.
  Polyline At(const std::vector<double>& arcs) const;

private:
  std::vector<Vec3> Chain;
  std::vector<double> Lengths;
};

/// The true value lies between the two.
struct LengthBounds
{
  double Lower = 0.0;
  double Upper = 0.0;
};

/// Largest distance of a point of @a from to @a to, one way. The distance to a segment is convex,
/// so that over a piece of a segment it is largest at an end (design 5); pieces are halved until
/// the bounds differ by at most @a accuracy, or 1 % where the distance is larger.
LengthBounds LargestDistance(const Polyline& from, const Polyline& to, double accuracy);
} // namespace featurehex

#endif

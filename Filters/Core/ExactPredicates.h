// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Signs of orientation determinants, exact: a floating-point filter that proves most signs, and
/// expansion arithmetic for the others.
///
/// Reference: J. R. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust
/// Geometric Predicates", Discrete & Computational Geometry 18(3), 1997, doi:10.1007/PL00009321.

#ifndef featurehex_ExactPredicates_h
#define featurehex_ExactPredicates_h

#include "Types.h"

#include <cmath>

namespace featurehex
{
/// Range of non-zero coordinates (magnitude) for which the predicates are exact: their products
/// neither overflow nor lose bits to underflow.
constexpr double PredicateMinimum = 1e-90;
constexpr double PredicateMaximum = 1e90;

/// The points as given when they are within the range above; otherwise scaled by a power of two so
/// that the largest coordinate is near 1, and coordinates below 1e-90 of it are zero.
/// Precondition: finite coordinates.
std::vector<Vec3> PointsForPredicates(const std::vector<Vec3>& points);

/// Sign of det(b - a, c - a, d - a) in expansion arithmetic, without the filter.
int Orient3DExact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Sign of (b - a) x (c - a), coordinates @a i and @a j, in expansion arithmetic.
int Orient2DExact(const Vec3& a, const Vec3& b, const Vec3& c, int i, int j);

/// Sign (-1, 0, 1) of det(b - a, c - a, d - a): 1 when d is on the side to which the normal of the
/// counter-clockwise triangle a b c points, 0 when the four points are coplanar.
inline int Orient3D(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  const double ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
  const double vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
  const double wx = d[0] - a[0], wy = d[1] - a[1], wz = d[2] - a[2];
  const double yz = uy * vz, zy = uz * vy, zx = uz * vx, xz = ux * vz, xy = ux * vy, yx = uy * vx;
  const double determinant = wx * (yz - zy) + wy * (zx - xz) + wz * (xy - yx);
  const double permanent = std::abs(wx) * (std::abs(yz) + std::abs(zy)) +
                           std::abs(wy) * (std::abs(zx) + std::abs(xz)) +
                           std::abs(wz) * (std::abs(xy) + std::abs(yx));
  // Shewchuk's first bound is (7 + 56 e) e with e = 2^-53; 8 e is above it.
  const double bound = 8.8817841970012523e-16 * permanent;
  if (determinant > bound)
  {
    return 1;
  }
  if (-determinant > bound)
  {
    return -1;
  }
  // Differences of doubles are zero only between equals: a zero permanent is exact.
  return permanent == 0.0 ? 0 : Orient3DExact(a, b, c, d);
}

/// Sign of the turn a, b, c in the projection to coordinates @a i and @a j: 1 counter-clockwise.
inline int Orient2D(const Vec3& a, const Vec3& b, const Vec3& c, int i, int j)
{
  const double left = (b[i] - a[i]) * (c[j] - a[j]);
  const double right = (b[j] - a[j]) * (c[i] - a[i]);
  const double determinant = left - right;
  // (3 + 16 e) e in the paper.
  const double sum = std::abs(left) + std::abs(right);
  const double bound = 4.4408920985006262e-16 * sum;
  if (determinant > bound)
  {
    return 1;
  }
  if (-determinant > bound)
  {
    return -1;
  }
  return sum == 0.0 ? 0 : Orient2DExact(a, b, c, i, j);
}

/// True when a, b and c lie on one line, or coincide.
inline bool Collinear(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return Orient2D(a, b, c, 0, 1) == 0 && Orient2D(a, b, c, 1, 2) == 0 &&
         Orient2D(a, b, c, 2, 0) == 0;
}
} // namespace featurehex

#endif

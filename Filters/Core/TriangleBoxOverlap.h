// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Does a triangle meet an axis-aligned box? Separating-axis test over the 13 candidate axes:
/// T. Akenine-Moller, "Fast 3D Triangle-Box Overlap Testing", Journal of Graphics Tools 6(1), 2001,
/// DOI 10.1080/10867651.2001.10487535.

#ifndef featurehex_TriangleBoxOverlap_h
#define featurehex_TriangleBoxOverlap_h

#include "Types.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace featurehex
{
/// True when the closed triangle @a a @a b @a c meets the closed box around @a center with half
/// edge lengths @a half; touching counts.
///
/// Rounding is on the safe side: any direction that separates the two proves that they are
/// disjoint, however inaccurately the direction itself was computed, so only the dot products need
/// a bound, and the box is inflated by it. An overlap is never missed; a triangle that misses the
/// box by a few units in the last place may be reported.
inline bool TriangleBoxOverlap(
  const Vec3& center, const Vec3& half, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 v[3] = { a - center, b - center, c - center };
  const double largest = std::max({ v[0].cwiseAbs().maxCoeff(), v[1].cwiseAbs().maxCoeff(),
    v[2].cwiseAbs().maxCoeff(), half.maxCoeff() });
  const Vec3 size = half.array() + 8 * std::numeric_limits<double>::epsilon() * largest;

  for (int k = 0; k < 3; ++k)
  {
    if (std::min({ v[0][k], v[1][k], v[2][k] }) > size[k] ||
        std::max({ v[0][k], v[1][k], v[2][k] }) < -size[k])
    {
      return false;
    }
  }

  const auto separates = [&v, &size](const Vec3& axis)
  {
    const double p[3] = { axis.dot(v[0]), axis.dot(v[1]), axis.dot(v[2]) };
    const double radius = axis.cwiseAbs().dot(size);
    return std::min({ p[0], p[1], p[2] }) > radius || std::max({ p[0], p[1], p[2] }) < -radius;
  };
  const Vec3 edge[3] = { v[1] - v[0], v[2] - v[1], v[0] - v[2] };
  if (separates(edge[0].cross(edge[1])))
  {
    return false;
  }
  for (const Vec3& e : edge)
  {
    if (separates(Vec3(0, -e[2], e[1])) || separates(Vec3(e[2], 0, -e[0])) ||
        separates(Vec3(-e[1], e[0], 0)))
    {
      return false;
    }
  }
  return true;
}
} // namespace featurehex

#endif

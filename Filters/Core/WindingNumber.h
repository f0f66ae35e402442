// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Generalised winding number of a triangle surface: how often it encloses a point.

#ifndef featurehex_WindingNumber_h
#define featurehex_WindingNumber_h

#include "Types.h"

namespace featurehex
{
/// For a closed surface oriented outward (cavities inward) the number is 1 in the solid, 0 outside
/// and in cavities, and it changes by 1 across the surface; gaps and overlaps only blur it. Near
/// groups of triangles are summed exactly (solid angles: A. van Oosterom, J. Strackee, 1983), far
/// groups by their dipole: G. Barill, N. Dickson, R. Schmidt, D. Levin, A. Jacobson, "Fast Winding
/// Numbers for Soups and Clouds", ACM TOG 37(4), 2018, doi:10.1145/3197517.3201337. Queries are
/// const, may run in parallel and always sum in the same order.
class WindingNumber
{
public:
  WindingNumber() = default;

  /// @a accuracy: a group counts as far when it is more than this many of its radii away (the
  /// paper: 2; larger is slower and closer to the exact sum).
  WindingNumber(
    const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, double accuracy = 2.5);

  explicit WindingNumber(const SurfaceMesh& surface)
    : WindingNumber(surface.Points, surface.Triangles)
  {
  }

  double At(const Vec3& p) const;

  /// True in the solid.
  bool Inside(const Vec3& p) const { return this->At(p) > 0.5; }

private:
  struct Corners
  {
    Vec3 A, B, C;
  };
  struct Node
  {
    Vec3 Center;       ///< area-weighted
    Vec3 AreaVector;   ///< sum of area * normal
    double FarSquared; ///< squared distance from Center beyond which the dipole is used
    Index First;       ///< first triangle
    Index Last;        ///< one past the last triangle
    Index Right;       ///< second child (the first is the next node); -1: leaf
  };

  Index Build(Index first, Index last, std::vector<Index>& order,
    const std::vector<Corners>& corners, double accuracy);

  std::vector<Corners> Triangles; ///< in tree order
  std::vector<Node> Nodes;
};
}

#endif

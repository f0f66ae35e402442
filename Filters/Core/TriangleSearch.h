// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Closest points and rays on a set of triangles: Embree hierarchy, distances in double precision.

#ifndef featurehex_TriangleSearch_h
#define featurehex_TriangleSearch_h

#include "Types.h"

#include <memory>

namespace featurehex
{
/// Closest point on a triangle.
struct TrianglePoint
{
  Vec3 Point = Vec3::Zero();
  Vec3 Barycentric = Vec3::Zero();
  double Distance = 1e300;
  Index Triangle = -1; ///< -1: nothing within the search radius
};

/// Closest point of the triangle a b c to p (C. Ericson, Real-Time Collision Detection, 2005,
/// 5.1.5).
TrianglePoint ClosestPointOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// How a search structure is built.
enum class SearchBuild
{
  Thorough, ///< for many queries
  Quick     ///< three times as fast; queries take some percent longer
};

/// Spatial search in triangles. Embree works in single precision on recentred, scaled coordinates;
/// every candidate is measured in double and the search radius is inflated by the rounding error,
/// so that the answer is that of a search in doubles. Ties go to the lowest triangle id: the answer
/// does not depend on the hierarchy. Queries are const and may run in parallel.
class TriangleSearch
{
public:
  TriangleSearch();
  TriangleSearch(std::vector<Vec3> points, std::vector<Triangle> triangles,
    SearchBuild build = SearchBuild::Thorough);
  ~TriangleSearch();
  TriangleSearch(TriangleSearch&&) noexcept;
  TriangleSearch& operator=(TriangleSearch&&) noexcept;

  /// Closest point within @a radius; @a hint is a triangle that is probably near (-1: none).
  TrianglePoint Closest(const Vec3& p, Index hint = -1, double radius = 1e300) const;

  /// Closest point of one triangle, no search.
  TrianglePoint ClosestOn(const Vec3& p, Index triangle) const;

  const std::vector<Vec3>& Points() const { return this->MeshPoints; }
  const std::vector<Triangle>& Triangles() const { return this->MeshTriangles; }

  /// Unit normal of a triangle; zero for a degenerate one.
  const Vec3& Normal(Index triangle) const { return this->Normals[triangle]; }

private:
  struct Scene;
  std::vector<Vec3> MeshPoints;
  std::vector<Triangle> MeshTriangles;
  std::vector<Vec3> Normals;
  std::unique_ptr<Scene> Hierarchy;
};
}

#endif

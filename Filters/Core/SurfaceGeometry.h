// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A checked surface with what the stages ask of it: closest points, smooth normals, samples.

#ifndef featurehex_SurfaceGeometry_h
#define featurehex_SurfaceGeometry_h

#include "TriangleSearch.h"

#include <functional>

namespace featurehex
{
/// Prepared once for a surface and shared by all stages and rounds.
class SurfaceGeometry
{
public:
  explicit SurfaceGeometry(SurfaceMesh surface);

  const SurfaceMesh& Mesh() const { return this->Surface; }
  const TriangleSearch& Search() const { return this->Triangles; }
  const Box& Bounds() const { return this->BoundingBox; }
  double Diagonal() const { return this->BoundingBox.Diagonal(); }

  /// Unit normal interpolated from area-weighted point normals; zero where they cancel.
  Vec3 NormalAt(const TrianglePoint& point) const;

  /// Model units, above 0, wanted at a point of the surface. The second argument is -1 at first and
  /// then what the function left there for a point nearby: a search may start from it, the result
  /// doesn't depend on it. Called by several threads.
  using SpacingFunction = std::function<double(const Vec3&, Index&)>;

  /// All points, and points on edges and triangles longer than the spacing there: no point of the
  /// surface is farther than about spacing / sqrt(3) from a sample. Order: points, then edges and
  /// interiors by triangle.
  std::vector<Vec3> Samples(const SpacingFunction& spacing) const;
  std::vector<Vec3> Samples(double spacing) const;

private:
  SurfaceMesh Surface;
  TriangleSearch Triangles;
  std::vector<Vec3> PointNormals;
  Box BoundingBox;
};
}

#endif

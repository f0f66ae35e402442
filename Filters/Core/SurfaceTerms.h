// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The terms that draw the boundary of a hex mesh to the surface (design 3.8, recipe-pipeline 2.7).

#ifndef featurehex_SurfaceTerms_h
#define featurehex_SurfaceTerms_h

#include "HexOptimizer.h"
#include "SurfaceEnvelope.h"

namespace featurehex
{
/// Sets the surface terms of an optimiser; keeps the closest triangles of the last round as hints.
class SurfaceTerms
{
public:
  /// Keeps references. @a features may be null: then the whole surface is the target of all.
  SurfaceTerms(const HexMesh& mesh, const HexStars& stars, const SurfaceGeometry& surface,
    const FeatureTargets* features = nullptr);

  /// Each boundary vertex and the centre of each boundary quad gets the tangent plane at the
  /// closest point of the surface, with features of its patch; far from it, a target in that
  /// direction. Feature vertices get their corner or the tangent of their curve.
  /// @a featureWeight: of corners and curves.
  void UpdatePlanes(HexOptimizer& optimizer, double weight, double featureWeight);

  /// Each quad is drawn to the sample of the input that is farthest from it. @a threshold (model
  /// units): closer samples exert no pull.
  void UpdateReverse(HexOptimizer& optimizer, const SurfaceEnvelope& envelope, double weight,
    double threshold) const;

private:
  Vec3 Center(std::size_t q) const;
  SurfaceTerm FeatureTerm(Index v, double size, double weight) const;
  double QuadSize(const HexOptimizer& optimizer, std::size_t q) const;

  const HexMesh& Mesh;
  const HexStars& Stars;
  const SurfaceGeometry& Surface;
  const FeatureTargets* Features;
  std::vector<Index> VertexHints;
  std::vector<Index> QuadHints;
};
}

#endif

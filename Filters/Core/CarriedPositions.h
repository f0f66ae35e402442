// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What one round of refinement leaves to the next: positions of the vertices whose surroundings
/// have not changed (design 5).

#ifndef featurehex_CarriedPositions_h
#define featurehex_CarriedPositions_h

#include "HexFeatures.h"

#include <cstdint>
#include <tuple>

namespace featurehex
{
/// Vertices of two padded meshes are the same when they were at the same place before anything was
/// untangled or fitted, and on the same feature.
class CarriedPositions
{
public:
  /// @a unfitted: positions after padding, @a fitted: at the end of the round. Both positively
  /// oriented there. @a length: of the edges of a hex; places are compared with 1e-6 of it.
  void Remember(const std::vector<Vec3>& unfitted, const FeatureLabels& labels,
    const std::vector<Vec3>& fitted, double length);

  /// Moves the points of an unfitted mesh where the vertices of the last round were in the end;
  /// new ones follow those round them. Returns 1 for each vertex that is new or in the rings round
  /// new ones: there the mesh has to be untangled and fitted, elsewhere it is. Empty: too little is
  /// known, and nothing has moved.
  std::vector<char> Apply(
    HexMesh& mesh, const HexStars& stars, const FeatureLabels& labels) const;

private:
  struct Vertex
  {
    std::array<std::int64_t, 3> Place;
    FeatureKind Kind;
    Index Id;
    Vec3 Fitted;

    auto Key() const { return std::tie(this->Place, this->Kind, this->Id); }
  };
  Vertex VertexAt(const Vec3& unfitted, FeatureKind kind, Index id) const;

  double Spacing = 1;
  std::vector<Vertex> Vertices; ///< ascending keys
};
} // namespace featurehex

#endif

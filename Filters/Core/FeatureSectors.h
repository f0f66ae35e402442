// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The quads between two feature edges at a vertex.

#ifndef featurehex_FeatureSectors_h
#define featurehex_FeatureSectors_h

#include "FeatureGeometry.h"
#include "HexFeatures.h"
#include "QuadGraph.h"

#include <vector>

namespace featurehex
{
/// Feature edges of a quad surface and the sectors they cut out round their vertices.
class FeatureSectors
{
public:
  /// @a features: of the vertices of @a graph.
  FeatureSectors(const QuadGraph& graph, const HexFeatures& features);

  /// -1: no feature edge.
  Index CurveOf(Index dart) const { return this->CurveOfDart[dart]; }

  /// Quads of the sector on the left of the feature edge that leaves its vertex along @a dart,
  /// counter-clockwise. Empty: no other feature edge ends the sector (free end of a curve).
  std::vector<Index> QuadsOf(Index dart) const;

  /// Angle of the surface at @a corner in the sector that begins at the feature edge @a dart,
  /// radians; 0: its curves don't follow each other round the corner.
  double AngleAt(Index corner, Index dart, const FeatureGeometry& geometry) const;

private:
  Index LastOf(Index dart) const;

  bool IsSpoke(const CornerFan::Spoke& spoke, Index dart) const
  {
    return spoke.Curve == this->CurveOfDart[dart] && spoke.AtEnd != this->AlongCurve[dart];
  }

  const QuadGraph& Graph;
  std::vector<Index> CurveOfDart;
  std::vector<bool> AlongCurve; ///< each dart: from the start of its curve to the end
};
} // namespace featurehex

#endif

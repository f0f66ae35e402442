// SPDX-License-Identifier: BSD-3-Clause
#include "HexFeatures.h"

namespace featurehex
{
FeatureLabels::FeatureLabels(
  const HexFeatures& features, const std::vector<Quad>& quads, std::size_t numberOfPoints)
  : Kind(numberOfPoints, FeatureKind::Interior)
  , Id(numberOfPoints, -1)
{
  const auto label = [this](Index v, FeatureKind kind, Index id) {
    this->Kind[v] = kind;
    this->Id[v] = id;
  };
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    for (Index v : quads[q])
    {
      const bool mixed =
        this->Kind[v] == FeatureKind::Surface && this->Id[v] != features.PatchOfQuad[q];
      label(v, FeatureKind::Surface, mixed ? -1 : features.PatchOfQuad[q]);
    }
  }
  for (std::size_t c = 0; c < features.CurvePaths.size(); ++c)
  {
    for (Index v : features.CurvePaths[c])
    {
      label(v, FeatureKind::Curve, static_cast<Index>(c));
    }
  }
  for (std::size_t c = 0; c < features.CornerVertices.size(); ++c)
  {
    if (features.CornerVertices[c] >= 0)
    {
      label(features.CornerVertices[c], FeatureKind::Corner, static_cast<Index>(c));
    }
  }
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause
#include "HexFeatures.h"

#include <utility>

namespace featurehex
{
void RenumberFeatures(const std::vector<Index>& ids, HexFeatures& features)
{
  for (Index& v : features.CornerVertices)
  {
    v = v < 0 ? -1 : ids[v];
  }
  for (std::vector<Index>& path : features.CurvePaths)
  {
    for (Index& v : path)
    {
      v = ids[v];
    }
  }
}

void QuadPatches::Renumber(const std::vector<Index>& ids)
{
  QuadPatches renumbered;
  for (const auto& [quad, patch] : this->Patches)
  {
    renumbered.Add({ ids[quad[0]], ids[quad[1]], ids[quad[2]], ids[quad[3]] }, patch);
  }
  *this = std::move(renumbered);
}

std::vector<int> QuadPatches::Of(const std::vector<Quad>& quads) const
{
  std::vector<int> patches;
  patches.reserve(quads.size());
  for (Quad quad : quads)
  {
    std::sort(quad.begin(), quad.end());
    const auto found = this->Patches.find(quad);
    patches.push_back(found == this->Patches.end() ? -1 : found->second);
  }
  return patches;
}

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

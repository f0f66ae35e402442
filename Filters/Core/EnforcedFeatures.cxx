// SPDX-License-Identifier: BSD-3-Clause
#include "EnforcedFeatures.h"

namespace featurehex
{
std::set<FeatureName> FeaturesAt(
  const HexMesh& mesh, const std::vector<Index>& hexes, const FeatureLabels& labels)
{
  std::set<FeatureName> features;
  for (Index h : hexes)
  {
    for (Index v : mesh.Hexes[h])
    {
      if (labels.Kind[v] >= FeatureKind::Curve)
      {
        features.insert({ labels.Kind[v], labels.Id[v] });
      }
    }
  }
  return features;
}

void EnforcedFeatures::Build(
  const SurfaceMesh& surface, const SurfaceFeatures& features, double trim)
{
  this->Surface = &surface;
  this->Graph = &features;
  this->Trim = trim;
  this->Current = std::make_unique<FeatureGeometry>(surface, features, trim, this->GivenUp);
}

bool EnforcedFeatures::GiveUp(const std::set<FeatureName>& failed, int patience)
{
  const std::size_t before = this->GivenUp.Corners.size() + this->GivenUp.Curves.size();
  for (const FeatureName& feature : failed)
  {
    if (++this->Failures[feature] < patience)
    {
      continue;
    }
    const auto [kind, id] = feature;
    if (kind == FeatureKind::Corner)
    {
      this->GivenUp.Corners.insert(id);
    }
    for (Index c = 0; c < static_cast<Index>(this->Graph->Curves.size()); ++c)
    {
      const FeatureCurve& curve = this->Graph->Curves[c];
      if ((kind == FeatureKind::Curve && id == c) ||
        (kind == FeatureKind::Surface && (curve.LeftPatch == id || curve.RightPatch == id)))
      {
        this->GivenUp.Curves.insert(c);
      }
    }
  }
  if (this->GivenUp.Corners.size() + this->GivenUp.Curves.size() == before)
  {
    return false;
  }
  this->Build(*this->Surface, *this->Graph, this->Trim);
  return true;
}

bool EnforcedFeatures::GiveUpLoose(const std::set<FeatureName>& features)
{
  std::set<FeatureName> loose;
  const auto add = [&](Index c) {
    const EnforcedCurve& curve = this->Current->Curves()[c];
    if (this->Current->PatchOf(curve.LeftPatch) == this->Current->PatchOf(curve.RightPatch))
    {
      loose.insert({ FeatureKind::Curve, c });
    }
  };
  for (const auto& [kind, id] : features)
  {
    if (kind == FeatureKind::Curve)
    {
      add(id);
    }
    for (std::size_t i = 0; kind == FeatureKind::Corner && i < this->Current->Fans()[id].Spokes.size(); ++i)
    {
      add(this->Current->Fans()[id].Spokes[i].Curve);
    }
  }
  return this->GiveUp(loose, 1);
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where the features of a surface are in a hex mesh.

#ifndef featurehex_HexFeatures_h
#define featurehex_HexFeatures_h

#include "HexStars.h"

#include <algorithm>
#include <map>

namespace featurehex
{
/// Corners are vertices, curves chains of boundary edges, patches sets of boundary quads. Ids are
/// those of SurfaceFeatures; what is not enforced has no image.
struct HexFeatures
{
  std::vector<Index> CornerVertices;          ///< of each corner; -1: none
  /// Of each curve; a loop repeats its first vertex; empty: none.
  std::vector<std::vector<Index>> CurvePaths;
  /// Of each boundary quad, in the order of HexStars::Quads.
  std::vector<int> PatchOfQuad;

  bool Empty() const { return this->PatchOfQuad.empty(); }
};

/// New vertex ids for corners and curves; @a ids: of each old vertex.
void RenumberFeatures(const std::vector<Index>& ids, HexFeatures& features);

/// Patches of boundary quads while a mesh changes: quads are known by their vertices.
class QuadPatches
{
public:
  void Add(Quad quad, int patch)
  {
    std::sort(quad.begin(), quad.end());
    this->Patches[quad] = patch;
  }
  /// New vertex ids for all quads; @a ids: of each old vertex, no two the same.
  void Renumber(const std::vector<Index>& ids);
  /// -1: a quad that was not added.
  std::vector<int> Of(const std::vector<Quad>& quads) const;

private:
  std::map<Quad, int> Patches;
};

/// Values of the array FeatureKind.
enum class FeatureKind : std::uint8_t
{
  Interior,
  Surface,
  Curve,
  Corner
};

/// For each vertex of a mesh the feature it belongs to.
struct FeatureLabels
{
  std::vector<FeatureKind> Kind;
  /// Patch, curve or corner; -1: interior, or between patches that no curve parts.
  std::vector<Index> Id;

  FeatureLabels() = default;
  FeatureLabels(const HexFeatures& features, const HexStars& stars)
    : FeatureLabels(features, stars.Quads, stars.Hexes.size())
  {
  }
  /// @a quads: those of the boundary, as many as PatchOfQuad has.
  FeatureLabels(
    const HexFeatures& features, const std::vector<Quad>& quads, std::size_t numberOfPoints);
};
} // namespace featurehex

#endif

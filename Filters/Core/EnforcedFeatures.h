// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which features of the surface the rounds of the refinement loop still ask for.

#ifndef featurehex_EnforcedFeatures_h
#define featurehex_EnforcedFeatures_h

#include "FeatureGeometry.h"
#include "FeatureValidation.h"

#include <map>
#include <set>

namespace featurehex
{
/// Corner, curve, or patch (FeatureKind::Surface) and its id.
using FeatureName = std::pair<FeatureKind, Index>;

/// Corners and curves on which some hexes have vertices.
std::set<FeatureName> FeaturesAt(
  const HexMesh& mesh, const std::vector<Index>& hexes, const FeatureLabels& labels);

/// Where finer cells may help features that @a report calls OffPosition, whose vertices are trapped
/// beside them, or BeyondTolerance: their chains and quads are farther from them than @a distance
/// (model units), sampled. The boundary as a whole may be nearer: the surface beyond a crease
/// counts there, not here. @a quads: the boundary.
std::vector<Vec3> MissedFeaturePlaces(const HexMesh& mesh, const std::vector<Quad>& quads,
  const HexFeatures& features, const FeatureGeometry& geometry,
  const FeatureValidationReport& report, double distance);

/// The features that a mesh shall have. What fails again and again is given up: a mesh without it,
/// which says so, is worth more than none.
class EnforcedFeatures
{
public:
  /// All features without a flaw, or those that are left; keeps the references. @a trim: see
  /// FeatureGeometry.
  void Build(const SurfaceMesh& surface, const SurfaceFeatures& features, double trim);

  /// For the next geometry.
  void SetTrim(double trim) { this->Trim = trim; }

  /// Null without features.
  const FeatureGeometry* Geometry() const { return this->Current.get(); }

  /// Counts failures; what has failed in @a patience rounds is given up (of a patch, the curves
  /// round it). True: there are such, and Geometry() is a new one.
  bool GiveUp(const std::set<FeatureName>& failed, int patience);

  /// Gives up loose curves among these features and at these corners: curves with the same patch on
  /// both sides, which bound nothing. True: there are such, and Geometry() is a new one.
  bool GiveUpLoose(const std::set<FeatureName>& features);

private:
  const SurfaceMesh* Surface = nullptr;
  const SurfaceFeatures* Graph = nullptr;
  double Trim = 0.0;
  GivenUpFeatures GivenUp;
  std::map<FeatureName, int> Failures;
  std::unique_ptr<FeatureGeometry> Current;
};
} // namespace featurehex

#endif

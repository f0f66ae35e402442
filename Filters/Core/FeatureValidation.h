// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which corners, curves and patches of a surface a hex mesh reproduces, one to one (design 1,
/// 3.9).

#ifndef featurehex_FeatureValidation_h
#define featurehex_FeatureValidation_h

#include "HexFeatures.h"
#include "MeshTopology.h"
#include "SurfaceFeatures.h"

#include <string>

namespace featurehex
{
/// Captured, or the first thing that is wrong. Values are stable: they are written to files.
enum class FeatureOutcome : std::uint8_t
{
  Captured = 0,
  /// A flawed corner; a curve that ends at one; patches that such a curve parts.
  NotEnforced = 1,
  NotMapped = 2,       ///< nothing in the mesh stands for it
  OffPosition = 3,     ///< a vertex isn't on the corner or curve
  BrokenPath = 4,      ///< no simple chain of boundary edges from one end to the other
  WrongEnd = 5,        ///< the chain ends at another vertex than that of the corner
  BeyondTolerance = 6, ///< chords too far from the curve, quads too far from the patch
  InPieces = 7,        ///< the quads of the patch don't hang together
  WrongBoundary = 8,   ///< the quads are bounded by other curves than the patch
  WrongTopology = 9    ///< another Euler characteristic than the patch of the surface
};

/// "Captured", "NotMapped" and so on.
const char* FeatureOutcomeName(FeatureOutcome outcome);

/// The verdict on one corner, curve or patch.
struct FeatureFinding
{
  FeatureOutcome Outcome = FeatureOutcome::Captured;
  std::string Reason; ///< in words; empty when captured
  /// Corner: distance of its vertex. Curve: chain and curve, both ways, proven (of a curve that is
  /// cut short: of the part that the chain follows). Patch: from points of its quads to the patch.
  /// Model units; 0 where nothing could be measured.
  double Deviation = 0.0;
  /// Curve: largest distance of a vertex of the chain, model units.
  double VertexDeviation = 0.0;
  Vec3 Where = Vec3::Zero(); ///< of the feature, model units

  bool Captured() const { return this->Outcome == FeatureOutcome::Captured; }
  bool Enforced() const { return this->Outcome != FeatureOutcome::NotEnforced; }
};

/// One kind of feature in numbers. Deviations are those of enforced features, model units.
struct FeatureTotals
{
  Index Found = 0; ///< on the surface
  Index Enforced = 0;
  Index Captured = 0;
  double Deviation = 0.0;       ///< largest
  double VertexDeviation = 0.0; ///< largest, of curves
};

/// Findings in the order of SurfaceFeatures; patches by id.
struct FeatureValidationReport
{
  std::vector<FeatureFinding> Corners;
  std::vector<FeatureFinding> Curves;
  std::vector<FeatureFinding> Patches;
  double Diagonal = 0.0; ///< of the surface's bounding box, model units

  FeatureTotals CornerTotals() const { return Sum(this->Corners); }
  FeatureTotals CurveTotals() const { return Sum(this->Curves); }
  FeatureTotals PatchTotals() const { return Sum(this->Patches); }
  bool AllCaptured() const; ///< of those that are enforced

  /// What is missed, in one sentence with the first place; empty when everything is captured.
  std::string Complaint() const;

  static FeatureTotals Sum(const std::vector<FeatureFinding>& findings);
};

/// A corner vertex may be off its corner, a curve vertex off its curve by this, as a fraction of
/// the diagonal.
constexpr double CornerAccuracy = 1e-9;
constexpr double CurveAccuracy = 1e-6;

/// The features of a surface and what a mesh has of them; ids agree.
struct FeatureCorrespondence
{
  const SurfaceFeatures* OfSurface = nullptr;
  const HexFeatures* OfMesh = nullptr; ///< PatchOfQuad: in the order of ExtractBoundary()
};

/// Measures with code that shares nothing with mapping and fitting; the only distance search is
/// that of the other validations.
///
/// A corner is captured when one boundary vertex of its own is within CornerAccuracy of it. A
/// curve: a chain of boundary edges that uses no vertex twice and none of another curve runs once
/// along it from corner vertex to corner vertex (loops are closed), every vertex within
/// CurveAccuracy of it, chain and curve within @a tolerance (a fraction of the diagonal) of each
/// other, both ways. A patch: its quads are connected without crossing a chain, bounded by exactly
/// the chains of its curves, each seen on the right side, have the Euler characteristic of the
/// patch, and their corners, centres and edge middles are within @a tolerance of it.
///
/// A corner that isn't Valid() isn't enforced, nor a curve that ends at one, nor the patches on
/// its two sides: nothing parts them at that corner. They are reported, but don't count; how
/// the quads of such patches are labelled doesn't matter.
///
/// @a boundary: of @a mesh. Ids and sizes in @a features needn't be right. Parallel over the
/// patches, the same bits for any number of threads.
FeatureValidationReport ValidateFeatures(const HexMesh& mesh, const HexBoundary& boundary,
  const SurfaceMesh& surface, const FeatureCorrespondence& features, double tolerance);
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Stage 8 as a whole: fit, improve, and prove the distance.

#ifndef featurehex_ProvenFitting_h
#define featurehex_ProvenFitting_h

#include "CertifiedDistance.h"
#include "HexFitting.h"
#include "HexImprovement.h"

namespace featurehex
{
/// Of fitting, improvement and their proof together.
struct ProvenFittingOptions
{
  /// Fraction of the diagonal of the surface's bounding box.
  double Tolerance = 0.005;
  /// Wanted, best effort; 0: no improvement.
  double MinimumScaledJacobian = 0.55;
  int FittingIterations = 14;
  int ImprovementRounds = 8;
};

/// How fitting ended.
enum class FittingOutcome
{
  Proven,   ///< every point of both surfaces is within the tolerance
  Far,      ///< the fitted boundary is too far for the improvement to mend
  NotDrawn, ///< the improvement could not draw the boundary inside the tolerance
  NotProven ///< the samples are inside, but not all points are known to be
};

/// Whether the distance is proven, and where not.
struct ProvenFittingReport
{
  FittingOutcome Outcome = FittingOutcome::Far;
  /// Where the surface is beyond the tolerance or not proven to be within: more cells help there.
  std::vector<Vec3> Places;
  ImprovementReport Improvement;
};

/// Fits a mesh without inverted hexes to a surface. Where the proof of the distance fails, the
/// samples were too coarse: its witnesses become samples, with others round them, and the improvement
/// runs again there; the second time and later the limit gets a little tighter, too.
class ProvenFitting
{
public:
  /// Keeps the reference.
  ProvenFitting(const SurfaceGeometry& surface, const ProvenFittingOptions& options);

  /// @a features may be null. @a changed: 1 for vertices that have to be fitted and improved; null:
  /// all. The others are in place (CarriedPositions.h).
  Status Run(HexMesh& mesh, const HexStars& stars, FeatureTargets* features,
    const std::vector<char>* changed, ProvenFittingReport& report, Monitor& monitor);

private:
  double AbsoluteTolerance() const { return this->Options.Tolerance * this->Surface.Diagonal(); }
  void AddSamplesRound(const DistanceWitness& witness);
  Status ImproveAndProve(HexMesh& mesh, const HexStars& stars, SurfaceEnvelope& envelope,
    FeatureTargets* features, const std::vector<char>* changed, ProvenFittingReport& report,
    Monitor& monitor);

  const SurfaceGeometry& Surface;
  ProvenFittingOptions Options;
  CertifiedDistance Distance;
  std::vector<Vec3> Samples;   ///< of the surface, for the current mesh
  std::vector<Vec3> Witnesses; ///< of failed proofs, from all meshes so far: samples in each
};
}

#endif

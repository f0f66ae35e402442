// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Worst-element stage: raises the minimum scaled Jacobian of a fitted mesh inside the tolerance
/// (design 3.8, recipe-quality 2).

#ifndef featurehex_HexImprovement_h
#define featurehex_HexImprovement_h

#include "FeatureTargets.h"
#include "HexStars.h"
#include "Monitor.h"
#include "SurfaceEnvelope.h"

namespace featurehex
{
/// When the improvement stops, and what it may not do.
struct ImprovementOptions
{
  /// Wanted minimum scaled Jacobian; best effort.
  double MinimumScaledJacobian = 0.55;
  /// Fraction of the diagonal of the surface's bounding box.
  double Tolerance = 0.005;
  /// Sampled distances stay below this share of the tolerance, so that the certified bound of all
  /// points, not only of the samples, stays below the tolerance.
  double EnvelopeShare = 0.93;
  int MaximumRounds = 8;
  int MaximumPatches = 40; ///< per round
  /// Feature vertices that are locked slide on their features only; others are put there as soon as
  /// that keeps the mesh valid. May be null.
  FeatureTargets* Features = nullptr;
  /// 1 for vertices whose mean quality is raised and which are put on the surface; null: all. For
  /// the others that is done (CarriedPositions.h), unless they are moved by the rest.
  const std::vector<char>* Changed = nullptr;
  /// Raise the minimum, too, only in the hexes of those and where vertices are moved.
  bool OnlyChanged = false;
};

/// What the improvement reached.
struct ImprovementReport
{
  double MinimumBefore = 0, MinimumAfter = 0;
  double Distance = 0; ///< bound of the sampled distance at the end, model units
  bool Drawn = false;  ///< the boundary came well inside the tolerance
  int Rounds = 0;
  /// Boundary vertices that lie on the surface exactly (before a last correction).
  Index OnSurface = 0;
  Index OffFeatures = 0; ///< corner and curve vertices that are not on their features
  Index BelowTarget = 0; ///< hexes left below the wanted minimum
};

/// Moves points of a valid mesh; connectivity stays. Every step keeps elements valid over their
/// whole volume and quads inside the envelope. When the boundary can't be drawn inside, the stage
/// ends there (report.Drawn is false): the mesh needs other cells. @a envelope belongs to this
/// mesh.
Status ImproveHexes(HexMesh& mesh, const HexStars& stars, const SurfaceGeometry& surface,
  SurfaceEnvelope& envelope, const ImprovementOptions& options, ImprovementReport& report,
  Monitor& monitor);
}

#endif

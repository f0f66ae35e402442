// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Fitting: a valid hex mesh near the surface becomes one whose boundary lies on it (design 3.8).

#ifndef featurehex_HexFitting_h
#define featurehex_HexFitting_h

#include "FeatureTargets.h"
#include "Monitor.h"
#include "SurfaceEnvelope.h"

namespace featurehex
{
/// Of the way to the surface.
struct FittingOptions
{
  double Tolerance = 0.005;       ///< of the diagonal of the surface's bounding box
  int Iterations = 14;            ///< projections to the surface
  double InitialWeight = 5.0;     ///< of the surface terms against the distortion
  double WeightGrowth = 1.5;      ///< per iteration
  double MaximumWeight = 200.0;   ///< more only lowers the quality (recipe-pipeline 3)
  /// 1 for vertices that move; null: all. The others are fitted (CarriedPositions.h).
  const std::vector<char>* Changed = nullptr;
};

/// From a valid mesh to a valid mesh with its boundary on the surface. @a features may be null;
/// corner and curve vertices that reach their features are locked there. @a envelope belongs to
/// this mesh.
Status FitHexes(HexMesh& mesh, const HexStars& stars, const SurfaceGeometry& surface,
  FeatureTargets* features, SurfaceEnvelope& envelope, const FittingOptions& options,
  Monitor& monitor);
}

#endif

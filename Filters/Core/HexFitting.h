// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Untangling and fitting: a hex mesh near the surface becomes one whose boundary lies on it (design 3.7, 3.8).

#ifndef featurehex_HexFitting_h
#define featurehex_HexFitting_h

#include "HexOptimizer.h"
#include "Monitor.h"
#include "SurfaceEnvelope.h"

namespace featurehex
{
struct UntangleOptions
{
  int MaximumSweeps = 60;
  /// Of the terms that hold the boundary near the surface; without a surface the boundary is fixed.
  double SurfaceWeight = 1.0;
};

struct UntangleReport
{
  Index InvertedBefore = 0;
  Index InvertedAfter = 0;
  int Sweeps = 0;
};

/// Hexes with a corner determinant <= 0, ascending.
std::vector<Index> InvertedHexes(const HexMesh& mesh);

/// Moves points until no corner determinant is <= 0. @a surface may be null: then boundary vertices don't move.
Status UntangleHexes(HexMesh& mesh, const HexStars& stars, const SurfaceGeometry* surface,
  const UntangleOptions& options, UntangleReport& report, Monitor& monitor);

struct FittingOptions
{
  double Tolerance = 0.005;       ///< of the diagonal of the surface's bounding box
  int Iterations = 14;            ///< projections to the surface
  double InitialWeight = 5.0;     ///< of the surface terms against the distortion
  double WeightGrowth = 1.5;      ///< per iteration
  double MaximumWeight = 200.0;   ///< more only lowers the quality (recipe-pipeline 3)
};

/// From a valid mesh to a valid mesh with its boundary on the surface. @a envelope belongs to this mesh.
Status FitHexes(HexMesh& mesh, const HexStars& stars, const SurfaceGeometry& surface,
  SurfaceEnvelope& envelope, const FittingOptions& options, Monitor& monitor);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Frees the last bad hexes: all vertices of a small neighbourhood at once, by Newton on the
/// barrier.

#ifndef featurehex_PatchImprover_h
#define featurehex_PatchImprover_h

#include "Monitor.h"
#include "VertexImprover.h"

namespace featurehex
{
/// Patch solves of recipe-quality 2.5: the vertices of a bad hex and one or two rings, the barrier
/// of BarrierFunction.h on all corners, 9x9 corner Hessians projected to be positive, sparse
/// factorisation, Levenberg-Marquardt. Same hard checks as VertexImprover. Sequential: there are
/// few patches.
class PatchImprover
{
public:
  PatchImprover(HexMesh& mesh, const HexStars& stars, SurfaceEnvelope& envelope,
    const VertexImprover& vertices);

  /// Worst hex first, until none of @a hexes is below @a target or @a maximumPatches are solved.
  void RaiseWorst(
    const std::vector<Index>& hexes, double target, int maximumPatches, Monitor& monitor);

private:
  struct Patch;

  double Solve(Index hex, int rings, double target);
  void BuildPatch(Index hex, int rings, Patch& patch) const;
  bool Step(Patch& patch, double theta);
  double Energy(const Patch& patch, double theta) const;
  bool Sound(const Patch& patch, const std::vector<double>& before) const;
  double Assemble(Patch& patch, double theta) const;

  HexMesh& Mesh;
  const HexStars& Stars;
  SurfaceEnvelope& Envelope;
  const VertexImprover& Vertices;
};
}

#endif

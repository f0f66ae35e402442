// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Stage 5: which vertices, edges and quads of the interface become the corners, curves and patches
/// of the surface (design 3.5).

#ifndef featurehex_HexFeatureMapping_h
#define featurehex_HexFeatureMapping_h

#include "FeatureGeometry.h"
#include "HexFeatures.h"
#include "InterfaceRepair.h"
#include "Monitor.h"

#include <string>

namespace featurehex
{
/// How far features may be looked for.
struct FeatureMappingOptions
{
  /// A corner goes to an interface vertex within this many local edge lengths, if there is one.
  double CornerReach = 1.8;
  /// A path stays within this many local edge lengths of its curve.
  double CurveReach = 2.5;
  /// A curve that finds no way takes it from others, which look for another one; this often.
  int MaximumAttempts = 20;
};

/// One feature that could not be mapped.
struct MappingFailure
{
  FeatureKind Kind = FeatureKind::Interior; ///< Corner, Curve, or Surface: a patch
  Index Id = -1;
  std::string Reason; ///< a sentence that names the feature
  std::vector<Vec3> Places; ///< where finer cells would help
};

/// Which vertices, edges and quads stand for the features, and what failed.
struct FeatureMapping
{
  HexFeatures Features; ///< vertices of the hex mesh; PatchOfQuad: of each interface quad
  std::vector<MappingFailure> Failures;
  Index Reroutes = 0; ///< paths that were given up for another curve

  bool Complete() const { return this->Failures.empty(); }
};

/// Corners become interface vertices, one to one, with at least as many edges as curves meet there;
/// curves become paths of interface edges that keep their cyclic order at the corners and touch
/// nowhere else; patches are the pieces between the paths, matched one to one by the curves that
/// bound them.
///
/// A path is a shortest one in (length) x (1 + 2 (distance to the curve / edge length)^2) plus a
/// price for turns that leave a single quad, or many, on one side; it never jumps along its curve,
/// so that a narrow horseshoe isn't cut off. What can't be mapped is no error: see Failures.
/// Sequential, deterministic. Cost: O(n log n) in the edges near each curve.
Status MapFeaturesToInterface(const HexMesh& mesh, const std::vector<InterfaceQuad>& interface,
  const FeatureGeometry& geometry, const FeatureMappingOptions& options, Monitor& monitor,
  FeatureMapping& mapping);
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The part of FeatureValidation.h that looks at patches.

#ifndef featurehex_PatchValidation_h
#define featurehex_PatchValidation_h

#include "FeatureValidation.h"

namespace featurehex
{
/// An edge of a boundary quad or of a triangle, with the face on its left.
struct FaceEdge
{
  Index Low = -1, High = -1; ///< points, ascending
  Index Face = -1;
  bool Upward = false; ///< the face runs from Low to High

  bool Joins(const FaceEdge& other) const
  {
    return this->Low == other.Low && this->High == other.High;
  }
};

/// By their points.
inline bool Before(const FaceEdge& a, const FaceEdge& b)
{
  return a.Low != b.Low ? a.Low < b.Low : a.High < b.High;
}

/// All edges of the quads, those of the same points together.
std::vector<FaceEdge> SortedEdges(const std::vector<Quad>& quads);

/// The edges of one chain, walking along its curve.
struct ChainEdge
{
  Index Low = -1, High = -1;
  Index Curve = -1;
  bool Upward = false; ///< the curve runs from Low to High
};

/// Findings for all patches. @a chains: sorted by Low, High; @a absent: enforced curves without a
/// chain.
std::vector<FeatureFinding> ValidatePatches(const HexMesh& mesh, const HexBoundary& boundary,
  const SurfaceMesh& surface, const FeatureCorrespondence& features,
  const std::vector<ChainEdge>& chains, const std::vector<Index>& absent, double tolerance);
} // namespace featurehex

#endif

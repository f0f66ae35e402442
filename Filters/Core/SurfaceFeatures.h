// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sharp features of a surface: corners, curves between them, and the patches that they bound.

#ifndef featurehex_SurfaceFeatures_h
#define featurehex_SurfaceFeatures_h

#include "Types.h"

namespace featurehex
{
/// Why a corner is not enforced (design 3.1).
enum class CornerFlaw : std::uint8_t
{
  None,
  ManyCurves, ///< more than six curves meet
  AcuteCurves ///< two curves meet at less than 30 degrees
};

/// A surface point where a curve ends, curves meet, or a curve has a kink.
struct FeatureCorner
{
  Index Point = -1;
  CornerFlaw Flaw = CornerFlaw::None;
  bool Valid() const { return this->Flaw == CornerFlaw::None; }
};

/// A chain of sharp edges. Closed ones (a loop without or with one corner) repeat their first point
/// at the end.
struct FeatureCurve
{
  std::vector<Index> Points;                ///< surface points, at least two
  Index FirstCorner = -1, LastCorner = -1;  ///< -1: a loop without corner
  int LeftPatch = -1, RightPatch = -1;      ///< seen from outside, walking along Points
  bool Closed() const { return this->Points.size() > 1 && this->Points.front() == this->Points.back(); }
};

/// The feature graph of a checked surface (SurfaceCheck.h) and the patches between its curves. Ids
/// are positions in the lists. Order: corners by point id, curves by their lowest point pair,
/// patches by their first triangle.
struct SurfaceFeatures
{
  std::vector<FeatureCorner> Corners;
  std::vector<FeatureCurve> Curves;
  std::vector<int> PatchOfTriangle; ///< of each triangle of the surface
  int NumberOfPatches = 0;
};
} // namespace featurehex

#endif

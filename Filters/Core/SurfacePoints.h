// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Recognises points of a surface in other data: annotations, selections, feature graphs.

#ifndef featurehex_SurfacePoints_h
#define featurehex_SurfacePoints_h

#include "Status.h"

namespace featurehex
{
/// The surface point of each place, -1: none.
///
/// @a named: ids that the data itself gives, or empty. They are believed when they agree with all
/// places, or when several points are all at one place (data without coordinates). Otherwise the
/// places count: the nearest point that a triangle uses, the lowest id of several, within 1e-6 of
/// the diagonal of the surface (a file in single precision).
/// Cost: (n + m) log n.
std::vector<Index> RecognizeSurfacePoints(
  const SurfaceMesh& surface, const std::vector<Vec3>& places, const std::vector<Index>& named);

/// The error for a point that wasn't recognised, or that doesn't exist at all.
Status UnknownSurfacePoint(std::int64_t point, const std::vector<Vec3>& places);
} // namespace featurehex

#endif

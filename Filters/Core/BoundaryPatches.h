// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Boundary quads and the input surface: which part of it they belong to, which quad is near a
/// place.

#ifndef featurehex_BoundaryPatches_h
#define featurehex_BoundaryPatches_h

#include "Types.h"

namespace featurehex
{
/// Patch of each quad. Quads connected through their vertices form a shell; the shell gets the
/// patch that most of its quads are closest to (their centres; ties: the lowest). A shell therefore
/// never mixes two components of the surface that are close to each other.
/// @a patchOfTriangle: of each triangle, -1 for triangles that don't count. All -1 without any.
/// Precondition: ids exist, points are finite.
std::vector<int> PatchesOfShells(const std::vector<Vec3>& points, const std::vector<Quad>& quads,
  const SurfaceMesh& surface, const std::vector<Index>& patchOfTriangle);

/// For each of @a places the quad that is closest to it; quads count as two triangles.
std::vector<Index> NearestQuads(
  const std::vector<Vec3>& points, const std::vector<Quad>& quads, const std::vector<Vec3>& places);
} // namespace featurehex

#endif

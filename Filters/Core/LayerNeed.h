// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where the mesh follows a part of the surface without any padding.

#ifndef featurehex_LayerNeed_h
#define featurehex_LayerNeed_h

#include "FeatureGeometry.h"
#include "HexFeatures.h"
#include "Types.h"

#include <vector>

namespace featurehex
{
/// For each group of patches (PaddingGroups.h): whether its quads need a layer of hexes.
///
/// They need none where the unpadded hexes already meet as they would in a grid: two hexes along
/// each edge in a patch, three to five quads round each of its vertices; along each crease and at
/// each corner as many hexes and quads as right angles fit best. Flat faces along the axes of the
/// octree are like that, and a layer would bend their corners for nothing. Faces across the axes
/// have stairs, and hexes with two quads.
///
/// @a quads: the boundary of @a mesh with the patches and paths of @a features.
std::vector<char> GroupsThatNeedLayers(const HexMesh& mesh, const std::vector<Quad>& quads,
  const HexFeatures& features, const FeatureGeometry& geometry,
  const std::vector<int>& groupOfPatch);
} // namespace featurehex

#endif

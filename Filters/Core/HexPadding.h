// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Global padding: layers of hexes under the whole boundary of the bodies.

#ifndef featurehex_HexPadding_h
#define featurehex_HexPadding_h

#include "FeatureGeometry.h"
#include "HexFeatures.h"
#include "Status.h"

namespace featurehex
{
/// Of the layer under the whole boundary.
struct PaddingOptions
{
  /// Of the layer, in local cell sizes. Positive: layers of no thickness tangle again. Thin layers
  /// invert fewer hexes (measured: 1 % of them at 0.1, 3 % at 0.3).
  double Thickness = 0.1;
  /// Also under groups of patches that the mesh follows without a layer (LayerNeed.h).
  bool EveryGroup = false;
};

/// The bodies with their layers. A boundary hex has one quad on the boundary, or one of each layer
/// that crosses it. Connectivity is valid; some hexes may be inverted.
struct PaddedMesh
{
  /// Points along a Morton curve, hexes by their lowest point: near in space, near in memory.
  HexMesh Mesh;
  std::vector<int> Region;         ///< per hex
  std::vector<char> IsLayer;       ///< per hex
  std::vector<Index> LayerHexes;   ///< ids of the layer hexes, ascending
  std::vector<Index> SourceHex;    ///< per hex that of the unpadded mesh (layer: the one it covers)
  std::vector<Index> SourcePoint;  ///< per point the point of the unpadded mesh (several share one)
  std::vector<char> OnBoundary;    ///< per point
};

/// Keep the hexes with @a region > 0, give them a layer inwards. Interface points stay where they
/// are and become the boundary; their inner copies move along the mean unit normal of the
/// interface.
///
/// @a features: those of the interface, PatchOfQuad in the order of InterfaceQuads(); replaced by
/// those of the padded mesh. With @a geometry each group of patches (PaddingGroups.h) gets its own
/// layer, in ascending order. Layers cross where groups meet: the copy of a point on such a crease
/// lies on the patch or the curve beyond it.
///
/// Fails with InvalidOption; InvalidMesh, also when the interface is not a manifold
/// (ComputeHexDomain makes manifolds).
Status PadInterface(const HexMesh& mesh, const std::vector<int>& region,
  const PaddingOptions& options, PaddedMesh& padded, HexFeatures* features = nullptr,
  const FeatureGeometry* geometry = nullptr);

/// Renumbers points along a Morton curve and hexes by their lowest point. Returns the new id of
/// each point.
std::vector<Index> OrderInSpace(PaddedMesh& padded);

/// Rank of each point along a Morton (Z-order) curve of 2^21 steps a side through their box.
/// Ties keep the order of the ids.
std::vector<Index> MortonRank(const std::vector<Vec3>& points);
}

#endif

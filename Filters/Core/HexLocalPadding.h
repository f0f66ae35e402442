// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Local padding: more elements where a feature would straighten the corner of a boundary quad
/// (design 3.6).

#ifndef featurehex_HexLocalPadding_h
#define featurehex_HexLocalPadding_h

#include "FeatureGeometry.h"
#include "HexFeatures.h"
#include "HexPadding.h"

namespace featurehex
{
/// Which quads are degenerate, and how thick their layers are.
struct LocalPaddingOptions
{
  /// A quad corner between two feature edges that will get a wider angle than this, degrees, is
  /// degenerate.
  double WidestAngle = 135.0;
  /// Three quads or more between two feature edges that would get narrower angles than this are
  /// padded, too.
  double NarrowestAngle = 50.0;
  /// Of the layers: share of the way to the centres of the hexes.
  double Thickness = 0.25;
};

/// How much was padded.
struct LocalPaddingReport
{
  Index DegenerateQuads = 0;
  Index Regions = 0; ///< connected groups of quads that were padded
  Index AddedHexes = 0;
};

/// A quad with two consecutive edges on one curve would get a straight angle there. Such quads and
/// those round their vertices without feature are grouped, and the layer hexes under each group are
/// shrunk away from all others ("pillow"); the gap is filled with hexes: a layer below the group,
/// and a ring round it, whose quads have one edge on the curve each.
///
/// Creases with one hex have no such quads. Where the rim of a group crosses one, the crease gets
/// one more vertex.
///
/// @a padded: the globally padded mesh; @a features: its features. Both are replaced; the
/// vertices of corners and curves stay the same points. Connectivity is valid afterwards, some
/// hexes may be inverted.
LocalPaddingReport PadDegenerateQuads(PaddedMesh& padded, HexFeatures& features,
  const FeatureGeometry& geometry, const LocalPaddingOptions& options);
} // namespace featurehex

#endif

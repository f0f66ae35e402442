// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sizes that are chosen where the user leaves the choice.

#ifndef featurehex_AutomaticSizing_h
#define featurehex_AutomaticSizing_h

#include "FeatureGeometry.h"
#include "Monitor.h"
#include "SurfaceGeometry.h"
#include "SurfaceSizing.h"

namespace featurehex
{
/// What is chosen where the user leaves it open.
struct AutomaticSizing
{
  double CellsPerSide;      ///< target edge length: longest side of the bounding box / this
  double CellsPerThickness; ///< SizingOptions
  int MaximumSizingLevel;   ///< SizingOptions
  double UniformHexes;      ///< a mesh with so few gets no coarser cells inside
};

/// Measured (Documentation/sizing.md). Layers under both sides of a thin wall add hexes across it:
/// with features one cell is enough there.
constexpr AutomaticSizing AutomaticSizingFor(bool features)
{
  return features ? AutomaticSizing{ 18, 1.0, 3, 6000 } : AutomaticSizing{ 20, 2.0, 2, 20000 };
}

/// The same for ComputeSizing(). @a slack: model units, usually the tolerance.
SizingOptions AutomaticSizingOptions(bool features, double edgeLength, double slack);

/// Target edge length, model units: the longest side / CellsPerSide; less where quads of that size
/// could not follow the curvature within @a slack, and more where even larger ones can. With
/// features it is fitted to the flat faces (GridFit.h), and more where no thin part, no curvature
/// and no feature asks for cells as small: a plain box needs ten a side. @a features: of the
/// surface, without curves when there are none. @a axes: of the grid (GridAxes()). @a slack: model
/// units, usually the tolerance.
double AutomaticEdgeLength(const SurfaceGeometry& surface, const SurfaceFeatures& features,
  const Mat3& axes, double slack, Monitor& monitor);

/// OctreeOptions::CoarseLevels for cells of @a edgeLength: none where they would save nothing worth
/// their irregular edges.
int AutomaticCoarseLevels(const SurfaceGeometry& surface, double edgeLength, bool features);
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Hexes of 20 or 27 nodes from linear ones: nodes of the boundary on the surface, valid with
/// proof.

#ifndef featurehex_QuadraticHexes_h
#define featurehex_QuadraticHexes_h

#include "HexFeatures.h"
#include "Monitor.h"
#include "Status.h"
#include "SurfaceFeatures.h"

namespace featurehex
{
/// Where nodes of the boundary shall go; null: they stay in the middle of edges and faces.
struct QuadraticTargets
{
  const SurfaceMesh* Surface = nullptr;
  const SurfaceFeatures* SurfaceGraph = nullptr; ///< needs Surface and MeshFeatures
  const HexFeatures* MeshFeatures = nullptr;     ///< of the hex mesh
};

/// How many nodes, and how far they may move.
struct QuadraticOptions
{
  int NodesPerHex = 20; ///< or 27
  /// A node that would move farther stays in the middle: fraction of the edge (of the shortest
  /// diagonal of a quad).
  double LargestMove = 0.25;
};

/// How many nodes reached the surface.
struct QuadraticReport
{
  Index BoundaryNodes = 0;    ///< added on the boundary
  Index OnSurface = 0;        ///< of these, how many are on the surface or their curve
  Index Shortened = 0;        ///< moved only part of the way, or not, to keep hexes valid
  Index TooFar = 0;           ///< LargestMove
  double SmallestRatio = 1.0; ///< smallest to largest determinant, the worst curved hex; proven
};

/// Result of MakeQuadratic().
struct QuadraticMesh
{
  std::vector<Vec3> Points; ///< those of the linear mesh, then the added ones
  int NodesPerHex = 20;
  std::vector<Index> HexNodes; ///< in the order of SolverMesh
  /// Of the added points. Id: curve; patch where MeshFeatures knows it, else -1.
  FeatureLabels Added;
  QuadraticReport Report;
};

/// Adds a node in the middle of each edge, with 27 nodes also of each face and hex. Those on the
/// boundary move to the closest point of the surface, those on an edge of a feature curve to the
/// closest point of this curve. A hex whose Jacobian isn't proven positive everywhere, or whose
/// ratio of smallest to largest determinant falls below a fifth of that of the linear hex, then
/// takes its nodes back, by halves and in the end wholly: straight hexes are as valid as the linear
/// ones. With 27 nodes the other nodes of a curved hex follow, as the 20-node hex has them.
///
/// Deterministic. Cost: 5 microseconds for the proof of a curved hex, and closest points.
/// @return InvalidOption, InvalidMesh (a linear hex that isn't proven valid), IndexOutOfRange,
/// Aborted, TimeLimit. @a result is empty then.
Status MakeQuadratic(const HexMesh& mesh, const QuadraticTargets& targets,
  const QuadraticOptions& options, Monitor& monitor, QuadraticMesh& result);
} // namespace featurehex

#endif

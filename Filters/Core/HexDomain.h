// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Which hexes of a mesh lie in the solid, with an interface that is a manifold, and whether that
/// interface has the topology of the surface.

#ifndef featurehex_HexDomain_h
#define featurehex_HexDomain_h

#include "BlockOctree.h"
#include "InterfaceRepair.h"
#include "Monitor.h"
#include "ShellTopology.h"
#include "TriangleSearch.h"
#include "Types.h"
#include "WindingNumber.h"

#include <string>

namespace featurehex
{
/// How hexes are labelled and the labels are repaired.
struct DomainOptions
{
  /// A hex belongs to the solid when its centre is inside, or outside by less than this many local
  /// cell sizes where a ball of diameter BiasGap fits outside. Small positive values fit better;
  /// negative ones lose thin parts.
  double LabelBias = 0.0;
  double BiasGap = 2.0; ///< local cell sizes

  double TargetEdgeLength = 0.0; ///< model units: cells of level 0; 0: the largest near the surface
  int MaximumLevel = 4;          ///< refinement points never ask for more

  /// Surface farther from the interface than this is lost; local cells.
  double MissingDistance = 1.0;
  double ThinLimit = 1.5;       ///< thickness or gap that explains wrong topology; local cells
  double Slack = 0.0;           ///< model units, as in ClearanceOptions

  Index MaximumFlips = 20000; ///< bound of the repair
};

/// The labels of all hexes, and how they compare with the surface.
struct HexDomain
{
  std::vector<int> Region; ///< per hex: 0 outside, 1.. body, in the order of their first hexes
  int NumberOfRegions = 0;

  Index InsideHexes = 0;
  Index LonelyFlips = 0; ///< hexes that disagreed with 5 of their 6 neighbours
  Index RepairFlips = 0; ///< hexes flipped to make the interface a manifold
  Index IslandFlips = 0; ///< hexes flipped to join or drop pieces that the cells tore off
  Index HandleFlips = 0; ///< hexes flipped to close or cut handles that the surface doesn't have
  Index WindingNumbers = 0; ///< how many were needed

  Shells SurfaceShells;
  Shells InterfaceShells;
  std::vector<InterfaceQuad> Interface;
  ShellComparison Topology; ///< Topology.Same(): shells one to one, same Euler characteristics

  std::vector<RefinementPoint> TopologyPoints; ///< where to refine to get the topology right
  std::vector<RefinementPoint> MissingPoints;  ///< where the surface has no hexes near it
};

/// Label, repair, compare with the surface. @a mesh must reach beyond the surface on all sides.
///
/// Hexes get the sign of the distance of their centres; two face neighbours whose distances add up
/// to more than the distance of their centres lie on the same side, so that one winding number
/// serves each group of hexes (few are alone). Fails with InvalidMesh when the mesh ends inside
/// the solid, with Topology when the interface could not be made a manifold. Different topology is
/// no failure: see Topology and the refinement points.
Status ComputeHexDomain(const HexMesh& mesh, const SurfaceMesh& surface,
  const TriangleSearch& search, const WindingNumber& winding, const DomainOptions& options,
  Monitor& monitor, HexDomain& domain);
}

#endif

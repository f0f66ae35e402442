// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Corners much nearer to each other than the edges of the interface are long: vertices for all of
/// them at once.

#ifndef featurehex_ClusterPlacement_h
#define featurehex_ClusterPlacement_h

#include "CurveRouter.h"

#include <set>

namespace featurehex
{
/// Tries all arrangements of a few corners where those that a short curve connects are neighbours
/// (or two edges apart, where short curves form a loop), and keeps the one whose curves leave their
/// corners best. Where the corners are in such a cluster says little: their distances are below
/// what the interface resolves. The cyclic order of their curves decides.
class ClusterPlacement
{
public:
  /// Keeps references. @a cornerVertices: those @a router knows; written.
  ClusterPlacement(const std::vector<Vec3>& points, const QuadGraph& graph,
    const FeatureGeometry& geometry, const CurveRouter& router, std::vector<Index>& cornerVertices);

  /// Corner of a cluster with the most neighbours. @a neighbors: of each corner, along short
  /// curves.
  static Index RootOf(
    const std::vector<Index>& cluster, const std::vector<std::vector<Index>>& neighbors);

  /// Gives the corners that are connected with @a root vertices that are not in @a used, and adds
  /// them; leaves all as it was when none fit. @a starts: vertices for the root.
  void Place(Index root, const std::vector<Index>& starts,
    const std::vector<std::vector<Index>>& neighbors, std::set<Index>& used);

private:
  void Extend(std::size_t place, double cost);
  double Fit() const;
  bool Near(Index a, Index b) const;

  const std::vector<Vec3>& Points;
  const QuadGraph& Graph;
  const FeatureGeometry& Geometry;
  const CurveRouter& Router;
  std::vector<Index>& CornerVertices;

  // Of the cluster in work.
  std::vector<Index> Corners; ///< in the order in which they are placed
  std::vector<Index> Parents; ///< corner placed before that a short curve leads to
  const std::vector<std::vector<Index>>* Neighbors = nullptr;
  const std::vector<Index>* Starts = nullptr;
  std::set<Index>* Used = nullptr;
  std::vector<Index> Best;
  double Least = 1e300;
};
} // namespace featurehex

#endif

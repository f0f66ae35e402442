// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Traces the curves of a surface as paths on the edges of an interface, corner to corner.

#ifndef featurehex_CurveRouter_h
#define featurehex_CurveRouter_h

#include "FeatureGeometry.h"
#include "HexFeatures.h"
#include "QuadGraph.h"

namespace featurehex
{
/// Routes curves one after the other; each path is a wall for the later ones. A curve that finds no
/// way takes it from others, which are routed again.
class CurveRouter
{
public:
  /// Keeps references. @a cornerVertices: interface vertex of each corner, -1: none. @a reach: in
  /// local edge lengths.
  CurveRouter(const std::vector<Vec3>& points, const QuadGraph& graph,
    const FeatureGeometry& geometry, const std::vector<Index>& cornerVertices, double reach);

  /// Returns the curves that found no way, ascending.
  std::vector<Index> RouteAll(int maximumAttempts);

  /// Darts of each curve's path, in the direction of the curve; empty: none.
  const std::vector<std::vector<Index>>& Paths() const { return this->PathOfCurve; }
  Index Reroutes() const { return this->NumberOfReroutes; }
  /// Where the curve was in the way of others, or others in its way.
  const std::vector<Vec3>& ContestedPlaces(Index curve) const { return this->Contested[curve]; }

  /// Mean length of the edges at a vertex.
  double SizeAt(Index vertex) const { return this->Sizes[vertex]; }

  /// The curve is so much shorter than the edges at the vertex that it can only be one of them.
  bool IsShort(Index curve, Index vertex) const;

  /// Darts for the spokes of a corner's fan that keep their cyclic order and fit their directions
  /// and angles best, if the corner were at @a vertex; empty when the vertex has too few edges.
  /// A short curve has the direction to the vertex of its other corner, once there is one.
  /// @a cost: how well they fit, 0 perfect.
  std::vector<Index> ArrangeSpokes(Index corner, Index vertex, double& cost) const;

private:
  struct Leg;

  bool Route(Index curve, bool relaxed, std::vector<Index>& path);
  bool RouteFrom(double shift, Index curve, bool relaxed, std::vector<Index>& path);
  bool RouteLeg(const Leg& leg, bool relaxed, std::vector<Index>& darts);
  void SmoothJunction(Index curve, double arc, std::vector<Index>& path, bool relaxed, bool loop);
  Index FreeVertexNear(const Vec3& p) const;
  double SpokeCost(Index corner, int spoke, Index dart, bool relaxed) const;
  bool HasRoom(Index corner, int spoke, Index dart) const;
  int SpokeOf(Index corner, Index curve, bool atEnd) const;
  double TurnCost(Index incoming, Index outgoing) const;
  bool Passable(Index vertex, Index curve, bool relaxed) const;
  std::vector<Index> MakeWay(Index curve, const std::vector<Index>& path);
  void Claim(Index curve, const std::vector<Index>& path);
  void Release(Index curve);

  const std::vector<Vec3>& Points;
  const QuadGraph& Graph;
  const FeatureGeometry& Geometry;
  const std::vector<Index>& CornerVertices;
  double Reach;
  double CurrentReach;
  std::vector<double> Sizes;
  std::vector<Index> Owner;      ///< of each vertex: curve, -1 free, -2 a corner
  /// Curve that would like to leave its corner through the vertex; -1: none.
  std::vector<Index> ReservedBy;
  std::vector<double> History;   ///< how often a vertex was contested
  std::vector<std::vector<Index>> Preferred; ///< dart of each spoke of each corner
  std::vector<std::vector<Index>> Taken;     ///< dart of each routed spoke of each corner, -1
  std::vector<std::vector<Index>> PathOfCurve;
  std::vector<std::vector<Vec3>> Contested;
  std::vector<double> Cost;      ///< of each dart in the current search
  std::vector<Index> Previous;
  std::vector<int> Stamp;
  std::vector<char> OwnPath;     ///< vertices of the other legs of the curve in work
  int Search = 0;
  Index NumberOfReroutes = 0;
};
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Branch and bound for the distance of one element (triangle or bilinear patch) to a set of
/// triangles. A detail of CertifiedDistance.

#ifndef featurehex_DistancePieces_h
#define featurehex_DistancePieces_h

#include "TriangleSearch.h"
#include "Types.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace featurehex
{
/// The surface that distances are measured to.
struct DistanceTarget
{
  const TriangleSearch* Search = nullptr;
  /// The true surface is within this distance of each triangle; empty: 0.
  std::vector<double> Slack;
  double LargestSlack = 0.0;

  double SlackOf(Index triangle) const { return this->Slack.empty() ? 0.0 : this->Slack[triangle]; }
};

/// A piece of an element: a triangle (3 corners), or the bilinear patch of 4 corners in cyclic
/// order.
struct DistancePiece
{
  int Count = 0;
  Vec3 Corner[4];
  Index Near[4] = { -1, -1, -1, -1 }; ///< a triangle near each corner
  double Distance[4] = { 1e300, 1e300, 1e300, 1e300 }; ///< of the corner to that triangle
  bool Exact[4] = { false, false, false, false }; ///< no triangle is nearer
  double Slack = 0.0;   ///< the true element is within this distance of the piece
  double Bound = 1e300; ///< no point of the true element's part is farther from the true surface
  Index Best = -1;      ///< the triangle nearest all corners
  int Depth = 0;
};

/// When to stop.
struct DistanceGoal
{
  bool Decide = false;    ///< stop at the first point beyond GiveUp
  double Accept = 0.0;    ///< pieces with a bound up to this need no more work
  double GiveUp = 0.0;    ///< a point farther than this makes the decision: no
  /// So far may a bound exceed the greatest distance found (value, not decision).
  double Gap = 0.0;
  double Flat = 0.0;      ///< patches flatter than this may be treated as two triangles
  double Tiny = 0.0;      ///< pieces of this radius aren't cut any more
  std::int64_t Budget = 0; ///< pieces
};

/// What is known about an element.
struct ElementDistance
{
  double Lower = 0.0;
  double Upper = 1e300;
  Vec3 Where = Vec3::Zero();    ///< a point with distance Lower
  Vec3 Unproven = Vec3::Zero(); ///< a place of the part that keeps Upper high
  std::int64_t Pieces = 0;

  /// Joins what another search found about the same element.
  void Merge(const ElementDistance& other)
  {
    if (other.Lower > this->Lower)
    {
      this->Lower = other.Lower;
      this->Where = other.Where;
    }
    this->Upper = std::min(this->Upper, other.Upper);
    this->Pieces += other.Pieces;
  }

  /// Takes note of a point and its exact distance to the triangles.
  void Found(const Vec3& p, double distance, const DistanceTarget& target, double slack = 0.0)
  {
    const double d = distance - target.LargestSlack - slack;
    if (d > this->Lower)
    {
      this->Lower = d;
      this->Where = p;
    }
  }
};

/// Bound of the distance, both ways, between a bilinear patch and triangles on its corners: two, or
/// four round its middle. With the same parameters they differ by at most @a share of its twist
/// (1/4 for two, 1/16 for four). And where the patch seen along the normal of its diagonals is
/// convex, both are graphs over the same region whose heights lie within |n . twist| / 4 of its
/// middle: a flat patch may be as skew as it likes.
double TriangleError(const Vec3* corners, double share);

/// Bounds the distance of the true element of @a root until @a goal is met; @a result holds what
/// samples found. Deterministic.
void BoundElement(const DistanceTarget& target, const DistancePiece& root, const DistanceGoal& goal,
  ElementDistance& result);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Half-edges of a closed quad surface: who is next to whom, in which order.

#ifndef featurehex_QuadGraph_h
#define featurehex_QuadGraph_h

#include "Types.h"

namespace featurehex
{
/// Dart 4 q + k is side k of quad q, from its k-th vertex to the next; the quad is on its left
/// (seen from outside). Vertices have the ids of the quads that were given.
class QuadGraph
{
public:
  /// Precondition: a closed manifold, consistently oriented.
  QuadGraph(const std::vector<Quad>& quads, std::size_t numberOfPoints);

  const std::vector<Quad>& Quads() const { return this->Faces; }
  Index NumberOfDarts() const { return static_cast<Index>(4 * this->Faces.size()); }

  Index Tail(Index dart) const { return this->Faces[dart / 4][dart & 3]; }
  Index Head(Index dart) const { return this->Faces[dart / 4][(dart + 1) & 3]; }
  Index Opposite(Index dart) const { return this->Opposites[dart]; }

  /// Some dart that leaves the vertex; -1 when the surface doesn't use it.
  Index Leaving(Index vertex) const { return this->FirstDart[vertex]; }
  /// The next dart that leaves the same vertex, counter-clockwise seen from outside.
  Index Rotate(Index dart) const { return this->Opposites[(dart & ~3) | ((dart + 3) & 3)]; }
  int Valence(Index vertex) const { return this->Valences[vertex]; }
  /// The dart from @a u to @a v; -1: no edge.
  Index Find(Index u, Index v) const;

  /// Quads on the left of the turn from @a incoming to @a outgoing, which leaves where that
  /// arrives.
  int QuadsOnLeft(Index incoming, Index outgoing) const;
  /// Darts counter-clockwise from @a first to @a second, which leave the same vertex.
  int Steps(Index first, Index second) const;

private:
  std::vector<Quad> Faces;
  std::vector<Index> Opposites;
  std::vector<Index> FirstDart;
  std::vector<int> Valences;
};
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
#include "QuadGraph.h"

#include <algorithm>

namespace featurehex
{
QuadGraph::QuadGraph(const std::vector<Quad>& quads, std::size_t numberOfPoints)
  : Faces(quads)
  , Opposites(4 * quads.size(), -1)
  , FirstDart(numberOfPoints, -1)
  , Valences(numberOfPoints, 0)
{
  struct Side
  {
    Index Low, High, Dart;
  };
  std::vector<Side> sides;
  sides.reserve(this->Opposites.size());
  for (Index d = 0; d < this->NumberOfDarts(); ++d)
  {
    const Index tail = this->Tail(d);
    sides.push_back({ std::min(tail, this->Head(d)), std::max(tail, this->Head(d)), d });
    if (this->FirstDart[tail] < 0)
    {
      this->FirstDart[tail] = d;
    }
    ++this->Valences[tail];
  }
  std::sort(sides.begin(), sides.end(),
    [](const Side& a, const Side& b)
    {
      return std::array<Index, 3>{ a.Low, a.High, a.Dart } <
             std::array<Index, 3>{ b.Low, b.High, b.Dart };
    });
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
  {
    this->Opposites[sides[i].Dart] = sides[i + 1].Dart;
    this->Opposites[sides[i + 1].Dart] = sides[i].Dart;
  }
}

Index QuadGraph::Find(Index u, Index v) const
{
  Index dart = this->FirstDart[u];
  for (int i = 0; i < this->Valences[u]; ++i, dart = this->Rotate(dart))
  {
    if (this->Head(dart) == v)
    {
      return dart;
    }
  }
  return -1;
}

int QuadGraph::QuadsOnLeft(Index incoming, Index outgoing) const
{
  return this->Steps(outgoing, this->Opposites[incoming]);
}

int QuadGraph::Steps(Index first, Index second) const
{
  int steps = 0;
  const int valence = this->Valences[this->Tail(first)];
  for (Index dart = first; dart != second && steps < valence; dart = this->Rotate(dart))
  {
    ++steps;
  }
  return steps;
}
} // namespace featurehex

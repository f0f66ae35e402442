// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Closest quad of a boundary.

#ifndef featurehex_QuadSearch_h
#define featurehex_QuadSearch_h

#include "TriangleSearch.h"

namespace featurehex
{
/// Quads of a hex mesh as they are when this is built, each measured as four triangles round its
/// centre. Queries are const and may run in parallel.
class QuadSearch
{
public:
  QuadSearch(const HexMesh& mesh, const std::vector<Quad>& quads);

  /// Id of the quad closest to @a p.
  Index Closest(const Vec3& p) const { return this->Fans.Closest(p).Triangle / 4; }

  /// The same, faster: @a hint comes from a call for a point nearby, also of another QuadSearch of
  /// quads that have moved a little since; -1: none. It is updated.
  Index Closest(const Vec3& p, Index& hint) const
  {
    hint = this->Fans.Closest(p, hint).Triangle;
    return hint / 4;
  }

private:
  TriangleSearch Fans;
};
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Places that a stage complains about as refinement points. Private to this module.

#ifndef featurehex_RefinementConversion_h
#define featurehex_RefinementConversion_h

#include "BlockOctree.h"

#include <string>
#include <utility>
#include <vector>

namespace featurehex
{
/// Boundary or interface quads of a hex mesh with the levels of the cells behind them.
struct RefinableQuads
{
  const std::vector<Vec3>& Points;
  const std::vector<Quad>& Quads;
  const std::vector<Index>& Owners; ///< hex of each quad
  const std::vector<int>& Level;    ///< of each hex; empty: all 0
  double EdgeLength = 0.0;          ///< of level 0; 0: unknown, points are not thinned
};

/// Appends points one level finer than the quads next to @a places; not those above
/// @a maximumLevel.
void AppendPlaces(const RefinableQuads& quads, const std::vector<Vec3>& places, int maximumLevel,
  const std::string& reason, std::vector<std::pair<RefinementPoint, std::string>>& points);
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Union-find.

#ifndef featurehex_DisjointSets_h
#define featurehex_DisjointSets_h

#include "Types.h"

#include <algorithm>
#include <numeric>

namespace featurehex
{
/// Disjoint sets; the root of a set is its lowest member.
class DisjointSets
{
public:
  explicit DisjointSets(std::size_t count)
    : Parent(count)
  {
    std::iota(this->Parent.begin(), this->Parent.end(), 0);
  }

  Index Find(Index i)
  {
    while (this->Parent[i] != i)
    {
      this->Parent[i] = this->Parent[this->Parent[i]];
      i = this->Parent[i];
    }
    return i;
  }

  void Join(Index i, Index j)
  {
    i = this->Find(i);
    j = this->Find(j);
    this->Parent[std::max(i, j)] = std::min(i, j);
  }

private:
  std::vector<Index> Parent;
};
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Order in which vertices are visited by block coordinate descent, sequential and parallel alike.

#ifndef featurehex_VertexSchedule_h
#define featurehex_VertexSchedule_h

#include "HexAdjacency.h"
#include "Monitor.h"

#include <cstddef>
#include <functional>
#include <vector>

namespace featurehex
{
/// Gauss-Seidel sweeps that give the same bits for any number of threads.
///
/// Vertices are taken in blocks of consecutive ids (ids follow a space-filling order, so that a
/// block is a compact piece of the mesh). Blocks are coloured so that the vertices of two blocks of
/// one colour are more than `rings` hexes apart: what a visit writes is out of reach of all visits
/// that run beside it. The order is colour after colour, but no thread waits for a colour to end: a
/// block starts as soon as those of earlier colours within its reach are done, so that blocks with
/// much work don't hold up the others. Large blocks: with vertex colouring two threads were slower
/// than one (design 4).
class VertexSchedule
{
public:
  VertexSchedule() = default;

  /// @a rings: 1 when a visit reads the hexes round the vertex, 3 when it also moves ownership
  /// between quads next to those of the vertex (SurfaceEnvelope).
  VertexSchedule(const std::vector<Hex>& hexes, const IdLists& hexesOfVertex, int rings);

  /// visit(v) for every vertex, in an order that looks the same to all vertices within reach of
  /// each other. Returns the number of visits that returned true. @a monitor is asked at the start
  /// and ten times a second; when it says stop, the blocks that follow are left out.
  template <typename Visit>
  std::size_t Sweep(const Visit& visit, Monitor* monitor = nullptr) const
  {
    return this->VisitBlocks(
      [&visit](Index first, Index last) {
        std::size_t count = 0;
        for (Index v = first; v < last; ++v)
        {
          count += visit(v) ? 1 : 0;
        }
        return count;
      },
      monitor);
  }

  /// Vertices First to Last - 1.
  struct Block
  {
    Index First, Last;
  };

  /// The blocks of each colour, in the order of a sweep.
  std::vector<std::vector<Block>> BlocksByColor() const;

private:
  /// Visits the vertices [first, last); the number of visits that returned true.
  using BlockVisit = std::function<std::size_t(Index first, Index last)>;
  class Run;

  std::size_t VisitBlocks(const BlockVisit& visit, Monitor* monitor) const;

  std::vector<Block> Blocks;      ///< in the order of a sweep
  std::vector<Index> Colors;      ///< of each block
  std::vector<Index> Earlier;     ///< number of blocks before each one within its reach
  IdLists Later;                  ///< blocks after each one within its reach
};
}

#endif

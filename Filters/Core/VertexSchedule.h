// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Order in which vertices are visited by block coordinate descent, sequential and parallel alike.

#ifndef featurehex_VertexSchedule_h
#define featurehex_VertexSchedule_h

#include "HexAdjacency.h"
#include "Parallel.h"

namespace featurehex
{
/// Gauss-Seidel sweeps that give the same bits for any number of threads.
///
/// Vertices are taken in blocks of consecutive ids (ids follow a space-filling order, so that a
/// block is a compact piece of the mesh). Blocks are coloured so that the vertices of two blocks of
/// one colour are more than `rings` hexes apart: what a visit writes is out of reach of all visits
/// that run beside it. Few colours and large blocks: with vertex colouring two threads were slower
/// than one (design 4).
class VertexSchedule
{
public:
  VertexSchedule() = default;

  /// @a rings: 1 when a visit reads the hexes round the vertex, 3 when it also moves ownership
  /// between quads next to those of the vertex (SurfaceEnvelope).
  VertexSchedule(const std::vector<Hex>& hexes, const IdLists& hexesOfVertex, int rings);

  /// visit(v) for every vertex; colour after colour, the blocks of a colour in parallel. Returns
  /// the number of visits that returned true. @a monitor is asked before each colour; when it says
  /// stop, the colours that follow are left out.
  template <typename Visit>
  std::size_t Sweep(const Visit& visit, Monitor* monitor = nullptr) const
  {
    std::size_t total = 0;
    for (const std::vector<Block>& blocks : this->Colors)
    {
      if (monitor && !monitor->Ask())
      {
        break;
      }
      std::vector<std::size_t> counts(blocks.size(), 0);
      ParallelFor(blocks.size(), 1, [&](std::size_t i) {
        for (Index v = blocks[i].First; v < blocks[i].Last; ++v)
        {
          counts[i] += visit(v) ? 1 : 0;
        }
      });
      for (std::size_t count : counts)
      {
        total += count;
      }
    }
    return total;
  }

  /// Vertices First to Last - 1.
  struct Block
  {
    Index First, Last;
  };

  /// The blocks of each colour, in the order of a sweep.
  const std::vector<std::vector<Block>>& BlocksByColor() const { return this->Colors; }

private:
  std::vector<std::vector<Block>> Colors;
};
}

#endif

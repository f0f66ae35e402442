// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Parallel loops with vtkSMPTools. Results never depend on the number of threads: an iteration
/// writes only what belongs to it, and reductions are done afterwards in order.

#ifndef featurehex_Parallel_h
#define featurehex_Parallel_h

#include "Monitor.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <cstddef>

namespace featurehex
{
/// body(i) for i in [0, count), at least @a grain iterations a task.
template <typename Body>
void ParallelFor(std::size_t count, std::size_t grain, const Body& body)
{
  if (count <= grain)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      body(i);
    }
    return;
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(count), static_cast<vtkIdType>(grain),
    [&body](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        body(static_cast<std::size_t>(i));
      }
    });
}

/// The same in some 20 batches; @a monitor may be null, else it is asked before each. False: it
/// said stop, and the rest was left out.
template <typename Body>
bool ParallelFor(std::size_t count, std::size_t grain, Monitor* monitor, const Body& body)
{
  const std::size_t batch = std::max(grain, monitor ? (count + 19) / 20 : count);
  for (std::size_t first = 0; first < count; first += batch)
  {
    if (monitor && !monitor->Ask())
    {
      return false;
    }
    ParallelFor(std::min(batch, count - first), grain, [&](std::size_t i) { body(first + i); });
  }
  return true;
}
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Parallel loops with vtkSMPTools. Results never depend on the number of threads: an iteration
/// writes only what belongs to it, and reductions are done afterwards in order.

#ifndef featurehex_Parallel_h
#define featurehex_Parallel_h

#include <vtkSMPTools.h>

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
}

#endif

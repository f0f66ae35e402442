// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Sets up vtkSMPTools.

#ifndef featurehex_Threads_h
#define featurehex_Threads_h

#include <vtkSMPTools.h>

namespace featurehex
{
/// STDThread, because it is the one backend that all builds of VTK have; @a threads 0: all cores.
inline void UseThreads(int threads)
{
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(threads);
}
} // namespace featurehex

#endif

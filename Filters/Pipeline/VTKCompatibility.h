// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What differs between VTK 9.1 and the VTK of ParaView 5.11. Private to this module.

#ifndef featurehex_VTKCompatibility_h
#define featurehex_VTKCompatibility_h

#include "vtkAlgorithm.h"
#include "vtkVersionMacros.h"

namespace featurehex
{
/// True when the user has asked @a algorithm to stop.
inline bool AbortRequested(vtkAlgorithm* algorithm)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 2, 20220823)
  return algorithm->CheckAbort();
#else
  return algorithm->GetAbortExecute() != 0;
#endif
}
} // namespace featurehex

#endif

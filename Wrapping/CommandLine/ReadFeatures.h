// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The sharp features that the command line asks for.

#ifndef featurehex_ReadFeatures_h
#define featurehex_ReadFeatures_h

#include "Arguments.h"
#include "Status.h"

class vtkPolyData;

namespace featurehex
{
struct RunLog;

/// The feature graph of @a surface as @a arguments ask for it.
Status ReadFeatures(
  const FeatureArguments& arguments, vtkPolyData* surface, RunLog& log, vtkPolyData* graph);
} // namespace featurehex

#endif

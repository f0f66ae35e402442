// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Runs a VTK algorithm and turns what it says into a Status.

#ifndef featurehex_RunAlgorithm_h
#define featurehex_RunAlgorithm_h

#include "Console.h"
#include "Status.h"

#include <string>
#include <utility>
#include <vector>

class vtkAlgorithm;

namespace featurehex
{
/// What algorithms say while they run.
struct RunLog
{
  ProgressBar Bar;
  std::vector<std::string> Warnings;
  std::vector<std::pair<std::string, double>> Phases; ///< wall time in seconds of each, in order
};

/// Updates @a algorithm, a writer too. Its progress and warnings go to @a log, nothing to VTK's
/// output window. Ctrl-C aborts it.
/// @return Ok, or its first error with the code of its error code; @a otherwise where it has none.
Status RunAlgorithm(vtkAlgorithm* algorithm, StatusCode otherwise, RunLog& log);

/// From now on VTK writes nothing to standard error by itself.
void SilenceVTK();
} // namespace featurehex

#endif

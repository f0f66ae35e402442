// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exit codes of the command line. They are API: scripts depend on them.

#ifndef featurehex_ExitCode_h
#define featurehex_ExitCode_h

#include "Status.h"

namespace featurehex
{
enum class ExitCode
{
  Success = 0,
  Failed = 1, ///< no valid mesh could be made, or the checked mesh breaks a promise
  BadArguments = 2,
  Unreadable = 3, ///< input file missing, damaged, or of no known format
  Rejected = 4,   ///< the surface doesn't bound a body
  TimeLimit = 5,
  CellLimit = 6,
  Aborted = 7,    ///< Ctrl-C, or terminated
  Unwritable = 8, ///< output or report
  Internal = 9    ///< out of memory, or an error of the program itself
};

ExitCode ExitCodeOf(StatusCode code);

/// For the end of --help.
const char* ExitCodeHelp();
} // namespace featurehex

#endif

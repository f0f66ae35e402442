// SPDX-License-Identifier: BSD-3-Clause
#include "ExitCode.h"

namespace featurehex
{
ExitCode ExitCodeOf(StatusCode code)
{
  switch (code)
  {
    case StatusCode::Ok:
      return ExitCode::Success;
    case StatusCode::Aborted:
      return ExitCode::Aborted;
    case StatusCode::TimeLimit:
      return ExitCode::TimeLimit;
    case StatusCode::CellLimit:
      return ExitCode::CellLimit;
    case StatusCode::InvalidOption:
      return ExitCode::BadArguments;
    case StatusCode::UnreadableFile:
      return ExitCode::Unreadable;
    case StatusCode::UnwritableFile:
      return ExitCode::Unwritable;
    case StatusCode::EmptySurface:
    case StatusCode::NonFinite:
    case StatusCode::IndexOutOfRange:
    case StatusCode::Degenerate:
    case StatusCode::OpenBoundary:
    case StatusCode::NonManifold:
    case StatusCode::NotOrientable:
    case StatusCode::SelfIntersection:
      return ExitCode::Rejected;
    case StatusCode::InvalidMesh:
    case StatusCode::Topology:
    case StatusCode::Untangling:
    case StatusCode::Distance:
    case StatusCode::Features:
    case StatusCode::Validation:
      return ExitCode::Failed;
    case StatusCode::OutOfMemory:
    case StatusCode::Unexpected:
      return ExitCode::Internal;
  }
  return ExitCode::Internal;
}

const char* ExitCodeHelp()
{
  return "Exit codes:\n"
         "  0  done\n"
         "  1  no valid mesh could be made, or the checked mesh breaks a promise\n"
         "  2  bad arguments\n"
         "  3  input file missing, damaged, or of no known format\n"
         "  4  input surface rejected: empty, open, non-manifold, self-intersecting, ...\n"
         "  5  time limit reached\n"
         "  6  limit of cells reached\n"
         "  7  aborted (Ctrl-C)\n"
         "  8  output or report can't be written\n"
         "  9  out of memory, or an error of the program\n"
         "Other than 0: one line on standard error says why, and there is no output.";
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How core algorithms report failure: a code for programs, a message for people, the places.

#ifndef featurehex_Status_h
#define featurehex_Status_h

#include "Types.h"

#include <string>
#include <utility>
#include <vector>

namespace featurehex
{
/// What went wrong. Stable: the command line prints the name of the code with the message.
enum class StatusCode
{
  Ok,
  Aborted,           ///< the user cancelled
  TimeLimit,         ///< TimeLimit reached
  CellLimit,         ///< MaximumNumberOfCells would be exceeded
  InvalidOption,     ///< an option is out of its range
  UnreadableFile,    ///< file missing, truncated or not of its format
  UnwritableFile,    ///< file could not be written
  EmptySurface,      ///< no points or no faces
  NonFinite,         ///< NaN or infinite coordinate
  IndexOutOfRange,   ///< a face refers to a point that does not exist
  Degenerate,        ///< zero volume, or degenerate triangles that can't be removed
  OpenBoundary,      ///< edges with one triangle
  NonManifold,       ///< edges with more than two triangles, vertices with several umbrellas
  NotOrientable,     ///< no consistent orientation exists
  SelfIntersection,  ///< triangles that cross or touch
  InvalidMesh,       ///< input hex mesh breaks the stage's precondition
  Topology,          ///< components or genus of the input not reached
  Untangling,        ///< inverted hexes remain
  Distance,          ///< the boundary leaves the tolerance
  Validation,        ///< the finished mesh broke a promise
  OutOfMemory,       ///< an allocation failed
  Features,          ///< a corner, curve or patch of the surface could not be mapped to the mesh
  Unexpected         ///< a stage broke its promise, a library threw: a defect of the program
};

/// Result of a core algorithm. Message: what is wrong, where, how much, what to do.
struct [[nodiscard]] Status
{
  StatusCode Code = StatusCode::Ok;
  std::string Message;
  std::vector<Vec3> Where;

  Status() = default;
  Status(StatusCode code, std::string message, std::vector<Vec3> where = {})
    : Code(code)
    , Message(std::move(message))
    , Where(std::move(where))
  {
  }
  bool Ok() const { return this->Code == StatusCode::Ok; }
};

/// Name of a code as it appears in reports, e.g. "OpenBoundary".
inline const char* StatusCodeName(StatusCode code)
{
  constexpr const char* names[] = { "Ok", "Aborted", "TimeLimit", "CellLimit", "InvalidOption",
    "UnreadableFile", "UnwritableFile", "EmptySurface", "NonFinite", "IndexOutOfRange",
    "Degenerate", "OpenBoundary", "NonManifold", "NotOrientable", "SelfIntersection",
    "InvalidMesh", "Topology", "Untangling", "Distance", "Validation", "OutOfMemory",
    "Features", "Unexpected" };
  return names[static_cast<int>(code)];
}
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Every stage checks its own output: an error of the program is found in the stage that made it,
/// and no stage hands on what breaks the next one.

#ifndef featurehex_StageCheck_h
#define featurehex_StageCheck_h

#include "BlockOctree.h"
#include "Status.h"
#include "Types.h"

#include <cstddef>
#include <string>
#include <vector>

namespace featurehex
{
/// What a stage promises about its cells; each includes those before it.
enum class StagePromise
{
  Ids,             ///< points that the cells refer to exist
  Finite,          ///< coordinates are finite
  Conforming,      ///< hexes: HexTopology::Conforming(); triangles: closed, manifold, oriented
  PositiveCorners, ///< scaled Jacobian > 0 at each corner
  Certified        ///< Jacobian proven positive in the whole hex
};

/// How much of a stage's output is checked.
enum class CheckDepth
{
  Cheap, ///< ids, coordinates, lengths of arrays: one pass, no memory
  Full   ///< all that is promised
};

/// Full in builds without NDEBUG and where the environment variable FEATUREHEX_CHECK_STAGES is set,
/// as in all tests; else Cheap.
CheckDepth DefaultCheckDepth();

/// What a stage hands on.
struct StageOutput
{
  /// An array and the length it has to have.
  struct Array
  {
    const char* Name;
    std::size_t Length;
    std::size_t Expected;
  };
  std::string Stage; ///< the message begins with it
  StagePromise Promise;
  std::vector<Array> Arrays = {};
};

/// The first broken promise: stage, id and coordinates. Code Unexpected, a defect of the program;
/// Validation for a hex that isn't certified, which finer cells may cure.
Status CheckStageOutput(
  const StageOutput& output, const HexMesh& mesh, CheckDepth depth = DefaultCheckDepth());
Status CheckStageOutput(
  const StageOutput& output, const SurfaceMesh& surface, CheckDepth depth = DefaultCheckDepth());

/// Finite frame and leaves; Full: leaves tile the root grid and are balanced.
Status CheckStageOutput(
  const StageOutput& output, const BlockOctree& octree, CheckDepth depth = DefaultCheckDepth());
} // namespace featurehex

#endif

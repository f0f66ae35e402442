// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where the large test data is, which is not part of the sources.

#ifndef featurehex_Testing_SharedData_h
#define featurehex_Testing_SharedData_h

#include <cstdlib>
#include <filesystem>

namespace featurehex
{
/// $FEATUREHEX_SHARED/data, by default in the folder "shared" beside the sources; it may not exist.
inline std::filesystem::path SharedData()
{
  const char* folder = std::getenv("FEATUREHEX_SHARED");
  const std::filesystem::path beside =
    std::filesystem::path(FEATUREHEX_SOURCE_DIR).parent_path() / "shared";
  return (folder ? std::filesystem::path(folder) : beside) / "data";
}
}

#endif

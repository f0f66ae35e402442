// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where the large test data is, which is not part of the sources.

#ifndef featurehex_Testing_SharedData_h
#define featurehex_Testing_SharedData_h

#include "FeatureGraphFile.h"
#include "SurfaceCheck.h"
#include "SurfaceFeatures.h"
#include "SurfaceReader.h"

#include <cstdlib>
#include <filesystem>
#include <string>

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

/// A CAD part of the shared data, checked, with the features that its file gives it.
inline Status ReadPart(const std::string& name, SurfaceMesh& surface, FeatureGraph& features)
{
  const std::filesystem::path data = SharedData();
  Status status = ReadSurface((data / "surfaces/cad" / (name + ".obj")).string(), surface);
  SurfaceCheckReport check;
  if (status.Ok())
  {
    Monitor monitor;
    status = CheckSurface(surface, SurfaceCheckOptions(), check, monitor);
  }
  if (status.Ok())
  {
    status = ReadFeatureGraph((data / "features" / (name + ".fgraph")).string(), -1, features);
  }
  return status.Ok() ? MapFeatures(check.Points, features.Edges, features.Corners) : status;
}
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Any bytes as OBJ, STL, PLY and OFF: what is read keeps the promises of ReadSurface().

#include "FuzzChecks.h"
#include "SurfaceReader.h"

using namespace featurehex;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  const std::string_view bytes = BytesOf(data, size);
  for (const SurfaceFormat format : { DetectSurfaceFormat("fuzz", bytes), SurfaceFormat::Obj,
         SurfaceFormat::Stl, SurfaceFormat::Ply, SurfaceFormat::Off })
  {
    SurfaceMesh surface;
    const Status status = ParseSurface(bytes, format, "fuzz", surface);
    CheckStatus(status);
    if (!status.Ok())
    {
      Require(surface.Points.empty() && surface.Triangles.empty(), "empty after an error");
      continue;
    }
    Require(!surface.Triangles.empty(), "at least one triangle");
    CheckIds(surface.Triangles, surface.Points.size());
    // At most 10 times the file size: nothing is allocated that the file has no bytes for.
    Require(surface.Points.size() <= size && surface.Triangles.size() <= size,
      "no more than the file has bytes for");
  }
  return 0;
}

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Any bytes as a Medit file: what is read keeps the promises of ReadMedit().

#include "FuzzChecks.h"
#include "MeditFile.h"

using namespace featurehex;

namespace
{
template <typename Element, typename Reference>
void CheckReferences(const std::vector<Element>& elements, const std::vector<Reference>& references)
{
  Require(references.empty() || references.size() == elements.size(), "one reference an element");
}
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  MeditMesh mesh;
  const Status status = ParseMedit(BytesOf(data, size), "fuzz.mesh", mesh);
  CheckStatus(status);
  if (!status.Ok())
  {
    Require(mesh.Points.empty() && mesh.Hexes.empty() && mesh.Quads.empty() && mesh.Edges.empty() &&
        mesh.Corners.empty() && mesh.Ridges.empty(),
      "empty after an error");
    return 0;
  }
  Require(!mesh.Points.empty(), "points");
  CheckIds(mesh.Hexes, mesh.Points.size());
  CheckIds(mesh.Quads, mesh.Points.size());
  CheckIds(mesh.Edges, mesh.Points.size());
  CheckId(mesh.Corners, mesh.Points.size());
  CheckId(mesh.Ridges, mesh.Edges.size());
  CheckReferences(mesh.Points, mesh.PointReferences);
  CheckReferences(mesh.Hexes, mesh.HexReferences);
  CheckReferences(mesh.Quads, mesh.QuadReferences);
  CheckReferences(mesh.Edges, mesh.EdgeReferences);
  return 0;
}

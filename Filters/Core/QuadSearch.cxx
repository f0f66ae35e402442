// SPDX-License-Identifier: BSD-3-Clause
#include "QuadSearch.h"

namespace featurehex
{
QuadSearch::QuadSearch(const HexMesh& mesh, const std::vector<Quad>& quads)
{
  // Only the boundary's points: the search scales to the box of its points.
  std::vector<Vec3> points;
  std::vector<Triangle> triangles;
  for (const Quad& quad : quads)
  {
    const Index first = static_cast<Index>(points.size());
    Vec3 center = Vec3::Zero();
    for (Index v : quad)
    {
      points.push_back(mesh.Points[v]);
      center += 0.25 * mesh.Points[v];
    }
    points.push_back(center);
    for (int k = 0; k < 4; ++k)
    {
      triangles.push_back({ first + k, first + (k + 1) % 4, first + 4 });
    }
  }
  this->Fans = TriangleSearch(std::move(points), std::move(triangles), SearchBuild::Quick);
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "QuadSearch.h"

#include "HexGrids.h"
#include "HexStars.h"

#include <gtest/gtest.h>

using namespace featurehex;

TEST(QuadSearch, FindsTheQuadUnderAPoint)
{
  const HexMesh mesh = hexgrids::Grid(3);
  const HexStars stars(mesh);
  const QuadSearch search(mesh, stars.Quads);
  for (Index q = 0; q < static_cast<Index>(stars.Quads.size()); ++q)
  {
    Vec3 center = Vec3::Zero();
    for (Index v : stars.Quads[q])
    {
      center += 0.25 * mesh.Points[v];
    }
    EXPECT_EQ(search.Closest(center), q);
  }
}

TEST(HexStars, RingsGrowByHexes)
{
  const HexMesh mesh = hexgrids::Grid(5);
  std::vector<char> marked(mesh.Points.size(), 0);
  marked[0] = 1; // a corner
  MarkRings(mesh, 2, marked);
  for (std::size_t v = 0; v < marked.size(); ++v)
  {
    EXPECT_EQ(marked[v] != 0, mesh.Points[v].maxCoeff() < 2.5) << v;
  }
}

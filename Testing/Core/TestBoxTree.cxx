// SPDX-License-Identifier: BSD-3-Clause
#include "BoxTree.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace featurehex;

TEST(BoxTree, FindsWhatBruteForceFinds)
{
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> place(0, 1), side(-0.1, 0.1);
  for (Index count : { 1, 2, 3, 4, 5, 9, 100, 333 })
  {
    std::vector<Vec3> points;
    std::vector<Triangle> triangles;
    std::vector<Box> boxes;
    for (Index t = 0; t < count; ++t)
    {
      const Vec3 center(place(generator), place(generator), place(generator));
      for (int k = 0; k < 3; ++k)
      {
        points.push_back(center + Vec3(side(generator), side(generator), side(generator)));
      }
      triangles.push_back({ 3 * t, 3 * t + 1, 3 * t + 2 });
      boxes.push_back(TriangleBox(points, triangles.back()));
    }
    const BoxTree tree(points, triangles);
    std::multiset<std::pair<Index, Index>> found, expected;
    for (std::size_t leaf = 0; leaf < tree.NumberOfLeaves(); ++leaf)
    {
      tree.VisitPairs(leaf,
        [&](Index a, Index b)
        {
          found.insert({ std::min(a, b), std::max(a, b) });
          return true;
        });
    }
    for (Index a = 0; a < count; ++a)
    {
      for (Index b = a + 1; b < count; ++b)
      {
        if (BoxesMeet(boxes[a], boxes[b]))
        {
          expected.insert({ a, b });
        }
      }
    }
    EXPECT_TRUE(found == expected);
    Box query;
    query.Extend(Vec3(0.2, 0.3, 0.1));
    query.Extend(Vec3(0.8, 0.6, 0.9));
    std::set<Index> at;
    tree.VisitBox(query, [&](Index id) { at.insert(id); });
    for (Index t = 0; t < count; ++t)
    {
      EXPECT_EQ(at.count(t) > 0, BoxesMeet(boxes[t], query));
    }
  }
}

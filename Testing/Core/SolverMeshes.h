// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Small meshes with bodies, patches, curves and corners for the tests of the solver formats.

#ifndef featurehex_SolverMeshes_h
#define featurehex_SolverMeshes_h

#include "FileAccess.h"
#include "SolverMesh.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <set>
#include <sstream>

namespace featurehex
{
/// Two cubes on top of each other: bodies 1 and 2; patches 0 (bottom), 1 (top), 4 (sides); curve 0
/// round the bottom, curve 2 round the top; corners 0 and 5. @a nodes: 8, 20 or 27 a hex, mid nodes
/// in the middle.
inline SolverMesh TwoBodies(int nodes = 8)
{
  SolverMesh mesh;
  for (int z = 0; z < 3; ++z)
  {
    for (const auto& [x, y] : { std::pair(0., 0.), { 1., 0. }, { 1., 1. }, { -1. / 3e7, 1. } })
    {
      mesh.Points.push_back({ x, y, z / 3.0 });
    }
  }
  mesh.NodesPerHex = nodes;
  mesh.Regions = { 1, 2 };
  std::map<std::set<Index>, Index> middles;
  for (Index start : { 0, 4 })
  {
    const std::size_t first = mesh.HexNodes.size();
    for (Index k = 0; k < 8; ++k)
    {
      mesh.HexNodes.push_back(start + k);
    }
    const auto middle = [&](const std::set<int>& corners)
    {
      std::set<Index> ids;
      Vec3 sum = Vec3::Zero();
      for (int k : corners)
      {
        ids.insert(mesh.HexNodes[first + k]);
        sum += mesh.Points[mesh.HexNodes[first + k]];
      }
      const auto [at, isNew] = middles.emplace(ids, static_cast<Index>(mesh.Points.size()));
      if (isNew)
      {
        mesh.Points.push_back(sum / static_cast<double>(corners.size()));
      }
      mesh.HexNodes.push_back(at->second);
    };
    for (int e = 0; e < 12 && nodes > 8; ++e)
    {
      middle({ HexEdges[e][0], HexEdges[e][1] });
    }
    for (int f = 0; f < 6 && nodes == 27; ++f)
    {
      middle({ HexFaces[f][0], HexFaces[f][1], HexFaces[f][2], HexFaces[f][3] });
    }
    if (nodes == 27)
    {
      middle({ 0, 1, 2, 3, 4, 5, 6, 7 });
    }
  }
  SolverLabels labels;
  labels.Quads = { { 0, 1, 2, 3 }, { 8, 9, 10, 11 } };
  labels.Patches = { 0, 1 };
  for (Index k = 0; k < 4; ++k)
  {
    for (Index start : { 0, 4 })
    {
      const Index a = start + k, b = start + (k + 1) % 4;
      labels.Quads.push_back({ a, b, b + 4, a + 4 });
      labels.Patches.push_back(4);
    }
    labels.Edges.push_back({ k, (k + 1) % 4 });
    labels.Curves.push_back(0);
    labels.Edges.push_back({ 8 + (k + 1) % 4, 8 + k });
    labels.Curves.push_back(2);
  }
  labels.Corners = { { 0, 0 }, { 10, 5 } };
  EXPECT_TRUE(LabelSolverMesh(labels, mesh).Ok());
  return mesh;
}

/// What @a write makes of @a mesh; empty when it fails.
template <typename Write>
std::string TextOf(const SolverMesh& mesh, const Write& write)
{
  const auto* info = testing::UnitTest::GetInstance()->current_test_info();
  const std::string name = (std::filesystem::temp_directory_path() /
                            (std::string("featurehex-") + info->test_suite_name() + info->name()))
                             .string();
  const Status status = write(name, mesh);
  EXPECT_TRUE(status.Ok()) << status.Message;
  std::string text;
  EXPECT_TRUE(ReadFileBytes(name, text).Ok());
  std::filesystem::remove(name);
  return text;
}

/// Every hex of @a mesh with points of @a points: mid nodes between the corners they belong to.
inline void ExpectMiddles(const std::vector<Vec3>& points, const SolverMesh& mesh)
{
  const auto between = [&](const std::vector<int>& corners, const Index* nodes, int node)
  {
    Vec3 sum = Vec3::Zero();
    for (int k : corners)
    {
      sum += points[nodes[k]];
    }
    EXPECT_LT((points[nodes[node]] - sum / static_cast<double>(corners.size())).norm(), 1e-6)
      << node;
  };
  for (Index h = 0; h < mesh.NumberOfHexes(); ++h)
  {
    for (int e = 0; e < 12 && mesh.NodesPerHex > 8; ++e)
    {
      between({ HexEdges[e][0], HexEdges[e][1] }, mesh.Nodes(h), 8 + e);
    }
    for (int f = 0; f < 6 && mesh.NodesPerHex == 27; ++f)
    {
      between(
        { HexFaces[f][0], HexFaces[f][1], HexFaces[f][2], HexFaces[f][3] }, mesh.Nodes(h), 20 + f);
    }
  }
}
} // namespace featurehex

#endif

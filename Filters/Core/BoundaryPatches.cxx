// SPDX-License-Identifier: BSD-3-Clause
#include "BoundaryPatches.h"

#include "HexAdjacency.h"
#include "Parallel.h"
#include "TriangleSearch.h"

#include <map>

namespace featurehex
{
namespace
{
/// Shell of each quad, numbered by their first quads.
std::vector<Index> ShellsOf(const std::vector<Quad>& quads, std::size_t points, Index& count)
{
  const IdLists quadsOfVertex = CellsOfVertices(quads, points);
  std::vector<Index> shell(quads.size(), -1);
  std::vector<Index> stack;
  count = 0;
  for (std::size_t first = 0; first < quads.size(); ++first)
  {
    if (shell[first] >= 0)
    {
      continue;
    }
    shell[first] = count;
    stack.assign(1, static_cast<Index>(first));
    while (!stack.empty())
    {
      const Index quad = stack.back();
      stack.pop_back();
      for (Index v : quads[quad])
      {
        for (Index other : quadsOfVertex[v])
        {
          if (shell[other] < 0)
          {
            shell[other] = count;
            stack.push_back(other);
          }
        }
      }
    }
    ++count;
  }
  return shell;
}
} // namespace

std::vector<int> PatchesOfShells(const std::vector<Vec3>& points, const std::vector<Quad>& quads,
  const SurfaceMesh& surface, const std::vector<Index>& patchOfTriangle)
{
  std::vector<Triangle> triangles;
  std::vector<Index> patch;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    if (patchOfTriangle[t] >= 0)
    {
      triangles.push_back(surface.Triangles[t]);
      patch.push_back(patchOfTriangle[t]);
    }
  }
  std::vector<int> result(quads.size(), -1);
  if (triangles.empty())
  {
    return result;
  }
  const TriangleSearch search(surface.Points, std::move(triangles));
  ParallelFor(quads.size(), 256,
    [&](std::size_t q)
    {
      Vec3 center = Vec3::Zero();
      for (Index v : quads[q])
      {
        center += 0.25 * points[v];
      }
      result[q] = patch[search.Closest(center).Triangle];
    });

  Index shells = 0;
  const std::vector<Index> shell = ShellsOf(quads, points.size(), shells);
  std::vector<std::map<int, Index>> votes(shells);
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    ++votes[shell[q]][result[q]];
  }
  std::vector<int> winner(shells, -1);
  for (Index s = 0; s < shells; ++s)
  {
    Index most = 0;
    for (const auto& [candidate, count] : votes[s])
    {
      if (count > most)
      {
        most = count;
        winner[s] = candidate;
      }
    }
  }
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    result[q] = winner[shell[q]];
  }
  return result;
}

std::vector<Index> NearestQuads(
  const std::vector<Vec3>& points, const std::vector<Quad>& quads, const std::vector<Vec3>& places)
{
  std::vector<Triangle> triangles;
  triangles.reserve(2 * quads.size());
  for (const Quad& q : quads)
  {
    triangles.push_back({ q[0], q[1], q[2] });
    triangles.push_back({ q[0], q[2], q[3] });
  }
  const TriangleSearch search(points, std::move(triangles));
  std::vector<Index> nearest(places.size());
  ParallelFor(places.size(), 256,
    [&](std::size_t i) { nearest[i] = search.Closest(places[i]).Triangle / 2; });
  return nearest;
}
} // namespace featurehex

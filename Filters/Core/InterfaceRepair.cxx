// SPDX-License-Identifier: BSD-3-Clause
#include "InterfaceRepair.h"

#include "Parallel.h"

#include <algorithm>
#include <set>
#include <string>

namespace featurehex
{
namespace
{
/// Weight of a non-manifold vertex, of the distance (in cells), and of each earlier flip of the
/// hex in the cost of a flip (measured on 19 surfaces: 3-12 flips each, none left over).
constexpr double VertexCost = 3.0;
constexpr double DistanceCost = 0.3;
constexpr double RepeatCost = 3.0;

bool FaceHasVertex(const Hex& hex, int face, Index vertex)
{
  const int* corners = HexFaces[face];
  return hex[corners[0]] == vertex || hex[corners[1]] == vertex || hex[corners[2]] == vertex ||
    hex[corners[3]] == vertex;
}

class Repair
{
public:
  Repair(const HexGraph& graph, const std::vector<double>& signedDistance,
    std::vector<char>& inside)
    : Graph(graph)
    , SignedDistance(signedDistance)
    , Inside(inside)
    , TimesFlipped(inside.size(), 0)
    , Border(graph.Mesh.Points.size(), 0)
  {
    for (std::size_t h = 0; h < graph.Neighbors.size(); ++h)
    {
      for (int f = 0; f < 6; ++f)
      {
        for (int k = 0; graph.Neighbors[h][f] < 0 && k < 4; ++k)
        {
          this->Border[graph.Mesh.Hexes[h][HexFaces[f][k]]] = 1;
        }
      }
    }
  }

  Index Run(Index maximumFlips)
  {
    const std::vector<Index> start = NonManifoldVertices(this->Graph, this->Inside);
    std::set<Index> bad(start.begin(), start.end());
    Index flips = 0;
    while (!bad.empty() && flips < maximumFlips)
    {
      const Index best = this->CheapestFlip(*bad.begin());
      if (best < 0)
      {
        break;
      }
      this->Inside[best] ^= 1;
      ++this->TimesFlipped[best];
      ++flips;
      for (Index v : this->Graph.Mesh.Hexes[best])
      {
        if (IsNonManifold(this->Graph, this->Inside, v))
        {
          bad.insert(v);
        }
        else
        {
          bad.erase(v);
        }
      }
    }
    return flips;
  }

private:
  Index CheapestFlip(Index vertex)
  {
    double lowest = 1e300;
    Index best = -1;
    for (Index h : this->Graph.HexesOfVertex[vertex])
    {
      if (!this->Inside[h] && this->TouchesBorder(h))
      {
        continue;
      }
      const int before = this->BadVertices(h);
      this->Inside[h] ^= 1;
      const int after = this->BadVertices(h);
      const bool agrees = (this->SignedDistance[h] < 0) == static_cast<bool>(this->Inside[h]);
      this->Inside[h] ^= 1;
      const double distance = std::abs(this->SignedDistance[h]);
      const double cost = VertexCost * (after - before) +
        DistanceCost * (agrees ? -distance : distance) + RepeatCost * this->TimesFlipped[h];
      if (cost < lowest)
      {
        lowest = cost;
        best = h;
      }
    }
    return best;
  }

  int BadVertices(Index hex) const
  {
    int count = 0;
    for (Index v : this->Graph.Mesh.Hexes[hex])
    {
      count += IsNonManifold(this->Graph, this->Inside, v);
    }
    return count;
  }

  bool TouchesBorder(Index hex) const
  {
    const Hex& vertices = this->Graph.Mesh.Hexes[hex];
    return std::any_of(
      vertices.begin(), vertices.end(), [this](Index v) { return this->Border[v] != 0; });
  }

  const HexGraph& Graph;
  const std::vector<double>& SignedDistance;
  std::vector<char>& Inside;
  std::vector<int> TimesFlipped;
  std::vector<char> Border;
};
}

bool IsNonManifold(const HexGraph& graph, const std::vector<char>& inside, Index vertex)
{
  const IdLists::Range hexes = graph.HexesOfVertex[vertex];
  Index insideCount = 0;
  for (Index h : hexes)
  {
    insideCount += inside[h];
  }
  if (insideCount == 0 || insideCount == hexes.size())
  {
    return false;
  }
  thread_local std::vector<char> seen;
  thread_local std::vector<Index> stack;
  seen.assign(hexes.size(), 0);
  int groups[2] = { 0, 0 };
  for (Index i = 0; i < hexes.size(); ++i)
  {
    if (seen[i])
    {
      continue;
    }
    const char label = inside[hexes[i]];
    if (++groups[static_cast<int>(label)] > 1)
    {
      return true;
    }
    seen[i] = 1;
    stack.assign(1, hexes[i]);
    while (!stack.empty())
    {
      const Index h = stack.back();
      stack.pop_back();
      for (int f = 0; f < 6; ++f)
      {
        const Index other = graph.Neighbors[h][f];
        if (other < 0 || inside[other] != label || !FaceHasVertex(graph.Mesh.Hexes[h], f, vertex))
        {
          continue;
        }
        const Index* found = std::lower_bound(hexes.begin(), hexes.end(), other);
        if (!seen[found - hexes.begin()])
        {
          seen[found - hexes.begin()] = 1;
          stack.push_back(other);
        }
      }
    }
  }
  return false;
}

std::vector<Index> NonManifoldVertices(const HexGraph& graph, const std::vector<char>& inside)
{
  const std::size_t count = graph.Mesh.Points.size();
  std::vector<char> bad(count);
  ParallelFor(count, 2048,
    [&](std::size_t v) { bad[v] = IsNonManifold(graph, inside, static_cast<Index>(v)); });
  std::vector<Index> result;
  for (std::size_t v = 0; v < count; ++v)
  {
    if (bad[v])
    {
      result.push_back(static_cast<Index>(v));
    }
  }
  return result;
}

Status CheckHexInput(const HexMesh& mesh)
{
  if (mesh.Hexes.empty())
  {
    return Status(StatusCode::InvalidMesh, "The hex mesh has no hexes.");
  }
  const Index count = static_cast<Index>(mesh.Points.size());
  for (std::size_t h = 0; h < mesh.Hexes.size(); ++h)
  {
    for (Index v : mesh.Hexes[h])
    {
      const bool exists = v >= 0 && v < count;
      if (!exists || !mesh.Points[v].allFinite())
      {
        return Status(StatusCode::InvalidMesh,
          "Hex " + std::to_string(h) + " uses point " + std::to_string(v) +
            (exists ? ", which is not finite." : ", which does not exist.") +
            " Give a hex mesh that the octree stages made.");
      }
    }
  }
  return Status();
}

RepairResult RepairInterface(const HexGraph& graph, const std::vector<double>& signedDistance,
  Index maximumFlips, std::vector<char>& inside)
{
  RepairResult result;
  result.Flips = Repair(graph, signedDistance, inside).Run(maximumFlips);
  result.NonManifoldVertices = NonManifoldVertices(graph, inside);
  return result;
}
}

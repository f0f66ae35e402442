// SPDX-License-Identifier: BSD-3-Clause
#include "HexDomain.h"

#include "DomainRefinement.h"
#include "HandleRepair.h"
#include "IslandRepair.h"
#include "Parallel.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
/// Of the way between two centres: as near to the surface as this counts as through it.
constexpr double TouchShare = 0.02;
/// Distances are searched up to this many cell sizes: 1.2 diagonals of a cube. Beyond, the limit
/// is a lower bound of the distance.
constexpr double NearDistance = 2.1;

/// Cells whose centre is farther than this from the surface are never lonely: their label is no
/// accident.
constexpr double LonelyDistance = 0.25;

constexpr int MaximumRepairPasses = 4;

struct Cells
{
  std::vector<Vec3> Centers;
  std::vector<double> Sizes;      ///< mean edge lengths
  std::vector<double> Distances;  ///< of the centres; lower bounds where Triangles is -1
  std::vector<Index> Triangles;   ///< the closest, -1: farther than NearDistance cells
};

Cells MeasureCells(const HexMesh& mesh, const TriangleSearch& search)
{
  Cells cells;
  const std::size_t count = mesh.Hexes.size();
  cells.Centers.resize(count);
  cells.Sizes.resize(count);
  cells.Distances.resize(count);
  cells.Triangles.resize(count);
  ParallelFor(count, 512, [&](std::size_t h) {
    const Hex& hex = mesh.Hexes[h];
    Vec3 center = Vec3::Zero();
    for (Index v : hex)
    {
      center += mesh.Points[v];
    }
    center /= 8.0;
    double size = 0.0;
    for (const int* edge : HexEdges)
    {
      size += (mesh.Points[hex[edge[0]]] - mesh.Points[hex[edge[1]]]).norm();
    }
    size /= 12.0;
    const double limit = NearDistance * size;
    const TrianglePoint closest = search.Closest(center, -1, limit);
    cells.Centers[h] = center;
    cells.Sizes[h] = size;
    cells.Triangles[h] = closest.Triangle;
    cells.Distances[h] = closest.Triangle < 0 ? limit : closest.Distance;
  });
  return cells;
}

/// Group of each hex: neighbours whose empty balls overlap have no surface between them.
/// Groups are numbered in the order of their first hexes.
std::vector<Index> GroupBySide(const HexGraph& graph, const Cells& cells, Index& groupCount)
{
  const std::size_t count = cells.Centers.size();
  std::vector<Index> group(count, -1);
  std::vector<Index> stack;
  groupCount = 0;
  for (std::size_t start = 0; start < count; ++start)
  {
    if (group[start] >= 0)
    {
      continue;
    }
    group[start] = groupCount;
    stack.assign(1, static_cast<Index>(start));
    while (!stack.empty())
    {
      const Index h = stack.back();
      stack.pop_back();
      for (Index other : graph.Neighbors[h])
      {
        // The factor keeps clear of rounding.
        if (other >= 0 && group[other] < 0 &&
          0.999999 * (cells.Distances[h] + cells.Distances[other]) >
            (cells.Centers[h] - cells.Centers[other]).norm())
        {
          group[other] = groupCount;
          stack.push_back(other);
        }
      }
    }
    ++groupCount;
  }
  return group;
}

/// What must be true before the stage looks at any hex.
Status CheckInput(const HexMesh& mesh, const TriangleSearch& search)
{
  if (search.Triangles().empty())
  {
    return Status(
      StatusCode::EmptySurface, "The surface has no triangles to tell inside from outside.");
  }
  return CheckHexInput(mesh);
}

/// Distances of the centres in local cell sizes, negative inside.
std::vector<double> SignedDistances(
  const HexGraph& graph, const Cells& cells, const WindingNumber& winding, Index& groupCount)
{
  const std::vector<Index> group = GroupBySide(graph, cells, groupCount);
  const std::size_t count = group.size();
  // The hex farthest from the surface answers for its group.
  std::vector<Index> speaker(groupCount, -1);
  for (std::size_t h = 0; h < count; ++h)
  {
    Index& best = speaker[group[h]];
    if (best < 0 || cells.Distances[h] > cells.Distances[best])
    {
      best = static_cast<Index>(h);
    }
  }
  std::vector<char> inside(groupCount);
  ParallelFor(inside.size(), 16,
    [&](std::size_t g) { inside[g] = winding.Inside(cells.Centers[speaker[g]]); });
  std::vector<double> distances(count);
  for (std::size_t h = 0; h < count; ++h)
  {
    const double distance = cells.Distances[h] / cells.Sizes[h];
    distances[h] = inside[group[h]] ? -distance : distance;
  }
  return distances;
}

std::vector<char> LabelHexes(const Cells& cells, const TriangleSearch& search,
  const std::vector<double>& distances, const DomainOptions& options)
{
  std::vector<char> inside(distances.size());
  ParallelFor(inside.size(), 1024, [&](std::size_t h) {
    inside[h] = distances[h] < 0;
    if (distances[h] >= 0 && distances[h] < options.LabelBias && cells.Triangles[h] >= 0)
    {
      const Vec3 foot = search.ClosestOn(cells.Centers[h], cells.Triangles[h]).Point;
      Vec3 away = (cells.Centers[h] - foot).stableNormalized();
      away = away.isZero() ? search.Normal(cells.Triangles[h]) : away;
      const double radius = 0.5 * options.BiasGap * cells.Sizes[h];
      const Vec3 center = foot + radius * away;
      inside[h] = search.Closest(center, cells.Triangles[h]).Distance > 0.9 * radius;
    }
  });
  return inside;
}

/// Labels near the surface that disagree with at least 5 neighbours. Decided on the labels as they
/// were, and never beside another flip, so that a limb one cell thick loses its tip at most.
Index FlipLonely(
  const HexGraph& graph, const std::vector<double>& distances, std::vector<char>& inside)
{
  const std::vector<char> before = inside;
  Index flips = 0;
  for (std::size_t h = 0; h < inside.size(); ++h)
  {
    int different = 0;
    bool flippedBeside = false;
    for (Index other : graph.Neighbors[h])
    {
      // Beyond the border is outside.
      different += (other < 0 ? 0 : before[other]) != before[h];
      flippedBeside = flippedBeside || (other >= 0 && inside[other] != before[other]);
    }
    if (different >= 5 && !flippedBeside && std::abs(distances[h]) < LonelyDistance)
    {
      inside[h] ^= 1;
      ++flips;
    }
  }
  return flips;
}

/// Inside hexes on the border of the mesh: the mesh doesn't enclose the solid.
Status CheckBorder(const HexGraph& graph, const Cells& cells, const std::vector<char>& inside)
{
  std::vector<Vec3> where;
  for (std::size_t h = 0; h < inside.size(); ++h)
  {
    const std::array<Index, 6>& neighbors = graph.Neighbors[h];
    if (inside[h] && std::find(neighbors.begin(), neighbors.end(), -1) != neighbors.end())
    {
      where.push_back(cells.Centers[h]);
    }
  }
  if (where.empty())
  {
    return Status();
  }
  return Status(StatusCode::InvalidMesh,
    "The hex mesh ends inside the surface: " + std::to_string(where.size()) +
      " hexes on its border are inside. Use a mesh that reaches at least two cells beyond the "
      "surface on all sides.",
    std::move(where));
}

void NumberRegions(const HexGraph& graph, const std::vector<char>& inside, HexDomain& domain)
{
  domain.Region.assign(inside.size(), 0);
  domain.NumberOfRegions = 0;
  domain.InsideHexes = 0;
  std::vector<Index> stack;
  for (std::size_t start = 0; start < inside.size(); ++start)
  {
    if (!inside[start] || domain.Region[start] > 0)
    {
      continue;
    }
    domain.Region[start] = ++domain.NumberOfRegions;
    stack.assign(1, static_cast<Index>(start));
    while (!stack.empty())
    {
      const Index h = stack.back();
      stack.pop_back();
      ++domain.InsideHexes;
      for (Index other : graph.Neighbors[h])
      {
        if (other >= 0 && inside[other] && domain.Region[other] == 0)
        {
          domain.Region[other] = domain.NumberOfRegions;
          stack.push_back(other);
        }
      }
    }
  }
}

/// Manifold interface and no islands; each may disturb the other, so a few times.
RepairResult RepairLabels(const HexGraph& graph, const HexDistances& distances,
  const DomainOptions& options, std::vector<char>& inside, HexDomain& domain)
{
  RepairResult repair;
  for (int pass = 0; pass < MaximumRepairPasses; ++pass)
  {
    repair = RepairInterface(graph, distances.Signed, options.MaximumFlips, inside);
    domain.RepairFlips += repair.Flips;
    const Index flips = pass + 1 < MaximumRepairPasses
      ? RepairIslands(graph, distances, domain.SurfaceShells, inside)
      : 0;
    domain.IslandFlips += flips;
    if (flips == 0)
    {
      break;
    }
  }
  return repair;
}

/// Regions, interface and topology of the labels.
void DescribeInterface(const HexGraph& graph, const TriangleSearch& search,
  const std::vector<char>& inside, HexDomain& domain)
{
  NumberRegions(graph, inside, domain);
  domain.Interface = InterfaceQuads(graph.Mesh, graph.Neighbors, domain.Region);
  std::vector<Quad> quads;
  for (const InterfaceQuad& quad : domain.Interface)
  {
    quads.push_back(quad.Vertices);
  }
  domain.InterfaceShells = FindShells(graph.Mesh.Points, quads);
  domain.Topology =
    CompareShells(domain.SurfaceShells, search, domain.InterfaceShells, graph.Mesh.Points, quads);
}

/// Per shell of the surface the handles that its shell of the interface has too many.
std::vector<Index> ExcessHandles(const HexDomain& domain)
{
  std::vector<Index> excess(domain.SurfaceShells.List.size(), 0);
  for (std::size_t m = 0; m < domain.InterfaceShells.List.size(); ++m)
  {
    const Index shell = domain.Topology.Matched[m];
    if (domain.Topology.Verdicts[shell] == ShellVerdict::Genus)
    {
      excess[shell] =
        domain.InterfaceShells.List[m].Genus() - domain.SurfaceShells.List[shell].Genus();
    }
  }
  return excess;
}

/// Walks along the segment in balls that the surface doesn't enter.
bool SurfaceBetween(const TriangleSearch& search, const Vec3& a, const Vec3& b)
{
  const double length = (b - a).norm();
  for (double way = 0; way < length;)
  {
    const double free = search.Closest(a + way / length * (b - a)).Distance;
    if (free < TouchShare * length)
    {
      return true;
    }
    way += free;
  }
  return false;
}

Status CheckRepair(const HexMesh& mesh, const RepairResult& repair)
{
  if (repair.NonManifoldVertices.empty())
  {
    return Status();
  }
  std::vector<Vec3> where;
  for (Index v : repair.NonManifoldVertices)
  {
    where.push_back(mesh.Points[v]);
  }
  return Status(StatusCode::Topology,
    "The interface between inside and outside hexes is not a manifold at " +
      std::to_string(where.size()) + " vertices after " + std::to_string(repair.Flips) +
      " flips. Lower TargetEdgeLength.",
    std::move(where));
}
}

Status ComputeHexDomain(const HexMesh& mesh, const SurfaceMesh& surface,
  const TriangleSearch& search, const WindingNumber& winding, const DomainOptions& options,
  Monitor& monitor, HexDomain& domain)
{
  domain = HexDomain();
  if (Status status = CheckInput(mesh, search); !status.Ok())
  {
    return status;
  }
  const HexGraph graph(mesh);
  const Cells cells = MeasureCells(mesh, search);
  if (!monitor.Update(0.3))
  {
    return monitor.StopStatus();
  }
  const HexDistances distances = { SignedDistances(graph, cells, winding, domain.WindingNumbers),
    cells.Triangles };
  std::vector<char> inside = LabelHexes(cells, search, distances.Signed, options);
  domain.LonelyFlips = FlipLonely(graph, distances.Signed, inside);
  if (Status status = CheckBorder(graph, cells, inside); !status.Ok())
  {
    return status;
  }
  if (!monitor.Update(0.5))
  {
    return monitor.StopStatus();
  }
  domain.SurfaceShells = FindShells(surface.Points, surface.Triangles);
  const RepairResult repair = RepairLabels(graph, distances, options, inside, domain);
  DescribeInterface(graph, search, inside, domain);
  if (Status status = CheckRepair(mesh, repair); !status.Ok())
  {
    return status;
  }
  std::vector<Index> excess = ExcessHandles(domain);
  const auto seesOther = [&](Index a, Index b) {
    return !SurfaceBetween(search, cells.Centers[a], cells.Centers[b]);
  };
  domain.HandleFlips =
    RepairHandles(graph, distances, domain.SurfaceShells, seesOther, excess, inside);
  if (domain.HandleFlips > 0)
  {
    DescribeInterface(graph, search, inside, domain);
  }
  if (!monitor.Update(0.6))
  {
    return monitor.StopStatus();
  }
  std::vector<Vec3> nearCenters;
  std::vector<double> nearSizes;
  for (std::size_t h = 0; h < cells.Centers.size(); ++h)
  {
    if (cells.Triangles[h] >= 0)
    {
      nearCenters.push_back(cells.Centers[h]);
      nearSizes.push_back(cells.Sizes[h]);
    }
  }
  FindDomainRefinement(
    mesh, surface, search, CellSizeMap(nearCenters, nearSizes), options, domain);
  monitor.Update(1.0);
  return monitor.StopStatus();
}
}

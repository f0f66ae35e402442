// SPDX-License-Identifier: BSD-3-Clause
#include "DomainRefinement.h"

#include "Parallel.h"
#include "SurfaceSizing.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
/// Samples of the surface per edge of the smallest cell near it.
constexpr double SamplesPerCell = 2.0;

/// The thin limit grows by this factor until it finds samples, up to the last value (in cells).
constexpr double ThinGrowth = 1.5;
constexpr double LastThinLimit = 6.0;

/// Smallest number of halvings of @a largest that gets closest to @a size.
int Halvings(double largest, double size)
{
  return std::max(0, static_cast<int>(std::lround(std::log2(largest / size))));
}

/// One point per cell of its level: the first in the order of the samples.
class PointCollector
{
public:
  PointCollector(double baseSize, int maximumLevel)
    : BaseSize(baseSize)
    , MaximumLevel(maximumLevel)
  {
  }

  void Add(const Vec3& position, double localSize)
  {
    const int level = Halvings(this->BaseSize, localSize) + 1;
    if (level <= this->MaximumLevel)
    {
      this->Points.push_back({ position, level });
    }
  }

  std::vector<RefinementPoint> Take() { return ThinRefinementPoints(this->Points, this->BaseSize); }

private:
  double BaseSize;
  int MaximumLevel;
  std::vector<RefinementPoint> Points;
};

TriangleSearch InterfaceSearch(const HexMesh& mesh, const std::vector<InterfaceQuad>& quads)
{
  std::vector<Vec3> points;
  std::vector<Index> ids(mesh.Points.size(), -1);
  std::vector<Triangle> triangles;
  const auto id = [&](Index v) {
    if (ids[v] < 0)
    {
      ids[v] = static_cast<Index>(points.size());
      points.push_back(mesh.Points[v]);
    }
    return ids[v];
  };
  for (const InterfaceQuad& quad : quads)
  {
    const Quad q = { id(quad.Vertices[0]), id(quad.Vertices[1]), id(quad.Vertices[2]),
      id(quad.Vertices[3]) };
    triangles.push_back({ q[0], q[1], q[2] });
    triangles.push_back({ q[0], q[2], q[3] });
  }
  return TriangleSearch(std::move(points), std::move(triangles), SearchBuild::Quick);
}

/// Samples that belong to shells with a verdict other than Same.
std::vector<std::size_t> SuspectSamples(
  const std::vector<SurfaceSample>& samples, const HexDomain& domain)
{
  std::vector<std::size_t> suspects;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    const Index shell = domain.SurfaceShells.OfFace[samples[i].Triangle];
    if (domain.Topology.Verdicts[shell] != ShellVerdict::Same)
    {
      suspects.push_back(i);
    }
  }
  return suspects;
}

/// Where the solid or the gap is thinner than a growing number of cells.
void AddThinSamples(const std::vector<SurfaceSample>& samples,
  const std::vector<std::size_t>& suspects, const std::vector<double>& localSizes,
  const TriangleSearch& search, const DomainOptions& options, PointCollector& points)
{
  std::vector<char> thin(suspects.size(), 0);
  bool any = false;
  for (double limit = options.ThinLimit; !any && limit <= LastThinLimit; limit *= ThinGrowth)
  {
    ParallelFor(suspects.size(), 64, [&](std::size_t i) {
      const SurfaceSample& sample = samples[suspects[i]];
      ClearanceOptions clearance;
      clearance.MaximumRadius = 0.5 * limit * localSizes[suspects[i]];
      clearance.Slack = options.Slack;
      thin[i] = false;
      for (SurfaceSide side : { SurfaceSide::Inside, SurfaceSide::Outside })
      {
        thin[i] = thin[i] ||
          ClearanceRadius(search, sample, side, clearance) < 0.999 * clearance.MaximumRadius;
      }
    });
    any = std::find(thin.begin(), thin.end(), 1) != thin.end();
  }
  for (std::size_t i = 0; i < suspects.size(); ++i)
  {
    if (thin[i] || !any)
    {
      points.Add(samples[suspects[i]].Position, localSizes[suspects[i]]);
    }
  }
}

/// All shells of the interface that share their surface shell with a larger one.
void AddExtraShells(const HexMesh& mesh, const TriangleSearch& search, const CellSizeMap& sizes,
  const HexDomain& domain, PointCollector& points)
{
  std::vector<Index> largest(domain.SurfaceShells.List.size(), -1);
  const std::vector<ShellTopology>& shells = domain.InterfaceShells.List;
  for (std::size_t s = 0; s < shells.size(); ++s)
  {
    Index& best = largest[domain.Topology.Matched[s]];
    if (best < 0 || std::abs(shells[s].Volume) > std::abs(shells[best].Volume))
    {
      best = static_cast<Index>(s);
    }
  }
  for (std::size_t q = 0; q < domain.Interface.size(); ++q)
  {
    const Index shell = domain.InterfaceShells.OfFace[q];
    if (shell != largest[domain.Topology.Matched[shell]])
    {
      const Vec3 position = search.Closest(mesh.Points[domain.Interface[q].Vertices[0]]).Point;
      points.Add(position, sizes.At(position));
    }
  }
}
}

CellSizeMap::CellSizeMap(const std::vector<Vec3>& centers, const std::vector<double>& sizes)
  : Centers(centers)
  , Sizes(sizes)
{
  Box box;
  double smallest = 1e300;
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    box.Extend(centers[i]);
    this->LargestSize = std::max(this->LargestSize, sizes[i]);
    smallest = std::min(smallest, sizes[i]);
  }
  if (sizes.empty())
  {
    return;
  }
  this->Origin = box.Low;
  this->Levels = Halvings(this->LargestSize, smallest) + 1;
  for (std::size_t i = 0; i < sizes.size(); ++i)
  {
    this->Entries.push_back({ this->Key(centers[i], Halvings(this->LargestSize, sizes[i])),
      static_cast<Index>(i) });
  }
  std::sort(this->Entries.begin(), this->Entries.end(), [](const Entry& a, const Entry& b) {
    return a.Key < b.Key || (a.Key == b.Key && a.Cell < b.Cell);
  });
}

std::array<int, 4> CellSizeMap::Key(const Vec3& p, int level) const
{
  const Vec3 local = (p - this->Origin) * std::ldexp(1.0, level) / this->LargestSize;
  return { level, static_cast<int>(std::floor(local[0])), static_cast<int>(std::floor(local[1])),
    static_cast<int>(std::floor(local[2])) };
}

double CellSizeMap::At(const Vec3& p) const
{
  double nearest = 1e300;
  double size = this->LargestSize;
  for (int level = 0; level < this->Levels; ++level)
  {
    const std::array<int, 4> middle = this->Key(p, level);
    for (int i = -1; i <= 1; ++i)
    {
      for (int j = -1; j <= 1; ++j)
      {
        // The three cells along the last axis follow each other.
        const std::array<int, 4> first = { level, middle[1] + i, middle[2] + j, middle[3] - 1 };
        const std::array<int, 4> last = { level, middle[1] + i, middle[2] + j, middle[3] + 1 };
        auto entry = std::lower_bound(this->Entries.begin(), this->Entries.end(), first,
          [](const Entry& e, const std::array<int, 4>& key) { return e.Key < key; });
        for (; entry != this->Entries.end() && entry->Key <= last; ++entry)
        {
          const double distance =
            (this->Centers[entry->Cell] - p).norm() / this->Sizes[entry->Cell];
          if (distance < nearest)
          {
            nearest = distance;
            size = this->Sizes[entry->Cell];
          }
        }
      }
    }
  }
  return size;
}

void FindDomainRefinement(const HexMesh& mesh, const SurfaceMesh& surface,
  const TriangleSearch& search, const CellSizeMap& sizes, const DomainOptions& options,
  HexDomain& domain)
{
  const double base = options.TargetEdgeLength > 0 ? options.TargetEdgeLength : sizes.Largest();
  const std::vector<SurfaceSample> samples = SampleSurface(surface, base / SamplesPerCell);
  const TriangleSearch interfaceSearch = InterfaceSearch(mesh, domain.Interface);
  std::vector<double> localSizes(samples.size());
  std::vector<char> missing(samples.size());
  ParallelFor(samples.size(), 64, [&](std::size_t i) {
    localSizes[i] = sizes.At(samples[i].Position);
    const double limit = options.MissingDistance * localSizes[i];
    missing[i] = interfaceSearch.Closest(samples[i].Position, -1, limit).Triangle < 0;
  });

  PointCollector missingPoints(base, options.MaximumLevel);
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (missing[i])
    {
      missingPoints.Add(samples[i].Position, localSizes[i]);
    }
  }
  domain.MissingPoints = missingPoints.Take();
  if (domain.Topology.Same())
  {
    return;
  }

  PointCollector topologyPoints(base, options.MaximumLevel);
  const std::vector<std::size_t> suspects = SuspectSamples(samples, domain);
  bool lost = false;
  for (std::size_t i : suspects)
  {
    if (missing[i])
    {
      topologyPoints.Add(samples[i].Position, localSizes[i]);
      lost = true;
    }
  }
  if (!lost)
  {
    AddThinSamples(samples, suspects, localSizes, search, options, topologyPoints);
  }
  AddExtraShells(mesh, search, sizes, domain, topologyPoints);
  domain.TopologyPoints = topologyPoints.Take();
}
}

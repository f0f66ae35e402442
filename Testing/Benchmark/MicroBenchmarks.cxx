// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The hot loops of the mesher one by one, with Google Benchmark.
///
///   MicroBenchmarks SURFACE MESH.mesh [--benchmark_...]
///
/// MESH.mesh: a hex mesh of SURFACE within 0.5 % of its diagonal, as "featurehex mesh" makes it. Each
/// benchmark runs on one thread and on all; items are counted in the label's unit. Started by
/// Testing/Benchmark/run, what they mean is in README.md beside this file.

#include "BlockOctree.h"
#include "CertifiedDistance.h"
#include "HexCertificate.h"
#include "HexOptimizer.h"
#include "HexStars.h"
#include "MeditFile.h"
#include "OctreeDual.h"
#include "Parallel.h"
#include "SurfaceCheck.h"
#include "SurfaceGeometry.h"
#include "SurfaceReader.h"
#include "SurfaceTerms.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <thread>

using namespace featurehex;

namespace
{
constexpr double Tolerance = 0.005;         // of the diagonal
constexpr double DualCellsPerSide = 120;    // about half a million hexes
constexpr double QueryDistance = 0.002;     // of points from the surface, of the diagonal
constexpr double Jitter = 0.2;              // of the local edge length
constexpr double SurfaceWeight = 5.0;       // FittingOptions::InitialWeight

/// What the benchmarks share; made once, before the first.
struct Input
{
  std::unique_ptr<SurfaceGeometry> Surface;
  HexMesh Mesh;
  std::unique_ptr<HexStars> Stars;
  std::unique_ptr<CertifiedDistance> Distance;
  std::vector<Vec3> Queries;  ///< centres of the boundary quads, moved off the surface
  std::vector<Index> Hints;   ///< closest triangle of the query before

  double AbsoluteTolerance() const { return Tolerance * this->Surface->Diagonal(); }
};

Input input;

Status Load(const char* surfacePath, const char* meshPath)
{
  Monitor monitor;
  SurfaceMesh surface;
  SurfaceCheckReport check;
  Status status = ReadSurface(surfacePath, surface);
  if (status.Ok())
  {
    status = CheckSurface(surface, SurfaceCheckOptions(), check, monitor);
  }
  MeditMesh medit;
  if (status.Ok())
  {
    status = ReadMedit(meshPath, medit);
  }
  if (!status.Ok())
  {
    return status;
  }
  input.Surface = std::make_unique<SurfaceGeometry>(std::move(surface));
  input.Distance = std::make_unique<CertifiedDistance>(input.Surface->Mesh());
  input.Mesh = { std::move(medit.Points), std::move(medit.Hexes) };
  input.Stars = std::make_unique<HexStars>(input.Mesh);

  const double offset = QueryDistance * input.Surface->Diagonal();
  for (const Quad& quad : input.Stars->Quads)
  {
    const std::vector<Vec3>& p = input.Mesh.Points;
    const Vec3 normal = (p[quad[2]] - p[quad[0]]).cross(p[quad[3]] - p[quad[1]]).normalized();
    input.Queries.push_back(
      0.25 * (p[quad[0]] + p[quad[1]] + p[quad[2]] + p[quad[3]]) + offset * normal);
  }
  // A stage that moves vertices remembers the triangle of a slightly different place.
  for (const Vec3& query : input.Queries)
  {
    const Vec3 before = query + Vec3(offset, -offset, offset);
    input.Hints.push_back(input.Surface->Search().Closest(before).Triangle);
  }
  return Status();
}

/// One thread or all of them, as benchmark arguments.
void ThreadCounts(benchmark::internal::Benchmark* one)
{
  one->ArgName("threads")->Arg(1);
  const int all = static_cast<int>(std::thread::hardware_concurrency());
  if (all > 1)
  {
    one->Arg(all);
  }
  one->UseRealTime()->MeasureProcessCPUTime()->Unit(benchmark::kMillisecond);
}

void UseThreads(const benchmark::State& state)
{
  vtkSMPTools::Initialize(static_cast<int>(state.range(0)));
}

void Count(benchmark::State& state, std::size_t items, const char* unit)
{
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(items));
  state.counters["items"] = static_cast<double>(items);
  state.SetLabel(unit);
}

/// Octree to hexes with the arrays that the mesher asks for.
void DualConversion(benchmark::State& state)
{
  UseThreads(state);
  Monitor monitor;
  OctreeOptions options;
  options.TargetEdgeLength = input.Surface->Bounds().Size().maxCoeff() / DualCellsPerSide;
  BlockOctree octree;
  HexMesh dual;
  OctreeDualArrays arrays;
  Status status =
    BuildBlockOctree(input.Surface->Mesh(), {}, options, octree, nullptr, monitor);
  for (auto _ : state)
  {
    if (status.Ok())
    {
      status = ConvertOctreeToHexes(octree, dual, &arrays, monitor);
    }
  }
  if (!status.Ok())
  {
    state.SkipWithError(status.Message.c_str());
  }
  Count(state, dual.Hexes.size(), "hex");
}
BENCHMARK(DualConversion)->Apply(ThreadCounts);

void Certificate(benchmark::State& state)
{
  UseThreads(state);
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(CertifyHexes(input.Mesh));
  }
  Count(state, input.Mesh.Hexes.size(), "hex");
}
BENCHMARK(Certificate)->Apply(ThreadCounts);

/// Moves each vertex by a fixed pseudo-random vector, where the ratio test lets it.
void Shake(HexOptimizer& optimizer, std::size_t vertices)
{
  for (std::size_t v = 0; v < vertices; ++v)
  {
    const double t = static_cast<double>(v);
    const Vec3 direction(std::sin(12.9898 * t), std::sin(78.233 * t), std::sin(37.719 * t));
    optimizer.TryMove(
      static_cast<Index>(v), Jitter * optimizer.SizeAt(static_cast<Index>(v)) * direction);
  }
}

/// A sweep of the fitting stage over all vertices of a shaken mesh; each starts from the same points.
void OptimizerSweep(benchmark::State& state)
{
  UseThreads(state);
  HexMesh mesh = input.Mesh;
  HexOptimizer optimizer(mesh, *input.Stars);
  Shake(optimizer, mesh.Points.size());
  const std::vector<Vec3> shaken = mesh.Points;
  optimizer.UpdateSizes();
  SurfaceTerms(mesh, *input.Stars, *input.Surface).UpdatePlanes(optimizer, SurfaceWeight, 0.0);
  for (auto _ : state)
  {
    state.PauseTiming();
    mesh.Points = shaken;
    optimizer.ActivateAll();
    state.ResumeTiming();
    optimizer.Sweep(-1.0);
  }
  Count(state, mesh.Points.size(), "vertex");
}
BENCHMARK(OptimizerSweep)->Apply(ThreadCounts);

/// "Within the tolerance, both ways?", as the refinement loop asks. The search structure of the surface exists.
void DistanceDecision(benchmark::State& state)
{
  UseThreads(state);
  for (auto _ : state)
  {
    Monitor monitor;
    if (!input.Distance
           ->DistanceWithin(
             input.Mesh.Points, input.Stars->Quads, input.AbsoluteTolerance(), monitor)
           .Within)
    {
      state.SkipWithError("the mesh is not within 0.5 % of the surface");
    }
  }
  Count(state, input.Surface->Mesh().Triangles.size(), "triangle");
}
BENCHMARK(DistanceDecision)->Apply(ThreadCounts);

/// The value, to 1 % of the tolerance, as the validation measures it.
void DistanceBound(benchmark::State& state)
{
  UseThreads(state);
  for (auto _ : state)
  {
    Monitor monitor;
    if (!input.Distance
           ->Measure(input.Mesh.Points, input.Stars->Quads, input.AbsoluteTolerance(), monitor)
           .Converged())
    {
      state.SkipWithError("the bounds of the distance don't converge");
    }
  }
  Count(state, input.Surface->Mesh().Triangles.size(), "triangle");
}
BENCHMARK(DistanceBound)->Apply(ThreadCounts);

/// Building the search structure of the surface.
void SearchStructure(benchmark::State& state)
{
  UseThreads(state);
  const SurfaceMesh& surface = input.Surface->Mesh();
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(TriangleSearch(surface.Points, surface.Triangles));
  }
  Count(state, surface.Triangles.size(), "triangle");
}
BENCHMARK(SearchStructure)->Apply(ThreadCounts);

void SearchClosest(benchmark::State& state, bool hints)
{
  UseThreads(state);
  const TriangleSearch& search = input.Surface->Search();
  std::vector<Index> found(input.Queries.size());
  for (auto _ : state)
  {
    ParallelFor(found.size(), 512, [&](std::size_t i) {
      found[i] = search.Closest(input.Queries[i], hints ? input.Hints[i] : -1).Triangle;
    });
    benchmark::ClobberMemory();
  }
  Count(state, found.size(), "point");
}

void ClosestPoint(benchmark::State& state)
{
  SearchClosest(state, false);
}
BENCHMARK(ClosestPoint)->Apply(ThreadCounts);

void ClosestPointWithHint(benchmark::State& state)
{
  SearchClosest(state, true);
}
BENCHMARK(ClosestPointWithHint)->Apply(ThreadCounts);
}

int main(int argc, char* argv[])
{
  benchmark::Initialize(&argc, argv);
  if (argc != 3)
  {
    std::fprintf(stderr, "usage: %s SURFACE MESH.mesh [--benchmark_...]\n", argv[0]);
    return 2;
  }
  // The backend of the command line program.
  vtkSMPTools::SetBackend("STDThread");
  const Status status = Load(argv[1], argv[2]);
  if (!status.Ok())
  {
    std::fprintf(stderr, "%s\n", status.Message.c_str());
    return 1;
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}

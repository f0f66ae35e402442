// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Compares the two untangling methods; prints a table, tab separated.
///
///   CompareUntangling [SHARED_DATA]
///
/// Rows: the tangled meshes of SHARED_DATA/tangled with fixed boundary, then the first padded mesh
/// of each surface in SHARED_DATA/surfaces/organic, drawn to its surface (the stages of
/// FeatureHexMesher.cxx). Result of the last run: untangling.tsv beside this file.

#include "BlockOctree.h"
#include "HexDomain.h"
#include "HexPadding.h"
#include "HexQuality.h"
#include "HexUntangling.h"
#include "OctreeDual.h"
#include "SurfaceCheck.h"
#include "SurfaceReader.h"
#include "SurfaceSizing.h"
#include "WindingNumber.h"

#include "../Core/SharedData.h"
#include "../Core/TangledMesh.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <memory>

using namespace featurehex;

namespace
{
constexpr double CellsPerSide = 26;
constexpr double Tolerance = 0.005;

struct PaddedModel
{
  std::unique_ptr<SurfaceGeometry> Surface;
  PaddedMesh Body;
};

/// Stages 1 to 6 with default options, first round only.
Status MakePadded(const std::string& path, PaddedModel& model)
{
  Monitor monitor;
  SurfaceMesh mesh;
  SurfaceCheckReport check;
  Status status = ReadSurface(path, mesh);
  if (status.Ok())
  {
    status = CheckSurface(mesh, SurfaceCheckOptions(), check, monitor);
  }
  if (!status.Ok())
  {
    return status;
  }
  model.Surface = std::make_unique<SurfaceGeometry>(std::move(mesh));
  const SurfaceGeometry& surface = *model.Surface;
  const WindingNumber winding(surface.Mesh());

  SizingOptions sizing;
  sizing.TargetEdgeLength = surface.Bounds().Size().maxCoeff() / CellsPerSide;
  sizing.Slack = Tolerance * surface.Diagonal();
  OctreeOptions octreeOptions;
  octreeOptions.TargetEdgeLength = sizing.TargetEdgeLength;
  DomainOptions domainOptions;
  domainOptions.TargetEdgeLength = sizing.TargetEdgeLength;
  domainOptions.Slack = sizing.Slack;

  BlockOctree octree;
  HexMesh dual;
  HexDomain domain;
  status = BuildBlockOctree(surface.Mesh(),
    ComputeSizing(surface.Mesh(), surface.Search(), sizing, monitor), octreeOptions, octree,
    nullptr, monitor);
  if (status.Ok())
  {
    status = ConvertOctreeToHexes(octree, dual, nullptr, monitor);
  }
  if (status.Ok())
  {
    status = ComputeHexDomain(
      dual, surface.Mesh(), surface.Search(), winding, domainOptions, monitor, domain);
  }
  return status.Ok() ? PadInterface(dual, domain.Region, PaddingOptions(), model.Body) : status;
}

void PrintRow(const std::string& name, const char* boundary, const HexMesh& tangled,
  const SurfaceGeometry* surface, UntangleMethod method)
{
  HexMesh mesh = tangled;
  UntangleOptions options;
  options.Method = method;
  UntangleReport report;
  Monitor monitor;
  const HexStars stars(mesh);
  const auto start = std::chrono::steady_clock::now();
  const Status status = UntangleHexes(mesh, stars, surface, options, report, monitor);
  const double seconds =
    std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const QualityStatistics quality = SummarizeQuality(ScaledJacobians(mesh));
  std::printf("%s\t%s\t%s\t%zu\t%d\t%d\t%d\t%d\t%.3f\t%.3f\t%.3f%s\n", name.c_str(), boundary,
    method == UntangleMethod::Regularized ? "regularized" : "stitching", mesh.Hexes.size(),
    report.InvertedBefore, report.InvertedAfter, report.Hopeless, report.Sweeps, seconds,
    quality.Minimum, quality.Mean, status.Ok() ? "" : "\tfailed");
  std::fflush(stdout);
}

void Compare(const std::string& name, const char* boundary, const HexMesh& mesh,
  const SurfaceGeometry* surface)
{
  for (UntangleMethod method : { UntangleMethod::Regularized, UntangleMethod::Stitching })
  {
    PrintRow(name, boundary, mesh, surface, method);
  }
}

std::vector<std::filesystem::path> FilesOf(const std::filesystem::path& folder)
{
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error))
  {
    files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}
}

int main(int argc, char* argv[])
{
  const std::filesystem::path data = argc > 1 ? std::filesystem::path(argv[1]) : SharedData();
  std::printf("model\tboundary\tmethod\thexes\tinverted_before\tinverted_after\thopeless\tsweeps\t"
              "seconds\tminimum_scaled_jacobian\tmean_scaled_jacobian\n");
  for (const std::filesystem::path& file : FilesOf(data / "tangled"))
  {
    HexMesh mesh;
    if (ReadTangledMesh(file.string(), mesh))
    {
      Compare(file.stem().string(), "fixed", mesh, nullptr);
    }
  }
  int failed = 0;
  for (const std::filesystem::path& file : FilesOf(data / "surfaces" / "organic"))
  {
    PaddedModel model;
    const Status status = MakePadded(file.string(), model);
    if (status.Ok())
    {
      Compare(file.stem().string(), "surface", model.Body.Mesh, model.Surface.get());
      Compare(file.stem().string(), "fixed", model.Body.Mesh, nullptr);
    }
    else
    {
      std::fprintf(stderr, "%s: %s\n", file.c_str(), status.Message.c_str());
      ++failed;
    }
  }
  return failed > 0 ? 1 : 0;
}

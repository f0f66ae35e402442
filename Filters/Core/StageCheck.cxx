// SPDX-License-Identifier: BSD-3-Clause
#include "StageCheck.h"

#include "HexCertificate.h"
#include "HexQuality.h"
#include "MeshTopology.h"
#include "MessageText.h"

#include <algorithm>
#include <cstdlib>

namespace featurehex
{
namespace
{
Status Defect(
  const StageOutput& output, const std::string& what, const std::vector<Vec3>& where = {})
{
  return Status(StatusCode::Unexpected,
    "Wrong result of the stage " + output.Stage + ": " + what +
      (where.empty() ? "" : " at " + PlaceText(where.front())) +
      ". This is a defect of FeatureHex: please report it with the surface and the options.",
    where);
}

Status CheckArrays(const StageOutput& output)
{
  for (const StageOutput::Array& array : output.Arrays)
  {
    if (array.Length != array.Expected)
    {
      return Defect(output, "the array " + std::string(array.Name) + " has " +
                              std::to_string(array.Length) + " values instead of " +
                              std::to_string(array.Expected));
    }
  }
  return Status();
}

template <typename Cell>
Status CheckCells(const StageOutput& output, const std::vector<Vec3>& points,
  const std::vector<Cell>& cells, const char* cellName)
{
  const auto count = static_cast<Index>(points.size());
  for (std::size_t c = 0; c < cells.size(); ++c)
  {
    for (Index id : cells[c])
    {
      if (id < 0 || id >= count)
      {
        return Defect(output, std::string(cellName) + " " + std::to_string(c) +
                                " refers to point " + std::to_string(id) + " of " +
                                std::to_string(count));
      }
    }
  }
  if (cells.empty())
  {
    return Defect(output, std::string("no ") + cellName);
  }
  if (output.Promise >= StagePromise::Finite)
  {
    const auto bad =
      std::find_if(points.begin(), points.end(), [](const Vec3& p) { return !p.allFinite(); });
    if (bad != points.end())
    {
      return Defect(
        output, "point " + std::to_string(bad - points.begin()) + " is not finite", { *bad });
    }
  }
  return CheckArrays(output);
}

Status CheckConforming(const StageOutput& output, const HexMesh& mesh)
{
  const HexTopology topology = AnalyzeHexMesh(mesh);
  const struct
  {
    const std::vector<Index>& Hexes;
    const char* What;
  } defects[] = { { topology.DegenerateHexIds, "repeats a point" },
    { topology.DuplicateHexIds, "is there twice" },
    { topology.Defects.Overused, "has a face of three hexes or more" },
    { topology.Defects.Twisted, "has a twisted face" },
    { topology.Defects.Misoriented, "has a face that both hexes see in the same direction" } };
  for (const auto& [hexes, what] : defects)
  {
    if (!hexes.empty())
    {
      return Defect(output, "hex " + std::to_string(hexes.front()) + " " + what,
        { mesh.Points[mesh.Hexes[hexes.front()][0]] });
    }
  }
  return Status();
}

Status CheckCorners(const StageOutput& output, const HexMesh& mesh)
{
  const std::vector<double> quality = ScaledJacobians(mesh);
  const auto bad = std::find_if(quality.begin(), quality.end(), [](double q) { return !(q > 0); });
  if (bad == quality.end())
  {
    return Status();
  }
  const auto hex = bad - quality.begin();
  return Defect(output,
    "hex " + std::to_string(hex) + " has an inverted corner (scaled Jacobian " +
      std::to_string(*bad) + ")",
    { mesh.Points[mesh.Hexes[hex][0]] });
}

Status CheckCertified(const StageOutput& output, const HexMesh& mesh)
{
  const std::vector<HexCertificate> certificates = CertifyHexes(mesh);
  const auto bad = std::find_if(certificates.begin(), certificates.end(),
    [](const HexCertificate& c) { return c.State != Validity::Valid; });
  if (bad == certificates.end())
  {
    return Status();
  }
  const auto hex = bad - certificates.begin();
  const Vec3& where = mesh.Points[mesh.Hexes[hex][0]];
  return Status(StatusCode::Validation,
    "The stage " + output.Stage + " leaves a hex whose Jacobian is not proven positive: hex " +
      std::to_string(hex) + " at " + PlaceText(where) + ". Make the octree finer there.",
    { where });
}
} // namespace

CheckDepth DefaultCheckDepth()
{
#ifdef NDEBUG
  static const bool full = std::getenv("FEATUREHEX_CHECK_STAGES") != nullptr;
  return full ? CheckDepth::Full : CheckDepth::Cheap;
#else
  return CheckDepth::Full;
#endif
}

Status CheckStageOutput(const StageOutput& output, const HexMesh& mesh, CheckDepth depth)
{
  Status status = CheckCells(output, mesh.Points, mesh.Hexes, "hex");
  if (depth == CheckDepth::Cheap)
  {
    return status;
  }
  if (status.Ok() && output.Promise >= StagePromise::Conforming)
  {
    status = CheckConforming(output, mesh);
  }
  if (status.Ok() && output.Promise >= StagePromise::PositiveCorners)
  {
    status = CheckCorners(output, mesh);
  }
  if (status.Ok() && output.Promise >= StagePromise::Certified)
  {
    status = CheckCertified(output, mesh);
  }
  return status;
}

Status CheckStageOutput(const StageOutput& output, const SurfaceMesh& surface, CheckDepth depth)
{
  Status status = CheckCells(output, surface.Points, surface.Triangles, "triangle");
  if (depth == CheckDepth::Cheap || !status.Ok() || output.Promise < StagePromise::Conforming)
  {
    return status;
  }
  const SurfaceTopology topology = AnalyzeSurface(surface.Points, surface.Triangles);
  if (topology.ClosedManifold())
  {
    return status;
  }
  const Index point = !topology.BadEdges.empty()      ? topology.BadEdges.front()[0]
                      : !topology.BadVertices.empty() ? topology.BadVertices.front()
                                                      : surface.Triangles.front()[0];
  return Defect(output, "the surface is not a closed manifold, see point " + std::to_string(point),
    { surface.Points[point] });
}

Status CheckStageOutput(const StageOutput& output, const BlockOctree& octree, CheckDepth depth)
{
  if (octree.Leaves.empty() || !octree.Origin.allFinite() || !octree.Axes.allFinite() ||
      !(octree.FinestCellSize > 0))
  {
    return Defect(output, "the octree has no leaves or no finite frame");
  }
  BlockOctree rebuilt = octree;
  const Status status =
    depth == CheckDepth::Full ? RebuildBlockOctree(ListOctreeCells(octree), rebuilt) : Status();
  return status.Ok() ? CheckArrays(output)
                     : Defect(output, "the leaves are not a balanced block octree");
}
} // namespace featurehex

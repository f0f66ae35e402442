// SPDX-License-Identifier: BSD-3-Clause
#include "UcdWriter.h"

#include "FileAccess.h"
#include "TextScanner.h"

namespace featurehex
{
namespace
{
class UcdText
{
public:
  explicit UcdText(const SolverMesh& mesh)
    : Mesh(mesh)
  {
  }

  std::string Text()
  {
    const auto hexes = static_cast<std::size_t>(this->Mesh.NumberOfHexes());
    // deal.II takes comment lines only in front of everything else.
    this->Out = "# FeatureHex: hexahedra, boundary quads (patch + 1), feature edges (curve + 1)\n";
    this->Out += std::to_string(this->Mesh.Points.size()) + " " +
                 std::to_string(hexes + this->Mesh.Sides.size() + this->Mesh.Segments.size()) +
                 " 0 0 0\n";
    for (std::size_t i = 0; i < this->Mesh.Points.size(); ++i)
    {
      AppendInteger(this->Out, static_cast<std::int64_t>(i) + 1);
      for (int k = 0; k < 3; ++k)
      {
        this->Out += ' ';
        AppendReal(this->Out, this->Mesh.Points[i][k]);
      }
      this->Out += '\n';
    }
    for (std::size_t hex = 0; hex < hexes; ++hex)
    {
      const Index* nodes = this->Mesh.Nodes(static_cast<Index>(hex));
      this->Cell(this->Mesh.Regions[hex], " hex", std::vector<Index>(nodes, nodes + 8));
    }
    for (const SolverMesh::Side& side : this->Mesh.Sides)
    {
      this->Cell(
        std::int64_t{ side.Patch } + 1, " quad", NodesOfSide(this->Mesh, side.Hex, side.Face));
    }
    for (const SolverMesh::Segment& segment : this->Mesh.Segments)
    {
      this->Cell(std::int64_t{ segment.Curve } + 1, " line",
        NodesOfSegment(this->Mesh, segment.Hex, segment.Edge));
    }
    return std::move(this->Out);
  }

private:
  void Cell(std::int64_t material, const char* type, const std::vector<Index>& nodes)
  {
    AppendInteger(this->Out, ++this->NumberOfCells);
    this->Out += ' ';
    AppendInteger(this->Out, material);
    this->Out += type;
    for (Index v : nodes)
    {
      this->Out += ' ';
      AppendInteger(this->Out, std::int64_t{ v } + 1);
    }
    this->Out += '\n';
  }

  const SolverMesh& Mesh;
  std::string Out;
  std::int64_t NumberOfCells = 0;
};

Status CheckLabels(const SolverMesh& mesh)
{
  const SolverGroups groups(mesh);
  for (const auto* labels : { &groups.Bodies, &groups.Patches, &groups.Curves })
  {
    if (!labels->empty() && labels->begin()->first < 0)
    {
      return Status(StatusCode::InvalidMesh, "A body, patch or curve has the number " +
                                               std::to_string(labels->begin()->first) +
                                               "; .ucd files can't have negative ones.");
    }
  }
  return {};
}
} // namespace

Status WriteUcd(const std::string& path, const SolverMesh& mesh)
{
  Status status = CheckSolverMesh(mesh);
  if (status.Ok() && mesh.NodesPerHex != 8)
  {
    status = Status(StatusCode::InvalidMesh,
      ".ucd files have linear hexahedra only: write quadratic ones as .inp, .msh or Exodus.");
  }
  status = status.Ok() ? CheckLabels(mesh) : status;
  return status.Ok() ? WriteFileBytes(path, UcdText(mesh).Text()) : status;
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause
#include "HexPadding.h"

#include "HexAdjacency.h"
#include "InterfaceRepair.h"
#include "MeshTopology.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <locale>
#include <numeric>
#include <sstream>

namespace featurehex
{
namespace
{
constexpr int MortonBits = 21;

/// Spread the lowest 21 bits so that two zeros follow each.
std::uint64_t SpreadBits(std::uint64_t x)
{
  x &= 0x1fffff;
  x = (x | (x << 32)) & 0x1f00000000ffffull;
  x = (x | (x << 16)) & 0x1f0000ff0000ffull;
  x = (x | (x << 8)) & 0x100f00f00f00f00full;
  x = (x | (x << 4)) & 0x10c30c30c30c30c3ull;
  x = (x | (x << 2)) & 0x1249249249249249ull;
  return x;
}

/// Along an edge of four boundary quads the layer would share one face between four hexes.
Status CheckInterface(const HexMesh& mesh, const std::vector<InterfaceQuad>& interface)
{
  std::vector<Quad> quads;
  quads.reserve(interface.size());
  for (const InterfaceQuad& quad : interface)
  {
    quads.push_back(quad.Vertices);
  }
  const SurfaceTopology topology = AnalyzeSurface(mesh.Points, quads);
  if (topology.ClosedManifold())
  {
    return Status();
  }
  const Index point = topology.BadEdges.empty() ? topology.BadVertices.front()
                                                : topology.BadEdges.front()[0];
  const Vec3& where = mesh.Points[point];
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << "The boundary of the bodies is not a manifold: " << topology.BadEdges.size()
       << " edges and " << topology.BadVertices.size() << " points, first at (" << where[0] << ", "
       << where[1] << ", " << where[2] << "). Pad the regions of the domain stage unchanged.";
  return Status(StatusCode::InvalidMesh, text.str(), { where });
}

double MeanEdgeLength(const HexMesh& mesh, Index hex)
{
  double sum = 0.0;
  for (const int* edge : HexEdges)
  {
    sum += (mesh.Points[mesh.Hexes[hex][edge[0]]] - mesh.Points[mesh.Hexes[hex][edge[1]]]).norm();
  }
  return sum / 12.0;
}

/// Where the inner copy of each interface point goes.
class InwardOffset
{
public:
  InwardOffset(const HexMesh& mesh, const std::vector<InterfaceQuad>& quads)
    : Normals(mesh.Points.size(), Vec3::Zero())
    , Sizes(mesh.Points.size(), 0.0)
    , Counts(mesh.Points.size(), 0)
  {
    for (const InterfaceQuad& quad : quads)
    {
      const double size = MeanEdgeLength(mesh, quad.Inside);
      for (int k = 0; k < 4; ++k)
      {
        const Index v = quad.Vertices[k];
        const Vec3& p = mesh.Points[v];
        const Vec3 normal = (mesh.Points[quad.Vertices[(k + 1) & 3]] - p)
                              .cross(mesh.Points[quad.Vertices[(k + 3) & 3]] - p);
        this->Normals[v] += normal.stableNormalized();
        this->Sizes[v] += size;
        ++this->Counts[v];
      }
    }
  }

  bool OnInterface(Index v) const { return this->Counts[v] > 0; }

  Vec3 operator()(Index v, double thickness) const
  {
    return -thickness * this->Sizes[v] / this->Counts[v] * this->Normals[v].stableNormalized();
  }

private:
  std::vector<Vec3> Normals;
  std::vector<double> Sizes;
  std::vector<int> Counts;
};
}

std::vector<Index> OrderInSpace(PaddedMesh& padded)
{
  const std::vector<Index> rank = MortonRank(padded.Mesh.Points);
  PaddedMesh sorted;
  const std::size_t pointCount = rank.size();
  sorted.Mesh.Points.resize(pointCount);
  sorted.SourcePoint.resize(pointCount);
  sorted.OnBoundary.resize(pointCount);
  for (std::size_t v = 0; v < pointCount; ++v)
  {
    sorted.Mesh.Points[rank[v]] = padded.Mesh.Points[v];
    sorted.SourcePoint[rank[v]] = padded.SourcePoint[v];
    sorted.OnBoundary[rank[v]] = padded.OnBoundary[v];
  }
  std::vector<Index> lowest(padded.Mesh.Hexes.size());
  for (std::size_t h = 0; h < lowest.size(); ++h)
  {
    for (Index& v : padded.Mesh.Hexes[h])
    {
      v = rank[v];
    }
    lowest[h] = *std::min_element(padded.Mesh.Hexes[h].begin(), padded.Mesh.Hexes[h].end());
  }
  std::vector<Index> order(lowest.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return lowest[a] < lowest[b] || (lowest[a] == lowest[b] && a < b);
  });
  for (Index h : order)
  {
    if (padded.IsLayer[h])
    {
      sorted.LayerHexes.push_back(static_cast<Index>(sorted.Mesh.Hexes.size()));
    }
    sorted.Mesh.Hexes.push_back(padded.Mesh.Hexes[h]);
    sorted.Region.push_back(padded.Region[h]);
    sorted.IsLayer.push_back(padded.IsLayer[h]);
    sorted.SourceHex.push_back(padded.SourceHex[h]);
    sorted.SourceQuad.push_back(padded.SourceQuad[h]);
  }
  padded = std::move(sorted);
  return rank;
}

std::vector<Index> MortonRank(const std::vector<Vec3>& points)
{
  Box box;
  for (const Vec3& p : points)
  {
    box.Extend(p);
  }
  const double side = points.empty() ? 0.0 : box.Size().maxCoeff();
  const double scale = side > 0 ? ((1 << MortonBits) - 1) / side : 0.0;
  std::vector<std::uint64_t> codes(points.size());
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vec3 local = (points[i] - box.Low) * scale;
    codes[i] = SpreadBits(static_cast<std::uint64_t>(local[0])) |
      SpreadBits(static_cast<std::uint64_t>(local[1])) << 1 |
      SpreadBits(static_cast<std::uint64_t>(local[2])) << 2;
  }
  std::vector<Index> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return codes[a] < codes[b] || (codes[a] == codes[b] && a < b);
  });
  std::vector<Index> rank(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    rank[order[i]] = static_cast<Index>(i);
  }
  return rank;
}

Status PadInterface(const HexMesh& mesh, const std::vector<int>& region,
  const PaddingOptions& options, PaddedMesh& padded)
{
  padded = PaddedMesh();
  if (!(options.Thickness > 0) || !(options.Thickness < 1))
  {
    return Status(StatusCode::InvalidOption,
      "The padding thickness is " + std::to_string(options.Thickness) +
        " of the local cell size; it must lie between 0 and 1.");
  }
  if (region.size() != mesh.Hexes.size())
  {
    return Status(StatusCode::InvalidMesh,
      "Padding needs one region per hex: there are " + std::to_string(mesh.Hexes.size()) +
        " hexes and " + std::to_string(region.size()) + " regions.");
  }
  if (Status status = CheckHexInput(mesh); !status.Ok())
  {
    return status;
  }
  const std::vector<std::array<Index, 6>> neighbors =
    FaceNeighbors(mesh.Hexes, CellsOfVertices(mesh.Hexes, mesh.Points.size()));
  const std::vector<InterfaceQuad> quads = InterfaceQuads(mesh, neighbors, region);
  if (quads.empty())
  {
    return Status(StatusCode::InvalidMesh,
      "Padding found no hex with a region above 0. Label the hexes of the bodies first.");
  }
  if (Status status = CheckInterface(mesh, quads); !status.Ok())
  {
    return status;
  }
  const InwardOffset offset(mesh, quads);

  std::vector<Index> inner(mesh.Points.size(), -1);
  std::vector<Index> outer(mesh.Points.size(), -1);
  const auto add = [&](std::vector<Index>& ids, Index v, const Vec3& position, bool boundary) {
    if (ids[v] < 0)
    {
      ids[v] = static_cast<Index>(padded.Mesh.Points.size());
      padded.Mesh.Points.push_back(position);
      padded.SourcePoint.push_back(v);
      padded.OnBoundary.push_back(boundary);
    }
    return ids[v];
  };
  const auto innerPoint = [&](Index v) {
    const Vec3& p = mesh.Points[v];
    return add(
      inner, v, offset.OnInterface(v) ? Vec3(p + offset(v, options.Thickness)) : p, false);
  };
  const auto addHex = [&](const Hex& hex, Index source, Index quad) {
    padded.Mesh.Hexes.push_back(hex);
    padded.Region.push_back(region[source]);
    padded.IsLayer.push_back(quad >= 0);
    padded.SourceHex.push_back(source);
    padded.SourceQuad.push_back(quad);
  };
  for (std::size_t h = 0; h < mesh.Hexes.size(); ++h)
  {
    if (region[h] > 0)
    {
      Hex hex;
      for (int k = 0; k < 8; ++k)
      {
        hex[k] = innerPoint(mesh.Hexes[h][k]);
      }
      addHex(hex, static_cast<Index>(h), -1);
    }
  }
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    const InterfaceQuad& quad = quads[q];
    Hex hex;
    for (int k = 0; k < 4; ++k)
    {
      const Index v = quad.Vertices[k];
      hex[k] = innerPoint(v);
      hex[4 + k] = add(outer, v, mesh.Points[v], true);
    }
    addHex(hex, quad.Inside, static_cast<Index>(q));
  }
  OrderInSpace(padded);
  return Status();
}
}

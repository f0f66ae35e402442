// SPDX-License-Identifier: BSD-3-Clause
#include "HexPadding.h"

#include "HexAdjacency.h"
#include "InterfaceRepair.h"
#include "LayerNeed.h"
#include "MeshTopology.h"
#include "MessageText.h"
#include "MortonCode.h"
#include "PaddingGroups.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <set>

namespace featurehex
{
namespace
{
constexpr int MortonBits = 21;

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
  return Status(StatusCode::InvalidMesh,
    "The boundary of the bodies is not a manifold: " + std::to_string(topology.BadEdges.size()) +
      " edges and " + std::to_string(topology.BadVertices.size()) + " points, first at " +
      PlaceText(where) + ". Pad the regions of the domain stage unchanged.",
    { where });
}

/// Features of other meshes, or edited by hand.
Status CheckFeatures(const HexFeatures& features, const std::vector<InterfaceQuad>& interface,
  const FeatureGeometry* geometry)
{
  const auto bad = [](const std::string& text) { return Status(StatusCode::InvalidMesh, text); };
  const std::vector<int>& patches = features.PatchOfQuad;
  if (patches.size() != interface.size())
  {
    return bad("Padding needs the patch of each quad of the interface: there are " +
      std::to_string(interface.size()) + " quads and " + std::to_string(patches.size()) +
      " patches.");
  }
  const int highest = *std::max_element(patches.begin(), patches.end());
  if (geometry && highest >= geometry->Features().NumberOfPatches)
  {
    return bad("A quad of the interface belongs to patch " + std::to_string(highest) +
      ", but the surface has " + std::to_string(geometry->Features().NumberOfPatches) +
      " patches.");
  }
  std::set<std::array<Index, 2>> edges;
  std::set<Index> vertices;
  for (const InterfaceQuad& quad : interface)
  {
    for (int k = 0; k < 4; ++k)
    {
      edges.insert({ quad.Vertices[k], quad.Vertices[(k + 1) & 3] });
      vertices.insert(quad.Vertices[k]);
    }
  }
  for (Index v : features.CornerVertices)
  {
    if (v >= 0 && vertices.count(v) == 0)
    {
      return bad("A corner is at point " + std::to_string(v) +
        ", which is not on the interface. Map the features to this mesh.");
    }
  }
  for (const std::vector<Index>& path : features.CurvePaths)
  {
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      if (edges.count({ path[i - 1], path[i] }) == 0)
      {
        return bad("A curve runs from point " + std::to_string(path[i - 1]) + " to " +
          std::to_string(path[i]) +
          ", which is no edge of the interface. Map the features to this mesh.");
      }
    }
  }
  return Status();
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

/// Puts one layer after the other under parts of the boundary.
class LayerBuilder
{
public:
  LayerBuilder(const HexMesh& mesh, const std::vector<int>& region,
    const std::vector<InterfaceQuad>& interface, double thickness, PaddedMesh& padded);

  /// Features of the interface become those of the boundary. @a geometry: null puts all patches into
  /// one group.
  void UseFeatures(HexFeatures& features, const FeatureGeometry* geometry);

  int NumberOfGroups() const { return this->Groups; }
  bool NeedsLayer(int group) const { return this->Needs.empty() || this->Needs[group]; }

  /// A layer under all quads of the group. It comes to the surface in the quads of other groups
  /// beside them.
  void AddLayer(int group);

  /// Patches in the order of the boundary quads, points and hexes in their order.
  void Finish();

private:
  struct Facet
  {
    Quad Vertices;
    Index Source; ///< hex of the unpadded mesh
    int Patch = -1;
    int Group = 0;
  };

  Index AddPoint(Index source, const Vec3& position)
  {
    this->Padded.Mesh.Points.push_back(position);
    this->Padded.SourcePoint.push_back(source);
    return static_cast<Index>(this->Padded.Mesh.Points.size()) - 1;
  }
  void AddHex(const Hex& hex, Index source, bool layer)
  {
    this->Padded.Mesh.Hexes.push_back(hex);
    this->Padded.Region.push_back(this->Region[source]);
    this->Padded.IsLayer.push_back(layer);
    this->Padded.SourceHex.push_back(source);
  }
  std::vector<Index> CopyPoints(int group);
  void UsePatchNormals(int group, std::vector<Vec3>& normals) const;
  void CloseBorders(int group, const std::vector<Index>& copies);
  void ExtendPaths(int group, const std::vector<Index>& copies);

  const HexMesh& Mesh;
  const std::vector<int>& Region;
  double Thickness;
  PaddedMesh& Padded;
  std::vector<Facet> Facets; ///< the boundary
  HexFeatures* Features = nullptr;
  const FeatureGeometry* Geometry = nullptr;
  int Groups = 1;
  std::vector<char> Needs; ///< a layer, each group; empty: all do
  std::vector<std::array<int, 2>> GroupsOfCurve; ///< on its two sides; empty path: none
};

LayerBuilder::LayerBuilder(const HexMesh& mesh, const std::vector<int>& region,
  const std::vector<InterfaceQuad>& interface, double thickness, PaddedMesh& padded)
  : Mesh(mesh)
  , Region(region)
  , Thickness(thickness)
  , Padded(padded)
{
  std::vector<Index> ids(mesh.Points.size(), -1);
  for (std::size_t h = 0; h < mesh.Hexes.size(); ++h)
  {
    if (region[h] > 0)
    {
      Hex hex;
      for (int k = 0; k < 8; ++k)
      {
        const Index v = mesh.Hexes[h][k];
        ids[v] = ids[v] < 0 ? this->AddPoint(v, mesh.Points[v]) : ids[v];
        hex[k] = ids[v];
      }
      this->AddHex(hex, static_cast<Index>(h), false);
    }
  }
  for (const InterfaceQuad& quad : interface)
  {
    Facet facet;
    facet.Source = quad.Inside;
    for (int k = 0; k < 4; ++k)
    {
      facet.Vertices[k] = ids[quad.Vertices[k]];
    }
    this->Facets.push_back(facet);
  }
}

void LayerBuilder::UseFeatures(HexFeatures& features, const FeatureGeometry* geometry)
{
  const std::vector<int> groupOfPatch = geometry ? GroupPatches(*geometry) : std::vector<int>();
  for (int group : groupOfPatch)
  {
    this->Groups = std::max(this->Groups, group + 1);
  }
  std::vector<Index> ids(this->Mesh.Points.size(), -1);
  for (std::size_t v = 0; v < this->Padded.SourcePoint.size(); ++v)
  {
    ids[this->Padded.SourcePoint[v]] = static_cast<Index>(v);
  }
  RenumberFeatures(ids, features);
  std::map<std::array<Index, 2>, int> groupOnLeft; // of each directed edge
  for (std::size_t q = 0; q < this->Facets.size(); ++q)
  {
    Facet& facet = this->Facets[q];
    facet.Patch = features.PatchOfQuad[q];
    facet.Group = facet.Patch < 0 || groupOfPatch.empty() ? 0 : groupOfPatch[facet.Patch];
    for (int k = 0; k < 4; ++k)
    {
      groupOnLeft[{ facet.Vertices[k], facet.Vertices[(k + 1) & 3] }] = facet.Group;
    }
  }
  for (const std::vector<Index>& path : features.CurvePaths)
  {
    this->GroupsOfCurve.push_back({ -1, -1 });
    if (path.size() > 1)
    {
      this->GroupsOfCurve.back() = { groupOnLeft.at({ path[0], path[1] }),
        groupOnLeft.at({ path[1], path[0] }) };
    }
  }
  this->Features = &features;
  this->Geometry = geometry;
  if (geometry)
  {
    std::vector<Quad> quads;
    for (const Facet& facet : this->Facets)
    {
      quads.push_back(facet.Vertices);
    }
    this->Needs =
      GroupsThatNeedLayers(this->Padded.Mesh, quads, features, *geometry, groupOfPatch);
  }
}

/// On a crease the stairs of the interface say little: there a copy goes away from the patches of
/// its layer themselves, so that it doesn't fold the strip that it makes beyond the crease.
void LayerBuilder::UsePatchNormals(int group, std::vector<Vec3>& normals) const
{
  std::set<std::pair<Index, int>> patches; // (point, patch)
  std::set<Index> onCrease;
  for (const Facet& facet : this->Facets)
  {
    for (Index v : facet.Vertices)
    {
      if (facet.Group != group)
      {
        onCrease.insert(v);
      }
      else
      {
        patches.insert({ v, facet.Patch });
      }
    }
  }
  Index last = -1;
  for (const auto& [v, patch] : patches)
  {
    if (patch >= 0 && onCrease.count(v) > 0)
    {
      const SurfaceGeometry& surface = this->Geometry->Patch(patch);
      const Vec3 normal = surface.NormalAt(surface.Search().Closest(this->Padded.Mesh.Points[v]));
      normals[v] = v == last ? Vec3(normals[v] + normal) : normal;
      last = v;
    }
  }
}

/// Inner copies of all points of the group; -1: not on it.
std::vector<Index> LayerBuilder::CopyPoints(int group)
{
  const std::size_t count = this->Padded.Mesh.Points.size();
  std::vector<Vec3> normals(count, Vec3::Zero());
  std::vector<double> sizes(count, 0.0);
  std::vector<int> quads(count, 0);
  for (const Facet& facet : this->Facets)
  {
    if (facet.Group != group)
    {
      continue;
    }
    const double size = MeanEdgeLength(this->Mesh, facet.Source);
    const std::vector<Vec3>& points = this->Padded.Mesh.Points;
    for (int k = 0; k < 4; ++k)
    {
      const Index v = facet.Vertices[k];
      const Vec3 normal = (points[facet.Vertices[(k + 1) & 3]] - points[v])
                            .cross(points[facet.Vertices[(k + 3) & 3]] - points[v]);
      normals[v] += normal.stableNormalized();
      sizes[v] += size;
      ++quads[v];
    }
  }
  if (this->Groups > 1)
  {
    this->UsePatchNormals(group, normals);
  }
  std::vector<Index> copies(count, -1);
  for (std::size_t v = 0; v < count; ++v)
  {
    if (quads[v] > 0)
    {
      copies[v] = this->AddPoint(this->Padded.SourcePoint[v],
        this->Padded.Mesh.Points[v] -
          this->Thickness * sizes[v] / quads[v] * normals[v].stableNormalized());
    }
  }
  return copies;
}

void LayerBuilder::AddLayer(int group)
{
  const std::vector<Index> copies = this->CopyPoints(group);
  for (Hex& hex : this->Padded.Mesh.Hexes)
  {
    for (Index& v : hex)
    {
      v = copies[v] < 0 ? v : copies[v];
    }
  }
  for (const Facet& facet : this->Facets)
  {
    if (facet.Group == group)
    {
      Hex hex;
      for (int k = 0; k < 4; ++k)
      {
        hex[k] = copies[facet.Vertices[k]];
        hex[4 + k] = facet.Vertices[k];
      }
      this->AddHex(hex, facet.Source, true);
    }
  }
  this->CloseBorders(group, copies);
  this->ExtendPaths(group, copies);
}

/// The quads beside the group move to the copies, and the side of the layer fills the gap.
void LayerBuilder::CloseBorders(int group, const std::vector<Index>& copies)
{
  std::set<std::array<Index, 2>> ofGroup; // directed edges
  for (const Facet& facet : this->Facets)
  {
    for (int k = 0; k < 4 && facet.Group == group; ++k)
    {
      ofGroup.insert({ facet.Vertices[k], facet.Vertices[(k + 1) & 3] });
    }
  }
  const std::size_t count = this->Facets.size();
  for (std::size_t q = 0; q < count; ++q)
  {
    if (this->Facets[q].Group == group)
    {
      continue;
    }
    const Quad vertices = this->Facets[q].Vertices;
    for (int k = 0; k < 4; ++k)
    {
      const Index a = vertices[k];
      const Index b = vertices[(k + 1) & 3];
      if (ofGroup.count({ b, a }) > 0)
      {
        Facet side = this->Facets[q];
        side.Vertices = { a, b, copies[b], copies[a] };
        this->Facets.push_back(side);
      }
      this->Facets[q].Vertices[k] = copies[a] < 0 ? a : copies[a];
    }
  }
}

/// A curve between other groups that ends at this one: its corner stays, the layer adds an edge.
void LayerBuilder::ExtendPaths(int group, const std::vector<Index>& copies)
{
  for (std::size_t c = 0; c < this->GroupsOfCurve.size(); ++c)
  {
    std::vector<Index>& path = this->Features->CurvePaths[c];
    if (path.size() < 2 || this->GroupsOfCurve[c][0] == group || this->GroupsOfCurve[c][1] == group)
    {
      continue;
    }
    if (const Index copy = copies[path.front()]; copy >= 0)
    {
      path.insert(path.begin() + 1, copy);
    }
    if (const Index copy = copies[path.back()]; copy >= 0)
    {
      path.insert(path.end() - 1, copy);
    }
  }
}

void LayerBuilder::Finish()
{
  this->Padded.OnBoundary.assign(this->Padded.Mesh.Points.size(), 0);
  for (const Facet& facet : this->Facets)
  {
    for (Index v : facet.Vertices)
    {
      this->Padded.OnBoundary[v] = 1;
    }
  }
  const std::vector<Index> rank = OrderInSpace(this->Padded);
  if (this->Features)
  {
    QuadPatches patches;
    for (const Facet& facet : this->Facets)
    {
      patches.Add(facet.Vertices, facet.Patch);
    }
    patches.Renumber(rank);
    this->Features->PatchOfQuad = patches.Of(HexStars(this->Padded.Mesh).Quads);
    RenumberFeatures(rank, *this->Features);
  }
}
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
    codes[i] = MortonCode(static_cast<std::uint64_t>(local[0]),
      static_cast<std::uint64_t>(local[1]), static_cast<std::uint64_t>(local[2]));
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
  const PaddingOptions& options, PaddedMesh& padded, HexFeatures* features,
  const FeatureGeometry* geometry)
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
  if (Status status = features ? CheckFeatures(*features, quads, geometry) : Status();
      !status.Ok())
  {
    return status;
  }
  LayerBuilder builder(mesh, region, quads, options.Thickness, padded);
  if (features)
  {
    builder.UseFeatures(*features, geometry);
  }
  for (int group = 0; group < builder.NumberOfGroups(); ++group)
  {
    if (options.EveryGroup || builder.NeedsLayer(group))
    {
      builder.AddLayer(group);
    }
  }
  builder.Finish();
  return Status();
}
}

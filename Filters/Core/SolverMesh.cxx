// SPDX-License-Identifier: BSD-3-Clause
#include "SolverMesh.h"

#include <algorithm>

namespace featurehex
{
namespace
{
template <std::size_t Size>
std::array<Index, Size> Sorted(std::array<Index, Size> ids)
{
  std::sort(ids.begin(), ids.end());
  return ids;
}

/// Parts (faces or edges) of all hexes by their sorted corners: where to find them.
template <std::size_t Size>
class PartTable
{
public:
  using Key = std::array<Index, Size>;
  struct Entry
  {
    Key Corners;
    Index Hex;
    int Part;
    bool operator<(const Entry& other) const
    {
      return this->Corners != other.Corners ? this->Corners < other.Corners : this->Hex < other.Hex;
    }
  };

  template <std::size_t Count>
  PartTable(const SolverMesh& mesh, const int (&parts)[Count][Size])
  {
    this->Entries.reserve(static_cast<std::size_t>(mesh.NumberOfHexes()) * Count);
    for (Index hex = 0; hex < mesh.NumberOfHexes(); ++hex)
    {
      for (std::size_t part = 0; part < Count; ++part)
      {
        Key key;
        for (std::size_t k = 0; k < Size; ++k)
        {
          key[k] = mesh.Nodes(hex)[parts[part][k]];
        }
        this->Entries.push_back({ Sorted(key), hex, static_cast<int>(part) });
      }
    }
    std::sort(this->Entries.begin(), this->Entries.end());
  }

  /// Of several the one of the lowest hex; null: the mesh has no such part.
  const Entry* Find(const Key& sortedCorners) const
  {
    const auto at =
      std::lower_bound(this->Entries.begin(), this->Entries.end(), Entry{ sortedCorners, -1, 0 });
    return at != this->Entries.end() && at->Corners == sortedCorners ? &*at : nullptr;
  }

  std::vector<Entry> Entries;
};

/// Patch of all points of a face that lie in one; -1: they disagree or don't know.
std::int32_t PatchOfPoints(const Quad& corners, const std::vector<std::int32_t>& patchOfPoint)
{
  std::int32_t patch = -1;
  for (Index v : corners)
  {
    const std::int32_t own = patchOfPoint.empty() ? 0 : patchOfPoint[v];
    if (own >= 0 && patch >= 0 && own != patch)
    {
      return -1;
    }
    patch = std::max(patch, own);
  }
  return patch;
}

void AddSides(const SolverLabels& labels, SolverMesh& mesh)
{
  const PartTable<4> faces(mesh, HexFaces);
  std::map<Quad, std::int32_t> patches;
  std::int32_t highest = -1;
  for (std::size_t q = 0; q < labels.Quads.size(); ++q)
  {
    patches.emplace(Sorted(labels.Quads[q]), labels.Patches[q]);
    highest = std::max(highest, labels.Patches[q]);
  }
  const auto& entries = faces.Entries;
  std::vector<std::size_t> unknown;
  for (std::size_t first = 0, last = 0; first < entries.size(); first = last)
  {
    while (last < entries.size() && entries[last].Corners == entries[first].Corners)
    {
      ++last;
    }
    const auto given = patches.find(entries[first].Corners);
    const bool boundary = last == first + 1;
    if (given != patches.end())
    {
      mesh.Sides.push_back({ entries[first].Hex, entries[first].Part, given->second });
    }
    else if (boundary)
    {
      const std::int32_t patch = PatchOfPoints(entries[first].Corners, labels.PatchOfPoint);
      highest = std::max(highest, patch);
      if (patch < 0)
      {
        unknown.push_back(mesh.Sides.size());
      }
      mesh.Sides.push_back({ entries[first].Hex, entries[first].Part, patch });
    }
  }
  for (std::size_t side : unknown)
  {
    mesh.Sides[side].Patch = highest + 1;
  }
  std::sort(mesh.Sides.begin(), mesh.Sides.end(),
    [](const SolverMesh::Side& a, const SolverMesh::Side& b)
    { return a.Hex != b.Hex ? a.Hex < b.Hex : a.Face < b.Face; });
}

void AddSegments(const SolverLabels& labels, SolverMesh& mesh)
{
  if (labels.Edges.empty())
  {
    return;
  }
  const PartTable<2> edges(mesh, HexEdges);
  for (std::size_t e = 0; e < labels.Edges.size(); ++e)
  {
    if (const auto* entry = edges.Find(Sorted(labels.Edges[e])))
    {
      mesh.Segments.push_back({ entry->Hex, entry->Part, labels.Curves[e] });
    }
  }
}

Status CheckHexes(const SolverMesh& mesh)
{
  if (mesh.HexNodes.empty())
  {
    return Status(StatusCode::EmptySurface, "There are no hexahedra to write.");
  }
  const Index count = static_cast<Index>(mesh.Points.size());
  const bool lengths = mesh.HexNodes.size() % static_cast<std::size_t>(mesh.NodesPerHex) == 0 &&
                       mesh.Regions.size() == static_cast<std::size_t>(mesh.NumberOfHexes());
  if (!lengths || std::any_of(mesh.HexNodes.begin(), mesh.HexNodes.end(),
                    [count](Index v) { return v < 0 || v >= count; }))
  {
    return Status(
      StatusCode::IndexOutOfRange, "The mesh to write refers to points that do not exist.");
  }
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    if (!mesh.Points[i].allFinite())
    {
      return Status(StatusCode::NonFinite,
        "Point " + std::to_string(i) + " of the mesh to write is not finite.");
    }
  }
  return {};
}

template <typename Item, typename Nodes>
std::vector<Index> PointsOf(
  const std::vector<Item>& items, const std::vector<Index>& chosen, const Nodes& nodes)
{
  std::vector<Index> points;
  for (Index i : chosen)
  {
    const std::vector<Index> own = nodes(items[i]);
    points.insert(points.end(), own.begin(), own.end());
  }
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  return points;
}
} // namespace

std::vector<Index> NodesOfSegment(const SolverMesh& mesh, Index hex, int edge)
{
  const Index* nodes = mesh.Nodes(hex);
  std::vector<Index> result = { nodes[HexEdges[edge][0]], nodes[HexEdges[edge][1]] };
  if (mesh.NodesPerHex > 8)
  {
    result.push_back(nodes[8 + edge]);
  }
  return result;
}

std::vector<Index> NodesOfSide(const SolverMesh& mesh, Index hex, int face)
{
  const Index* nodes = mesh.Nodes(hex);
  std::vector<Index> result;
  for (int corner : HexFaces[face])
  {
    result.push_back(nodes[corner]);
  }
  for (int k = 0; k < 4 && mesh.NodesPerHex > 8; ++k)
  {
    const int a = HexFaces[face][k], b = HexFaces[face][(k + 1) % 4];
    int edge = 0;
    while (std::min(a, b) != std::min(HexEdges[edge][0], HexEdges[edge][1]) ||
           std::max(a, b) != std::max(HexEdges[edge][0], HexEdges[edge][1]))
    {
      ++edge;
    }
    result.push_back(nodes[8 + edge]);
  }
  if (mesh.NodesPerHex == 27)
  {
    result.push_back(nodes[20 + face]);
  }
  return result;
}

Status LabelSolverMesh(const SolverLabels& labels, SolverMesh& mesh)
{
  mesh.Sides.clear();
  mesh.Segments.clear();
  mesh.Corners.clear();
  Status status = CheckHexes(mesh);
  if (!status.Ok())
  {
    return status;
  }
  AddSides(labels, mesh);
  AddSegments(labels, mesh);
  mesh.Corners = labels.Corners;
  return CheckSolverMesh(mesh);
}

Status CheckSolverMesh(const SolverMesh& mesh)
{
  Status status = CheckHexes(mesh);
  const Index hexes = mesh.NumberOfHexes();
  const Index points = static_cast<Index>(mesh.Points.size());
  const auto within = [](Index i, Index count) { return i >= 0 && i < count; };
  bool good = true;
  for (const SolverMesh::Side& side : mesh.Sides)
  {
    good = good && within(side.Hex, hexes) && within(side.Face, 6);
  }
  for (const SolverMesh::Segment& segment : mesh.Segments)
  {
    good = good && within(segment.Hex, hexes) && within(segment.Edge, 12);
  }
  for (const SolverMesh::Corner& corner : mesh.Corners)
  {
    good = good && within(corner.Point, points);
  }
  return !status.Ok() || good
           ? status
           : Status(StatusCode::IndexOutOfRange,
               "The mesh to write refers to faces, edges or corners that do not exist.");
}

SolverGroups::SolverGroups(const SolverMesh& mesh)
{
  for (std::size_t i = 0; i < mesh.Regions.size(); ++i)
  {
    this->Bodies[mesh.Regions[i]].push_back(static_cast<Index>(i));
  }
  for (std::size_t i = 0; i < mesh.Sides.size(); ++i)
  {
    this->Patches[mesh.Sides[i].Patch].push_back(static_cast<Index>(i));
  }
  for (std::size_t i = 0; i < mesh.Segments.size(); ++i)
  {
    this->Curves[mesh.Segments[i].Curve].push_back(static_cast<Index>(i));
  }
  for (std::size_t i = 0; i < mesh.Corners.size(); ++i)
  {
    this->Corners[mesh.Corners[i].Id].push_back(static_cast<Index>(i));
  }
}

std::string GroupName(const char* kind, std::int32_t label)
{
  const auto value = static_cast<std::int64_t>(label);
  return std::string(kind) + (value < 0 ? "_n" : "_") + std::to_string(value < 0 ? -value : value);
}

std::vector<Index> PointsOfSides(const SolverMesh& mesh, const std::vector<Index>& sides)
{
  return PointsOf(mesh.Sides, sides,
    [&](const SolverMesh::Side& side) { return NodesOfSide(mesh, side.Hex, side.Face); });
}

std::vector<Index> PointsOfSegments(const SolverMesh& mesh, const std::vector<Index>& segments)
{
  return PointsOf(mesh.Segments, segments,
    [&](const SolverMesh::Segment& segment)
    { return NodesOfSegment(mesh, segment.Hex, segment.Edge); });
}
} // namespace featurehex

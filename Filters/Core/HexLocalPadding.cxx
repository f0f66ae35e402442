// SPDX-License-Identifier: BSD-3-Clause
#include "HexLocalPadding.h"

#include "DisjointSets.h"
#include "FeatureSectors.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace featurehex
{
namespace
{
constexpr double Degrees = 180 / 3.14159265358979323846;

/// Finds the quads to pad and groups them.
class DegenerateQuads
{
public:
  DegenerateQuads(const HexStars& stars, const HexFeatures& features,
    const FeatureGeometry& geometry, const LocalPaddingOptions& options)
    : Stars(stars)
    , Labels(features, stars)
    , Geometry(geometry)
    , Options(options)
    , Graph(stars.Quads, stars.Hexes.size())
    , Sectors(this->Graph, features)
  {
  }

  /// Group of each boundary quad, 1 and up; 0: not padded.
  std::vector<Index> Groups(LocalPaddingReport& report) const;

  /// For face f of hex h at [6 h + f]: it stands under a feature edge with padded quads on both
  /// sides. The hexes beside an edge that ends at a crease may be padded for their other quads: a
  /// wall there would end inside the group.
  std::vector<char> FacesUnderCurves(const HexMesh& mesh, const std::vector<Index>& groups,
    const std::vector<Index>& groupOfHex) const;

private:
  template <typename Visitor>
  void VisitSectors(const Visitor& visit) const;
  bool Degenerate(Index incoming, Index outgoing) const;
  /// A crease with one hex: both quads belong to it.
  bool OneHexAt(Index dart) const
  {
    return this->Stars.QuadOwners[dart / 4] ==
      this->Stars.QuadOwners[this->Graph.Opposite(dart) / 4];
  }
  void ChooseCrowded(std::vector<char>& chosen) const;
  bool CompleteSectors(std::vector<char>& chosen) const;
  void LeaveFreeEnds(std::vector<char>& chosen) const;

  const HexStars& Stars;
  FeatureLabels Labels;
  const FeatureGeometry& Geometry;
  const LocalPaddingOptions& Options;
  QuadGraph Graph;
  FeatureSectors Sectors;
};

/// Both are consecutive sides of one quad.
bool DegenerateQuads::Degenerate(Index incoming, Index outgoing) const
{
  if (this->Sectors.CurveOf(incoming) < 0 || this->Sectors.CurveOf(outgoing) < 0 ||
    this->OneHexAt(incoming) || this->OneHexAt(outgoing))
  {
    return false;
  }
  const Index v = this->Graph.Head(incoming);
  if (this->Labels.Kind[v] != FeatureKind::Corner)
  {
    return true;
  }
  return this->Sectors.AngleAt(this->Labels.Id[v], outgoing, this->Geometry) * Degrees >
    this->Options.WidestAngle;
}

/// Visits (first dart, quads) of each sector: the quads between two consecutive feature edges at a
/// vertex, on the left of the first.
template <typename Visitor>
void DegenerateQuads::VisitSectors(const Visitor& visit) const
{
  for (Index d = 0; d < this->Graph.NumberOfDarts(); ++d)
  {
    if (this->Sectors.CurveOf(d) >= 0)
    {
      // The free end of a curve has no sectors.
      if (const std::vector<Index> quads = this->Sectors.QuadsOf(d); !quads.empty())
      {
        visit(d, quads);
      }
    }
  }
}

/// Many quads in a narrow sector: after padding there are two, and the crowd is round a free
/// vertex.
void DegenerateQuads::ChooseCrowded(std::vector<char>& chosen) const
{
  this->VisitSectors([&](Index outgoing, const std::vector<Index>& quads) {
    const Index v = this->Graph.Tail(outgoing);
    const double angle = this->Labels.Kind[v] == FeatureKind::Corner
      ? this->Sectors.AngleAt(this->Labels.Id[v], outgoing, this->Geometry) * Degrees
      : 180.0;
    if (quads.size() > 2 && angle > 0 && angle < this->Options.NarrowestAngle * quads.size())
    {
      for (Index q : quads)
      {
        chosen[q] = 1;
      }
    }
  });
}

/// A group that takes some quads of a sector would add one to those left: it takes all. False:
/// nothing to do.
bool DegenerateQuads::CompleteSectors(std::vector<char>& chosen) const
{
  bool changed = false;
  this->VisitSectors([&](Index, const std::vector<Index>& quads) {
    const auto taken = std::count_if(
      quads.begin(), quads.end(), [&](Index q) { return chosen[q] != 0; });
    if (quads.size() > 2 && taken > 0 && taken < static_cast<std::ptrdiff_t>(quads.size()))
    {
      changed = true;
      for (Index q : quads)
      {
        chosen[q] = 1;
      }
    }
  });
  return changed;
}

/// A group that goes round the free end of a curve would fold its ring there: what isn't beside the
/// curve stays out.
void DegenerateQuads::LeaveFreeEnds(std::vector<char>& chosen) const
{
  for (Index d = 0; d < this->Graph.NumberOfDarts(); ++d)
  {
    Index next = this->Graph.Rotate(d);
    while (this->Sectors.CurveOf(next) < 0 && next != d)
    {
      next = this->Graph.Rotate(next);
    }
    if (this->Sectors.CurveOf(d) < 0 || next != d)
    {
      continue;
    }
    const Index right = this->Graph.Opposite(d) / 4;
    for (next = this->Graph.Rotate(d); next != d; next = this->Graph.Rotate(next))
    {
      if (next / 4 != right)
      {
        chosen[next / 4] = 0;
      }
    }
  }
}

std::vector<char> DegenerateQuads::FacesUnderCurves(const HexMesh& mesh,
  const std::vector<Index>& groups, const std::vector<Index>& groupOfHex) const
{
  std::vector<char> under(6 * mesh.Hexes.size(), 0);
  const auto padded = [&](Index dart) {
    const Index group = groups[dart / 4];
    return group > 0 && groupOfHex[this->Stars.QuadOwners[dart / 4]] == group;
  };
  for (Index d = 0; d < this->Graph.NumberOfDarts(); ++d)
  {
    if (this->Sectors.CurveOf(d) < 0 || !padded(d) || !padded(this->Graph.Opposite(d)))
    {
      continue;
    }
    const Index owner = this->Stars.QuadOwners[d / 4];
    const Quad& quad = this->Stars.Quads[d / 4];
    for (int f = 0; f < 6; ++f)
    {
      bool tail = false;
      bool head = false;
      int ofQuad = 0;
      for (int k : HexFaces[f])
      {
        const Index v = mesh.Hexes[owner][k];
        tail = tail || v == this->Graph.Tail(d);
        head = head || v == this->Graph.Head(d);
        ofQuad += std::find(quad.begin(), quad.end(), v) != quad.end() ? 1 : 0;
      }
      under[6 * owner + f] = under[6 * owner + f] || (tail && head && ofQuad == 2);
    }
  }
  return under;
}

std::vector<Index> DegenerateQuads::Groups(LocalPaddingReport& report) const
{
  const Index count = static_cast<Index>(this->Stars.Quads.size());
  std::vector<char> chosen(count, 0);
  for (Index q = 0; q < count; ++q)
  {
    bool degenerate = false;
    for (int k = 0; k < 4; ++k)
    {
      degenerate = degenerate || this->Degenerate(4 * q + k, 4 * q + ((k + 1) & 3));
    }
    if (!degenerate)
    {
      continue;
    }
    ++report.DegenerateQuads;
    chosen[q] = 1;
    for (Index v : this->Stars.Quads[q])
    {
      if (this->Labels.Kind[v] == FeatureKind::Surface)
      {
        for (Index other : this->Stars.QuadsOfVertex[v])
        {
          chosen[other] = 1;
        }
      }
    }
  }
  this->ChooseCrowded(chosen);
  while (this->CompleteSectors(chosen))
  {
  }
  this->LeaveFreeEnds(chosen);
  DisjointSets sets(count);
  for (Index d = 0; d < this->Graph.NumberOfDarts(); ++d)
  {
    const Index other = this->Graph.Opposite(d) / 4;
    if (this->Sectors.CurveOf(d) < 0 && chosen[d / 4] && chosen[other])
    {
      sets.Join(d / 4, other);
    }
  }
  std::vector<Index> groups(count, 0);
  std::map<Index, Index> number;
  for (Index q = 0; q < count; ++q)
  {
    if (chosen[q])
    {
      groups[q] =
        number.emplace(sets.Find(q), static_cast<Index>(number.size()) + 1).first->second;
    }
  }
  report.Regions = static_cast<Index>(number.size());
  return groups;
}

/// Shrinks groups of hexes away from each other and from the rest, and fills the gaps.
class Pillow
{
public:
  /// @a walls: as FacesUnderCurves(): hexes of one group are shrunk away from each other there,
  /// too.
  Pillow(PaddedMesh& padded, HexFeatures& features, const HexStars& stars,
    const std::vector<Index>& groupOfHex, const std::vector<char>& walls, double thickness)
    : Padded(padded)
    , Features(features)
    , Stars(stars)
    , Groups(groupOfHex)
    , Walls(walls)
    , Thickness(thickness)
    , Neighbors(FaceNeighbors(padded.Mesh.Hexes, stars.Hexes))
  {
  }

  void Apply();

private:
  bool OnHull(Index hex, int face) const
  {
    const Index other = this->Neighbors[hex][face];
    return other >= 0 &&
      (this->Groups[other] != this->Groups[hex] || this->Walls[6 * hex + face]);
  }
  void CopyVertex(Index v);
  Vec3 Center(Index hex) const;
  void CollectPatches();
  void ExtendPaths();
  Index CopyIn(Index hex, Index v) const
  {
    const Hex& old = this->Padded.Mesh.Hexes[hex];
    return this->Copies[hex][std::find(old.begin(), old.end(), v) - old.begin()];
  }

  PaddedMesh& Padded;
  HexFeatures& Features;
  const HexStars& Stars;
  const std::vector<Index>& Groups;
  const std::vector<char>& Walls;
  double Thickness;
  std::vector<std::array<Index, 6>> Neighbors;
  std::vector<std::array<Index, 8>> Copies; ///< of each hex: its vertices afterwards
  QuadPatches Patches;                      ///< of the boundary afterwards
};

Vec3 Pillow::Center(Index hex) const
{
  Vec3 center = Vec3::Zero();
  for (Index v : this->Padded.Mesh.Hexes[hex])
  {
    center += 0.125 * this->Padded.Mesh.Points[v];
  }
  return center;
}

/// Each fan of hexes of one group at the vertex that has a face on the hull gets its own copy.
void Pillow::CopyVertex(Index v)
{
  const auto hexes = this->Stars.Hexes[v];
  std::vector<char> done(hexes.size(), 0);
  for (Index i = 0; i < hexes.size(); ++i)
  {
    if (done[i] || this->Groups[hexes[i]] == 0)
    {
      continue;
    }
    std::vector<Index> fan = { i };
    done[i] = 1;
    bool hull = false;
    for (std::size_t next = 0; next < fan.size(); ++next)
    {
      const Index h = hexes[fan[next]];
      const Hex& hex = this->Padded.Mesh.Hexes[h];
      for (int f = 0; f < 6; ++f)
      {
        const int* face = HexFaces[f];
        if (hex[face[0]] != v && hex[face[1]] != v && hex[face[2]] != v && hex[face[3]] != v)
        {
          continue;
        }
        hull = hull || this->OnHull(h, f);
        for (Index j = 0; j < hexes.size(); ++j)
        {
          if (!done[j] && hexes[j] == this->Neighbors[h][f] && !this->OnHull(h, f))
          {
            done[j] = 1;
            fan.push_back(j);
          }
        }
      }
    }
    if (!hull)
    {
      continue;
    }
    Vec3 center = Vec3::Zero();
    for (Index member : fan)
    {
      center += this->Center(hexes[member]) / static_cast<double>(fan.size());
    }
    const Index copy = static_cast<Index>(this->Padded.Mesh.Points.size());
    const Vec3 p = this->Padded.Mesh.Points[v];
    this->Padded.Mesh.Points.push_back(p + this->Thickness * (center - p));
    this->Padded.SourcePoint.push_back(this->Padded.SourcePoint[v]);
    this->Padded.OnBoundary.push_back(this->Padded.OnBoundary[v]);
    for (Index member : fan)
    {
      this->Copies[hexes[member]][this->Stars.Corners[this->Stars.Hexes.Offsets[v] + member]] =
        copy;
    }
  }
}

/// Boundary quads move with their hexes; where a layer comes to the surface it belongs to the patch
/// of the quad beside it.
void Pillow::CollectPatches()
{
  for (std::size_t q = 0; q < this->Stars.Quads.size(); ++q)
  {
    const Quad& old = this->Stars.Quads[q];
    const Index hex = this->Stars.QuadOwners[q];
    Quad quad;
    for (int k = 0; k < 4; ++k)
    {
      quad[k] = this->CopyIn(hex, old[k]);
    }
    this->Patches.Add(quad, this->Features.PatchOfQuad[q]);
    for (int k = 0; k < 4; ++k)
    {
      const int next = (k + 1) & 3;
      if (quad[k] != old[k] && quad[next] != old[next])
      {
        this->Patches.Add(
          { quad[k], quad[next], old[next], old[k] }, this->Features.PatchOfQuad[q]);
      }
    }
  }
}

/// Where the rim of a group crosses a curve, a vertex of its path becomes an edge.
void Pillow::ExtendPaths()
{
  const QuadGraph graph(this->Stars.Quads, this->Stars.Hexes.size());
  for (std::vector<Index>& path : this->Features.CurvePaths)
  {
    std::vector<Index> longer;
    const auto append = [&longer](Index v) {
      if (longer.empty() || longer.back() != v)
      {
        longer.push_back(v);
      }
    };
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      const Index dart = graph.Find(path[i - 1], path[i]);
      const Index left = this->Stars.QuadOwners[dart / 4];
      const Index right = this->Stars.QuadOwners[graph.Opposite(dart) / 4];
      const Index from = this->CopyIn(left, path[i - 1]);
      const Index to = this->CopyIn(left, path[i]);
      append(path[i - 1]);
      if (from == this->CopyIn(right, path[i - 1]) && to == this->CopyIn(right, path[i]))
      {
        append(from);
        append(to);
      }
      append(path[i]);
    }
    path = std::move(longer);
  }
}

void Pillow::Apply()
{
  HexMesh& mesh = this->Padded.Mesh;
  this->Copies.assign(mesh.Hexes.begin(), mesh.Hexes.end());
  const Index vertices = static_cast<Index>(mesh.Points.size());
  for (Index v = 0; v < vertices; ++v)
  {
    this->CopyVertex(v);
  }
  this->CollectPatches();
  this->ExtendPaths();
  const Index count = static_cast<Index>(mesh.Hexes.size());
  for (Index h = 0; h < count; ++h)
  {
    for (int f = 0; f < 6 && this->Groups[h] > 0; ++f)
    {
      if (!this->OnHull(h, f))
      {
        continue;
      }
      Hex hex;
      for (int k = 0; k < 4; ++k)
      {
        hex[k] = this->Copies[h][HexFaces[f][k]];
        hex[4 + k] = mesh.Hexes[h][HexFaces[f][k]];
      }
      mesh.Hexes.push_back(hex);
      this->Padded.Region.push_back(this->Padded.Region[h]);
      this->Padded.IsLayer.push_back(1);
      this->Padded.SourceHex.push_back(this->Padded.SourceHex[h]);
    }
  }
  for (Index h = 0; h < count; ++h)
  {
    mesh.Hexes[h] = this->Copies[h];
  }
  const std::vector<Index> rank = OrderInSpace(this->Padded);
  RenumberFeatures(rank, this->Features);
  this->Patches.Renumber(rank);
  this->Features.PatchOfQuad = this->Patches.Of(HexStars(mesh).Quads);
}
}

LocalPaddingReport PadDegenerateQuads(PaddedMesh& padded, HexFeatures& features,
  const FeatureGeometry& geometry, const LocalPaddingOptions& options)
{
  LocalPaddingReport report;
  const HexStars stars(padded.Mesh);
  const DegenerateQuads degenerate(stars, features, geometry, options);
  const std::vector<Index> groups = degenerate.Groups(report);
  if (report.Regions == 0)
  {
    return report;
  }
  std::vector<Index> groupOfHex(padded.Mesh.Hexes.size(), 0);
  for (std::size_t q = 0; q < groups.size(); ++q)
  {
    Index& group = groupOfHex[stars.QuadOwners[q]];
    group = std::max(group, groups[q]);
  }
  const std::size_t before = padded.Mesh.Hexes.size();
  Pillow(padded, features, stars, groupOfHex,
    degenerate.FacesUnderCurves(padded.Mesh, groups, groupOfHex), options.Thickness)
    .Apply();
  report.AddedHexes = static_cast<Index>(padded.Mesh.Hexes.size() - before);
  return report;
}
} // namespace featurehex

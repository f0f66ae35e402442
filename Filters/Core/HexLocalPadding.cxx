// SPDX-License-Identifier: BSD-3-Clause
#include "HexLocalPadding.h"

#include "DisjointSets.h"
#include "QuadGraph.h"

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
    , CurveOfDart(this->Graph.NumberOfDarts(), -1)
  {
    for (std::size_t c = 0; c < features.CurvePaths.size(); ++c)
    {
      const std::vector<Index>& path = features.CurvePaths[c];
      for (std::size_t i = 1; i < path.size(); ++i)
      {
        const Index dart = this->Graph.Find(path[i - 1], path[i]);
        this->CurveOfDart[dart] = this->CurveOfDart[this->Graph.Opposite(dart)] =
          static_cast<Index>(c);
      }
    }
  }

  /// Group of each boundary quad, 1 and up; 0: not padded.
  std::vector<Index> Groups(LocalPaddingReport& report) const;

private:
  bool Degenerate(Index incoming, Index outgoing) const;
  double SectorAngle(Index corner, Index outgoing, Index incoming) const;

  const HexStars& Stars;
  FeatureLabels Labels;
  const FeatureGeometry& Geometry;
  const LocalPaddingOptions& Options;
  QuadGraph Graph;
  std::vector<Index> CurveOfDart; ///< -1: no feature edge
};

/// Angle of the surface between the curve that leaves the corner along @a outgoing and, counter-clockwise, the one
/// that arrives along @a incoming.
double DegenerateQuads::SectorAngle(Index corner, Index outgoing, Index incoming) const
{
  const CornerFan& fan = this->Geometry.Fans()[corner];
  const Index first = this->CurveOfDart[outgoing];
  const Index second = this->CurveOfDart[incoming];
  for (std::size_t i = 0; i < fan.Spokes.size(); ++i)
  {
    const CornerFan::Spoke& spoke = fan.Spokes[i];
    const std::size_t next = (i + 1) % fan.Spokes.size();
    if (spoke.Curve == first && fan.Spokes[next].Curve == second)
    {
      const double angle = fan.Spokes[next].Angle - spoke.Angle;
      return angle > 0 ? angle : angle + fan.FullAngle;
    }
  }
  return 0;
}

/// Both are consecutive sides of one quad.
bool DegenerateQuads::Degenerate(Index incoming, Index outgoing) const
{
  if (this->CurveOfDart[incoming] < 0 || this->CurveOfDart[outgoing] < 0)
  {
    return false;
  }
  const Index v = this->Graph.Head(incoming);
  if (this->Labels.Kind[v] != FeatureKind::Corner)
  {
    return true;
  }
  return this->SectorAngle(this->Labels.Id[v], outgoing, incoming) * Degrees >
    this->Options.WidestAngle;
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
  DisjointSets sets(count);
  for (Index d = 0; d < this->Graph.NumberOfDarts(); ++d)
  {
    const Index other = this->Graph.Opposite(d) / 4;
    if (this->CurveOfDart[d] < 0 && chosen[d / 4] && chosen[other])
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
  Pillow(PaddedMesh& padded, const HexStars& stars, const std::vector<Index>& groupOfHex,
    double thickness)
    : Padded(padded)
    , Stars(stars)
    , Groups(groupOfHex)
    , Thickness(thickness)
    , Neighbors(FaceNeighbors(padded.Mesh.Hexes, stars.Hexes))
  {
  }

  void Apply();

private:
  bool OnHull(Index hex, int face) const
  {
    const Index other = this->Neighbors[hex][face];
    return other >= 0 && this->Groups[other] != this->Groups[hex];
  }
  void CopyVertex(Index v);
  Vec3 Center(Index hex) const;

  PaddedMesh& Padded;
  const HexStars& Stars;
  const std::vector<Index>& Groups;
  double Thickness;
  std::vector<std::array<Index, 6>> Neighbors;
  std::vector<std::array<Index, 8>> Copies; ///< of each hex: its vertices afterwards
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
      this->Copies[hexes[member]][this->Stars.Corners[this->Stars.Hexes.Offsets[v] + member]] = copy;
    }
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
      this->Padded.SourceQuad.push_back(this->Padded.SourceQuad[h]);
    }
  }
  for (Index h = 0; h < count; ++h)
  {
    mesh.Hexes[h] = this->Copies[h];
  }
}
}

HexFeatures FeaturesOfPaddedMesh(
  const HexFeatures& interface, const PaddedMesh& padded, const HexStars& stars)
{
  std::map<Index, Index> boundaryPoint;
  for (std::size_t v = 0; v < padded.SourcePoint.size(); ++v)
  {
    if (padded.OnBoundary[v])
    {
      boundaryPoint[padded.SourcePoint[v]] = static_cast<Index>(v);
    }
  }
  HexFeatures features = interface;
  for (Index& v : features.CornerVertices)
  {
    v = v < 0 ? -1 : boundaryPoint.at(v);
  }
  for (std::vector<Index>& path : features.CurvePaths)
  {
    for (Index& v : path)
    {
      v = boundaryPoint.at(v);
    }
  }
  features.PatchOfQuad.clear();
  for (Index owner : stars.QuadOwners)
  {
    features.PatchOfQuad.push_back(interface.PatchOfQuad[padded.SourceQuad[owner]]);
  }
  return features;
}

LocalPaddingReport PadDegenerateQuads(PaddedMesh& padded, HexFeatures& features,
  const FeatureGeometry& geometry, const LocalPaddingOptions& options)
{
  LocalPaddingReport report;
  const HexStars stars(padded.Mesh);
  const std::vector<Index> groups =
    DegenerateQuads(stars, features, geometry, options).Groups(report);
  if (report.Regions == 0)
  {
    return report;
  }
  std::vector<Index> groupOfHex(padded.Mesh.Hexes.size(), 0);
  // New hexes inherit the source quad of the hex they surround, and so its patch.
  std::vector<int> patchOfSource;
  for (std::size_t q = 0; q < groups.size(); ++q)
  {
    groupOfHex[stars.QuadOwners[q]] = groups[q];
    const std::size_t source = padded.SourceQuad[stars.QuadOwners[q]];
    patchOfSource.resize(std::max(patchOfSource.size(), source + 1), -1);
    patchOfSource[source] = features.PatchOfQuad[q];
  }
  const std::size_t before = padded.Mesh.Hexes.size();
  Pillow(padded, stars, groupOfHex, options.Thickness).Apply();
  report.AddedHexes = static_cast<Index>(padded.Mesh.Hexes.size() - before);

  const std::vector<Index> rank = OrderInSpace(padded);
  for (Index& v : features.CornerVertices)
  {
    v = v < 0 ? -1 : rank[v];
  }
  for (std::vector<Index>& path : features.CurvePaths)
  {
    for (Index& v : path)
    {
      v = rank[v];
    }
  }
  features.PatchOfQuad.clear();
  for (Index owner : HexStars(padded.Mesh).QuadOwners)
  {
    features.PatchOfQuad.push_back(patchOfSource[padded.SourceQuad[owner]]);
  }
  return report;
}
} // namespace featurehex

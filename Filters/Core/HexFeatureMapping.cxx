// SPDX-License-Identifier: BSD-3-Clause
#include "HexFeatureMapping.h"

#include "ClusterPlacement.h"
#include "CurveRouter.h"
#include "DisjointSets.h"
#include "MessageText.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace featurehex
{
namespace
{
constexpr double WideReach = 2.5; // of the usual reach, when there is nothing within it
constexpr int BesideRings = 3;
constexpr std::size_t LargestCluster = 5;
constexpr double PlaceSpacing = 1.0; // of refinement points along a curve, local edge lengths

/// What the parts of the mapping share.
class Mapper
{
public:
  Mapper(const HexMesh& mesh, const std::vector<InterfaceQuad>& interface,
    const FeatureGeometry& geometry, const FeatureMappingOptions& options, FeatureMapping& mapping)
    : Mesh(mesh)
    , Geometry(geometry)
    , Options(options)
    , Result(mapping)
    , Graph(QuadsOf(interface), mesh.Points.size())
    , Router(
        mesh.Points, this->Graph, geometry, mapping.Features.CornerVertices, options.CurveReach)
  {
  }

  void PlaceCorners();
  void TraceCurves();
  void MatchPatches();

private:
  struct Candidate
  {
    double Cost;
    Index Corner, Vertex;
    bool operator<(const Candidate& other) const
    {
      return std::tie(this->Cost, this->Corner, this->Vertex) <
        std::tie(other.Cost, other.Corner, other.Vertex);
    }
  };

  static std::vector<Quad> QuadsOf(const std::vector<InterfaceQuad>& interface)
  {
    std::vector<Quad> quads;
    for (const InterfaceQuad& quad : interface)
    {
      quads.push_back(quad.Vertices);
    }
    return quads;
  }

  void Fail(FeatureKind kind, Index id, const std::string& reason, std::vector<Vec3> places)
  {
    this->Result.Failures.push_back({ kind, id, reason, std::move(places) });
  }
  void AddCandidates(Index corner, double reach, std::vector<Candidate>& candidates) const;
  void PlaceClusters(const std::vector<std::vector<Candidate>>& candidates);
  std::vector<Vec3> PlacesAlong(Index curve) const;
  std::vector<Vec3> PlacesOfPatch(int patch) const;
  std::vector<Vec3> PlacesBetween(const std::vector<Index>& pieces, Index piece, int patch) const;
  std::vector<int> PatchesBesidePaths() const;
  int NearestOfGroup(int root, const Vec3& p) const;
  Vec3 Center(Index quad) const;
  std::vector<Index> PiecesBetweenPaths() const;

  const HexMesh& Mesh;
  const FeatureGeometry& Geometry;
  const FeatureMappingOptions& Options;
  FeatureMapping& Result;
  QuadGraph Graph;
  CurveRouter Router;
};

Vec3 Mapper::Center(Index quad) const
{
  const Quad& q = this->Graph.Quads()[quad];
  return 0.25 * (this->Mesh.Points[q[0]] + this->Mesh.Points[q[1]] + this->Mesh.Points[q[2]] +
                  this->Mesh.Points[q[3]]);
}

void Mapper::AddCandidates(Index corner, double reach, std::vector<Candidate>& candidates) const
{
  const Vec3& p = this->Geometry.CornerPoint(corner);
  for (Index v = 0; v < static_cast<Index>(this->Mesh.Points.size()); ++v)
  {
    if (this->Graph.Leaving(v) < 0)
    {
      continue;
    }
    const double distance = (this->Mesh.Points[v] - p).norm() / this->Router.SizeAt(v);
    double fit;
    if (distance <= reach)
    {
      this->Router.ArrangeSpokes(corner, v, fit);
      if (fit < 1e300)
      {
        candidates.push_back({ distance * distance + fit, corner, v });
      }
    }
  }
}

void Mapper::PlaceCorners()
{
  const std::size_t count = this->Geometry.Features().Corners.size();
  std::vector<Index>& vertices = this->Result.Features.CornerVertices;
  std::vector<std::vector<Candidate>> candidates(count);
  for (std::size_t c = 0; c < count; ++c)
  {
    const Index corner = static_cast<Index>(c);
    if (this->Geometry.Enforced(corner))
    {
      // At the end of a thin wedge the interface may be far.
      this->AddCandidates(corner, this->Options.CornerReach, candidates[c]);
      if (candidates[c].empty())
      {
        this->AddCandidates(corner, WideReach * this->Options.CornerReach, candidates[c]);
      }
      std::sort(candidates[c].begin(), candidates[c].end());
    }
  }
  this->PlaceClusters(candidates);
  std::vector<Candidate> all;
  std::vector<bool> used(this->Mesh.Points.size(), false);
  for (std::size_t c = 0; c < count; ++c)
  {
    if (vertices[c] >= 0)
    {
      used[vertices[c]] = true;
    }
    all.insert(all.end(), candidates[c].begin(), candidates[c].end());
  }
  std::sort(all.begin(), all.end());
  for (const Candidate& candidate : all)
  {
    if (vertices[candidate.Corner] < 0 && !used[candidate.Vertex])
    {
      vertices[candidate.Corner] = candidate.Vertex;
      used[candidate.Vertex] = true;
    }
  }
  for (std::size_t c = 0; c < count; ++c)
  {
    if (this->Geometry.Enforced(static_cast<Index>(c)) && vertices[c] < 0)
    {
      const Vec3& p = this->Geometry.CornerPoint(static_cast<Index>(c));
      this->Fail(FeatureKind::Corner, static_cast<Index>(c),
        "Corner " + std::to_string(c) + " at " + PlaceText(p) + " with " +
          std::to_string(this->Geometry.Fans()[c].Spokes.size()) +
          " curves has no free vertex with as many edges near it",
        { p });
    }
  }
}

/// Corners that are connected by curves much shorter than the edges: one by one they would take the
/// nearest vertices in any order, and the curves between them would cross.
void Mapper::PlaceClusters(const std::vector<std::vector<Candidate>>& candidates)
{
  const std::size_t count = candidates.size();
  std::vector<std::vector<Index>> neighbors(count);
  DisjointSets sets(count);
  for (std::size_t c = 0; c < this->Geometry.Curves().size(); ++c)
  {
    const EnforcedCurve& curve = this->Geometry.Curves()[c];
    const Index a = curve.FirstCorner;
    const Index b = curve.LastCorner;
    const auto isShort = [&](Index corner) {
      return corner >= 0 && !candidates[corner].empty() &&
        this->Router.IsShort(static_cast<Index>(c), candidates[corner].front().Vertex);
    };
    if (!curve.Points.empty() && a != b && isShort(a) && isShort(b))
    {
      neighbors[a].push_back(b);
      neighbors[b].push_back(a);
      sets.Join(a, b);
    }
  }
  std::map<Index, std::vector<Index>> clusters;
  for (std::size_t c = 0; c < count; ++c)
  {
    if (!neighbors[c].empty())
    {
      clusters[sets.Find(static_cast<Index>(c))].push_back(static_cast<Index>(c));
    }
  }
  std::set<Index> used;
  for (const auto& entry : clusters)
  {
    if (entry.second.size() <= LargestCluster)
    {
      ClusterPlacement placement(this->Mesh.Points, this->Graph, this->Geometry, this->Router,
        this->Result.Features.CornerVertices);
      std::vector<Index> starts;
      const Index root = ClusterPlacement::RootOf(entry.second, neighbors);
      for (const Candidate& candidate : candidates[root])
      {
        starts.push_back(candidate.Vertex);
      }
      placement.Place(root, starts, neighbors, used);
    }
  }
}

std::vector<Vec3> Mapper::PlacesAlong(Index c) const
{
  const EnforcedCurve& curve = this->Geometry.Curves()[c];
  double size = curve.Length();
  for (Index d : this->Router.Paths()[c])
  {
    size = std::min(size, this->Router.SizeAt(this->Graph.Tail(d)));
  }
  if (this->Router.Paths()[c].empty())
  {
    size = curve.Length() / 16;
  }
  std::vector<Vec3> places;
  const int pieces =
    std::clamp(static_cast<int>(curve.Length() / (PlaceSpacing * size)), 2, 1000);
  for (int i = 0; i <= pieces; ++i)
  {
    places.push_back(curve.At(curve.Length() * i / pieces));
  }
  return places;
}

void Mapper::TraceCurves()
{
  const std::vector<Index> failed = this->Router.RouteAll(this->Options.MaximumAttempts);
  this->Result.Reroutes = this->Router.Reroutes();
  for (Index c : failed)
  {
    const EnforcedCurve& curve = this->Geometry.Curves()[c];
    bool cornersPlaced = true;
    for (Index corner : { curve.FirstCorner, curve.LastCorner })
    {
      cornersPlaced =
        cornersPlaced && (corner < 0 || this->Result.Features.CornerVertices[corner] >= 0);
    }
    if (cornersPlaced)
    {
      const std::vector<Vec3>& contested = this->Router.ContestedPlaces(c);
      this->Fail(FeatureKind::Curve, c,
        "Curve " + std::to_string(c) + " from " + PlaceText(curve.Points.front()) + " to " +
          PlaceText(curve.Points.back()) + " finds no way between the others",
        contested.empty() ? this->PlacesAlong(c) : contested);
    }
  }
  std::vector<std::vector<Index>>& paths = this->Result.Features.CurvePaths;
  for (std::size_t c = 0; c < paths.size(); ++c)
  {
    const std::vector<Index>& darts = this->Router.Paths()[c];
    if (!darts.empty())
    {
      paths[c].push_back(this->Graph.Tail(darts.front()));
      for (Index d : darts)
      {
        paths[c].push_back(this->Graph.Head(d));
      }
    }
  }
}

/// For each quad the lowest quad that is connected with it without crossing a path.
std::vector<Index> Mapper::PiecesBetweenPaths() const
{
  std::vector<bool> wall(this->Graph.NumberOfDarts(), false);
  for (const std::vector<Index>& path : this->Router.Paths())
  {
    for (Index d : path)
    {
      wall[d] = wall[this->Graph.Opposite(d)] = true;
    }
  }
  DisjointSets pieces(this->Graph.Quads().size());
  for (Index d = 0; d < this->Graph.NumberOfDarts(); ++d)
  {
    if (!wall[d])
    {
      pieces.Join(d / 4, this->Graph.Opposite(d) / 4);
    }
  }
  std::vector<Index> roots;
  for (std::size_t q = 0; q < this->Graph.Quads().size(); ++q)
  {
    roots.push_back(pieces.Find(static_cast<Index>(q)));
  }
  return roots;
}

std::vector<Vec3> Mapper::PlacesOfPatch(int patch) const
{
  std::vector<Vec3> places;
  const SurfaceMesh& mesh = this->Geometry.Patch(patch).Mesh();
  const std::size_t stride = std::max<std::size_t>(1, mesh.Triangles.size() / 200);
  for (std::size_t t = 0; t < mesh.Triangles.size(); t += stride)
  {
    const Triangle& triangle = mesh.Triangles[t];
    places.push_back(
      (mesh.Points[triangle[0]] + mesh.Points[triangle[1]] + mesh.Points[triangle[2]]) / 3);
  }
  return places;
}

/// Quads on the shortest way, without crossing a path, from those beside paths that bound a patch
/// to those beside paths that bound others, in a piece that should be several. Somewhere on it the
/// interface hangs together where the surface doesn't.
std::vector<Vec3> Mapper::PlacesBetween(
  const std::vector<Index>& pieces, Index piece, int patch) const
{
  std::vector<bool> wall(this->Graph.NumberOfDarts(), false);
  std::map<Index, Index> previous; // of each quad that was reached; itself: a start
  std::set<Index> ends;
  std::vector<Index> reached;
  for (std::size_t c = 0; c < this->Router.Paths().size(); ++c)
  {
    const EnforcedCurve& curve = this->Geometry.Curves()[c];
    for (Index d : this->Router.Paths()[c])
    {
      const Index other = this->Graph.Opposite(d);
      wall[d] = wall[other] = true;
      for (const auto& [quad, side] : { std::make_pair(d / 4, curve.LeftPatch),
             std::make_pair(other / 4, curve.RightPatch) })
      {
        if (pieces[quad] != piece)
        {
          continue;
        }
        if (this->Geometry.PatchOf(side) != patch)
        {
          ends.insert(quad);
        }
        else if (previous.insert({ quad, quad }).second)
        {
          reached.push_back(quad);
        }
      }
    }
  }
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < reached.size() && places.empty(); ++i)
  {
    if (ends.count(reached[i]) > 0)
    {
      Index quad = reached[i];
      places.push_back(this->Center(quad));
      while (previous[quad] != quad)
      {
        quad = previous[quad];
        places.push_back(this->Center(quad));
      }
    }
    for (int k = 0; k < 4; ++k)
    {
      const Index dart = 4 * reached[i] + k;
      const Index next = this->Graph.Opposite(dart) / 4;
      if (!wall[dart] && previous.insert({ next, reached[i] }).second)
      {
        reached.push_back(next);
      }
    }
  }
  return places;
}

void Mapper::MatchPatches()
{
  const std::vector<Index> pieces = this->PiecesBetweenPaths();
  // What the curves say about the pieces on their two sides: (piece, patch) -> (edges, one of the
  // curves).
  std::map<std::pair<Index, int>, std::pair<int, Index>> votes;
  for (std::size_t c = 0; c < this->Router.Paths().size(); ++c)
  {
    const EnforcedCurve& curve = this->Geometry.Curves()[c];
    for (Index d : this->Router.Paths()[c])
    {
      auto& left = votes[{ pieces[d / 4], this->Geometry.PatchOf(curve.LeftPatch) }];
      left = { left.first + 1, static_cast<Index>(c) };
      auto& right = votes[{ pieces[this->Graph.Opposite(d) / 4],
        this->Geometry.PatchOf(curve.RightPatch) }];
      right = { right.first + 1, static_cast<Index>(c) };
    }
  }
  std::map<Index, int> patchOfPiece;
  std::map<Index, int> most;
  for (const auto& [key, vote] : votes)
  {
    int& count = most[key.first];
    if (vote.first > count)
    {
      count = vote.first;
      patchOfPiece[key.first] = key.second;
    }
  }
  for (const auto& [key, vote] : votes)
  {
    if (patchOfPiece[key.first] != key.second)
    {
      this->Fail(FeatureKind::Curve, vote.second,
        "Curve " + std::to_string(vote.second) + " bounds patch " + std::to_string(key.second) +
          ", its path a piece of patch " + std::to_string(patchOfPiece[key.first]),
        this->PlacesBetween(pieces, key.first, key.second));
    }
  }
  const bool mismatched = !this->Result.Complete();
  std::map<int, int> piecesOfPatch;
  for (const auto& [piece, patch] : patchOfPiece)
  {
    ++piecesOfPatch[patch];
  }
  // A component without curves is one patch: the nearest of those that no curve bounds.
  std::vector<int> lonely;
  for (int patch = 0; patch < this->Geometry.Features().NumberOfPatches; ++patch)
  {
    if (this->Geometry.PatchOf(patch) == patch && piecesOfPatch.find(patch) == piecesOfPatch.end())
    {
      lonely.push_back(patch);
    }
  }
  for (Index q = 0; q < static_cast<Index>(pieces.size()); ++q)
  {
    if (patchOfPiece.find(pieces[q]) == patchOfPiece.end())
    {
      double least = 1e300;
      for (int patch : lonely)
      {
        const double distance =
          this->Geometry.Patch(patch).Search().Closest(this->Center(q), -1, least).Distance;
        if (distance < least)
        {
          least = distance;
          patchOfPiece[pieces[q]] = patch;
        }
      }
      if (least < 1e300)
      {
        ++piecesOfPatch[patchOfPiece[pieces[q]]];
      }
      else
      {
        patchOfPiece[pieces[q]] = -1;
        this->Fail(FeatureKind::Surface, -1,
          "A piece of the interface at " + PlaceText(this->Center(q)) + " belongs to no patch",
          { this->Center(q) });
      }
    }
  }
  std::map<int, int> merged; // patches in each group
  for (int patch = 0; patch < this->Geometry.Features().NumberOfPatches; ++patch)
  {
    ++merged[this->Geometry.PatchOf(patch)];
  }
  for (int patch = 0; patch < this->Geometry.Features().NumberOfPatches; ++patch)
  {
    const int count = piecesOfPatch[patch];
    // How merged patches hang together depends on curves that are not enforced.
    if (this->Geometry.PatchOf(patch) == patch && count != 1 && (count == 0 || merged[patch] == 1))
    {
      const std::vector<Vec3> places = this->PlacesOfPatch(patch);
      // Quads that went to another patch have failed above.
      this->Fail(FeatureKind::Surface, patch,
        "Patch " + std::to_string(patch) + " at " + PlaceText(places.front()) + " has " +
          (count == 0 ? "no quads" : std::to_string(count) + " pieces"),
        count == 0 && mismatched ? std::vector<Vec3>() : places);
    }
  }
  // Where patches were merged, the paths tell them apart near the curves.
  const std::vector<int> beside = this->PatchesBesidePaths();
  for (Index q = 0; q < static_cast<Index>(pieces.size()); ++q)
  {
    const int root = patchOfPiece[pieces[q]];
    const bool known = beside[q] >= 0 && this->Geometry.PatchOf(beside[q]) == root;
    this->Result.Features.PatchOfQuad.push_back(
      known || root < 0 ? (known ? beside[q] : -1) : this->NearestOfGroup(root, this->Center(q)));
  }
}

/// Patch of the quads up to BesideRings rings from a path, by the side they are on; -1: farther.
std::vector<int> Mapper::PatchesBesidePaths() const
{
  std::vector<int> patches(this->Graph.Quads().size(), -1);
  std::vector<bool> wall(this->Graph.NumberOfDarts(), false);
  std::vector<Index> front;
  const auto reach = [&](Index quad, int patch, std::vector<Index>& list) {
    if (patches[quad] < 0)
    {
      patches[quad] = patch;
      list.push_back(quad);
    }
  };
  for (std::size_t c = 0; c < this->Router.Paths().size(); ++c)
  {
    const EnforcedCurve& curve = this->Geometry.Curves()[c];
    for (Index d : this->Router.Paths()[c])
    {
      const Index other = this->Graph.Opposite(d);
      wall[d] = wall[other] = true;
      reach(d / 4, curve.LeftPatch, front);
      reach(other / 4, curve.RightPatch, front);
    }
  }
  for (int ring = 1; ring < BesideRings; ++ring)
  {
    std::vector<Index> next;
    for (Index q : front)
    {
      for (int k = 0; k < 4; ++k)
      {
        if (!wall[4 * q + k])
        {
          reach(this->Graph.Opposite(4 * q + k) / 4, patches[q], next);
        }
      }
    }
    front = std::move(next);
  }
  return patches;
}

int Mapper::NearestOfGroup(int root, const Vec3& p) const
{
  int nearest = root;
  double least = 1e300;
  for (int patch = 0; patch < this->Geometry.Features().NumberOfPatches; ++patch)
  {
    if (this->Geometry.PatchOf(patch) != root)
    {
      continue;
    }
    const double distance = this->Geometry.Patch(patch).Search().Closest(p, -1, least).Distance;
    if (distance < least)
    {
      least = distance;
      nearest = patch;
    }
  }
  return nearest;
}
}

Status MapFeaturesToInterface(const HexMesh& mesh, const std::vector<InterfaceQuad>& interface,
  const FeatureGeometry& geometry, const FeatureMappingOptions& options, Monitor& monitor,
  FeatureMapping& mapping)
{
  mapping = FeatureMapping();
  mapping.Features.CornerVertices.assign(geometry.Features().Corners.size(), -1);
  mapping.Features.CurvePaths.resize(geometry.Curves().size());
  Mapper mapper(mesh, interface, geometry, options, mapping);
  mapper.PlaceCorners();
  if (!monitor.Update(0.3))
  {
    return monitor.StopStatus();
  }
  mapper.TraceCurves();
  if (!monitor.Update(0.9))
  {
    return monitor.StopStatus();
  }
  if (mapping.Complete())
  {
    mapper.MatchPatches();
  }
  return Status();
}
} // namespace featurehex

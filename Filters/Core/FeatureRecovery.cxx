// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureRecovery.h"

#include "DisjointSets.h"
#include "PatchValidation.h"
#include "PolylineDistance.h"

#include <algorithm>
#include <map>

namespace featurehex
{
namespace
{
std::vector<Index> CornerVertices(const HexMesh& mesh, const SurfaceMesh& surface,
  const SurfaceFeatures& features, const FeatureLabels& labels)
{
  std::vector<Index> vertices(features.Corners.size(), -1);
  std::vector<double> distances(features.Corners.size(), 1e300);
  for (std::size_t v = 0; v < labels.Kind.size(); ++v)
  {
    const Index corner = labels.Id[v];
    if (labels.Kind[v] == FeatureKind::Corner && corner >= 0 &&
      corner < static_cast<Index>(vertices.size()))
    {
      const double distance =
        (mesh.Points[v] - surface.Points[features.Corners[corner].Point]).norm();
      if (distance < distances[corner])
      {
        vertices[corner] = static_cast<Index>(v);
        distances[corner] = distance;
      }
    }
  }
  return vertices;
}

std::vector<Index> OrderedAlong(const HexMesh& mesh, const SurfaceMesh& surface,
  const FeatureCurve& curve, const std::vector<Index>& vertices)
{
  std::vector<Vec3> points;
  for (Index v : curve.Points)
  {
    points.push_back(surface.Points[v]);
  }
  const Polyline line(std::move(points));
  std::vector<std::pair<double, Index>> order;
  for (Index v : vertices)
  {
    order.emplace_back(line.Closest(mesh.Points[v]).Arc, v);
  }
  std::sort(order.begin(), order.end());
  std::vector<Index> result;
  for (const auto& entry : order)
  {
    result.push_back(entry.second);
  }
  return result;
}

std::vector<std::vector<Index>> CurvePaths(const HexMesh& mesh, const SurfaceMesh& surface,
  const SurfaceFeatures& features, const FeatureLabels& labels, const std::vector<Index>& corners)
{
  std::vector<std::vector<Index>> paths(features.Curves.size());
  for (std::size_t v = 0; v < labels.Kind.size(); ++v)
  {
    const Index curve = labels.Id[v];
    if (labels.Kind[v] == FeatureKind::Curve && curve >= 0 &&
      curve < static_cast<Index>(paths.size()))
    {
      paths[curve].push_back(static_cast<Index>(v));
    }
  }
  for (std::size_t c = 0; c < paths.size(); ++c)
  {
    const FeatureCurve& curve = features.Curves[c];
    std::vector<Index> path = OrderedAlong(mesh, surface, curve, paths[c]);
    const auto end = [&](Index corner) { return corner >= 0 ? corners[corner] : -1; };
    if (curve.FirstCorner < 0 && !path.empty())
    {
      path.push_back(path.front());
    }
    if (end(curve.FirstCorner) >= 0)
    {
      path.insert(path.begin(), end(curve.FirstCorner));
    }
    if (end(curve.LastCorner) >= 0)
    {
      path.push_back(end(curve.LastCorner));
    }
    paths[c] = std::move(path);
  }
  return paths;
}

using EdgeKey = std::array<Index, 2>;

EdgeKey KeyOf(Index a, Index b)
{
  return { std::min(a, b), std::max(a, b) };
}

/// Two corners without an edge between them are no chain.
void DropLonePairs(const HexBoundary& boundary, std::vector<std::vector<Index>>& paths)
{
  const std::vector<FaceEdge> edges = SortedEdges(boundary.Quads);
  for (std::vector<Index>& path : paths)
  {
    if (path.size() != 2)
    {
      continue;
    }
    FaceEdge wanted;
    wanted.Low = std::min(path[0], path[1]);
    wanted.High = std::max(path[0], path[1]);
    const auto found = std::lower_bound(edges.begin(), edges.end(), wanted, Before);
    if (found == edges.end() || !found->Joins(wanted))
    {
      path.clear();
    }
  }
}

/// Most frequent value; ties: the lowest. -1: none.
int MostFrequent(const std::map<int, Index>& counts)
{
  int best = -1;
  Index most = 0;
  for (const auto& [value, count] : counts)
  {
    if (count > most)
    {
      best = value;
      most = count;
    }
  }
  return best;
}

/// Votes for the patch of each quad, then of each piece between the chains.
class PatchVotes
{
public:
  PatchVotes(const HexBoundary& boundary, const SurfaceFeatures& features)
    : Boundary(boundary)
    , Features(features)
    , Pieces(boundary.Quads.size())
    , ByPoints(boundary.Quads.size())
    , BySides(boundary.Quads.size())
  {
  }

  std::vector<int> Count(const std::vector<std::vector<Index>>& paths, const FeatureLabels& labels)
  {
    this->FindPieces(paths);
    for (std::size_t q = 0; q < this->Boundary.Quads.size(); ++q)
    {
      for (Index v : this->Boundary.Quads[q])
      {
        if (labels.Kind[v] == FeatureKind::Surface && labels.Id[v] >= 0 &&
          labels.Id[v] < this->Features.NumberOfPatches)
        {
          ++this->ByPoints[this->Pieces.Find(static_cast<Index>(q))][labels.Id[v]];
        }
      }
    }
    std::vector<int> patches;
    for (std::size_t q = 0; q < this->Boundary.Quads.size(); ++q)
    {
      const Index piece = this->Pieces.Find(static_cast<Index>(q));
      const int patch = MostFrequent(this->ByPoints[piece]);
      patches.push_back(patch >= 0 ? patch : MostFrequent(this->BySides[piece]));
    }
    return patches;
  }

private:
  void FindPieces(const std::vector<std::vector<Index>>& paths)
  {
    std::map<EdgeKey, std::pair<Index, bool>> chains; // curve, and whether it runs to the higher id
    for (std::size_t c = 0; c < paths.size(); ++c)
    {
      for (std::size_t i = 1; i < paths[c].size(); ++i)
      {
        chains[KeyOf(paths[c][i - 1], paths[c][i])] = { static_cast<Index>(c),
          paths[c][i - 1] < paths[c][i] };
      }
    }
    const std::vector<FaceEdge> edges = SortedEdges(this->Boundary.Quads);
    std::vector<std::pair<Index, int>> sides;
    for (std::size_t i = 0; i < edges.size(); ++i)
    {
      const auto chain = chains.find({ edges[i].Low, edges[i].High });
      if (chain != chains.end())
      {
        const FeatureCurve& curve = this->Features.Curves[chain->second.first];
        sides.emplace_back(edges[i].Face,
          chain->second.second == edges[i].Upward ? curve.LeftPatch : curve.RightPatch);
      }
      else if (i > 0 && edges[i].Joins(edges[i - 1]))
      {
        this->Pieces.Join(edges[i - 1].Face, edges[i].Face);
      }
    }
    for (const auto& [quad, patch] : sides)
    {
      ++this->BySides[this->Pieces.Find(quad)][patch];
    }
  }

  const HexBoundary& Boundary;
  const SurfaceFeatures& Features;
  DisjointSets Pieces;
  std::vector<std::map<int, Index>> ByPoints, BySides; ///< by root of the piece
};
}

HexFeatures RecoverFeatures(const HexMesh& mesh, const HexBoundary& boundary,
  const SurfaceMesh& surface, const SurfaceFeatures& features, const FeatureLabels& labels)
{
  HexFeatures found;
  found.CornerVertices = CornerVertices(mesh, surface, features, labels);
  found.CurvePaths = CurvePaths(mesh, surface, features, labels, found.CornerVertices);
  DropLonePairs(boundary, found.CurvePaths);
  found.PatchOfQuad = PatchVotes(boundary, features).Count(found.CurvePaths, labels);
  return found;
}
}

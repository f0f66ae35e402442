// SPDX-License-Identifier: BSD-3-Clause
#include "BoundarySpreading.h"

#include <algorithm>

namespace featurehex
{
namespace
{
constexpr int Rings = 2;
constexpr int Passes = 30;
/// Cosine of the angle between quad and patch normal: quads across a fillet stand steeply, too.
constexpr double FoldedCosine = -0.2;

/// The vertices of some boundary quads and of the rings round them, ascending.
std::vector<Index> VerticesAround(const HexStars& stars, const std::vector<Index>& quads)
{
  std::vector<char> chosen(stars.Hexes.size(), 0);
  std::vector<Index> vertices;
  const auto add = [&](const Quad& quad) {
    for (Index v : quad)
    {
      if (!chosen[v])
      {
        chosen[v] = 1;
        vertices.push_back(v);
      }
    }
  };
  for (Index q : quads)
  {
    add(stars.Quads[q]);
  }
  for (int ring = 0; ring < Rings; ++ring)
  {
    const std::size_t count = vertices.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      for (Index q : stars.QuadsOfVertex[vertices[i]])
      {
        add(stars.Quads[q]);
      }
    }
  }
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

/// For each vertex those that draw it: at the ends of its boundary edges, on a curve before and
/// after it.
std::vector<std::vector<Index>> NeighborsOf(
  const HexStars& stars, const FeatureTargets& features, const std::vector<Index>& vertices)
{
  std::vector<std::vector<Index>> neighbors(stars.Hexes.size());
  for (const std::vector<Index>& path : features.Mapped().CurvePaths)
  {
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      neighbors[path[i]].push_back(path[i - 1]);
      neighbors[path[i - 1]].push_back(path[i]);
    }
  }
  for (Index v : vertices)
  {
    if (features.KindOf(v) == FeatureKind::Surface)
    {
      for (Index q : stars.QuadsOfVertex[v])
      {
        const Quad& quad = stars.Quads[q];
        const auto k = std::find(quad.begin(), quad.end(), v) - quad.begin();
        neighbors[v].push_back(quad[(k + 1) & 3]);
      }
    }
  }
  return neighbors;
}

/// Closest point of the patches of the quads round a vertex: more than one where no curve parts
/// them.
Vec3 OnPatches(const HexStars& stars, const FeatureTargets& features, Index vertex, const Vec3& p)
{
  TrianglePoint best;
  const SurfaceGeometry* last = nullptr;
  for (Index q : stars.QuadsOfVertex[vertex])
  {
    const SurfaceGeometry& patch = features.PatchOfQuad(q);
    if (&patch != last)
    {
      const TrianglePoint point = patch.Search().Closest(p, -1, best.Distance);
      best = point.Triangle >= 0 && point.Distance < best.Distance ? point : best;
      last = &patch;
    }
  }
  return best.Point;
}

/// Sequential, in the order of the ids.
void Spread(HexMesh& mesh, const HexStars& stars, const FeatureTargets& features,
  const std::vector<Index>& quads, const std::vector<char>* changed)
{
  std::vector<Index> vertices = VerticesAround(stars, quads);
  if (changed)
  {
    vertices.erase(std::remove_if(vertices.begin(), vertices.end(),
                     [changed](Index v) { return !(*changed)[v]; }),
      vertices.end());
  }
  const std::vector<std::vector<Index>> neighbors = NeighborsOf(stars, features, vertices);
  for (int pass = 0; pass < Passes; ++pass)
  {
    for (Index v : vertices)
    {
      Vec3 mean = Vec3::Zero();
      for (Index other : neighbors[v])
      {
        mean += mesh.Points[other] / static_cast<double>(neighbors[v].size());
      }
      mesh.Points[v] =
        features.OnFeature(v) ? features.Project(v, mean) : OnPatches(stars, features, v, mean);
    }
  }
}
}

void SpreadAtFeatures(HexMesh& mesh, const HexStars& stars, const FeatureTargets& features,
  const std::vector<char>* changed)
{
  std::vector<Index> quads;
  for (Index v : features.Vertices())
  {
    quads.insert(quads.end(), stars.QuadsOfVertex[v].begin(), stars.QuadsOfVertex[v].end());
  }
  Spread(mesh, stars, features, quads, changed);
}

bool IsFolded(
  const HexMesh& mesh, const HexStars& stars, const FeatureTargets& features, Index quad)
{
  std::array<Vec3, 4> p;
  Vec3 center = Vec3::Zero();
  for (int k = 0; k < 4; ++k)
  {
    p[k] = mesh.Points[stars.Quads[quad][k]];
    center += 0.25 * p[k];
  }
  const Vec3 normal = (p[2] - p[0]).cross(p[3] - p[1]).stableNormalized();
  const TriangleSearch& search = features.PatchOfQuad(quad).Search();
  const Vec3& wanted = search.Normal(search.Closest(center).Triangle);
  return normal.dot(wanted.stableNormalized()) < FoldedCosine;
}

Index UnfoldBoundary(HexMesh& mesh, const HexStars& stars, const FeatureTargets& features)
{
  std::vector<Index> folded;
  for (Index q = 0; q < static_cast<Index>(stars.Quads.size()); ++q)
  {
    if (IsFolded(mesh, stars, features, q))
    {
      folded.push_back(q);
    }
  }
  Spread(mesh, stars, features, folded, nullptr);
  return static_cast<Index>(folded.size());
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause

#include "HexValidation.h"
#include "SelfIntersection.h"
#include "SubMonitor.h"

#include <algorithm>

namespace featurehex
{
namespace
{
constexpr std::size_t PairLimit = 100000;

/// Subdivision that decides about quads with a finding.
constexpr int Fine = 8;

/// Triangles with the quad that each belongs to.
struct Facets
{
  std::vector<Triangle> Triangles;
  std::vector<Index> Owners;

  void Add(Index a, Index b, Index c, std::size_t owner)
  {
    this->Triangles.push_back({ a, b, c });
    this->Owners.push_back(static_cast<Index>(owner));
  }
};

/// Inner points of an edge, shared by the quads at it.
struct FineEdge
{
  Index Low, High;
  Index First; ///< of Fine - 1 points, from Low to High

  bool operator<(const FineEdge& o) const
  {
    return this->Low != o.Low ? this->Low < o.Low : this->High < o.High;
  }
};

bool IsRepeated(const Quad& q)
{
  return q[0] == q[1] || q[0] == q[2] || q[0] == q[3] || q[1] == q[2] || q[1] == q[3] ||
    q[2] == q[3];
}

/// The suspect quads as Fine x Fine cells; appends to @a points.
Facets Subdivide(
  const std::vector<Quad>& quads, const std::vector<char>& suspect, std::vector<Vec3>& points)
{
  std::vector<FineEdge> edges;
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    for (int k = 0; suspect[q] && k < 4; ++k)
    {
      const Index a = quads[q][k], b = quads[q][(k + 1) % 4];
      edges.push_back({ std::min(a, b), std::max(a, b), -1 });
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end(),
                [](const FineEdge& a, const FineEdge& b) { return !(a < b) && !(b < a); }),
    edges.end());
  for (FineEdge& e : edges)
  {
    e.First = static_cast<Index>(points.size());
    const Vec3 a = points[e.Low], b = points[e.High];
    for (int k = 1; k < Fine; ++k)
    {
      points.push_back(a + (static_cast<double>(k) / Fine) * (b - a));
    }
  }
  const auto onEdge = [&](Index a, Index b, int step) {
    if (a > b)
    {
      std::swap(a, b);
      step = Fine - step;
    }
    const auto e = std::lower_bound(edges.begin(), edges.end(), FineEdge{ a, b, -1 });
    return step == 0 ? a : step == Fine ? b : e->First + step - 1;
  };

  Facets facets;
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    if (!suspect[q])
    {
      continue;
    }
    const Quad& c = quads[q];
    const Vec3 p[4] = { points[c[0]], points[c[1]], points[c[2]], points[c[3]] };
    Index id[Fine + 1][Fine + 1];
    for (int i = 0; i <= Fine; ++i)
    {
      id[i][0] = onEdge(c[0], c[1], i);
      id[i][Fine] = onEdge(c[3], c[2], i);
      id[0][i] = onEdge(c[0], c[3], i);
      id[Fine][i] = onEdge(c[1], c[2], i);
    }
    for (int i = 1; i < Fine; ++i)
    {
      for (int j = 1; j < Fine; ++j)
      {
        const double u = static_cast<double>(i) / Fine, v = static_cast<double>(j) / Fine;
        id[i][j] = static_cast<Index>(points.size());
        points.push_back(
          (1 - v) * ((1 - u) * p[0] + u * p[1]) + v * ((1 - u) * p[3] + u * p[2]));
      }
    }
    for (int i = 0; i < Fine; ++i)
    {
      for (int j = 0; j < Fine; ++j)
      {
        facets.Add(id[i][j], id[i + 1][j], id[i + 1][j + 1], q);
        facets.Add(id[i][j], id[i + 1][j + 1], id[i][j + 1], q);
      }
    }
  }
  return facets;
}

/// Marks the owners of the pairs; returns their number.
std::size_t Mark(const std::vector<Vec3>& points, const Facets& facets, Monitor& monitor,
  std::vector<char>& marks)
{
  const std::vector<TrianglePair> pairs =
    FindSelfIntersections(points, facets.Triangles, PairLimit, &monitor);
  for (const TrianglePair& pair : pairs)
  {
    marks[facets.Owners[pair.First]] = 1;
    marks[facets.Owners[pair.Second]] = 1;
  }
  return pairs.size();
}
}

BoundaryIntersections FindBoundaryIntersections(
  const std::vector<Vec3>& meshPoints, const std::vector<Quad>& quads, Monitor& monitor)
{
  BoundaryIntersections result;
  // Only the points in use, in the order of their ids.
  std::vector<Index> local(meshPoints.size(), -1);
  std::vector<Vec3> points;
  std::vector<Quad> corners = quads;
  for (Quad& q : corners)
  {
    for (Index& v : q)
    {
      if (local[v] < 0)
      {
        local[v] = static_cast<Index>(points.size());
        points.push_back(meshPoints[v]);
      }
      v = local[v];
    }
  }
  std::vector<char> suspect(corners.size(), 0);
  for (int diagonal = 0; diagonal < 2; ++diagonal)
  {
    Facets facets;
    for (std::size_t q = 0; q < corners.size(); ++q)
    {
      const Quad& c = corners[q];
      if (IsRepeated(c))
      {
        continue; // reported as RepeatedId
      }
      facets.Add(c[0], c[1], c[diagonal ? 3 : 2], q);
      facets.Add(c[diagonal ? 1 : 0], c[2], c[3], q);
    }
    SubMonitor part(monitor, 0.4 * diagonal, 0.4 * (diagonal + 1));
    Mark(points, facets, part, suspect);
  }
  result.SuspectQuads = static_cast<Index>(std::count(suspect.begin(), suspect.end(), 1));
  if (result.SuspectQuads > 0)
  {
    const Facets fine = Subdivide(corners, suspect, points);
    std::vector<char> guilty(corners.size(), 0);
    SubMonitor part(monitor, 0.8, 1.0);
    result.Pairs = static_cast<Index>(Mark(points, fine, part, guilty));
    for (std::size_t q = 0; q < corners.size(); ++q)
    {
      if (guilty[q])
      {
        result.Quads.push_back(static_cast<Index>(q));
      }
    }
  }
  return result;
}
}

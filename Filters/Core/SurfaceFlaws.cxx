// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceFlaws.h"

#include "MessageText.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

namespace featurehex
{
Vec3 CheckedSurface::Center(Index triangle) const
{
  const Triangle& t = this->Triangles[triangle];
  return this->Points[t[0]] / 3.0 + this->Points[t[1]] / 3.0 + this->Points[t[2]] / 3.0;
}

void CheckedSurface::AddPlace(std::vector<Vec3>& places, const Vec3& p) const
{
  if (places.size() < this->MaximumNumberOfPlaces)
  {
    places.push_back(p);
  }
}

Status CheckIndices(const SurfaceMesh& surface)
{
  const std::size_t numberOfPoints = surface.Points.size();
  if (surface.Triangles.empty())
  {
    return Status(StatusCode::EmptySurface,
      numberOfPoints == 0
        ? "The surface is empty: it has no points and no faces. Give a closed triangle surface."
        : "The surface has " + CountText(numberOfPoints, "point", "points") +
            " but no faces. Give a closed triangle surface; point clouds have to be reconstructed "
            "first.");
  }
  constexpr std::size_t largest = std::numeric_limits<Index>::max() / 3;
  if (numberOfPoints > largest || surface.Triangles.size() > largest)
  {
    return Status(
      StatusCode::IndexOutOfRange, "Index out of range: more than " + std::to_string(largest) +
                                     " points or triangles. Decimate the surface first.");
  }
  std::size_t bad = 0;
  std::string first;
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    for (Index v : surface.Triangles[t])
    {
      if ((v < 0 || static_cast<std::size_t>(v) >= numberOfPoints) && bad++ == 0)
      {
        first = "triangle " + std::to_string(t) + " uses point " + std::to_string(v);
      }
    }
  }
  if (bad == 0)
  {
    return Status();
  }
  return Status(StatusCode::IndexOutOfRange,
    "Index out of range: " +
      CountText(bad, "triangle corner uses a point", "triangle corners use points") +
      " that the surface does not have; first, " + first + ", but there are " +
      std::to_string(numberOfPoints) +
      " points. The file is damaged or truncated: export it again.");
}

Status CheckCoordinates(const SurfaceMesh& surface)
{
  std::size_t bad = 0;
  std::string first;
  for (std::size_t v = 0; v < surface.Points.size(); ++v)
  {
    const Vec3& p = surface.Points[v];
    for (int k = 0; k < 3; ++k)
    {
      // Negated, so that NaN is caught.
      if (!(std::abs(p[k]) <= LargestCoordinate))
      {
        if (bad++ == 0)
        {
          first = "point " + std::to_string(v) + " at " + PlaceText(p);
        }
        break;
      }
    }
  }
  if (bad == 0)
  {
    return Status();
  }
  return Status(
    StatusCode::NonFinite, "Non-finite coordinate (not a number, infinite or beyond 1e100) in " +
                             CountText(bad, "point", "points") + "; first, " + first +
                             ". Correct or remove these points where the surface was made.");
}

namespace
{
/// "from point 3 at (0, 0, 0) to point 8 at (1, 0, 0)"
std::string EdgeText(const CheckedSurface& surface, const EdgeUse& edge)
{
  return "from point " + std::to_string(edge.Low()) + " at " +
         PlaceText(surface.Points[edge.Low()]) + " to point " + std::to_string(edge.High()) +
         " at " + PlaceText(surface.Points[edge.High()]);
}

Vec3 Middle(const CheckedSurface& surface, const EdgeUse& edge)
{
  return 0.5 * surface.Points[edge.Low()] + 0.5 * surface.Points[edge.High()];
}

Status CoincidentTriangles(const CheckedSurface& surface, const std::vector<Index>& twin)
{
  std::vector<Vec3> places;
  std::size_t count = 0;
  std::string first;
  for (Index t = 0; t < static_cast<Index>(twin.size()); ++t)
  {
    if (twin[t] > t)
    {
      const Vec3 center = surface.Center(t);
      if (count++ == 0)
      {
        first = "triangles " + surface.Name(t) + " and " + surface.Name(twin[t]) + " at " +
                PlaceText(center);
      }
      surface.AddPlace(places, center);
    }
  }
  return Status(StatusCode::SelfIntersection,
    "Self-intersection (coplanar overlap): " + CountText(count, "pair", "pairs") +
      " of triangles with the same corners; first, " + first +
      ". Two bodies or sheets touch there: unite them (Boolean union) or move them apart.",
    std::move(places));
}

Status OverusedEdges(const CheckedSurface& surface, const EdgeTable& edges)
{
  std::vector<Vec3> places;
  std::size_t count = 0;
  std::string first;
  edges.VisitEdges(
    [&](const EdgeUse* begin, const EdgeUse* end)
    {
      if (end - begin <= 2)
      {
        return;
      }
      if (count++ == 0)
      {
        first =
          EdgeText(surface, *begin) + " has " + std::to_string(end - begin) + " faces (triangles";
        for (const EdgeUse* use = begin; use != end && use - begin < 8; ++use)
        {
          first += (use == begin ? " " : ", ") + surface.Name(use->Triangle());
        }
        first += end - begin > 8 ? ", ...)" : ")";
      }
      surface.AddPlace(places, Middle(surface, *begin));
    });
  return Status(StatusCode::NonManifold,
    CountText(count, "non-manifold edge", "non-manifold edges") + ": the " +
      (count == 1 ? "edge " : "first, ") + first +
      ", but an edge of a closed surface has 2. Remove inner faces and fins, or move bodies that "
      "touch along an edge apart or unite them.",
    std::move(places));
}

/// A loop is a connected set of open edges.
std::size_t CountLoops(const std::vector<std::uint64_t>& openEdges, std::size_t numberOfPoints)
{
  std::vector<Index> root(numberOfPoints);
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](Index v)
  {
    while (root[v] != v)
    {
      root[v] = root[root[v]];
      v = root[v];
    }
    return v;
  };
  std::size_t loops = 0;
  std::vector<char> seen(numberOfPoints, 0);
  for (const std::uint64_t edge : openEdges)
  {
    const Index ends[2] = { EdgeUse{ edge, 0 }.Low(), EdgeUse{ edge, 0 }.High() };
    for (Index v : ends)
    {
      loops += seen[v] ? 0 : 1;
      seen[v] = 1;
    }
    const Index a = find(ends[0]);
    const Index b = find(ends[1]);
    loops -= a != b ? 1 : 0;
    root[std::max(a, b)] = std::min(a, b);
  }
  return loops;
}

Status OpenEdges(const CheckedSurface& surface, const EdgeTable& edges)
{
  std::vector<std::uint64_t> open;
  std::vector<Vec3> places;
  std::string first;
  edges.VisitEdges(
    [&](const EdgeUse* begin, const EdgeUse* end)
    {
      if (end - begin != 1)
      {
        return;
      }
      if (open.empty())
      {
        first = EdgeText(surface, *begin) + " (triangle " + surface.Name(begin->Triangle()) + ")";
      }
      open.push_back(begin->Edge);
      surface.AddPlace(places, Middle(surface, *begin));
    });
  return Status(StatusCode::OpenBoundary,
    "Open boundary: " + CountText(open.size(), "edge has", "edges have") + " only one face, in " +
      CountText(CountLoops(open, surface.Points.size()), "loop", "loops") + "; the first goes " +
      first + ". Close the holes (fill holes, or merge points that should coincide).",
    std::move(places));
}
} // namespace

Status CheckEdges(
  const CheckedSurface& surface, const EdgeTable& edges, const std::vector<Index>& twin)
{
  bool open = false, overused = false, coincident = false;
  edges.VisitEdges(
    [&](const EdgeUse* first, const EdgeUse* last)
    {
      open = open || last - first == 1;
      overused = overused || last - first > 2;
      for (const EdgeUse* use = first; last - first > 2 && use != last; ++use)
      {
        coincident = coincident || twin[use->Triangle()] >= 0;
      }
    });
  if (coincident)
  {
    return CoincidentTriangles(surface, twin);
  }
  if (overused)
  {
    return OverusedEdges(surface, edges);
  }
  return open ? OpenEdges(surface, edges) : Status();
}

Status CheckFans(const CheckedSurface& surface, const std::vector<Index>& opposite)
{
  const std::vector<Index> fans = CountFans(surface.Triangles, opposite, surface.Points.size());
  std::vector<Vec3> places;
  std::size_t count = 0;
  std::string first;
  for (std::size_t v = 0; v < fans.size(); ++v)
  {
    if (fans[v] > 1)
    {
      if (count++ == 0)
      {
        first = "point " + std::to_string(v) + " at " + PlaceText(surface.Points[v]) + " joins " +
                std::to_string(fans[v]) + " separate fans of triangles";
      }
      surface.AddPlace(places, surface.Points[v]);
    }
  }
  if (count == 0)
  {
    return Status();
  }
  return Status(StatusCode::NonManifold,
    CountText(count, "non-manifold vertex", "non-manifold vertices") + ": " +
      (count == 1 ? "" : "first, ") + first +
      ". Parts of the surface touch there in a point: move them apart or unite them.",
    std::move(places));
}

Status DescribeIntersections(
  const CheckedSurface& surface, const std::vector<TrianglePair>& pairs, bool limited)
{
  std::vector<Vec3> places;
  std::string first;
  for (std::size_t i = 0; i < pairs.size(); ++i)
  {
    const Vec3 place = IntersectionPlace(surface.Points, surface.Triangles, pairs[i]);
    surface.AddPlace(places, place);
    if (i < 3)
    {
      first += (i == 0 ? "" : ", ") + surface.Name(pairs[i].First) + " and " +
               surface.Name(pairs[i].Second) + " near " + PlaceText(place);
    }
  }
  return Status(StatusCode::SelfIntersection,
    std::string("Self-intersection: ") + (limited ? "at least " : "") +
      CountText(
        pairs.size(), "pair of triangles crosses or touches", "pairs of triangles cross or touch") +
      "; first, triangles " + first +
      ". Unite overlapping bodies (Boolean union), or repair or remesh the surface there.",
    std::move(places));
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause
#include "SurfacePoints.h"

#include "BoxTree.h"
#include "SurfaceFlaws.h"

#include <algorithm>

namespace featurehex
{
namespace
{
/// Coordinates in single precision are this near; fraction of the diagonal.
constexpr double PlaceTolerance = 1e-6;

bool NamesAgree(const SurfaceMesh& surface, const std::vector<Vec3>& places,
  const std::vector<Index>& named, double tolerance)
{
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const Index id = named[i];
    const bool exists = id >= 0 && id < static_cast<Index>(surface.Points.size());
    if (!exists || !((places[i] - surface.Points[id]).norm() <= tolerance))
    {
      return false;
    }
  }
  return true;
}

/// The points that triangles use, as triangles without extent: for the tree.
std::vector<Triangle> UsedPoints(const SurfaceMesh& surface)
{
  std::vector<char> used(surface.Points.size(), 0);
  for (const Triangle& t : surface.Triangles)
  {
    for (Index v : t)
    {
      used[v] = 1;
    }
  }
  std::vector<Triangle> points;
  for (Index p = 0; p < static_cast<Index>(used.size()); ++p)
  {
    if (used[p])
    {
      points.push_back({ p, p, p });
    }
  }
  return points;
}
} // namespace

std::vector<Index> RecognizeSurfacePoints(
  const SurfaceMesh& surface, const std::vector<Vec3>& places, const std::vector<Index>& named)
{
  const double tolerance = PlaceTolerance * BoundingBox(surface).Diagonal();
  if (!places.empty() && named.size() == places.size())
  {
    const bool onePlace = places.size() > 1 && std::all_of(places.begin(), places.end(),
                                                 [&](const Vec3& p) { return p == places[0]; });
    if (onePlace || NamesAgree(surface, places, named, tolerance))
    {
      std::vector<Index> ids = named;
      for (Index& id : ids)
      {
        id = id < static_cast<Index>(surface.Points.size()) ? id : -1;
      }
      return ids;
    }
  }
  const std::vector<Triangle> used = UsedPoints(surface);
  const BoxTree tree(surface.Points, used);
  std::vector<Index> ids(places.size(), -1);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    Box box;
    box.Extend(places[i] - Vec3::Constant(tolerance));
    box.Extend(places[i] + Vec3::Constant(tolerance));
    double nearest = tolerance;
    tree.VisitBox(box,
      [&](Index leaf)
      {
        const Index id = used[leaf][0];
        const double distance = (surface.Points[id] - places[i]).norm();
        if (distance < nearest || (distance == nearest && (ids[i] < 0 || id < ids[i])))
        {
          nearest = distance;
          ids[i] = id;
        }
      });
  }
  return ids;
}

Status UnknownSurfacePoint(std::int64_t point, const std::vector<Vec3>& places)
{
  if (point < 0 || point >= static_cast<std::int64_t>(places.size()))
  {
    return Status(StatusCode::IndexOutOfRange, "A feature refers to point " +
                                                 std::to_string(point) + " of " +
                                                 std::to_string(places.size()) + ".");
  }
  const Vec3& place = places[static_cast<std::size_t>(point)];
  return Status(StatusCode::IndexOutOfRange,
    "Point " + std::to_string(point) + " of the features, at " + PlaceText(place) +
      ", is no point of the surface. Features have to lie on edges of this very surface; points "
      "are recognised by SurfacePointId or, within 1e-6 of the diagonal, by their coordinates.",
    { place });
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the surface formats have in common. Private to the surface reader.

#ifndef featurehex_SurfaceFormats_h
#define featurehex_SurfaceFormats_h

#include "Status.h"
#include "TextScanner.h"

#include <string>
#include <string_view>

namespace featurehex
{
/// A surface while it is read: collects points and polygons, turns mistakes into a Status.
class SurfaceBuilder
{
public:
  /// @a unit: what Where counts in messages, "line", "face" or "triangle".
  SurfaceBuilder(const std::string& name, const char* unit, SurfaceMesh& surface)
    : Name(name)
    , Unit(unit)
    , Surface(surface)
  {
  }

  std::int64_t NumberOfPoints() const
  {
    return static_cast<std::int64_t>(this->Surface.Points.size());
  }

  void ReservePoints(std::int64_t count) { this->Surface.Points.reserve(count); }
  void ReserveTriangles(std::int64_t count) { this->Surface.Triangles.reserve(count); }
  void AddPoint(const Vec3& point) { this->Surface.Points.push_back(point); }

  /// A polygon starts at @a where; its corners follow through AddCorner().
  void BeginPolygon(std::size_t where)
  {
    this->Where = where;
    this->Corners = 0;
  }
  /// 0-based @a id; false: it can't be right whatever follows in the file. Then
  /// return IndexError().
  bool AddCorner(std::int64_t id);
  std::int64_t NumberOfCorners() const { return this->Corners; }

  Status IndexError(std::int64_t id, std::size_t where, bool oneBased = false) const;
  Status ParseError(std::size_t where, const std::string& what) const;

  /// To be called at the end: too many points, indices beyond the end, no points, no faces.
  Status Finish(bool oneBased = false) const;

private:
  const std::string& Name;
  const char* Unit;
  SurfaceMesh& Surface;
  ReferenceCheck References;
  std::size_t Where = 0;
  std::int64_t Corners = 0;
  Index First = 0;
  Index Previous = 0;
};

Status ParseObj(std::string_view bytes, const std::string& name, SurfaceMesh& surface);
Status ParseStl(std::string_view bytes, const std::string& name, SurfaceMesh& surface);
Status ParsePly(std::string_view bytes, const std::string& name, SurfaceMesh& surface);
Status ParseOff(std::string_view bytes, const std::string& name, SurfaceMesh& surface);

/// Binary STL by its size: 80 bytes, the count of triangles, 50 bytes each.
bool HasBinaryStlSize(std::string_view bytes);
} // namespace featurehex

#endif

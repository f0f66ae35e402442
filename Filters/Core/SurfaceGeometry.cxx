// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceGeometry.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
SurfaceGeometry::SurfaceGeometry(SurfaceMesh surface)
  : Surface(std::move(surface))
  , Triangles(this->Surface.Points, this->Surface.Triangles)
  , PointNormals(this->Surface.Points.size(), Vec3::Zero())
  , BoundingBox(featurehex::BoundingBox(this->Surface))
{
  for (const Triangle& t : this->Surface.Triangles)
  {
    const Vec3& a = this->Surface.Points[t[0]];
    const Vec3 normal = (this->Surface.Points[t[1]] - a).cross(this->Surface.Points[t[2]] - a);
    for (Index v : t)
    {
      this->PointNormals[v] += normal;
    }
  }
  for (Vec3& normal : this->PointNormals)
  {
    const double length = normal.norm();
    normal = length > 0 ? Vec3(normal / length) : Vec3(Vec3::Zero());
  }
}

Vec3 SurfaceGeometry::NormalAt(const TrianglePoint& point) const
{
  const Triangle& t = this->Surface.Triangles[point.Triangle];
  const Vec3 normal = point.Barycentric[0] * this->PointNormals[t[0]] +
    point.Barycentric[1] * this->PointNormals[t[1]] +
    point.Barycentric[2] * this->PointNormals[t[2]];
  const double length = normal.norm();
  return length > 0 ? Vec3(normal / length) : Vec3(Vec3::Zero());
}

std::vector<Vec3> SurfaceGeometry::Samples(double spacing) const
{
  const auto pieces = [spacing](double length) {
    return static_cast<int>(std::ceil(std::min(length / spacing, 1000.0)));
  };
  std::vector<Vec3> samples;
  std::vector<bool> used(this->Surface.Points.size(), false);
  for (const Triangle& t : this->Surface.Triangles)
  {
    for (Index v : t)
    {
      used[v] = true;
    }
  }
  for (std::size_t v = 0; v < used.size(); ++v)
  {
    if (used[v])
    {
      samples.push_back(this->Surface.Points[v]);
    }
  }
  const auto addInside = [&](const Vec3& a, const Vec3& b) {
    const int n = pieces((b - a).norm());
    for (int i = 1; i < n; ++i)
    {
      samples.push_back(a + (b - a) * (static_cast<double>(i) / n));
    }
  };
  for (const Triangle& t : this->Surface.Triangles)
  {
    int base = 0;
    std::array<double, 3> lengths;
    for (int k = 0; k < 3; ++k)
    {
      const Vec3& a = this->Surface.Points[t[k]];
      const Vec3& b = this->Surface.Points[t[(k + 1) % 3]];
      lengths[k] = (b - a).norm();
      base = lengths[k] > lengths[base] ? k : base;
      // Each edge of a closed surface is seen twice, in both directions: once is enough.
      if (t[k] < t[(k + 1) % 3])
      {
        addInside(a, b);
      }
    }
    // Rows along the longest edge: few across a sliver.
    const Vec3& a = this->Surface.Points[t[base]];
    const Vec3& b = this->Surface.Points[t[(base + 1) % 3]];
    const Vec3& c = this->Surface.Points[t[(base + 2) % 3]];
    const int rows =
      lengths[base] > 0 ? pieces((b - a).cross(c - a).norm() / lengths[base]) : 0;
    for (int row = 1; row < rows; ++row)
    {
      const double share = static_cast<double>(row) / rows;
      addInside(a + (c - a) * share, b + (c - b) * share);
    }
  }
  return samples;
}
}

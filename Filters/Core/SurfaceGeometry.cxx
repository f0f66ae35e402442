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
  for (const Triangle& t : this->Surface.Triangles)
  {
    double longest = 0;
    for (int k = 0; k < 3; ++k)
    {
      const Vec3& a = this->Surface.Points[t[k]];
      const Vec3& b = this->Surface.Points[t[(k + 1) % 3]];
      const int n = pieces((b - a).norm());
      longest = std::max(longest, (b - a).norm());
      // Each edge of a closed surface is seen twice, in both directions: once is enough.
      for (int i = 1; i < n && t[k] < t[(k + 1) % 3]; ++i)
      {
        samples.push_back(a + (b - a) * (static_cast<double>(i) / n));
      }
    }
    const int n = pieces(longest);
    const Vec3& a = this->Surface.Points[t[0]];
    const Vec3 ab = this->Surface.Points[t[1]] - a;
    const Vec3 ac = this->Surface.Points[t[2]] - a;
    for (int i = 1; i < n; ++i)
    {
      for (int j = 1; i + j < n; ++j)
      {
        samples.push_back(
          a + ab * (static_cast<double>(i) / n) + ac * (static_cast<double>(j) / n));
      }
    }
  }
  return samples;
}
}

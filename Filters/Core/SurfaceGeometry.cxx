// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceGeometry.h"

#include "Parallel.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
/// Pieces of this many spacings are small enough for one spacing.
constexpr double EvenPieces = 8;
constexpr std::size_t TrianglesPerPart = 512; // of the work of one thread

/// Fills edges and triangles, without their ends and edges.
class Sampler
{
public:
  explicit Sampler(const SurfaceGeometry::SpacingFunction& spacing)
    : Spacing(spacing)
  {
  }

  void AddInside(const Vec3& a, const Vec3& b)
  {
    const Vec3 middle = 0.5 * (a + b);
    const double spacing = this->Spacing(middle, this->Near);
    if ((b - a).norm() <= EvenPieces * spacing)
    {
      this->AddRow(a, b, spacing);
      return;
    }
    this->AddInside(a, middle);
    this->Samples.push_back(middle);
    this->AddInside(middle, b);
  }

  void AddInside(Vec3 a, Vec3 b, Vec3 c)
  {
    // The longest edge first.
    const double ab = (b - a).squaredNorm();
    const double bc = (c - b).squaredNorm();
    const double ca = (a - c).squaredNorm();
    if (bc > ab && bc >= ca)
    {
      std::swap(a, b);
      std::swap(b, c);
    }
    else if (ca > ab && ca > bc)
    {
      std::swap(a, c);
      std::swap(b, c);
    }
    const double base = (b - a).norm();
    const double spacing = this->Spacing((a + b + c) / 3, this->Near);
    const int rows = base > 0 ? Pieces((b - a).cross(c - a).norm() / base, spacing) : 0;
    if (rows > 1 && base > EvenPieces * spacing)
    {
      const Vec3 middle = 0.5 * (a + b);
      this->AddInside(middle, c);
      this->AddInside(a, middle, c);
      this->AddInside(middle, b, c);
      return;
    }
    // Rows along the longest edge: few across a sliver.
    for (int row = 1; row < rows; ++row)
    {
      const double share = static_cast<double>(row) / rows;
      this->AddRow(a + (c - a) * share, b + (c - b) * share, spacing);
    }
  }

  std::vector<Vec3> Samples;

private:
  static int Pieces(double length, double spacing)
  {
    return static_cast<int>(std::ceil(length / spacing));
  }

  void AddRow(const Vec3& a, const Vec3& b, double spacing)
  {
    const int n = Pieces((b - a).norm(), spacing);
    for (int i = 1; i < n; ++i)
    {
      this->Samples.push_back(a + (b - a) * (static_cast<double>(i) / n));
    }
  }

  const SurfaceGeometry::SpacingFunction& Spacing;
  Index Near = -1; ///< left by Spacing
};
}

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
  return this->Samples([spacing](const Vec3&, Index&) { return spacing; });
}

std::vector<Vec3> SurfaceGeometry::Samples(const SpacingFunction& spacing) const
{
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
  const std::vector<Triangle>& triangles = this->Surface.Triangles;
  const auto addTriangle = [this](const Triangle& t, Sampler& sampler) {
    for (int k = 0; k < 3; ++k)
    {
      // Each edge of a closed surface is seen twice, in both directions: once is enough.
      if (t[k] < t[(k + 1) % 3])
      {
        sampler.AddInside(this->Surface.Points[t[k]], this->Surface.Points[t[(k + 1) % 3]]);
      }
    }
    sampler.AddInside(
      this->Surface.Points[t[0]], this->Surface.Points[t[1]], this->Surface.Points[t[2]]);
  };
  std::vector<std::vector<Vec3>> parts(
    (triangles.size() + TrianglesPerPart - 1) / TrianglesPerPart);
  ParallelFor(parts.size(), 1, [&](std::size_t part) {
    Sampler sampler(spacing);
    const std::size_t last = std::min((part + 1) * TrianglesPerPart, triangles.size());
    for (std::size_t i = part * TrianglesPerPart; i < last; ++i)
    {
      addTriangle(triangles[i], sampler);
    }
    parts[part] = std::move(sampler.Samples);
  });
  for (const std::vector<Vec3>& part : parts)
  {
    samples.insert(samples.end(), part.begin(), part.end());
  }
  return samples;
}
}

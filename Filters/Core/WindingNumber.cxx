// SPDX-License-Identifier: BSD-3-Clause
#include "WindingNumber.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace featurehex
{
namespace
{
constexpr Index LeafSize = 8;
constexpr double FullSphere = 4.0 * 3.14159265358979323846;

/// Signed solid angle of the triangle a b c seen from the origin (van Oosterom and Strackee 1983).
double SolidAngle(const Vec3& a, const Vec3& b, const Vec3& c)
{
  const double la = a.norm();
  const double lb = b.norm();
  const double lc = c.norm();
  return 2.0 *
    std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
}
}

WindingNumber::WindingNumber(
  const std::vector<Vec3>& points, const std::vector<Triangle>& triangles, double accuracy)
{
  if (triangles.empty())
  {
    return;
  }
  std::vector<Corners> corners;
  corners.reserve(triangles.size());
  for (const Triangle& t : triangles)
  {
    corners.push_back({ points[t[0]], points[t[1]], points[t[2]] });
  }
  std::vector<Index> order(triangles.size());
  std::iota(order.begin(), order.end(), 0);
  this->Nodes.reserve(triangles.size() / 2 + 2);
  this->Build(0, static_cast<Index>(order.size()), order, corners, accuracy);
  this->Triangles.reserve(triangles.size());
  for (Index t : order)
  {
    this->Triangles.push_back(corners[t]);
  }
}

Index WindingNumber::Build(Index first, Index last, std::vector<Index>& order,
  const std::vector<Corners>& corners, double accuracy)
{
  const Index id = static_cast<Index>(this->Nodes.size());
  this->Nodes.emplace_back();
  Vec3 areaVector = Vec3::Zero();
  Vec3 weighted = Vec3::Zero();
  double area = 0.0;
  Box box;
  Box centroids;
  for (Index i = first; i < last; ++i)
  {
    const Corners& t = corners[order[i]];
    const Vec3 cross = 0.5 * (t.B - t.A).cross(t.C - t.A);
    const Vec3 centroid = (t.A + t.B + t.C) / 3.0;
    areaVector += cross;
    weighted += cross.norm() * centroid;
    area += cross.norm();
    centroids.Extend(centroid);
    for (const Vec3* p : { &t.A, &t.B, &t.C })
    {
      box.Extend(*p);
    }
  }
  const Vec3 center = area > 0 ? Vec3(weighted / area) : box.Center();
  double radiusSquared = 0.0;
  for (Index i = first; i < last; ++i)
  {
    const Corners& t = corners[order[i]];
    for (const Vec3* p : { &t.A, &t.B, &t.C })
    {
      radiusSquared = std::max(radiusSquared, (*p - center).squaredNorm());
    }
  }
  Index right = -1;
  if (last - first > LeafSize)
  {
    int axis = 0;
    centroids.Size().maxCoeff(&axis);
    const Index middle = first + (last - first) / 2;
    const auto key = [&](Index t) {
      return corners[t].A[axis] + corners[t].B[axis] + corners[t].C[axis];
    };
    std::nth_element(order.begin() + first, order.begin() + middle, order.begin() + last,
      [&](Index a, Index b) {
        const double ka = key(a);
        const double kb = key(b);
        return ka < kb || (ka == kb && a < b);
      });
    this->Build(first, middle, order, corners, accuracy);
    right = this->Build(middle, last, order, corners, accuracy);
  }
  this->Nodes[id] = { center, areaVector, accuracy * accuracy * radiusSquared, first, last, right };
  return id;
}

double WindingNumber::At(const Vec3& p) const
{
  if (this->Nodes.empty())
  {
    return 0.0;
  }
  double sum = 0.0;
  Index stack[128];
  int top = 0;
  stack[top++] = 0;
  while (top > 0)
  {
    const Index id = stack[--top];
    const Node& node = this->Nodes[id];
    const Vec3 d = node.Center - p;
    const double squared = d.squaredNorm();
    if (squared > node.FarSquared)
    {
      sum += node.AreaVector.dot(d) / (squared * std::sqrt(squared));
    }
    else if (node.Right < 0)
    {
      for (Index t = node.First; t < node.Last; ++t)
      {
        const Corners& c = this->Triangles[t];
        sum += SolidAngle(c.A - p, c.B - p, c.C - p);
      }
    }
    else
    {
      stack[top++] = node.Right;
      stack[top++] = id + 1;
    }
  }
  return sum / FullSphere;
}
}

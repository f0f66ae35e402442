// SPDX-License-Identifier: BSD-3-Clause
#include "GridFit.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace featurehex
{
namespace
{
constexpr double LeastCosine = 0.99996; // half a degree: a tenth of a cell over ten cells
constexpr int Phases = 64;              // positions of a plane that are tried, in a cell
constexpr int NearPhases = 12;          // faces farther from a plane than this get stairs
constexpr double LeastShare = 0.05;     // of the area, for a plane to count
constexpr double LeastSize = 0.8;       // of the given one
constexpr int Sizes = 41;               // that are tried
constexpr double LeastGain = 0.05;      // of the area, for a smaller size
}

GridFit::GridFit(const SurfaceMesh& surface, const Mat3& axes)
{
  std::array<std::map<double, double>, 3> areas;
  for (const Triangle& t : surface.Triangles)
  {
    const Vec3& a = surface.Points[t[0]];
    const Vec3 normal = axes.transpose() *
      (surface.Points[t[1]] - a).cross(surface.Points[t[2]] - a);
    const double length = normal.norm();
    this->TotalArea += 0.5 * length;
    int axis = 0;
    if (normal.cwiseAbs().maxCoeff(&axis) > LeastCosine * length)
    {
      const Vec3 center = (a + surface.Points[t[1]] + surface.Points[t[2]]) / 3;
      areas[axis][axes.col(axis).dot(center)] += 0.5 * length;
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const auto& [position, area] : areas[axis])
    {
      this->Faces[axis].push_back({ position, area });
    }
  }
}

GridFit::Plane GridFit::BestPlane(int axis, double size) const
{
  std::array<double, Phases> areas = {};
  for (const Face& face : this->Faces[axis])
  {
    const double phase = face.Position / size - std::floor(face.Position / size);
    const int bin = static_cast<int>(std::lround(phase * Phases)) % Phases;
    for (int k = -NearPhases; k <= NearPhases; ++k)
    {
      areas[(bin + k + Phases) % Phases] +=
        face.Area * (1 - std::abs(k) / static_cast<double>(NearPhases + 1));
    }
  }
  const auto best = std::max_element(areas.begin(), areas.end());
  return { size * static_cast<double>(best - areas.begin()) / Phases, *best };
}

double GridFit::CenterPlane(int axis, double size, double otherwise) const
{
  const Plane plane = this->BestPlane(axis, size);
  return plane.Area > LeastShare * this->TotalArea ? plane.Position : otherwise;
}

double GridFit::BestSize(double size) const
{
  double best = size;
  double most = LeastShare * this->TotalArea;
  for (int i = 0; i < Sizes; ++i)
  {
    const double factor = 1 - (1 - LeastSize) * i / (Sizes - 1);
    double area = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      area += this->BestPlane(axis, factor * size).Area;
    }
    if (area > (1 + LeastGain) * most)
    {
      most = area;
      best = factor * size;
    }
  }
  return best;
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause

#include "HexQuality.h"

#include "Parallel.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
/// Unit vector of e; false when e is zero. The detour over the largest component keeps very small
/// and very large meshes from underflow and overflow.
bool Normalize(Vec3& e)
{
  const double largest = e.cwiseAbs().maxCoeff();
  if (!(largest > 0.0) || !std::isfinite(largest))
  {
    return false;
  }
  e /= largest;
  e /= e.norm();
  return true;
}

/// Distinct ids of existing points with finite coordinates.
bool IsProper(const HexMesh& mesh, const Hex& hex)
{
  const auto count = static_cast<Index>(mesh.Points.size());
  for (int i = 0; i < 8; ++i)
  {
    if (hex[i] < 0 || hex[i] >= count || !mesh.Points[hex[i]].allFinite())
    {
      return false;
    }
    for (int j = 0; j < i; ++j)
    {
      if (hex[i] == hex[j])
      {
        return false;
      }
    }
  }
  return true;
}
}

std::array<double, 8> CornerScaledJacobians(const HexMesh& mesh, Index hexId)
{
  std::array<double, 8> result;
  result.fill(-1.0);
  const Hex& hex = mesh.Hexes[hexId];
  if (!IsProper(mesh, hex))
  {
    return result;
  }
  Vec3 unit[12];
  bool nonZero[12];
  for (int e = 0; e < 12; ++e)
  {
    unit[e] = mesh.Points[hex[HexEdges[e][1]]] - mesh.Points[hex[HexEdges[e][0]]];
    nonZero[e] = Normalize(unit[e]);
  }
  // Edges of each corner in the order of HexCornerNeighbors; sign: does the edge leave the corner?
  constexpr int edges[8][3] = { { 0, 3, 8 }, { 1, 0, 9 }, { 2, 1, 10 }, { 3, 2, 11 }, { 7, 4, 8 },
    { 4, 5, 9 }, { 5, 6, 10 }, { 6, 7, 11 } };
  for (int c = 0; c < 8; ++c)
  {
    const int* e = edges[c];
    if (nonZero[e[0]] && nonZero[e[1]] && nonZero[e[2]])
    {
      double det = unit[e[0]].cross(unit[e[1]]).dot(unit[e[2]]);
      for (int k = 0; k < 3; ++k)
      {
        det = HexEdges[e[k]][0] == c ? det : -det;
      }
      result[c] = std::clamp(det, -1.0, 1.0);
    }
  }
  return result;
}

double ScaledJacobian(const HexMesh& mesh, Index hex)
{
  const std::array<double, 8> corners = CornerScaledJacobians(mesh, hex);
  return *std::min_element(corners.begin(), corners.end());
}

std::vector<double> ScaledJacobians(const HexMesh& mesh)
{
  std::vector<double> result(mesh.Hexes.size());
  ParallelFor(result.size(), 4096,
    [&](std::size_t i) { result[i] = ScaledJacobian(mesh, static_cast<Index>(i)); });
  return result;
}

QualityStatistics SummarizeQuality(const std::vector<double>& values)
{
  QualityStatistics s;
  if (values.empty())
  {
    return s;
  }
  s.Minimum = *std::min_element(values.begin(), values.end());
  s.Maximum = *std::max_element(values.begin(), values.end());
  double sum = 0.0;
  for (double v : values)
  {
    sum += v;
    if (v > 0.0)
    {
      // Truncation happens before the clamp, so that 1.0 falls into the last bin.
      ++s.Histogram[std::min(static_cast<int>(v * s.Bins), s.Bins - 1)];
    }
    else
    {
      ++s.NonPositive;
    }
  }
  const auto count = static_cast<double>(values.size());
  s.Mean = sum / count;
  double squares = 0.0;
  for (double v : values)
  {
    squares += (v - s.Mean) * (v - s.Mean);
  }
  s.StandardDeviation = std::sqrt(squares / count);
  return s;
}
}

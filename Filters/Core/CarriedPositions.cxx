// SPDX-License-Identifier: BSD-3-Clause
#include "CarriedPositions.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
constexpr double Resolution = 1e-6; // of the edge length
constexpr int Rings = 3;            // of hexes round new vertices
constexpr int Passes = 30;          // until new vertices have followed the others
/// Of the vertices: when more are new, a fresh start is as fast.
constexpr double MaximumShare = 0.6;

/// New vertices get the mean displacement of those at the ends of their hexes' edges, from the rim
/// inwards; sequential, in the order of the ids.
void Follow(const HexMesh& mesh, const HexStars& stars, const std::vector<Index>& fresh,
  std::vector<Vec3>& displacements)
{
  for (int pass = 0; pass < Passes; ++pass)
  {
    for (Index v : fresh)
    {
      Vec3 sum = Vec3::Zero();
      for (Index i = stars.Hexes.Offsets[v]; i < stars.Hexes.Offsets[v + 1]; ++i)
      {
        const Hex& hex = mesh.Hexes[stars.Hexes.Ids[i]];
        for (int neighbor : HexCornerNeighbors[stars.Corners[i]])
        {
          sum += displacements[hex[neighbor]];
        }
      }
      displacements[v] = sum / (3.0 * static_cast<double>(stars.Hexes[v].size()));
    }
  }
}
}

CarriedPositions::Vertex CarriedPositions::VertexAt(
  const Vec3& unfitted, FeatureKind kind, Index id) const
{
  Vertex vertex = { {}, kind, id, Vec3::Zero() };
  for (int k = 0; k < 3; ++k)
  {
    vertex.Place[k] = std::llround(unfitted[k] / this->Spacing);
  }
  return vertex;
}

void CarriedPositions::Remember(const std::vector<Vec3>& unfitted, const FeatureLabels& labels,
  const std::vector<Vec3>& fitted, double length)
{
  this->Spacing = Resolution * length;
  this->Vertices.clear();
  this->Vertices.reserve(unfitted.size());
  for (std::size_t v = 0; v < unfitted.size(); ++v)
  {
    this->Vertices.push_back(this->VertexAt(unfitted[v], labels.Kind[v], labels.Id[v]));
    this->Vertices.back().Fitted = fitted[v];
  }
  std::stable_sort(this->Vertices.begin(), this->Vertices.end(),
    [](const Vertex& a, const Vertex& b) { return a.Key() < b.Key(); });
}

std::vector<char> CarriedPositions::Apply(
  HexMesh& mesh, const HexStars& stars, const FeatureLabels& labels) const
{
  std::vector<char> changed(mesh.Points.size(), 0);
  std::vector<Vec3> displacements(mesh.Points.size(), Vec3::Zero());
  std::vector<Vec3> fitted(mesh.Points.size());
  std::vector<Index> fresh;
  for (Index v = 0; v < static_cast<Index>(mesh.Points.size()); ++v)
  {
    const Vertex vertex = this->VertexAt(mesh.Points[v], labels.Kind[v], labels.Id[v]);
    const auto [first, last] = std::equal_range(this->Vertices.begin(), this->Vertices.end(),
      vertex, [](const Vertex& a, const Vertex& b) { return a.Key() < b.Key(); });
    if (last - first == 1)
    {
      fitted[v] = first->Fitted;
      displacements[v] = fitted[v] - mesh.Points[v];
    }
    else
    {
      fresh.push_back(v);
      changed[v] = 1;
    }
  }
  MarkRings(mesh, Rings, changed);
  if (std::count(changed.begin(), changed.end(), 1) > MaximumShare * changed.size())
  {
    return {};
  }
  Follow(mesh, stars, fresh, displacements);
  for (Index v : fresh)
  {
    fitted[v] = mesh.Points[v] + displacements[v];
  }
  mesh.Points = std::move(fitted);
  return changed;
}
} // namespace featurehex

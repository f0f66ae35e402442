// SPDX-License-Identifier: BSD-3-Clause
#include "ClusterPlacement.h"

#include <algorithm>

namespace featurehex
{
namespace
{
constexpr double ApartPrice = 0.5;  // for ends of a short curve that are two edges apart
constexpr double SharedPrice = 1.0; // for two curves that leave towards the same vertex
}

ClusterPlacement::ClusterPlacement(const std::vector<Vec3>& points, const QuadGraph& graph,
  const FeatureGeometry& geometry, const CurveRouter& router, std::vector<Index>& cornerVertices)
  : Points(points)
  , Graph(graph)
  , Geometry(geometry)
  , Router(router)
  , CornerVertices(cornerVertices)
{
}

Index ClusterPlacement::RootOf(
  const std::vector<Index>& cluster, const std::vector<std::vector<Index>>& neighbors)
{
  return *std::max_element(cluster.begin(), cluster.end(), [&](Index a, Index b) {
    return neighbors[a].size() < neighbors[b].size();
  });
}

void ClusterPlacement::Place(Index root, const std::vector<Index>& starts,
  const std::vector<std::vector<Index>>& neighbors, std::set<Index>& used)
{
  this->Neighbors = &neighbors;
  this->Starts = &starts;
  this->Used = &used;
  this->Corners = { root };
  this->Parents = { -1 };
  for (std::size_t i = 0; i < this->Corners.size(); ++i)
  {
    for (Index other : neighbors[this->Corners[i]])
    {
      if (std::find(this->Corners.begin(), this->Corners.end(), other) == this->Corners.end())
      {
        this->Corners.push_back(other);
        this->Parents.push_back(this->Corners[i]);
      }
    }
  }
  this->Least = 1e300;
  this->Extend(0, 0.0);
  for (std::size_t i = 0; i < this->Corners.size() && this->Least < 1e300; ++i)
  {
    this->CornerVertices[this->Corners[i]] = this->Best[i];
    used.insert(this->Best[i]);
  }
}

/// At most two edges apart.
bool ClusterPlacement::Near(Index a, Index b) const
{
  const auto beside = [this](Index u, Index v) { return this->Graph.Find(u, v) >= 0; };
  Index dart = this->Graph.Leaving(a);
  bool near = beside(a, b);
  for (int i = 0; i < this->Graph.Valence(a) && !near; ++i, dart = this->Graph.Rotate(dart))
  {
    near = beside(this->Graph.Head(dart), b);
  }
  return near;
}

/// How well the curves leave the corners where they are.
double ClusterPlacement::Fit() const
{
  double sum = 0;
  std::vector<std::pair<Index, Index>> towards; // vertex, curve
  for (Index corner : this->Corners)
  {
    double fit;
    const std::vector<Index> darts =
      this->Router.ArrangeSpokes(corner, this->CornerVertices[corner], fit);
    if (fit >= 1e300)
    {
      return 1e300;
    }
    sum += fit;
    for (std::size_t i = 0; i < darts.size(); ++i)
    {
      towards.emplace_back(
        this->Graph.Head(darts[i]), this->Geometry.Fans()[corner].Spokes[i].Curve);
    }
  }
  for (std::size_t i = 0; i < towards.size(); ++i)
  {
    const auto& [vertex, curveId] = towards[i];
    const EnforcedCurve& curve = this->Geometry.Curves()[curveId];
    for (Index corner : this->Corners)
    {
      if (this->CornerVertices[corner] == vertex && corner != curve.FirstCorner &&
        corner != curve.LastCorner)
      {
        return 1e300; // in the way
      }
    }
    for (std::size_t k = 0; k < i; ++k)
    {
      sum += towards[k].first == vertex && towards[k].second != curveId ? SharedPrice : 0.0;
    }
  }
  return sum;
}

/// Depth first, the costs of the places so far as a bound.
void ClusterPlacement::Extend(std::size_t place, double cost)
{
  if (cost >= this->Least)
  {
    return;
  }
  if (place == this->Corners.size())
  {
    const double total = cost + this->Fit();
    if (total < this->Least)
    {
      this->Least = total;
      this->Best.clear();
      for (Index corner : this->Corners)
      {
        this->Best.push_back(this->CornerVertices[corner]);
      }
    }
    return;
  }
  const Index corner = this->Corners[place];
  const auto placed = [&](Index other) {
    const auto end = this->Corners.begin() + static_cast<std::ptrdiff_t>(place);
    return std::find(this->Corners.begin(), end, other) != end;
  };
  const auto attempt = [&](Index vertex) {
    double price = (this->Points[vertex] - this->Geometry.CornerPoint(corner)).squaredNorm() /
      (this->Router.SizeAt(vertex) * this->Router.SizeAt(vertex));
    bool possible = this->Used->count(vertex) == 0;
    for (std::size_t i = 0; i < place && possible; ++i)
    {
      possible = this->CornerVertices[this->Corners[i]] != vertex;
    }
    for (Index other : (*this->Neighbors)[corner])
    {
      if (possible && placed(other))
      {
        const Index neighbor = this->CornerVertices[other];
        possible = this->Near(neighbor, vertex);
        price += this->Graph.Find(neighbor, vertex) < 0 ? ApartPrice : 0.0;
      }
    }
    if (possible)
    {
      this->CornerVertices[corner] = vertex;
      this->Extend(place + 1, cost + price);
      this->CornerVertices[corner] = -1;
    }
  };
  if (place == 0)
  {
    for (Index vertex : *this->Starts)
    {
      attempt(vertex);
    }
    return;
  }
  const Index parent = this->CornerVertices[this->Parents[place]];
  Index dart = this->Graph.Leaving(parent);
  for (int i = 0; i < this->Graph.Valence(parent); ++i, dart = this->Graph.Rotate(dart))
  {
    attempt(this->Graph.Head(dart));
  }
}
} // namespace featurehex

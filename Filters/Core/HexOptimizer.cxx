// SPDX-License-Identifier: BSD-3-Clause
#include "HexOptimizer.h"

#include "MipsEnergy.h"
#include "Parallel.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
constexpr double MaximumStep = 0.3;               // of the local size
/// Of the local size: below it the vertex is at rest.
constexpr double MinimumStep = 1e-6;
constexpr double WakingStep = 2e-3;               // of the local size: wakes the neighbours
constexpr double RatioTest = 0.8;                 // share of a determinant that one step may take

double Determinant(const HexMesh& mesh, const Hex& hex, int corner)
{
  const Vec3& p = mesh.Points[hex[corner]];
  const Vec3 a = mesh.Points[hex[HexCornerNeighbors[corner][0]]] - p;
  const Vec3 b = mesh.Points[hex[HexCornerNeighbors[corner][1]]] - p;
  const Vec3 c = mesh.Points[hex[HexCornerNeighbors[corner][2]]] - p;
  return a.dot(b.cross(c));
}

double Regularized(double det, double delta)
{
  return 0.5 * (det + std::sqrt(det * det + delta * delta));
}
}

double LeastCornerDeterminant(const HexMesh& mesh, Index hex)
{
  double least = 1e300;
  for (int corner = 0; corner < 8; ++corner)
  {
    least = std::min(least, Determinant(mesh, mesh.Hexes[hex], corner));
  }
  return least;
}

/// A corner of an incident hex with the regularisation of its determinant.
struct HexOptimizer::Corner : MipsCorner
{
  double Delta;
};

HexOptimizer::HexOptimizer(HexMesh& mesh, const HexStars& stars)
  : VertexTerms(mesh.Points.size())
  , CentroidTerms(stars.Quads.size())
  , ReverseTerms(stars.Quads.size())
  , Fixed(mesh.Points.size(), false)
  , Mesh(mesh)
  , Stars(stars)
  , Schedule(mesh.Hexes, stars.Hexes, 1)
  , VertexSizes(mesh.Points.size())
  , HexSizes(mesh.Hexes.size())
  , Active(new std::atomic<bool>[mesh.Points.size()])
{
  this->UpdateSizes();
  this->ActivateAll();
}

void HexOptimizer::UpdateSizes()
{
  ParallelFor(this->Mesh.Hexes.size(), 2048, [&](std::size_t h) {
    const Hex& hex = this->Mesh.Hexes[h];
    double sum = 0;
    for (const auto& edge : HexEdges)
    {
      sum += (this->Mesh.Points[hex[edge[1]]] - this->Mesh.Points[hex[edge[0]]]).norm();
    }
    this->HexSizes[h] = sum / 12;
  });
  ParallelFor(this->Mesh.Points.size(), 2048, [&](std::size_t v) {
    const auto hexes = this->Stars.Hexes[static_cast<Index>(v)];
    double sum = 0;
    for (Index h : hexes)
    {
      sum += this->HexSizes[h];
    }
    this->VertexSizes[v] = hexes.size() > 0 ? sum / hexes.size() : 0.0;
  });
}

void HexOptimizer::ActivateAll()
{
  for (std::size_t v = 0; v < this->Mesh.Points.size(); ++v)
  {
    this->Active[v].store(true, std::memory_order_relaxed);
  }
}

void HexOptimizer::ActivateBoundary()
{
  for (const Quad& quad : this->Stars.Quads)
  {
    for (Index v : quad)
    {
      this->Active[v].store(true, std::memory_order_relaxed);
    }
  }
}

void HexOptimizer::ActivateAround(Index vertex)
{
  for (Index h : this->Stars.Hexes[vertex])
  {
    for (Index u : this->Mesh.Hexes[h])
    {
      this->Active[u].store(true, std::memory_order_relaxed);
    }
  }
}

void HexOptimizer::ActivateAround(const Hex& hex)
{
  for (Index v : hex)
  {
    this->ActivateAround(v);
  }
}

bool HexOptimizer::CanMove(const Hex& hex, int corner) const
{
  bool fixed = this->Fixed[hex[corner]];
  for (int neighbor : HexCornerNeighbors[corner])
  {
    fixed = fixed && this->Fixed[hex[neighbor]];
  }
  return !fixed;
}

double HexOptimizer::LeastDeterminant() const
{
  std::vector<double> least(this->Mesh.Hexes.size(), 1e300);
  ParallelFor(least.size(), 2048, [&](std::size_t h) {
    const Hex& hex = this->Mesh.Hexes[h];
    const double size = this->HexSizes[h];
    for (int corner = 0; corner < 8; ++corner)
    {
      if (this->CanMove(hex, corner))
      {
        least[h] = std::min(least[h], Determinant(this->Mesh, hex, corner) / (size * size * size));
      }
    }
  });
  return least.empty() ? 1e300 : *std::min_element(least.begin(), least.end());
}

bool HexOptimizer::Hopeless(Index h) const
{
  const Hex& hex = this->Mesh.Hexes[h];
  for (int corner = 0; corner < 8; ++corner)
  {
    if (!this->CanMove(hex, corner) && !(Determinant(this->Mesh, hex, corner) > 0))
    {
      return true;
    }
  }
  return false;
}

std::size_t HexOptimizer::Sweep(double regularization, Monitor* monitor)
{
  const auto visit = [this, regularization](Index v) {
    if (this->Fixed[v] || !this->Active[v].load(std::memory_order_relaxed))
    {
      return false;
    }
    this->Active[v].store(false, std::memory_order_relaxed);
    return this->MoveVertex(v, regularization);
  };
  return this->Schedule.Sweep(visit, monitor);
}

void HexOptimizer::CollectCorners(
  Index vertex, double regularization, std::vector<Corner>& corners) const
{
  corners.clear();
  for (Index i = this->Stars.Hexes.Offsets[vertex]; i < this->Stars.Hexes.Offsets[vertex + 1]; ++i)
  {
    const Index h = this->Stars.Hexes.Ids[i];
    const Hex& hex = this->Mesh.Hexes[h];
    const double size = this->HexSizes[h];
    const double delta = regularization * size * size * size;
    for (const MipsCorner& corner :
      MipsCornersAt([&](int local) -> const Vec3& { return this->Mesh.Points[hex[local]]; },
        this->Stars.Corners[i]))
    {
      corners.push_back({ corner, delta });
    }
  }
}

/// Visits (term, displacement of the term's point, weight of the vertex in it).
template <typename Visitor>
void HexOptimizer::VisitTerms(Index vertex, const Visitor& visit) const
{
  const SurfaceTerm& own = this->VertexTerms[vertex];
  if (own.Weight > 0)
  {
    visit(own, Vec3(this->Mesh.Points[vertex] - own.Target), 1.0);
  }
  for (Index q : this->Stars.QuadsOfVertex[vertex])
  {
    const Quad& quad = this->Stars.Quads[q];
    for (const std::vector<QuadTerm>* terms : { &this->CentroidTerms, &this->ReverseTerms })
    {
      const QuadTerm& term = (*terms)[q];
      if (term.Term.Weight > 0)
      {
        Vec3 d = -term.Term.Target;
        double weight = 0;
        for (int k = 0; k < 4; ++k)
        {
          d += term.Weights[k] * this->Mesh.Points[quad[k]];
          weight += quad[k] == vertex ? term.Weights[k] : 0.0;
        }
        visit(term.Term, d, weight);
      }
    }
  }
}

bool HexOptimizer::MoveVertex(Index vertex, double regularization)
{
  const bool valid = regularization < 0;
  static thread_local std::vector<Corner> corners;
  this->CollectCorners(vertex, regularization, corners);
  if (corners.empty())
  {
    return false;
  }

  MipsSum sum;
  for (const Corner& corner : corners)
  {
    double det = corner.D;
    double slope = 1;
    if (!valid)
    {
      const double root = std::sqrt(det * det + corner.Delta * corner.Delta);
      slope = 0.5 * (1 + det / root);
      det = 0.5 * (det + root);
    }
    else if (!(det > 0))
    {
      return false;
    }
    sum.Add(corner, det, slope);
  }
  double& energy = sum.Value;
  Vec3& gradient = sum.Gradient;
  Mat3& hessian = sum.Hessian;
  this->VisitTerms(vertex, [&](const SurfaceTerm& term, const Vec3& d, double w) {
    const double nd = term.Normal.dot(d);
    energy += term.Weight * (term.Stiffness * nd * nd + term.Tether * d.squaredNorm());
    gradient += (2 * w * term.Weight) * (term.Stiffness * nd * term.Normal + term.Tether * d);
    hessian.noalias() +=
      (2 * w * w * term.Weight * term.Stiffness) * term.Normal * term.Normal.transpose();
    hessian.diagonal().array() += 2 * w * w * term.Weight * term.Tether;
  });

  const double size = this->VertexSizes[vertex];
  const Vec3 start = this->Mesh.Points[vertex];
  const bool locked = this->Features && this->Features->Locked(vertex);
  Vec3 step;
  if (locked)
  {
    const Vec3 slope = this->Features->Allowed(vertex, start, gradient);
    step = -slope * (slope.squaredNorm() / slope.dot(hessian * slope));
  }
  else
  {
    step = -hessian.ldlt().solve(gradient);
  }
  if (!step.allFinite() || !(gradient.dot(step) < 0))
  {
    if (locked)
    {
      return false;
    }
    step = -gradient / hessian.trace();
    if (!step.allFinite() || !(gradient.dot(step) < 0))
    {
      return false;
    }
  }
  const double length = step.norm();
  if (length < MinimumStep * size)
  {
    return false;
  }
  double alpha = std::min(1.0, MaximumStep * size / length);
  if (valid)
  {
    for (const Corner& corner : corners)
    {
      const double change = corner.GradD.dot(step);
      if (change < 0)
      {
        alpha = std::min(alpha, RatioTest * corner.D / -change);
      }
    }
  }

  const auto energyAt = [&](const Vec3& displacement) {
    double total = 0;
    for (const Corner& corner : corners)
    {
      const double s = corner.S + corner.GradS.dot(displacement) +
        corner.Edges * displacement.squaredNorm();
      const double det = corner.D + corner.GradD.dot(displacement);
      const double chi = valid ? det : Regularized(det, corner.Delta);
      if (!(chi > 0))
      {
        return 1e300;
      }
      total += MipsValue(s, chi);
    }
    this->VisitTerms(vertex, [&](const SurfaceTerm& term, const Vec3& d, double w) {
      const Vec3 moved = d + w * displacement;
      const double nd = term.Normal.dot(moved);
      total += term.Weight * (term.Stiffness * nd * nd + term.Tether * moved.squaredNorm());
    });
    return total;
  };
  for (int trial = 0; trial < 8; ++trial, alpha *= 0.4)
  {
    Vec3 position = start + alpha * step;
    if (locked)
    {
      position = this->Features->Project(vertex, position);
    }
    if (energyAt(position - start) < energy)
    {
      this->Mesh.Points[vertex] = position;
      if (alpha * length > WakingStep * size)
      {
        this->ActivateAround(vertex);
      }
      return true;
    }
  }
  return false;
}

bool HexOptimizer::TryMove(Index vertex, const Vec3& displacement)
{
  static thread_local std::vector<Corner> corners;
  this->CollectCorners(vertex, 0.0, corners);
  for (const Corner& corner : corners)
  {
    if (!(corner.D + corner.GradD.dot(displacement) > (1 - RatioTest) * corner.D))
    {
      return false;
    }
  }
  this->Mesh.Points[vertex] += displacement;
  this->ActivateAround(vertex);
  return true;
}
}

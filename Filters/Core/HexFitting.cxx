// SPDX-License-Identifier: BSD-3-Clause
#include "HexFitting.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
// Shares of the local size (recipe-pipeline 2.7).
constexpr double NearSurface = 0.05; // closer: the smooth normal of the surface counts, not the direction
constexpr double TargetReach = 0.5;  // targets are no farther than this
constexpr double Tether = 0.02;      // weak pull to the closest point itself
constexpr double ReverseThreshold = 0.2; // of the tolerance: closer samples of the input exert no pull
constexpr int ReverseStart = 3;          // iterations before samples of the input pull

/// Plane through (or, when far, towards) the closest surface point of @a p.
SurfaceTerm PlaneTerm(
  const SurfaceGeometry& surface, const Vec3& p, Index& hint, double size, double weight)
{
  const TrianglePoint closest = surface.Search().Closest(p, hint);
  hint = closest.Triangle;
  SurfaceTerm term;
  term.Target = closest.Point;
  term.Normal = surface.NormalAt(closest);
  term.Weight = weight / (size * size);
  if (closest.Distance > NearSurface * size)
  {
    term.Normal = (p - closest.Point) / closest.Distance;
    term.Tether = Tether;
  }
  if (closest.Distance > TargetReach * size)
  {
    term.Target = p - term.Normal * (TargetReach * size);
  }
  return term;
}

/// Pulls the point of the quad to the sample of the input.
QuadTerm ReverseTerm(const EnvelopeContact& contact, double size, double weight)
{
  QuadTerm term;
  term.Weights = contact.Weights;
  term.Term.Normal = (contact.SurfacePoint - contact.QuadPoint) / contact.Distance;
  term.Term.Target =
    contact.QuadPoint + term.Term.Normal * std::min(contact.Distance, TargetReach * size);
  term.Term.Weight = weight / (size * size);
  term.Term.Tether = Tether;
  return term;
}

/// Surface terms of an optimiser, with the closest triangles of the last round as hints.
class SurfaceTerms
{
public:
  SurfaceTerms(const HexMesh& mesh, const HexStars& stars, const SurfaceGeometry& surface)
    : Mesh(mesh)
    , Stars(stars)
    , Surface(surface)
    , VertexHints(mesh.Points.size(), -1)
    , QuadHints(stars.Quads.size(), -1)
  {
  }

  void UpdatePlanes(HexOptimizer& optimizer, double weight)
  {
    ParallelFor(this->Mesh.Points.size(), 512, [&](std::size_t v) {
      if (this->Stars.OnBoundary(static_cast<Index>(v)))
      {
        optimizer.VertexTerms[v] = PlaneTerm(this->Surface, this->Mesh.Points[v],
          this->VertexHints[v], optimizer.SizeAt(static_cast<Index>(v)), weight);
      }
    });
    ParallelFor(this->Stars.Quads.size(), 512, [&](std::size_t q) {
      const Vec3 center = this->Center(q);
      QuadTerm& term = optimizer.CentroidTerms[q];
      term.Term =
        PlaneTerm(this->Surface, center, this->QuadHints[q], this->QuadSize(optimizer, q), weight);
      term.Term.Tether = 0;
    });
  }

  /// Each quad is drawn to the sample of the input that is farthest from it.
  void UpdateReverse(HexOptimizer& optimizer, const SurfaceEnvelope& envelope, double weight,
    double threshold) const
  {
    ParallelFor(this->Stars.Quads.size(), 64, [&](std::size_t q) {
      const EnvelopeContact worst = envelope.WorstReverse(static_cast<Index>(q), threshold);
      optimizer.ReverseTerms[q] =
        worst.Quad < 0 ? QuadTerm() : ReverseTerm(worst, this->QuadSize(optimizer, q), weight);
    });
  }

private:
  Vec3 Center(std::size_t q) const
  {
    const Quad& quad = this->Stars.Quads[q];
    return 0.25 * (this->Mesh.Points[quad[0]] + this->Mesh.Points[quad[1]] +
                    this->Mesh.Points[quad[2]] + this->Mesh.Points[quad[3]]);
  }
  double QuadSize(const HexOptimizer& optimizer, std::size_t q) const
  {
    const Quad& quad = this->Stars.Quads[q];
    return 0.5 * (optimizer.SizeAt(quad[0]) + optimizer.SizeAt(quad[2]));
  }

  const HexMesh& Mesh;
  const HexStars& Stars;
  const SurfaceGeometry& Surface;
  std::vector<Index> VertexHints;
  std::vector<Index> QuadHints;
};
}

std::vector<Index> InvertedHexes(const HexMesh& mesh)
{
  std::vector<Index> inverted;
  for (Index h = 0; h < static_cast<Index>(mesh.Hexes.size()); ++h)
  {
    if (!(LeastCornerDeterminant(mesh, h) > 0))
    {
      inverted.push_back(h);
    }
  }
  return inverted;
}

Status UntangleHexes(HexMesh& mesh, const HexStars& stars, const SurfaceGeometry* surface,
  const UntangleOptions& options, UntangleReport& report, Monitor& monitor)
{
  HexOptimizer optimizer(mesh, stars);
  report = UntangleReport();
  const auto countInverted = [&mesh] { return static_cast<Index>(InvertedHexes(mesh).size()); };
  report.InvertedBefore = report.InvertedAfter = countInverted();
  if (surface)
  {
    SurfaceTerms(mesh, stars, *surface).UpdatePlanes(optimizer, options.SurfaceWeight);
  }
  else
  {
    for (std::size_t v = 0; v < mesh.Points.size(); ++v)
    {
      optimizer.Fixed[v] = stars.OnBoundary(static_cast<Index>(v));
    }
  }
  while (report.InvertedAfter > 0 && report.Sweeps < options.MaximumSweeps)
  {
    if (!monitor.Update(static_cast<double>(report.Sweeps) / options.MaximumSweeps))
    {
      return monitor.StopStatus();
    }
    // Regularisation of recipe-pipeline 2.6: follows the worst determinant, wide in the first sweeps.
    const double worst = std::min(optimizer.LeastDeterminant(), 0.0);
    double delta = std::sqrt(1e-6 + 0.04 * worst * worst);
    if (report.Sweeps < 15)
    {
      delta = std::max(delta, 0.05);
    }
    optimizer.ActivateAll();
    optimizer.Sweep(delta);
    ++report.Sweeps;
    report.InvertedAfter = countInverted();
  }
  return Status();
}

Status FitHexes(HexMesh& mesh, const HexStars& stars, const SurfaceGeometry& surface,
  SurfaceEnvelope& envelope, const FittingOptions& options, Monitor& monitor)
{
  HexOptimizer optimizer(mesh, stars);
  SurfaceTerms terms(mesh, stars, surface);
  const double threshold = ReverseThreshold * options.Tolerance * surface.Diagonal();
  double weight = options.InitialWeight;
  for (int iteration = 0; iteration < options.Iterations; ++iteration)
  {
    if (!monitor.Update(static_cast<double>(iteration) / options.Iterations))
    {
      return monitor.StopStatus();
    }
    optimizer.UpdateSizes();
    terms.UpdatePlanes(optimizer, weight);
    if (iteration == ReverseStart)
    {
      envelope.Rebuild();
    }
    else if (iteration > ReverseStart)
    {
      envelope.Update(threshold);
    }
    if (iteration >= ReverseStart)
    {
      terms.UpdateReverse(optimizer, envelope, weight, threshold);
    }
    optimizer.ActivateBoundary();
    optimizer.Sweep(-1.0);
    weight = std::min(weight * options.WeightGrowth, options.MaximumWeight);
  }
  envelope.Rebuild();
  return Status();
}
}

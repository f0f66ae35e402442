// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceTerms.h"

#include "Parallel.h"

#include <algorithm>

namespace featurehex
{
namespace
{
// Shares of the local size (recipe-pipeline 2.7).
/// Closer: the smooth normal of the surface counts, not the direction.
constexpr double NearSurface = 0.05;
constexpr double TargetReach = 0.5;  // targets are no farther than this
constexpr double SpreadReach = 0.3;  // farthest pull along a curve
constexpr double SpreadWeight = 20;  // of that pull
constexpr double Tether = 0.02;      // weak pull to the closest point itself

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
}

SurfaceTerms::SurfaceTerms(const HexMesh& mesh, const HexStars& stars,
  const SurfaceGeometry& surface, const FeatureTargets* features)
  : Mesh(mesh)
  , Stars(stars)
  , Surface(surface)
  , Features(features)
  , VertexHints(mesh.Points.size(), -1)
  , QuadHints(stars.Quads.size(), -1)
{
}

void SurfaceTerms::UpdatePlanes(HexOptimizer& optimizer, double weight, double featureWeight)
{
  ParallelFor(this->Mesh.Points.size(), 512, [&](std::size_t v) {
    const Index vertex = static_cast<Index>(v);
    if (optimizer.Fixed[v])
    {
      return;
    }
    const double size = optimizer.SizeAt(vertex);
    if (this->Features && this->Features->OnFeature(vertex))
    {
      optimizer.VertexTerms[v] = this->FeatureTerm(vertex, size, featureWeight);
    }
    else if (this->Stars.OnBoundary(vertex))
    {
      optimizer.VertexTerms[v] =
        PlaneTerm(this->Features ? this->Features->PatchAt(vertex, this->Surface) : this->Surface,
          this->Mesh.Points[v], this->VertexHints[v], size, weight);
    }
  });
  ParallelFor(this->Stars.Quads.size(), 512, [&](std::size_t q) {
    if (optimizer.AllFixed(this->Stars.Quads[q]))
    {
      return;
    }
    const Vec3 center = this->Center(q);
    QuadTerm& term = optimizer.CentroidTerms[q];
    term.Term =
      PlaneTerm(this->Features ? this->Features->PatchOfQuad(static_cast<Index>(q)) : this->Surface,
        center, this->QuadHints[q], this->QuadSize(optimizer, q), weight);
    term.Term.Tether = 0;
  });
}

void SurfaceTerms::UpdateReverse(
  HexOptimizer& optimizer, const SurfaceEnvelope& envelope, double weight, double threshold) const
{
  ParallelFor(this->Stars.Quads.size(), 64, [&](std::size_t q) {
    if (optimizer.AllFixed(this->Stars.Quads[q]))
    {
      return;
    }
    const EnvelopeContact worst = envelope.WorstReverse(static_cast<Index>(q), threshold);
    optimizer.ReverseTerms[q] =
      worst.Quad < 0 ? QuadTerm() : ReverseTerm(worst, this->QuadSize(optimizer, q), weight);
  });
}

SurfaceTerm SurfaceTerms::FeatureTerm(Index v, double size, double weight) const
{
  const Vec3& p = this->Mesh.Points[v];
  SurfaceTerm term;
  term.Target = this->Features->Project(v, p);
  term.Stiffness = 0;
  term.Tether = 1;
  if (this->Features->KindOf(v) == FeatureKind::Curve)
  {
    const CurvePoint closest = this->Features->OnCurve(v, p);
    const double ahead = std::clamp(
      this->Features->SpreadFrom(v, closest.Arc), -SpreadReach * size, SpreadReach * size);
    const double share = std::min(1.0, SpreadWeight / weight);
    term.Target = closest.Point + ahead * closest.Tangent;
    term.Normal = closest.Tangent;
    term.Stiffness = share - 1;
    term.Tether = 1;
  }
  const Vec3 toTarget = term.Target - p;
  const double distance = toTarget.norm();
  if (distance > TargetReach * size)
  {
    term.Target = p + toTarget * (TargetReach * size / distance);
  }
  term.Weight = weight / (size * size);
  return term;
}

Vec3 SurfaceTerms::Center(std::size_t q) const
{
  const Quad& quad = this->Stars.Quads[q];
  return 0.25 * (this->Mesh.Points[quad[0]] + this->Mesh.Points[quad[1]] +
                  this->Mesh.Points[quad[2]] + this->Mesh.Points[quad[3]]);
}

double SurfaceTerms::QuadSize(const HexOptimizer& optimizer, std::size_t q) const
{
  const Quad& quad = this->Stars.Quads[q];
  return 0.5 * (optimizer.SizeAt(quad[0]) + optimizer.SizeAt(quad[2]));
}
}

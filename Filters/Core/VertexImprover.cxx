// SPDX-License-Identifier: BSD-3-Clause
#include "VertexImprover.h"

#include "BarrierFunction.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
constexpr double LeastRatioOnFeatures = 0.05; // of edges at a vertex that arrives on its feature
constexpr double LongestStep = 0.3;      // of the mean or shortest edge
constexpr double NearLimit = 0.6;       // share of the limit from which contacts are felt
constexpr double DrawPullStart = 0.9;
constexpr double DrawNearLimit = 0.85;
constexpr double AveragePull = 1000.0; // of the surface term of RaiseAverage, per corner
/// Of a perfect corner in RaiseAverage; that of the worst corner of a hex is 1.
constexpr double LeastCornerWeight = 0.3;
constexpr int CornersPerHex = 4; // that change with one of its vertices

/// Newton step of a 3x3 system with the eigenvalues made positive.
Vec3 ModifiedNewtonStep(const Mat3& hessian, const Vec3& gradient)
{
  Eigen::SelfAdjointEigenSolver<Mat3> solver;
  solver.computeDirect(hessian);
  const Vec3 values = solver.eigenvalues().cwiseAbs();
  const double largest = std::max(values.maxCoeff(), 1e-30);
  const Vec3 y = solver.eigenvectors().transpose() * gradient;
  return solver.eigenvectors() * (-y.array() / values.array().max(1e-3 * largest)).matrix();
}
}

/// An envelope contact as a function of the vertex: distance(x) = Distance + Gradient . (x - x0).
struct VertexImprover::Pull
{
  double Distance;
  Vec3 Gradient;
};

struct VertexImprover::Star
{
  Vec3 Position;
  double Length = 0;   ///< mean edge length at the start of the improvement
  double Shortest = 0; ///< shortest edge now
  double Least = 2;    ///< least scaled Jacobian of the corners
  std::vector<Corner> Corners; ///< CornersPerHex for each hex of the vertex
  std::vector<Pull> Pulls;
  std::vector<EnvelopeContact> Contacts;
  double Limit = 0; ///< the envelope's, or the distance now where that is beyond
  bool Slides = false; ///< locked on a curve ...
  Vec3 Tangent = Vec3::Zero(); ///< ... that runs in this direction

  /// The part of a direction in which the vertex may move.
  Vec3 Allowed(const Vec3& direction) const
  {
    return this->Slides ? Vec3(this->Tangent.dot(direction) * this->Tangent) : direction;
  }
};

/// How contacts pull: weight, and the share of the limit from which they do.
struct VertexImprover::PullLaw
{
  double Weight, Start;
};

/// Energy of a vertex with its derivatives at the start of a move.
struct VertexImprover::Model
{
  double Energy = 0;
  Vec3 Gradient = Vec3::Zero();
  Mat3 Hessian = Mat3::Zero();
};

const VertexImprover::PullLaw VertexImprover::BarrierPull = { 10.0, 0.8 };

VertexImprover::VertexImprover(
  HexMesh& mesh, const HexStars& stars, SurfaceEnvelope& envelope, double limit,
  FeatureTargets* features)
  : Mesh(mesh)
  , Stars(stars)
  , Envelope(envelope)
  , EnvelopeLimit(limit)
  , FeaturesOfMesh(features)
  , Lengths(mesh.Points.size(), 0.0)
  , Hints(mesh.Points.size(), -1)
{
  for (Index v = 0; v < stars.Hexes.size(); ++v)
  {
    double sum = 0;
    int count = 0;
    for (Index i = stars.Hexes.Offsets[v]; i < stars.Hexes.Offsets[v + 1]; ++i)
    {
      for (int neighbor : HexCornerNeighbors[stars.Corners[i]])
      {
        sum += (mesh.Points[mesh.Hexes[stars.Hexes.Ids[i]][neighbor]] - mesh.Points[v]).norm();
        ++count;
      }
    }
    this->Lengths[v] = count > 0 ? sum / count : 0.0;
  }
}

/// A vertex that has reached its corner.
bool VertexImprover::Pinned(Index vertex) const
{
  return this->FeaturesOfMesh && this->FeaturesOfMesh->Locked(vertex) &&
    this->FeaturesOfMesh->KindOf(vertex) == FeatureKind::Corner;
}

/// On the patch of the vertex, or on the whole surface when it has none.
TrianglePoint VertexImprover::ClosestOnSurface(
  Index vertex, const Vec3& p, const SurfaceGeometry& surface, Vec3& normal)
{
  const bool matched =
    this->FeaturesOfMesh && this->FeaturesOfMesh->KindOf(vertex) == FeatureKind::Surface;
  const SurfaceGeometry& target =
    matched ? this->FeaturesOfMesh->PatchAt(vertex, surface) : surface;
  const TrianglePoint closest = target.Search().Closest(p, this->Hints[vertex]);
  this->Hints[vertex] = closest.Triangle;
  normal = target.Search().Normal(closest.Triangle);
  return closest;
}

void VertexImprover::Gather(Index vertex, Star& star) const
{
  star.Position = this->Mesh.Points[vertex];
  star.Slides = this->FeaturesOfMesh && this->FeaturesOfMesh->Locked(vertex);
  if (star.Slides)
  {
    star.Tangent = this->FeaturesOfMesh->OnCurve(vertex, star.Position).Tangent;
  }
  star.Length = this->Lengths[vertex];
  star.Shortest = 1e300;
  star.Least = 2;
  star.Corners.clear();
  star.Pulls.clear();
  for (Index i = this->Stars.Hexes.Offsets[vertex]; i < this->Stars.Hexes.Offsets[vertex + 1]; ++i)
  {
    const Hex& hex = this->Mesh.Hexes[this->Stars.Hexes.Ids[i]];
    const int local = this->Stars.Corners[i];
    Corner corner;
    for (int k = 0; k < 3; ++k)
    {
      corner.Ends[k] = this->Mesh.Points[hex[HexCornerNeighbors[local][k]]];
      star.Shortest = std::min(star.Shortest, (corner.Ends[k] - star.Position).norm());
    }
    star.Corners.push_back(corner);
    for (const NeighborCorner& n : NeighborCorners[local])
    {
      corner.Apex = false;
      corner.Origin = this->Mesh.Points[hex[n.Vertex]];
      const Vec3 b = this->Mesh.Points[hex[n.First]] - corner.Origin;
      const Vec3 c = this->Mesh.Points[hex[n.Second]] - corner.Origin;
      corner.Cross = b.cross(c);
      corner.Squares = b.squaredNorm() + c.squaredNorm();
      corner.Product = std::sqrt(b.squaredNorm() * c.squaredNorm());
      star.Corners.push_back(corner);
    }
  }
  for (Corner& corner : star.Corners)
  {
    corner.Value = corner.ScaledJacobian(star.Position);
    star.Least = std::min(star.Least, corner.Value);
  }
  star.Limit = this->EnvelopeLimit;
}

void VertexImprover::GatherPulls(Index vertex, double threshold, Star& star)
{
  star.Contacts.clear();
  for (Index q : this->Stars.QuadsOfVertex[vertex])
  {
    this->Envelope.Collect(q, threshold, star.Contacts);
  }
  for (const EnvelopeContact& contact : star.Contacts)
  {
    star.Limit = std::max(star.Limit, contact.Distance);
    const Quad& quad = this->Stars.Quads[contact.Quad];
    for (int k = 0; k < 4; ++k)
    {
      if (quad[k] == vertex)
      {
        star.Pulls.push_back({ contact.Distance,
          contact.Weights[k] * (contact.QuadPoint - contact.SurfacePoint) / contact.Distance });
      }
    }
  }
}

double VertexImprover::EdgeRatio(Index vertex, const Vec3& position) const
{
  double shortest = 1e300;
  double longest = 0;
  for (Index i = this->Stars.Hexes.Offsets[vertex]; i < this->Stars.Hexes.Offsets[vertex + 1]; ++i)
  {
    for (int neighbor : HexCornerNeighbors[this->Stars.Corners[i]])
    {
      const double length =
        (this->Mesh.Points[this->Mesh.Hexes[this->Stars.Hexes.Ids[i]][neighbor]] - position)
          .squaredNorm();
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
    }
  }
  return longest > 0 ? std::sqrt(shortest / longest) : 0.0;
}

/// Halves the step until accept(position) and all hard checks hold; the vertex is moved or stays.
template <typename Accept>
bool VertexImprover::Search(
  Index vertex, const Star& star, const Vec3& step, int trials, const Accept& accept,
  double leastRatio)
{
  const auto hexes = this->Stars.Hexes[vertex];
  const double ratio = this->EdgeRatio(vertex, star.Position);
  Vec3& point = this->Mesh.Points[vertex];
  const auto leastAt = [&](Index hex, const Vec3& position) {
    point = position;
    return LeastBezierCoefficient(this->Mesh, hex);
  };
  double alpha = 1;
  for (int trial = 0; trial < trials; ++trial, alpha *= 0.5)
  {
    Vec3 position = star.Position + alpha * step;
    if (star.Slides)
    {
      position = this->FeaturesOfMesh->Project(vertex, position);
    }
    if (!accept(position))
    {
      continue;
    }
    const double newRatio = this->EdgeRatio(vertex, position);
    if (newRatio < leastRatio && newRatio < ratio)
    {
      continue;
    }
    const bool sound = std::all_of(hexes.begin(), hexes.end(), [&](Index h) {
      const double least = leastAt(h, position);
      return least > 0 || least >= leastAt(h, star.Position);
    });
    point = position;
    if (sound &&
      (!this->Stars.OnBoundary(vertex) ||
        this->Envelope.AcceptMove(this->Stars.QuadsOfVertex[vertex],
          (position - star.Position).norm(), star.Limit)))
    {
      return true;
    }
    point = star.Position;
  }
  return false;
}

bool VertexImprover::RaiseMinimum(Index vertex)
{
  if (this->Pinned(vertex))
  {
    return false;
  }
  static thread_local Star star;
  this->Gather(vertex, star);
  this->GatherPulls(vertex, NearLimit * this->EnvelopeLimit, star);
  struct Value
  {
    double Level;
    Vec3 Gradient;
  };
  static thread_local std::vector<Value> values;
  values.clear();
  for (const Corner& corner : star.Corners)
  {
    if (corner.Value < star.Least + 0.4)
    {
      values.push_back({ corner.Value, star.Allowed(corner.Gradient(star.Position)) });
    }
  }
  const double scale = 2 / this->EnvelopeLimit;
  for (const Pull& pull : star.Pulls)
  {
    values.push_back({ star.Least + scale * std::max(0.0, star.Limit - pull.Distance),
      star.Allowed(-scale * pull.Gradient) });
  }

  // Proximal step d = rho sum(lambda g), lambda on the simplex minimising rho/2 |sum lambda g|^2 +
  // sum lambda s: pairwise Frank-Wolfe.
  const double rho = LongestStep * star.Length * star.Length;
  static thread_local std::vector<double> lambda;
  lambda.assign(values.size(), 0.0);
  std::size_t least = 0;
  for (std::size_t i = 1; i < values.size(); ++i)
  {
    least = values[i].Level < values[least].Level ? i : least;
  }
  lambda[least] = 1;
  Vec3 sum = values[least].Gradient;
  for (int iteration = 0; iteration < 80; ++iteration)
  {
    std::size_t toward = 0;
    std::size_t away = 0;
    double low = 1e300;
    double high = -1e300;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const double slope = rho * sum.dot(values[i].Gradient) + values[i].Level;
      if (slope < low)
      {
        low = slope;
        toward = i;
      }
      if (lambda[i] > 0 && slope > high)
      {
        high = slope;
        away = i;
      }
    }
    if (high - low < 1e-7)
    {
      break;
    }
    const Vec3 difference = values[toward].Gradient - values[away].Gradient;
    const double curvature = rho * difference.squaredNorm();
    const double shift =
      std::min(curvature > 0 ? (high - low) / curvature : 1.0, lambda[away]);
    lambda[away] -= shift;
    lambda[toward] += shift;
    sum += shift * difference;
  }
  Vec3 step = rho * sum;
  const double length = step.norm();
  if (!(length >= 1e-7 * star.Length))
  {
    return false;
  }
  step *= std::min(1.0, LongestStep * star.Length / length);
  return this->Search(vertex, star, step, 7, [](const Vec3& x) {
    double lowest = 2;
    for (const Corner& corner : star.Corners)
    {
      lowest = std::min(lowest, corner.ScaledJacobian(x));
    }
    return lowest >= star.Least + 1e-6;
  });
}

VertexImprover::Model VertexImprover::DistortionModel(const Star& star)
{
  Model model;
  for (const Corner& corner : star.Corners)
  {
    Vec3 g;
    Mat3 h;
    corner.DistortionDerivatives(star.Position, g, h);
    model.Energy += corner.Distortion(star.Position);
    model.Gradient += g;
    model.Hessian += h;
  }
  return model;
}

/// The energy of RaiseAverage without the surface.
VertexImprover::Model VertexImprover::MeanModel(const Star& star)
{
  Model model = DistortionModel(star);
  model.Energy = 0;
  model.Gradient *= VertexCorner::DistortionWeight;
  model.Hessian *= VertexCorner::DistortionWeight;
  for (const Corner& corner : star.Corners)
  {
    Vec3 g;
    Mat3 h;
    corner.Derivatives(star.Position, g, h);
    model.Energy += corner.MeanEnergy(star.Position);
    const double weight = 2 * VertexCorner::AngleWeight * corner.Weight;
    model.Gradient -= weight * (1 - corner.Value) * g;
    model.Hessian += weight * (g * g.transpose() - (1 - corner.Value) * h);
  }
  return model;
}

/// weight * excess^2 for each contact, excess = distance / limit - start where positive.
void VertexImprover::AddPulls(const Star& star, const PullLaw& law, Model& model) const
{
  for (const Pull& pull : star.Pulls)
  {
    const double excess = pull.Distance / this->EnvelopeLimit - law.Start;
    if (excess > 0)
    {
      const Vec3 g = pull.Gradient / this->EnvelopeLimit;
      model.Energy += law.Weight * excess * excess;
      model.Gradient += 2 * law.Weight * excess * g;
      model.Hessian += 2 * law.Weight * g * g.transpose();
    }
  }
}

/// @a energy with that of the contacts at @a x.
double VertexImprover::WithPulls(
  double energy, const Star& star, const PullLaw& law, const Vec3& x) const
{
  for (const Pull& pull : star.Pulls)
  {
    const double distance = pull.Distance + pull.Gradient.dot(x - star.Position);
    const double excess = distance / this->EnvelopeLimit - law.Start;
    energy += excess > 0 ? law.Weight * excess * excess : 0.0;
  }
  return energy;
}

/// Newton step of the model, limited by the shortest edge; zero when shorter than @a least mean
/// edge lengths.
Vec3 VertexImprover::StepOf(const Model& model, const Star& star, double least)
{
  Vec3 step;
  if (star.Slides)
  {
    const double curvature = std::abs(star.Tangent.dot(model.Hessian * star.Tangent));
    step = -star.Allowed(model.Gradient) / std::max(curvature, 1e-30);
  }
  else
  {
    step = ModifiedNewtonStep(model.Hessian, model.Gradient);
  }
  const double length = step.norm();
  if (!(length >= least * star.Length))
  {
    return Vec3::Zero();
  }
  return step * std::min(1.0, LongestStep * star.Shortest / length);
}

bool VertexImprover::PushBarrier(Index vertex, const BarrierParameters& parameters)
{
  if (this->Pinned(vertex))
  {
    return false;
  }
  static thread_local Star star;
  this->Gather(vertex, star);
  if (star.Least >= parameters.Theta)
  {
    return false;
  }
  this->GatherPulls(vertex, NearLimit * this->EnvelopeLimit, star);

  const auto floor = [&](const Corner& corner) {
    return std::min(parameters.Floor, corner.Value - parameters.Gap);
  };
  Model model;
  for (const Corner& corner : star.Corners)
  {
    const BarrierValue phi = Barrier(corner.Value, floor(corner), parameters.Theta);
    model.Energy += phi.Value;
    if (phi.First != 0 || phi.Second != 0)
    {
      Vec3 g;
      Mat3 h;
      corner.Derivatives(star.Position, g, h);
      model.Gradient += phi.First * g;
      model.Hessian += phi.Second * g * g.transpose() + phi.First * h;
    }
  }
  this->AddPulls(star, BarrierPull, model);
  const Vec3 step = StepOf(model, star, 1e-9);
  return !step.isZero(0) && this->Search(vertex, star, step, 8, [&](const Vec3& x) {
    double sum = 0;
    for (const Corner& corner : star.Corners)
    {
      const double s = corner.ScaledJacobian(x);
      const double lowest = floor(corner);
      if (s <= lowest)
      {
        return false;
      }
      sum += Barrier(s, lowest, parameters.Theta).Value;
    }
    return this->WithPulls(sum, star, BarrierPull, x) <
      model.Energy - 1e-12 * std::abs(model.Energy);
  });
}

bool VertexImprover::DrawInside(Index vertex, double weight)
{
  if (this->Pinned(vertex))
  {
    return false;
  }
  static thread_local Star star;
  this->Gather(vertex, star);
  this->GatherPulls(vertex, DrawNearLimit * this->EnvelopeLimit, star);
  const PullLaw law = { weight, DrawPullStart };
  Model model = DistortionModel(star);
  this->AddPulls(star, law, model);
  const Vec3 step = StepOf(model, star, 1e-9);
  return !step.isZero(0) && this->Search(vertex, star, step, 8, [&](const Vec3& x) {
    double sum = 0;
    for (const Corner& corner : star.Corners)
    {
      sum += corner.Distortion(x);
    }
    return this->WithPulls(sum, star, law, x) < model.Energy - 1e-12 * model.Energy;
  });
}

/// The nearer a corner's error is to the greatest one of its hex, the more it counts.
void VertexImprover::WeighCorners(Index vertex, Star& star) const
{
  std::size_t corner = 0;
  for (Index h : this->Stars.Hexes[vertex])
  {
    const double worst = 1 - LeastScaledJacobian(this->Mesh, h);
    for (int k = 0; k < CornersPerHex; ++k, ++corner)
    {
      const double share = worst > 0 ? (1 - star.Corners[corner].Value) / worst : 1.0;
      const double square = share * share;
      star.Corners[corner].Weight = LeastCornerWeight + (1 - LeastCornerWeight) * square * square;
    }
  }
}

bool VertexImprover::RaiseAverage(Index vertex, const SurfaceGeometry& surface, double floor)
{
  if (this->Pinned(vertex))
  {
    return false;
  }
  static thread_local Star star;
  this->Gather(vertex, star);
  this->WeighCorners(vertex, star);
  Model model = MeanModel(star);
  double weight = 0;
  TrianglePoint anchor;
  Vec3 normal = Vec3::Zero();
  if (this->Stars.OnBoundary(vertex))
  {
    // Beyond the limit already: it may stay there, if the distance is known.
    const double bound = this->Envelope.BoundAround(vertex);
    star.Limit = std::max(star.Limit, bound < 1e300 ? bound : 0.0);
    anchor = this->ClosestOnSurface(vertex, star.Position, surface, normal);
    weight = AveragePull * star.Corners.size() / (star.Length * star.Length);
    model.Gradient += 2 * weight * normal.dot(star.Position - anchor.Point) * normal;
    model.Hessian += 2 * weight * normal * normal.transpose();
  }
  const auto surfaceEnergy = [&](const Vec3& x) {
    const double offset = weight > 0 ? normal.dot(x - anchor.Point) : 0.0;
    return weight * offset * offset;
  };
  model.Energy += surfaceEnergy(star.Position);
  const double lowest = std::min(star.Least, floor) - 1e-12;
  const Vec3 step = StepOf(model, star, 1e-4);
  return !step.isZero(0) && this->Search(vertex, star, step, 8, [&](const Vec3& x) {
    double sum = surfaceEnergy(x);
    for (const Corner& corner : star.Corners)
    {
      if (corner.ScaledJacobian(x) < lowest)
      {
        return false;
      }
      sum += corner.MeanEnergy(x);
    }
    return sum < model.Energy - 1e-12 * model.Energy;
  });
}

bool VertexImprover::Project(Index vertex, const SurfaceGeometry& surface, double floor)
{
  FeatureTargets* const features = this->FeaturesOfMesh;
  const bool onFeature = features && features->OnFeature(vertex);
  if (onFeature && features->Locked(vertex))
  {
    return true;
  }
  static thread_local Star star;
  this->Gather(vertex, star);
  Vec3 normal;
  const Vec3 target = onFeature
                        ? features->Project(vertex, star.Position)
                        : this->ClosestOnSurface(vertex, star.Position, surface, normal).Point;
  if (target == star.Position)
  {
    if (onFeature)
    {
      features->Lock(vertex);
    }
    return true;
  }
  const double lowest = std::min(star.Least, floor) - 1e-12;
  const bool moved = this->Search(vertex, star, target - star.Position, 3, [&](const Vec3& x) {
    for (const Corner& corner : star.Corners)
    {
      if (corner.ScaledJacobian(x) < lowest)
      {
        return false;
      }
    }
    return true;
  }, onFeature ? LeastRatioOnFeatures : LeastEdgeRatio);
  // The whole step lands on the target, up to the rounding of one addition.
  const bool arrived =
    moved && (this->Mesh.Points[vertex] - target).norm() <= 1e-12 * surface.Diagonal();
  if (arrived && onFeature)
  {
    this->Mesh.Points[vertex] = target;
    features->Lock(vertex);
  }
  return arrived;
}
}

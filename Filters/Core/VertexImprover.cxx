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
/// Of the squared angle errors, (1 - scaled Jacobian)^2, in RaiseAverage: at the worst corner of a
/// hex, which decides its quality; this share of it at perfect corners ...
constexpr double AngleWeight = 30.0;
constexpr double LeastCornerShare = 0.3;
constexpr int CornersPerHex = 4; // that change with one of its vertices
/// ... and of the distortion, which alone would trade angles for equal edges.
constexpr double DistortionWeight = 0.05;
constexpr double MipsScale = 0.19245008972987526; // 3^(-3/2)

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

double CornerScaledJacobian(const HexMesh& mesh, const Hex& hex, int corner)
{
  const Vec3& p = mesh.Points[hex[corner]];
  const Vec3 a = mesh.Points[hex[HexCornerNeighbors[corner][0]]] - p;
  const Vec3 b = mesh.Points[hex[HexCornerNeighbors[corner][1]]] - p;
  const Vec3 c = mesh.Points[hex[HexCornerNeighbors[corner][2]]] - p;
  const double lengths = std::sqrt(a.squaredNorm() * b.squaredNorm() * c.squaredNorm());
  return lengths > 0 ? a.dot(b.cross(c)) / lengths : -1.0;
}

double LeastScaledJacobian(const HexMesh& mesh, Index hex)
{
  double least = 2;
  for (int corner = 0; corner < 8; ++corner)
  {
    least = std::min(least, CornerScaledJacobian(mesh, mesh.Hexes[hex], corner));
  }
  return least;
}

double LeastBezierCoefficient(const HexMesh& mesh, Index hex)
{
  // Corner of the hex at (i, j, k) of the unit cube.
  static constexpr int at[2][2][2] = { { { 0, 4 }, { 3, 7 } }, { { 1, 5 }, { 2, 6 } } };
  const Hex& h = mesh.Hexes[hex];
  const auto point = [&](int i, int j, int k) -> const Vec3&
  { return mesh.Points[h[at[i][j][k]]]; };
  Vec3 du[2][2], dv[2][2], dw[2][2];
  for (int a = 0; a < 2; ++a)
  {
    for (int b = 0; b < 2; ++b)
    {
      du[a][b] = point(1, a, b) - point(0, a, b);
      dv[a][b] = point(a, 1, b) - point(a, 0, b);
      dw[a][b] = point(a, b, 1) - point(a, b, 0);
    }
  }
  double coefficients[3][3][3] = {};
  for (int j1 = 0; j1 < 2; ++j1)
  {
    for (int k1 = 0; k1 < 2; ++k1)
    {
      for (int i1 = 0; i1 < 2; ++i1)
      {
        for (int k2 = 0; k2 < 2; ++k2)
        {
          const Vec3 cross = du[j1][k1].cross(dv[i1][k2]);
          for (int i2 = 0; i2 < 2; ++i2)
          {
            for (int j2 = 0; j2 < 2; ++j2)
            {
              coefficients[i1 + i2][j1 + j2][k1 + k2] += cross.dot(dw[i2][j2]);
            }
          }
        }
      }
    }
  }
  static constexpr double binomial[3] = { 1, 2, 1 };
  double least = 1e300;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      for (int k = 0; k < 3; ++k)
      {
        least = std::min(least, coefficients[i][j][k] / (binomial[i] * binomial[j] * binomial[k]));
      }
    }
  }
  return least;
}

/// A corner of an incident hex as a function of the vertex, which is its apex or the end of one of
/// its edges.
struct VertexImprover::Corner
{
  bool Apex = true;
  /// Apex: the three neighbours.
  std::array<Vec3, 3> Ends = { Vec3::Zero(), Vec3::Zero(), Vec3::Zero() };
  Vec3 Origin = Vec3::Zero(); ///< edge end: the apex
  Vec3 Cross = Vec3::Zero();  ///< edge end: cross product of the two other edges ...
  double Product = 0;         ///< ... of their lengths ...
  double Squares = 0;         ///< ... and the sum of their squared lengths
  double Value = 0;           ///< scaled Jacobian at the start
  double Weight = 1;          ///< of its squared angle error in RaiseAverage

  double ScaledJacobian(const Vec3& x) const
  {
    if (!this->Apex)
    {
      const Vec3 a = x - this->Origin;
      const double lengths = a.norm() * this->Product;
      return lengths > 0 ? a.dot(this->Cross) / lengths : -1.0;
    }
    const Vec3 a = this->Ends[0] - x;
    const Vec3 b = this->Ends[1] - x;
    const Vec3 c = this->Ends[2] - x;
    const double lengths = std::sqrt(a.squaredNorm() * b.squaredNorm() * c.squaredNorm());
    return lengths > 0 ? a.dot(b.cross(c)) / lengths : -1.0;
  }

  Vec3 Gradient(const Vec3& x) const
  {
    if (!this->Apex)
    {
      const Vec3 a = x - this->Origin;
      const double length = a.norm();
      return (this->Cross / this->Product - this->Value * a / length) / length;
    }
    Vec3 unit[3];
    double length[3];
    for (int k = 0; k < 3; ++k)
    {
      unit[k] = this->Ends[k] - x;
      length[k] = unit[k].norm();
      unit[k] /= length[k];
    }
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
    {
      sum += (unit[(k + 1) % 3].cross(unit[(k + 2) % 3]) - this->Value * unit[k]) / length[k];
    }
    return -sum;
  }

  void Derivatives(const Vec3& x, Vec3& gradient, Mat3& hessian) const
  {
    if (!this->Apex)
    {
      Vec3 a = x - this->Origin;
      const double length = a.norm();
      a /= length;
      const Vec3 n = this->Cross / this->Product;
      gradient = (n - this->Value * a) / length;
      hessian = (-n * a.transpose() - a * n.transpose() + 3 * this->Value * a * a.transpose() -
                  this->Value * Mat3::Identity()) /
        (length * length);
      return;
    }
    // Through the logarithm: log s = log det - sum of log lengths.
    const Vec3 edges[3] = { this->Ends[0] - x, this->Ends[1] - x, this->Ends[2] - x };
    const Vec3 c01 = edges[0].cross(edges[1]);
    const Vec3 c12 = edges[1].cross(edges[2]);
    const Vec3 c20 = edges[2].cross(edges[0]);
    const double det = edges[0].dot(c12);
    if (!(std::abs(det) > 0))
    {
      gradient.setZero();
      hessian.setZero();
      return;
    }
    gradient = -(c01 + c12 + c20) / det;
    hessian = -gradient * gradient.transpose();
    for (const Vec3& edge : edges)
    {
      const double square = edge.squaredNorm();
      gradient += edge / square;
      hessian += (2 / (square * square)) * edge * edge.transpose();
      hessian.diagonal().array() -= 1 / square;
    }
    hessian = this->Value * (hessian + gradient * gradient.transpose());
    gradient *= this->Value;
  }

  /// MIPS 3^(-3/2) S^(3/2) / det; 1e300 when inverted.
  double Distortion(const Vec3& x) const
  {
    double squares, det;
    if (this->Apex)
    {
      const Vec3 a = this->Ends[0] - x;
      const Vec3 b = this->Ends[1] - x;
      const Vec3 c = this->Ends[2] - x;
      squares = a.squaredNorm() + b.squaredNorm() + c.squaredNorm();
      det = a.dot(b.cross(c));
    }
    else
    {
      const Vec3 a = x - this->Origin;
      squares = a.squaredNorm() + this->Squares;
      det = a.dot(this->Cross);
    }
    return det > 0 ? MipsScale * squares * std::sqrt(squares) / det : 1e300;
  }

  double MeanEnergy(const Vec3& x) const
  {
    const double error = 1 - this->ScaledJacobian(x);
    return AngleWeight * this->Weight * error * error + DistortionWeight * this->Distortion(x);
  }

  void DistortionDerivatives(const Vec3& x, Vec3& gradient, Mat3& hessian) const
  {
    double squares, det, edges;
    Vec3 gradSquares, gradDet;
    if (this->Apex)
    {
      const Vec3 a = this->Ends[0] - x;
      const Vec3 b = this->Ends[1] - x;
      const Vec3 c = this->Ends[2] - x;
      const Vec3 bc = b.cross(c);
      squares = a.squaredNorm() + b.squaredNorm() + c.squaredNorm();
      det = a.dot(bc);
      edges = 3;
      gradSquares = -2 * (a + b + c);
      gradDet = -(bc + c.cross(a) + a.cross(b));
    }
    else
    {
      const Vec3 a = x - this->Origin;
      squares = a.squaredNorm() + this->Squares;
      det = a.dot(this->Cross);
      edges = 1;
      gradSquares = 2 * a;
      gradDet = this->Cross;
    }
    const double f = MipsScale * squares * std::sqrt(squares) / det;
    const double fS = 1.5 * f / squares;
    gradient = fS * gradSquares - (f / det) * gradDet;
    const Vec3 mixed =
      (-1.5 * f / (squares * det)) * gradDet + (0.375 * f / (squares * squares)) * gradSquares;
    hessian = gradSquares * mixed.transpose() + mixed * gradSquares.transpose() +
      (2 * f / (det * det)) * gradDet * gradDet.transpose();
    hessian.diagonal().array() += 2 * fS * edges;
  }
};

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
  std::array<double, 64> before;
  const Index count = std::min<Index>(hexes.size(), static_cast<Index>(before.size()));
  for (Index i = 0; i < count; ++i)
  {
    before[i] = LeastBezierCoefficient(this->Mesh, hexes[i]);
  }
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
    this->Mesh.Points[vertex] = position;
    bool sound = true;
    for (Index i = 0; i < hexes.size() && sound; ++i)
    {
      const double least = LeastBezierCoefficient(this->Mesh, hexes[i]);
      sound = least > 0 || (i < count && least >= before[i]);
    }
    if (sound &&
      (!this->Stars.OnBoundary(vertex) ||
        this->Envelope.AcceptMove(this->Stars.QuadsOfVertex[vertex],
          (position - star.Position).norm(), star.Limit)))
    {
      return true;
    }
    this->Mesh.Points[vertex] = star.Position;
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
  model.Gradient *= DistortionWeight;
  model.Hessian *= DistortionWeight;
  for (const Corner& corner : star.Corners)
  {
    Vec3 g;
    Mat3 h;
    corner.Derivatives(star.Position, g, h);
    model.Energy += corner.MeanEnergy(star.Position);
    const double weight = 2 * AngleWeight * corner.Weight;
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
      star.Corners[corner].Weight = LeastCornerShare + (1 - LeastCornerShare) * square * square;
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

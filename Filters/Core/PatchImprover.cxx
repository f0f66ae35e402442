// SPDX-License-Identifier: BSD-3-Clause
#include "PatchImprover.h"

#include "BarrierFunction.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>

#include <algorithm>
#include <cmath>
#include <set>

namespace featurehex
{
namespace
{
constexpr int OuterIterations = 10;
constexpr int InnerIterations = 5;
constexpr double BarrierWidth = 0.15; // theta above the worst hex
constexpr double BarrierGap = 0.01;
constexpr double LongestStep = 0.35; // of the edge length at a vertex
constexpr double LeastEdgeRatio = 0.1;
constexpr double NearLimit = 0.6; // share of the limit from which contacts are felt
constexpr double PullStart = 0.8; // ... and pull
constexpr double PullWeight = 10.0;
constexpr double LeastGain = 5e-4; // per outer iteration

using Matrix9 = Eigen::Matrix<double, 9, 9>;
using Vector9 = Eigen::Matrix<double, 9, 1>;
using Matrix12 = Eigen::Matrix<double, 12, 12>;
using Vector12 = Eigen::Matrix<double, 12, 1>;

Mat3 CrossMatrix(const Vec3& w)
{
  Mat3 m;
  m << 0, -w[2], w[1], w[2], 0, -w[0], -w[1], w[0], 0;
  return m;
}

/// Scaled Jacobian s = a . (b x c) of unit edges with its derivatives by the three edge vectors.
struct CornerDerivatives
{
  double Value;
  Vector9 Gradient;
  Matrix9 Hessian;

  explicit CornerDerivatives(const std::array<Vec3, 3>& edges)
  {
    Vec3 unit[3];
    double length[3];
    for (int j = 0; j < 3; ++j)
    {
      length[j] = edges[j].norm();
      unit[j] = edges[j] / length[j];
    }
    const double s = unit[0].dot(unit[1].cross(unit[2]));
    this->Value = s;
    for (int j = 0; j < 3; ++j)
    {
      const Vec3 n = unit[(j + 1) % 3].cross(unit[(j + 2) % 3]);
      this->Gradient.segment<3>(3 * j) = (n - s * unit[j]) / length[j];
      this->Hessian.block<3, 3>(3 * j, 3 * j) =
        (-n * unit[j].transpose() - unit[j] * n.transpose() +
          3 * s * unit[j] * unit[j].transpose() - s * Mat3::Identity()) /
        (length[j] * length[j]);
    }
    for (int j = 0; j < 3; ++j)
    {
      const int b = (j + 1) % 3;
      const int c = (j + 2) % 3;
      const Mat3 project = Mat3::Identity() - unit[b] * unit[b].transpose();
      const Mat3 mixed = (-CrossMatrix(unit[c]) * project / length[b] -
                           unit[j] * this->Gradient.segment<3>(3 * b).transpose()) /
        length[j];
      this->Hessian.block<3, 3>(3 * j, 3 * b) = mixed;
      this->Hessian.block<3, 3>(3 * b, 3 * j) = mixed.transpose();
    }
  }
};

void SortUnique(std::vector<Index>& ids)
{
  std::sort(ids.begin(), ids.end());
  ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
}

/// Nearest positive semidefinite matrix.
void MakePositive(Matrix9& matrix)
{
  const Eigen::SelfAdjointEigenSolver<Matrix9> solver(matrix);
  if (solver.eigenvalues()[0] < 0)
  {
    const Vector9 values = solver.eigenvalues().cwiseMax(0.0);
    matrix = solver.eigenvectors() * values.asDiagonal() * solver.eigenvectors().transpose();
  }
}
}

struct PatchImprover::Patch
{
  std::vector<Index> Vertices; ///< free, ascending
  std::vector<Index> Hexes;    ///< all that touch them, ascending
  std::vector<Index> Quads;    ///< all that touch them, ascending
  std::vector<double> Floors;  ///< 8 per hex
  std::vector<double> Sizes;   ///< mean edge length per vertex
  std::vector<EnvelopeContact> Contacts;
  std::vector<Mat3> Freedoms;  ///< of each vertex: projection on the directions it may move in
  double Damping = 1e-3;
  double Limit = 0;
  Eigen::VectorXd Gradient;
  std::vector<Eigen::Triplet<double>> Hessian; ///< lower triangle

  /// Row of the first unknown of a vertex, -1 when it is not free.
  int Row(Index vertex) const
  {
    const auto found = std::lower_bound(this->Vertices.begin(), this->Vertices.end(), vertex);
    return found != this->Vertices.end() && *found == vertex
      ? 3 * static_cast<int>(found - this->Vertices.begin())
      : -1;
  }

  void Add(const std::array<Index, 4>& vertices, const Matrix12& hessian, const Vector12& gradient)
  {
    for (int i = 0; i < 4; ++i)
    {
      const int row = this->Row(vertices[i]);
      if (row < 0)
      {
        continue;
      }
      const Mat3& freedom = this->Freedoms[row / 3];
      this->Gradient.segment<3>(row) += freedom * gradient.segment<3>(3 * i);
      for (int j = 0; j < 4; ++j)
      {
        const int column = this->Row(vertices[j]);
        if (column < 0 || column > row)
        {
          continue;
        }
        const Mat3 block =
          freedom * hessian.block<3, 3>(3 * i, 3 * j) * this->Freedoms[column / 3];
        for (int x = 0; x < 3; ++x)
        {
          for (int y = 0; y < 3; ++y)
          {
            if (row + x >= column + y)
            {
              this->Hessian.emplace_back(row + x, column + y, block(x, y));
            }
          }
        }
      }
    }
  }
};

PatchImprover::PatchImprover(
  HexMesh& mesh, const HexStars& stars, SurfaceEnvelope& envelope, const VertexImprover& vertices)
  : Mesh(mesh)
  , Stars(stars)
  , Envelope(envelope)
  , Vertices(vertices)
{
}

void PatchImprover::RaiseWorst(
  const std::vector<Index>& hexes, double target, int maximumPatches, Monitor& monitor)
{
  std::set<std::pair<double, Index>> queue;
  for (Index h : hexes)
  {
    const double quality = LeastScaledJacobian(this->Mesh, h);
    if (quality < target)
    {
      queue.insert({ quality, h });
    }
  }
  std::vector<int> tries(this->Mesh.Hexes.size(), 0);
  for (int solved = 0; !queue.empty() && solved < maximumPatches && monitor.Update(0.5);)
  {
    const auto [recorded, hex] = *queue.begin();
    queue.erase(queue.begin());
    const double quality = LeastScaledJacobian(this->Mesh, hex);
    if (quality >= target)
    {
      continue;
    }
    if (quality != recorded)
    {
      queue.insert({ quality, hex });
      continue;
    }
    const double reached = this->Solve(hex, 2 + tries[hex], target);
    ++solved;
    if (reached < target && ++tries[hex] < 2)
    {
      queue.insert({ reached, hex });
    }
  }
}

void PatchImprover::BuildPatch(Index hex, int rings, Patch& patch) const
{
  patch.Vertices.assign(this->Mesh.Hexes[hex].begin(), this->Mesh.Hexes[hex].end());
  for (int ring = 0; ring < rings; ++ring)
  {
    patch.Hexes.clear();
    for (Index v : patch.Vertices)
    {
      const auto around = this->Stars.Hexes[v];
      patch.Hexes.insert(patch.Hexes.end(), around.begin(), around.end());
    }
    SortUnique(patch.Hexes);
    for (Index h : patch.Hexes)
    {
      if (ring + 1 < rings)
      {
        const Hex& vertices = this->Mesh.Hexes[h];
        patch.Vertices.insert(patch.Vertices.end(), vertices.begin(), vertices.end());
      }
    }
    SortUnique(patch.Vertices);
  }
  for (Index v : patch.Vertices)
  {
    const auto around = this->Stars.QuadsOfVertex[v];
    patch.Quads.insert(patch.Quads.end(), around.begin(), around.end());
    double sum = 0;
    int count = 0;
    for (Index i = this->Stars.Hexes.Offsets[v]; i < this->Stars.Hexes.Offsets[v + 1]; ++i)
    {
      for (int n : HexCornerNeighbors[this->Stars.Corners[i]])
      {
        sum += (this->Mesh.Points[this->Mesh.Hexes[this->Stars.Hexes.Ids[i]][n]] -
          this->Mesh.Points[v])
                 .norm();
        ++count;
      }
    }
    patch.Sizes.push_back(sum / count);
  }
  SortUnique(patch.Quads);
  patch.Floors.resize(8 * patch.Hexes.size());
}

double PatchImprover::Solve(Index hex, int rings, double target)
{
  Patch patch;
  this->BuildPatch(hex, rings, patch);
  double last = LeastScaledJacobian(this->Mesh, hex);
  for (int outer = 0; outer < OuterIterations && last < target; ++outer)
  {
    const double theta = std::min(target + 0.02, last + BarrierWidth);
    for (std::size_t i = 0; i < patch.Hexes.size(); ++i)
    {
      for (int corner = 0; corner < 8; ++corner)
      {
        const double s =
          CornerScaledJacobian(this->Mesh, this->Mesh.Hexes[patch.Hexes[i]], corner);
        patch.Floors[8 * i + corner] = std::min(last, s) - BarrierGap;
      }
    }
    bool moved = false;
    for (int inner = 0; inner < InnerIterations && this->Step(patch, theta); ++inner)
    {
      moved = true;
    }
    const double reached = LeastScaledJacobian(this->Mesh, hex);
    if (!moved || reached - last < LeastGain)
    {
      return std::max(reached, last);
    }
    last = reached;
  }
  return last;
}

double PatchImprover::Energy(const Patch& patch, double theta) const
{
  double energy = 0;
  for (std::size_t i = 0; i < patch.Hexes.size(); ++i)
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      const double s = CornerScaledJacobian(this->Mesh, this->Mesh.Hexes[patch.Hexes[i]], corner);
      const double value = Barrier(s, patch.Floors[8 * i + corner], theta).Value;
      if (value >= 1e300)
      {
        return 1e300;
      }
      energy += value;
    }
  }
  for (const EnvelopeContact& contact : patch.Contacts)
  {
    const Quad& quad = this->Stars.Quads[contact.Quad];
    Vec3 p = Vec3::Zero();
    for (int k = 0; k < 4; ++k)
    {
      p += contact.Weights[k] * this->Mesh.Points[quad[k]];
    }
    const Vec3 normal = (contact.QuadPoint - contact.SurfacePoint) / contact.Distance;
    const double excess =
      normal.dot(p - contact.SurfacePoint) / this->Vertices.Limit() - PullStart;
    energy += excess > 0 ? PullWeight * excess * excess : 0.0;
  }
  return energy;
}

/// Gradient and Hessian of Energy(); returns the energy.
double PatchImprover::Assemble(Patch& patch, double theta) const
{
  patch.Gradient = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(patch.Vertices.size()));
  patch.Hessian.clear();
  for (std::size_t i = 0; i < patch.Hexes.size(); ++i)
  {
    const Hex& hex = this->Mesh.Hexes[patch.Hexes[i]];
    for (int corner = 0; corner < 8; ++corner)
    {
      const double s = CornerScaledJacobian(this->Mesh, hex, corner);
      const BarrierValue phi = Barrier(s, patch.Floors[8 * i + corner], theta);
      if (phi.First == 0 && phi.Second == 0)
      {
        continue;
      }
      std::array<Vec3, 3> edges;
      std::array<Index, 4> vertices = { hex[corner], 0, 0, 0 };
      for (int k = 0; k < 3; ++k)
      {
        vertices[k + 1] = hex[HexCornerNeighbors[corner][k]];
        edges[k] = this->Mesh.Points[vertices[k + 1]] - this->Mesh.Points[hex[corner]];
      }
      const CornerDerivatives d(edges);
      Matrix9 h = phi.Second * d.Gradient * d.Gradient.transpose() + phi.First * d.Hessian;
      MakePositive(h);
      // The apex moves all three edges the other way.
      Matrix12 hessian;
      Vector12 gradient;
      Eigen::Matrix<double, 9, 12> edgesOfPoints = Eigen::Matrix<double, 9, 12>::Zero();
      for (int k = 0; k < 3; ++k)
      {
        edgesOfPoints.block<3, 3>(3 * k, 0) = -Mat3::Identity();
        edgesOfPoints.block<3, 3>(3 * k, 3 + 3 * k) = Mat3::Identity();
      }
      hessian.noalias() = edgesOfPoints.transpose() * h * edgesOfPoints;
      gradient.noalias() = phi.First * (edgesOfPoints.transpose() * d.Gradient);
      patch.Add(vertices, hessian, gradient);
    }
  }
  for (const EnvelopeContact& contact : patch.Contacts)
  {
    const double excess = contact.Distance / this->Vertices.Limit() - PullStart;
    if (excess > 0)
    {
      const Vec3 normal = (contact.QuadPoint - contact.SurfacePoint) / contact.Distance;
      Vector12 w;
      for (int k = 0; k < 4; ++k)
      {
        w.segment<3>(3 * k) = contact.Weights[k] * normal / this->Vertices.Limit();
      }
      patch.Add(this->Stars.Quads[contact.Quad], 2 * PullWeight * w * w.transpose(),
        2 * PullWeight * excess * w);
    }
  }
  return this->Energy(patch, theta);
}

bool PatchImprover::Sound(const Patch& patch, const std::vector<double>& before) const
{
  for (std::size_t i = 0; i < patch.Hexes.size(); ++i)
  {
    const double least = LeastBezierCoefficient(this->Mesh, patch.Hexes[i]);
    if (!(least > 0) && !(least >= before[i]))
    {
      return false;
    }
  }
  for (Index v : patch.Vertices)
  {
    if (this->Vertices.EdgeRatio(v, this->Mesh.Points[v]) < LeastEdgeRatio)
    {
      return false;
    }
  }
  return true;
}

bool PatchImprover::Step(Patch& patch, double theta)
{
  patch.Contacts.clear();
  patch.Limit = this->Vertices.Limit();
  for (Index q : patch.Quads)
  {
    this->Envelope.Collect(q, NearLimit * this->Vertices.Limit(), patch.Contacts);
  }
  for (const EnvelopeContact& contact : patch.Contacts)
  {
    patch.Limit = std::max(patch.Limit, contact.Distance);
  }
  const FeatureTargets* const features = this->Vertices.Features();
  patch.Freedoms.assign(patch.Vertices.size(), Mat3::Identity());
  for (std::size_t i = 0; features && i < patch.Vertices.size(); ++i)
  {
    const Index v = patch.Vertices[i];
    for (int axis = 0; features->Locked(v) && axis < 3; ++axis)
    {
      patch.Freedoms[i].col(axis) =
        features->Allowed(v, this->Mesh.Points[v], Mat3::Identity().col(axis));
    }
  }
  const double energy = this->Assemble(patch, theta);
  if (!(energy < 1e299) || !(patch.Gradient.norm() > 0))
  {
    return false;
  }
  std::vector<Vec3> start;
  std::vector<double> before;
  for (Index v : patch.Vertices)
  {
    start.push_back(this->Mesh.Points[v]);
  }
  for (Index h : patch.Hexes)
  {
    before.push_back(LeastBezierCoefficient(this->Mesh, h));
  }
  const Eigen::Index unknowns = patch.Gradient.size();
  double trace = 0;
  for (const auto& entry : patch.Hessian)
  {
    trace += entry.row() == entry.col() ? entry.value() : 0.0;
  }
  const IdLists::Range quads = { patch.Quads.data(), patch.Quads.data() + patch.Quads.size() };

  for (int attempt = 0; attempt < 4; ++attempt)
  {
    auto entries = patch.Hessian;
    for (Eigen::Index i = 0; i < unknowns; ++i)
    {
      entries.emplace_back(i, i, (patch.Damping + 1e-9) * trace / unknowns);
    }
    Eigen::SparseMatrix<double> matrix(unknowns, unknowns);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(matrix);
    if (solver.info() != Eigen::Success)
    {
      patch.Damping *= 10;
      continue;
    }
    const Eigen::VectorXd step = -solver.solve(patch.Gradient);
    double relative = 0;
    for (std::size_t i = 0; i < patch.Vertices.size(); ++i)
    {
      const double length = step.segment<3>(3 * static_cast<Eigen::Index>(i)).norm();
      relative = std::max(relative, length / patch.Sizes[i]);
    }
    double alpha = relative > LongestStep ? LongestStep / relative : 1.0;
    for (int trial = 0; trial < 6; ++trial, alpha *= 0.5)
    {
      double shift = 0;
      for (std::size_t i = 0; i < patch.Vertices.size(); ++i)
      {
        const Index v = patch.Vertices[i];
        Vec3& p = this->Mesh.Points[v];
        p = start[i] + alpha * step.segment<3>(3 * static_cast<Eigen::Index>(i));
        if (features && features->Locked(v))
        {
          p = features->Project(v, p);
        }
        shift = std::max(shift, (p - start[i]).norm());
      }
      if (this->Energy(patch, theta) < energy - 1e-9 * std::abs(energy) &&
        this->Sound(patch, before) &&
        this->Envelope.AcceptMove(quads, shift, patch.Limit))
      {
        patch.Damping = std::max(0.3 * patch.Damping, 1e-5);
        return true;
      }
    }
    for (std::size_t i = 0; i < patch.Vertices.size(); ++i)
    {
      this->Mesh.Points[patch.Vertices[i]] = start[i];
    }
    patch.Damping = std::min(10 * patch.Damping, 1e3);
  }
  return false;
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "CornerMeasures.h"

#include "HexStars.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
constexpr double MipsScale = 0.19245008972987526; // 3^(-3/2)
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
  static constexpr double share[3] = { 1, 0.5, 1 }; // 1 / binomial coefficient: exact
  double least = 1e300;
  for (int i = 0; i < 3; ++i)
  {
    for (int j = 0; j < 3; ++j)
    {
      for (int k = 0; k < 3; ++k)
      {
        least = std::min(least, coefficients[i][j][k] * (share[i] * share[j] * share[k]));
      }
    }
  }
  return least;
}

Vec3 VertexCorner::Gradient(const Vec3& x) const
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

void VertexCorner::Derivatives(const Vec3& x, Vec3& gradient, Mat3& hessian) const
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

double VertexCorner::Distortion(const Vec3& x) const
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

double VertexCorner::MeanEnergy(const Vec3& x) const
{
  const double error = 1 - this->ScaledJacobian(x);
  return AngleWeight * this->Weight * error * error + DistortionWeight * this->Distortion(x);
}

void VertexCorner::DistortionDerivatives(const Vec3& x, Vec3& gradient, Mat3& hessian) const
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
}

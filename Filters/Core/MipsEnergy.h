// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The distortion at the corners of a hex as a function of one of its vertices, in closed form
/// (design 4).

#ifndef featurehex_MipsEnergy_h
#define featurehex_MipsEnergy_h

#include "HexStars.h"

#include <cmath>

namespace featurehex
{
/// One corner as a function of the moving vertex: S = |J|^2 (quadratic, Hessian 2 Edges I) and D =
/// det J (affine), J the three edge vectors.
struct MipsCorner
{
  double S, D, Edges;
  Vec3 GradS, GradD;
};

/// The four corners of a hex that depend on its vertex @a corner. @a point(i): position of the i-th
/// vertex.
template <typename PointOf>
std::array<MipsCorner, 4> MipsCornersAt(const PointOf& point, int corner)
{
  std::array<MipsCorner, 4> corners;
  const Vec3& p = point(corner);
  const Vec3 e0 = point(HexCornerNeighbors[corner][0]) - p;
  const Vec3 e1 = point(HexCornerNeighbors[corner][1]) - p;
  const Vec3 e2 = point(HexCornerNeighbors[corner][2]) - p;
  const Vec3 c12 = e1.cross(e2);
  corners[0] = { e0.squaredNorm() + e1.squaredNorm() + e2.squaredNorm(), e0.dot(c12), 3.0,
    -2 * (e0 + e1 + e2), -(c12 + e2.cross(e0) + e0.cross(e1)) };
  for (int r = 0; r < 3; ++r)
  {
    const NeighborCorner& n = NeighborCorners[corner][r];
    const Vec3& apex = point(n.Vertex);
    const Vec3 a = p - apex;
    const Vec3 b = point(n.First) - apex;
    const Vec3 c = point(n.Second) - apex;
    const Vec3 bc = b.cross(c);
    corners[1 + r] = { a.squaredNorm() + b.squaredNorm() + c.squaredNorm(), a.dot(bc), 1.0, 2 * a,
      bc };
  }
  return corners;
}

/// f = S^(3/2) / (3^(3/2) det): 3-D MIPS, 1 at the corner of a cube.
inline double MipsValue(double s, double det)
{
  constexpr double scale = 0.19245008972987526; // 3^(-3/2)
  return scale * s * std::sqrt(s) / det;
}

/// Value, gradient and Hessian of a sum of corners. The Hessian of a corner with its true
/// determinant is positive semidefinite: x^3 / y is convex, and |J| is convex in the vertex.
struct MipsSum
{
  double Value = 0;
  Vec3 Gradient = Vec3::Zero();
  Mat3 Hessian = Mat3::Zero();

  /// @a det: the determinant or its regularisation, with the derivative @a slope by the
  /// determinant. The second derivative of the regularisation is dropped (Gauss-Newton).
  void Add(const MipsCorner& corner, double det, double slope)
  {
    const double f = MipsValue(corner.S, det);
    const double fS = 1.5 * f / corner.S;
    const double fD = -f / det;
    const Vec3 gradD = slope * corner.GradD;
    this->Value += f;
    this->Gradient += fS * corner.GradS + fD * gradD;
    const Vec3 mixed =
      (-1.5 * f / (corner.S * det)) * gradD + (0.375 * f / (corner.S * corner.S)) * corner.GradS;
    this->Hessian.noalias() += corner.GradS * mixed.transpose() +
      mixed * corner.GradS.transpose() + (2 * f / (det * det)) * gradD * gradD.transpose();
    this->Hessian.diagonal().array() += 2 * fS * corner.Edges;
  }
};
}

#endif

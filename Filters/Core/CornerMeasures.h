// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Quality of the corners of hexes as the optimiser sees it: of a mesh, and as a function of one
/// vertex with its derivatives.

#ifndef featurehex_CornerMeasures_h
#define featurehex_CornerMeasures_h

#include "Types.h"

#include <cmath>

namespace featurehex
{
/// Determinant of the unit edge vectors at a corner; -1 when an edge has no length.
double CornerScaledJacobian(const HexMesh& mesh, const Hex& hex, int corner);

/// Least corner scaled Jacobian of a hex; -1 when an edge has no length.
double LeastScaledJacobian(const HexMesh& mesh, Index hex);

/// Least of the 27 Bezier coefficients of the Jacobian determinant of a hex: positive means that
/// the whole element is valid (Johnen, Weill, Remacle 2017).
double LeastBezierCoefficient(const HexMesh& mesh, Index hex);

/// A corner of an incident hex as a function of the vertex, which is its apex or the end of one of
/// its edges.
struct VertexCorner
{
  /// Of the squared angle errors, (1 - scaled Jacobian)^2, in MeanEnergy() ...
  static constexpr double AngleWeight = 30.0;
  /// ... and of the distortion, which alone would trade angles for equal edges.
  static constexpr double DistortionWeight = 0.05;

  bool Apex = true;
  /// Apex: the three neighbours.
  std::array<Vec3, 3> Ends = { Vec3::Zero(), Vec3::Zero(), Vec3::Zero() };
  Vec3 Origin = Vec3::Zero(); ///< edge end: the apex
  Vec3 Cross = Vec3::Zero();  ///< edge end: cross product of the two other edges ...
  double Product = 0;         ///< ... of their lengths ...
  double Squares = 0;         ///< ... and the sum of their squared lengths
  double Value = 0;           ///< scaled Jacobian at the start
  double Weight = 1;          ///< of its squared angle error in RaiseAverage

  // Asked for each corner at each try: inline.
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
  Vec3 Gradient(const Vec3& x) const;
  void Derivatives(const Vec3& x, Vec3& gradient, Mat3& hessian) const;
  /// MIPS 3^(-3/2) S^(3/2) / det; 1e300 when inverted.
  double Distortion(const Vec3& x) const;
  /// Weighted squared angle error and distortion (RaiseAverage).
  double MeanEnergy(const Vec3& x) const;
  void DistortionDerivatives(const Vec3& x, Vec3& gradient, Mat3& hessian) const;
};
}

#endif

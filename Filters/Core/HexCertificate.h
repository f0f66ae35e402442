// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Proof that the Jacobian determinant of a trilinear hex is positive at every point of the hex,
/// not only at its corners. References: A. Johnen, J.-F. Remacle, C. Geuzaine, "Geometrical
/// validity of curvilinear finite elements", Journal of Computational Physics 233, 2013, doi
/// 10.1016/j.jcp.2012.08.051; A. Johnen, J.-C. Weill, J.-F. Remacle, "Robust and efficient
/// validation of the linear hexahedral element", Procedia Engineering 203, 2017, doi
/// 10.1016/j.proeng.2017.09.809.

#ifndef featurehex_HexCertificate_h
#define featurehex_HexCertificate_h

#include "Types.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace featurehex
{
/// The 27 Bernstein-Bezier coefficients of the Jacobian determinant of the trilinear map of the
/// unit cube onto the hex, index i + 3 j + 9 k. They bound the determinant from both sides; those
/// with i, j, k in {0, 2} are its values at the corners; their mean is the volume of the hex. Only
/// differences of points enter, so that a huge offset costs no accuracy. Cost: 0.2 microseconds.
std::array<double, 27> BezierJacobian(const std::array<Vec3, 8>& corners);

/// What is known about the sign of the determinant over the whole closed hex.
enum class Validity : std::uint8_t
{
  Valid,    ///< positive everywhere: proven, rounding errors included
  Invalid,  ///< a point where it is not positive is known, or a point is not finite
  Undecided ///< neither could be shown in doubles at subdivision depth 8
};

/// Result of CertifyHex().
struct HexCertificate
{
  Validity State = Validity::Invalid;
  double LowerBound = -1e300; ///< certified lower bound of the determinant, model units cubed
  double UpperBound = 1e300;  ///< certified upper bound of the determinant
  double Volume = 0.0;        ///< integral of the determinant

  /// LowerBound / UpperBound: a certified lower bound of smallest / largest determinant, 1 for a
  /// parallelepiped; -1 where no point with a positive determinant is certain.
  double Ratio() const
  {
    return this->UpperBound > 0.0 ? std::max(-1.0, this->LowerBound / this->UpperBound) : -1.0;
  }
};

/// Certifies one hex: coefficients in doubles with a bound on their rounding error, octasection to
/// depth 8 where they don't decide.
HexCertificate CertifyHex(const std::array<Vec3, 8>& corners);

/// Certifies a hex of a mesh. Repeated ids and ids that do not exist are Invalid.
HexCertificate CertifyHex(const HexMesh& mesh, Index hex);

/// Certifies every hex. Parallel.
std::vector<HexCertificate> CertifyHexes(const HexMesh& mesh);
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Proof that the Jacobian determinant of a hex of 27 (or 20) nodes is positive everywhere in it.
/// The determinant is a polynomial of degree 5 in each direction; its Bernstein-Bezier coefficients
/// bound it. Reference: A. Johnen, J.-F. Remacle, C. Geuzaine, "Geometrical validity of curvilinear
/// finite elements", Journal of Computational Physics 233, 2013, doi:10.1016/j.jcp.2012.08.051.

#ifndef featurehex_QuadraticCertificate_h
#define featurehex_QuadraticCertificate_h

#include "Types.h"

namespace featurehex
{
/// Nodes of a hex by their place in a grid of 3 x 3 x 3, x fastest.
using HexGrid27 = std::array<Vec3, 27>;

/// Where corner 0 to 7, mid-edge node 8 to 19 (HexEdges), mid-face node 20 to 25 (HexFaces) and the
/// node in the middle (26) are in a HexGrid27.
const std::array<int, 27>& GridPlaces();

/// Sets the mid-face nodes and the one in the middle from the others as the 20-node hex has them:
/// then both are the same map.
void FillSerendipity(HexGrid27& nodes);

/// A lower bound of the determinant, divided by the largest coefficient: of smallest to largest
/// determinant. Positive: proven positive in the whole closed hex, rounding errors included. -1:
/// not proven (not positive somewhere, or too close to decide).
double QuadraticHexRatio(const HexGrid27& nodes);
} // namespace featurehex

#endif

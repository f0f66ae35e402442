// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The moving barrier of the worst-element stage (recipe-quality 2.4).

#ifndef featurehex_BarrierFunction_h
#define featurehex_BarrierFunction_h

#include <algorithm>
#include <cmath>

namespace featurehex
{
/// A function's value and its first and second derivative.
struct BarrierValue
{
  double Value = 0, First = 0, Second = 0;
};

/// phi(s) = -(1 - u)^2 ln u with u = (s - floor) / (theta - floor); 0 for s >= theta, infinite at
/// the floor, twice continuously differentiable.
inline BarrierValue Barrier(double s, double floor, double theta)
{
  BarrierValue phi;
  if (s <= floor)
  {
    phi.Value = 1e300;
    return phi;
  }
  const double width = std::max(theta - floor, 1e-3);
  const double u = (s - floor) / width;
  if (u < 1)
  {
    const double log = std::log(u);
    const double rest = 1 - u;
    phi.Value = -rest * rest * log;
    phi.First = (2 * rest * log - rest * rest / u) / width;
    phi.Second = (-2 * log + 4 * rest / u + rest * rest / (u * u)) / (width * width);
  }
  return phi;
}
}

#endif

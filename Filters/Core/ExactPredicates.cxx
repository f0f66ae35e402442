// SPDX-License-Identifier: BSD-3-Clause
#include "ExactPredicates.h"

namespace featurehex
{
namespace
{
/// A number as an unevaluated sum of doubles: non-overlapping, no zeros, increasing magnitude.
/// std::fma keeps the error terms exact whatever the compiler contracts.
template <int Capacity>
struct Expansion
{
  double Terms[Capacity];
  int Size = 0;

  void Append(double term)
  {
    if (term != 0.0)
    {
      this->Terms[this->Size++] = term;
    }
  }
  int Sign() const { return this->Size == 0 ? 0 : (this->Terms[this->Size - 1] > 0.0 ? 1 : -1); }
};

/// sum + error == a + b exactly (Knuth).
void TwoSum(double a, double b, double& sum, double& error)
{
  sum = a + b;
  const double virtualB = sum - a;
  error = (a - (sum - virtualB)) + (b - virtualB);
}

/// product + error == a * b exactly.
void TwoProduct(double a, double b, double& product, double& error)
{
  product = a * b;
  error = std::fma(a, b, -product);
}

Expansion<2> Difference(double a, double b)
{
  double sum, error;
  TwoSum(a, -b, sum, error);
  Expansion<2> result;
  result.Append(error);
  result.Append(sum);
  return result;
}

/// Shewchuk's fast expansion sum with zero elimination (figure 8); @a sign is 1 or -1.
template <int M, int N>
Expansion<M + N> Sum(const Expansion<M>& e, const Expansion<N>& f, double sign = 1.0)
{
  Expansion<M + N> result;
  int i = 0, j = 0;
  double carry = 0.0;
  while (i < e.Size || j < f.Size)
  {
    const bool takeFirst =
      j == f.Size || (i < e.Size && std::abs(e.Terms[i]) < std::abs(f.Terms[j]));
    const double next = takeFirst ? e.Terms[i++] : sign * f.Terms[j++];
    double sum, error;
    TwoSum(carry, next, sum, error);
    result.Append(error);
    carry = sum;
  }
  result.Append(carry);
  return result;
}

/// Shewchuk's scale expansion with zero elimination (figure 13).
template <int M>
Expansion<2 * M> Scale(const Expansion<M>& e, double factor)
{
  Expansion<2 * M> result;
  double carry = 0.0;
  for (int i = 0; i < e.Size; ++i)
  {
    double product, low, sum, error;
    TwoProduct(e.Terms[i], factor, product, low);
    TwoSum(carry, low, sum, error);
    result.Append(error);
    TwoSum(product, sum, carry, error);
    result.Append(error);
  }
  result.Append(carry);
  return result;
}

template <int M>
Expansion<4 * M> Product(const Expansion<M>& e, const Expansion<2>& f)
{
  Expansion<4 * M> result;
  for (int i = 0; i < f.Size; ++i)
  {
    const Expansion<2 * M> part = Scale(e, f.Terms[i]);
    if (i == 0)
    {
      for (int k = 0; k < part.Size; ++k)
      {
        result.Append(part.Terms[k]);
      }
    }
    else
    {
      Expansion<2 * M> first;
      for (int k = 0; k < result.Size; ++k)
      {
        first.Append(result.Terms[k]);
      }
      result = Sum(first, part);
    }
  }
  return result;
}
} // namespace

std::vector<Vec3> PointsForPredicates(const std::vector<Vec3>& points)
{
  double largest = 0.0;
  double smallest = PredicateMaximum;
  for (const Vec3& p : points)
  {
    for (double c : p)
    {
      const double magnitude = std::abs(c);
      largest = std::max(largest, magnitude);
      if (magnitude > 0.0)
      {
        smallest = std::min(smallest, magnitude);
      }
    }
  }
  std::vector<Vec3> result = points;
  if (largest == 0.0 || (smallest >= PredicateMinimum && largest <= PredicateMaximum))
  {
    return result;
  }
  const int exponent = -std::ilogb(largest);
  for (Vec3& p : result)
  {
    for (double& c : p)
    {
      c = std::ldexp(c, exponent);
      if (std::abs(c) < PredicateMinimum)
      {
        c = 0.0;
      }
    }
  }
  return result;
}

int Orient3DExact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
  Expansion<2> u[3], v[3], w[3];
  for (int k = 0; k < 3; ++k)
  {
    u[k] = Difference(b[k], a[k]);
    v[k] = Difference(c[k], a[k]);
    w[k] = Difference(d[k], a[k]);
  }
  const auto x = Product(Sum(Product(u[1], v[2]), Product(u[2], v[1]), -1.0), w[0]);
  const auto y = Product(Sum(Product(u[2], v[0]), Product(u[0], v[2]), -1.0), w[1]);
  const auto z = Product(Sum(Product(u[0], v[1]), Product(u[1], v[0]), -1.0), w[2]);
  return Sum(Sum(x, y), z).Sign();
}

int Orient2DExact(const Vec3& a, const Vec3& b, const Vec3& c, int i, int j)
{
  const auto left = Product(Difference(b[i], a[i]), Difference(c[j], a[j]));
  const auto right = Product(Difference(b[j], a[j]), Difference(c[i], a[i]));
  return Sum(left, right, -1.0).Sign();
}
} // namespace featurehex

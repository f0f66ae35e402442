// SPDX-License-Identifier: BSD-3-Clause
#include "QuadraticCertificate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace featurehex
{
namespace
{
constexpr int MaximumDepth = 4;

/// Corner of the grid of each hex corner.
constexpr int CornerPlaces[8][3] = { { 0, 0, 0 }, { 2, 0, 0 }, { 2, 2, 0 }, { 0, 2, 0 },
  { 0, 0, 2 }, { 2, 0, 2 }, { 2, 2, 2 }, { 0, 2, 2 } };

std::array<int, 27> MakeGridPlaces()
{
  std::array<int, 27> places{};
  const auto place = [](const int* corners, int count)
  {
    int sum[3] = { 0, 0, 0 };
    for (int i = 0; i < count; ++i)
    {
      for (int k = 0; k < 3; ++k)
      {
        sum[k] += CornerPlaces[corners[i]][k];
      }
    }
    return (sum[0] + 3 * sum[1] + 9 * sum[2]) / count;
  };
  for (int c = 0; c < 8; ++c)
  {
    places[c] = place(&c, 1);
  }
  for (int e = 0; e < 12; ++e)
  {
    places[8 + e] = place(HexEdges[e], 2);
  }
  for (int f = 0; f < 6; ++f)
  {
    places[20 + f] = place(HexFaces[f], 4);
  }
  places[26] = 13;
  return places;
}

/// Coefficients of a Bernstein polynomial in three directions, x fastest.
template <typename Value>
struct Polynomial
{
  int Degree[3];
  std::vector<Value> Values;

  Polynomial(int x, int y, int z, const Value& zero)
    : Degree{ x, y, z }
    , Values(static_cast<std::size_t>((x + 1) * (y + 1) * (z + 1)), zero)
  {
  }
  Value& operator()(int i, int j, int k)
  {
    return this->Values[static_cast<std::size_t>(
      i + (this->Degree[0] + 1) * (j + (this->Degree[1] + 1) * k))];
  }
  const Value& operator()(int i, int j, int k) const
  {
    return const_cast<Polynomial&>(*this)(i, j, k);
  }
};

using Vectors = Polynomial<Vec3>;
using Numbers = Polynomial<double>;

constexpr double Binomials[6][6] = { { 1 }, { 1, 1 }, { 1, 2, 1 }, { 1, 3, 3, 1 },
  { 1, 4, 6, 4, 1 }, { 1, 5, 10, 10, 5, 1 } };

/// Weight of the product of two Bernstein polynomials in one direction.
double Weight(int degreeA, int a, int degreeB, int b)
{
  return Binomials[degreeA][a] * Binomials[degreeB][b] / Binomials[degreeA + degreeB][a + b];
}

template <typename Product, typename Result>
void Multiply(const Vectors& a, const Vectors& b, const Product& product, Result& result)
{
  for (int ka = 0; ka <= a.Degree[2]; ++ka)
  {
    for (int kb = 0; kb <= b.Degree[2]; ++kb)
    {
      const double z = Weight(a.Degree[2], ka, b.Degree[2], kb);
      for (int ja = 0; ja <= a.Degree[1]; ++ja)
      {
        for (int jb = 0; jb <= b.Degree[1]; ++jb)
        {
          const double yz = z * Weight(a.Degree[1], ja, b.Degree[1], jb);
          for (int ia = 0; ia <= a.Degree[0]; ++ia)
          {
            for (int ib = 0; ib <= b.Degree[0]; ++ib)
            {
              result(ia + ib, ja + jb, ka + kb) += yz * Weight(a.Degree[0], ia, b.Degree[0], ib) *
                                                   product(a(ia, ja, ka), b(ib, jb, kb));
            }
          }
        }
      }
    }
  }
}

/// Bezier points of the map, relative to its first node.
Vectors BezierPoints(const HexGrid27& nodes)
{
  Vectors points(2, 2, 2, Vec3::Zero());
  for (int i = 0; i < 27; ++i)
  {
    points.Values[static_cast<std::size_t>(i)] = nodes[static_cast<std::size_t>(i)] - nodes[0];
  }
  for (int step : { 1, 3, 9 })
  {
    for (int i = 0; i < 27; ++i)
    {
      if (i / step % 3 == 1)
      {
        Vec3* p = points.Values.data() + i;
        *p = 2.0 * *p - 0.5 * (p[-step] + p[step]);
      }
    }
  }
  return points;
}

Vectors Derivative(const Vectors& points, int direction)
{
  Vectors result(2 - (direction == 0), 2 - (direction == 1), 2 - (direction == 2), Vec3::Zero());
  for (int k = 0; k <= result.Degree[2]; ++k)
  {
    for (int j = 0; j <= result.Degree[1]; ++j)
    {
      for (int i = 0; i <= result.Degree[0]; ++i)
      {
        result(i, j, k) =
          2.0 * (points(i + (direction == 0), j + (direction == 1), k + (direction == 2)) -
                  points(i, j, k));
      }
    }
  }
  return result;
}

/// Halves of a polynomial in one direction (de Casteljau): @a first becomes the lower one.
Numbers UpperHalf(Numbers& first, int direction)
{
  Numbers upper = first;
  const int steps[3] = { 1, 6, 36 };
  const int step = steps[direction];
  for (int start = 0; start < 216; ++start)
  {
    if (start / step % 6 != 0)
    {
      continue;
    }
    double* low = first.Values.data() + start;
    double* high = upper.Values.data() + start;
    double row[6];
    for (int i = 0; i < 6; ++i)
    {
      row[i] = low[i * step];
    }
    for (int level = 0; level < 6; ++level)
    {
      low[level * step] = row[0];
      high[(5 - level) * step] = row[5 - level];
      for (int i = 0; i + 1 < 6 - level; ++i)
      {
        row[i] = 0.5 * (row[i] + row[i + 1]);
      }
    }
  }
  return upper;
}

/// Smallest coefficient after subdividing where one isn't above @a floor; stops at a corner of a
/// piece that isn't: that is a value of the polynomial.
double SmallestBound(Numbers& polynomial, double floor, int depth)
{
  const double smallest = *std::min_element(polynomial.Values.begin(), polynomial.Values.end());
  if (smallest > floor || depth == MaximumDepth)
  {
    return smallest;
  }
  for (int k : { 0, 5 })
  {
    for (int j : { 0, 5 })
    {
      for (int i : { 0, 5 })
      {
        if (!(polynomial(i, j, k) > floor))
        {
          return polynomial(i, j, k);
        }
      }
    }
  }
  double bound = std::numeric_limits<double>::max();
  std::vector<Numbers> parts = { polynomial };
  for (int direction = 0; direction < 3; ++direction)
  {
    const std::size_t count = parts.size();
    for (std::size_t p = 0; p < count; ++p)
    {
      Numbers upper = UpperHalf(parts[p], direction);
      parts.push_back(std::move(upper));
    }
  }
  for (Numbers& part : parts)
  {
    bound = std::min(bound, SmallestBound(part, floor, depth + 1));
    if (!(bound > floor))
    {
      break;
    }
  }
  return bound;
}
} // namespace

const std::array<int, 27>& GridPlaces()
{
  static const std::array<int, 27> places = MakeGridPlaces();
  return places;
}

void FillSerendipity(HexGrid27& nodes)
{
  const auto& places = GridPlaces();
  Vec3 corners = Vec3::Zero(), edges = Vec3::Zero();
  for (int i = 0; i < 20; ++i)
  {
    (i < 8 ? corners : edges) += nodes[places[i]];
  }
  for (int f = 0; f < 6; ++f)
  {
    const int center = places[20 + f];
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 4; ++k)
    {
      const int a = places[HexFaces[f][k]], b = places[HexFaces[f][(k + 1) % 4]];
      sum += 0.5 * nodes[(a + b) / 2] - 0.25 * nodes[a];
    }
    nodes[center] = sum;
  }
  nodes[13] = 0.25 * edges - 0.25 * corners;
}

double QuadraticHexRatio(const HexGrid27& nodes)
{
  for (const Vec3& node : nodes)
  {
    if (!node.allFinite())
    {
      return -1.0;
    }
  }
  const Vectors points = BezierPoints(nodes);
  const Vectors x = Derivative(points, 0), y = Derivative(points, 1), z = Derivative(points, 2);
  Vectors normals(4, 3, 3, Vec3::Zero());
  Multiply(
    y, z, [](const Vec3& a, const Vec3& b) -> Vec3 { return a.cross(b); }, normals);
  Numbers determinant(5, 5, 5, 0.0);
  Multiply(
    x, normals, [](const Vec3& a, const Vec3& b) { return a.dot(b); }, determinant);

  // Each coefficient is a mean of determinants of such vectors. Their rounding errors are some ten
  // times that of a number as large as the largest Bezier point or vector; 4096 is generous.
  double size = 0.0;
  for (const Vectors* vectors : { &points, &x, &y, &z })
  {
    for (const Vec3& v : vectors->Values)
    {
      size = std::max(size, v.cwiseAbs().maxCoeff());
    }
  }
  const double error = 4096.0 * std::numeric_limits<double>::epsilon() * size * size * size;
  const double largest = *std::max_element(determinant.Values.begin(), determinant.Values.end());
  const double smallest = SmallestBound(determinant, error, 0);
  return smallest > error ? (smallest - error) / (largest + error) : -1.0;
}
} // namespace featurehex

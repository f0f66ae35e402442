// SPDX-License-Identifier: BSD-3-Clause

#include "HexCertificate.h"

#include "Parallel.h"

#include <cmath>
#include <limits>

namespace featurehex
{
namespace
{
using Coefficients = std::array<double, 27>;

constexpr int MaximumDepth = 8;

/// Boxes that one hex may cost; a hex that needs more is practically singular.
constexpr int MaximumBoxes = 5000;

constexpr int CornerCoefficients[8] = { 0, 2, 6, 8, 18, 20, 24, 26 };

/// Vertex of VTK_HEXAHEDRON at the parametric corner [u][v][w].
constexpr int VertexAt[2][2][2] = { { { 0, 4 }, { 3, 7 } }, { { 1, 5 }, { 2, 6 } } };

/// Edge vectors along the three parametric directions, by the two other parameters.
struct EdgeVectors
{
  Vec3 U[2][2]; ///< [v][w]
  Vec3 V[2][2]; ///< [u][w]
  Vec3 W[2][2]; ///< [u][v]

  explicit EdgeVectors(const std::array<Vec3, 8>& p)
  {
    for (int a = 0; a < 2; ++a)
    {
      for (int b = 0; b < 2; ++b)
      {
        this->U[a][b] = p[VertexAt[1][a][b]] - p[VertexAt[0][a][b]];
        this->V[a][b] = p[VertexAt[a][1][b]] - p[VertexAt[a][0][b]];
        this->W[a][b] = p[VertexAt[a][b][1]] - p[VertexAt[a][b][0]];
      }
    }
  }

  /// Product of the greatest 1-norms: bounds the sum of the absolute values of all terms of every
  /// coefficient.
  double Magnitude() const
  {
    double u = 0.0, v = 0.0, w = 0.0;
    for (int a = 0; a < 2; ++a)
    {
      for (int b = 0; b < 2; ++b)
      {
        u = std::max(u, this->U[a][b].cwiseAbs().sum());
        v = std::max(v, this->V[a][b].cwiseAbs().sum());
        w = std::max(w, this->W[a][b].cwiseAbs().sum());
      }
    }
    return u * v * w;
  }

  double LargestComponent() const
  {
    double largest = 0.0;
    for (int a = 0; a < 2; ++a)
    {
      for (int b = 0; b < 2; ++b)
      {
        largest = std::max({ largest, this->U[a][b].cwiseAbs().maxCoeff(),
          this->V[a][b].cwiseAbs().maxCoeff(), this->W[a][b].cwiseAbs().maxCoeff() });
      }
    }
    return largest;
  }

  void Scale(double factor)
  {
    for (int a = 0; a < 2; ++a)
    {
      for (int b = 0; b < 2; ++b)
      {
        this->U[a][b] *= factor;
        this->V[a][b] *= factor;
        this->W[a][b] *= factor;
      }
    }
  }
};

/// det = (U x V) . W is a product of bilinear functions; products of linear Bernstein polynomials
/// are B_a B_b = B2_{a+b} / binomial(2, a+b). U x V is summed over w first: 16 cross and 48 dot
/// products.
Coefficients BezierOf(const EdgeVectors& e)
{
  Coefficients c;
  c.fill(0.0);
  for (int u = 0; u < 2; ++u)
  {
    for (int v = 0; v < 2; ++v)
    {
      const Vec3 cross[3] = { e.U[v][0].cross(e.V[u][0]),
        0.5 * (e.U[v][0].cross(e.V[u][1]) + e.U[v][1].cross(e.V[u][0])),
        e.U[v][1].cross(e.V[u][1]) };
      for (int wu = 0; wu < 2; ++wu)
      {
        for (int wv = 0; wv < 2; ++wv)
        {
          const int i = u + wu, j = v + wv;
          const double factor = (i == 1 ? 0.5 : 1.0) * (j == 1 ? 0.5 : 1.0);
          for (int k = 0; k < 3; ++k)
          {
            c[i + 3 * j + 9 * k] += factor * cross[k].dot(e.W[wu][wv]);
          }
        }
      }
    }
  }
  return c;
}

/// Halves along one parametric direction by de Casteljau's scheme.
void Halve(const Coefficients& c, int stride, Coefficients& low, Coefficients& high)
{
  for (int n = 0; n < 27; ++n)
  {
    if (n / stride % 3 == 0)
    {
      const double a = c[n], b = c[n + stride], d = c[n + 2 * stride];
      const double ab = 0.5 * (a + b), bd = 0.5 * (b + d), middle = 0.5 * (ab + bd);
      low[n] = a;
      low[n + stride] = ab;
      low[n + 2 * stride] = middle;
      high[n] = middle;
      high[n + stride] = bd;
      high[n + 2 * stride] = d;
    }
  }
}

std::array<Coefficients, 8> Octasect(const Coefficients& c)
{
  std::array<Coefficients, 8> result;
  Coefficients x[2], y[2];
  Halve(c, 1, x[0], x[1]);
  for (int a = 0; a < 2; ++a)
  {
    Halve(x[a], 3, y[0], y[1]);
    for (int b = 0; b < 2; ++b)
    {
      Halve(y[b], 9, result[4 * a + 2 * b], result[4 * a + 2 * b + 1]);
    }
  }
  return result;
}

double Least(const Coefficients& c)
{
  return *std::min_element(c.begin(), c.end());
}

double LeastCorner(const Coefficients& c)
{
  double least = c[0];
  for (int n : CornerCoefficients)
  {
    least = std::min(least, c[n]);
  }
  return least;
}

/// A part of the parametric cube that is not proven yet.
struct SubBox
{
  Coefficients Bezier;
  double Low;
  int Depth;
};

/// Subdivides, the worst part first, until the sign is known. Returns the bound of what was proven.
Validity Subdivide(const Coefficients& root, double error, double& lowerBound)
{
  const auto better = [](const SubBox& a, const SubBox& b) { return a.Low > b.Low; };
  std::vector<SubBox> heap{ { root, Least(root), 0 } };
  bool singular = LeastCorner(root) <= error;
  lowerBound = Least(root) - error;
  // A value within the rounding error of zero can't become certain: look a little for a negative
  // one.
  for (int boxes = 0; boxes < (singular ? 100 : MaximumBoxes); ++boxes)
  {
    std::pop_heap(heap.begin(), heap.end(), better);
    const SubBox worst = heap.back();
    heap.pop_back();
    lowerBound = worst.Low - error;
    if (lowerBound > 0.0)
    {
      return singular ? Validity::Undecided : Validity::Valid;
    }
    if (worst.Depth == MaximumDepth)
    {
      return Validity::Undecided;
    }
    for (const Coefficients& child : Octasect(worst.Bezier))
    {
      const double corner = LeastCorner(child);
      if (corner < -error)
      {
        return Validity::Invalid;
      }
      singular = singular || corner <= error;
      heap.push_back({ child, Least(child), worst.Depth + 1 });
      std::push_heap(heap.begin(), heap.end(), better);
    }
  }
  return Validity::Undecided;
}
}

std::array<double, 27> BezierJacobian(const std::array<Vec3, 8>& corners)
{
  return BezierOf(EdgeVectors(corners));
}

HexCertificate CertifyHex(const std::array<Vec3, 8>& corners)
{
  HexCertificate result;
  EdgeVectors edges(corners);
  const double largest = edges.LargestComponent();
  bool finite = std::isfinite(largest);
  for (const Vec3& p : corners)
  {
    finite = finite && p.allFinite();
  }
  if (!finite || largest == 0.0)
  {
    result.UpperBound = finite ? 0.0 : result.UpperBound;
    return result;
  }
  // Powers of two scale exactly: products neither overflow nor underflow.
  int exponent = 0;
  std::frexp(largest, &exponent);
  exponent = std::clamp(exponent, -1000, 1000);
  const bool scale = std::abs(exponent) > 200;
  if (scale)
  {
    edges.Scale(std::ldexp(1.0, -exponent));
  }
  // With u = epsilon / 2: 3 u for the differences, 2 u + 1 u for the cross products, 3 u for the
  // dot products, 3 u for the sums: 6 epsilon. Each level of subdivision: 6 u. The last term:
  // underflow.
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double magnitude = edges.Magnitude();
  const double firstError = 8.0 * epsilon * magnitude + 1e-300;
  const Coefficients c = BezierOf(edges);
  const double least = Least(c);
  result.UpperBound = *std::max_element(c.begin(), c.end()) + firstError;
  result.LowerBound = least - firstError;
  double sum = 0.0;
  for (double v : c)
  {
    sum += v;
  }
  result.Volume = sum / 27.0;
  if (result.LowerBound > 0.0)
  {
    result.State = Validity::Valid;
  }
  else if (LeastCorner(c) < -firstError)
  {
    result.State = Validity::Invalid;
  }
  else
  {
    const double error = firstError + 4.0 * MaximumDepth * epsilon * magnitude;
    result.State = Subdivide(c, error, result.LowerBound);
  }
  if (scale)
  {
    result.LowerBound = std::ldexp(result.LowerBound, 3 * exponent);
    result.UpperBound = std::ldexp(result.UpperBound, 3 * exponent);
    result.Volume = std::ldexp(result.Volume, 3 * exponent);
  }
  return result;
}

HexCertificate CertifyHex(const HexMesh& mesh, Index hexId)
{
  const Hex& hex = mesh.Hexes[hexId];
  const auto count = static_cast<Index>(mesh.Points.size());
  std::array<Vec3, 8> corners;
  for (int i = 0; i < 8; ++i)
  {
    if (hex[i] < 0 || hex[i] >= count ||
      std::find(hex.begin(), hex.begin() + i, hex[i]) != hex.begin() + i)
    {
      return {};
    }
    corners[i] = mesh.Points[hex[i]];
  }
  return CertifyHex(corners);
}

std::vector<HexCertificate> CertifyHexes(const HexMesh& mesh)
{
  std::vector<HexCertificate> result(mesh.Hexes.size());
  ParallelFor(result.size(), 2048,
    [&](std::size_t i) { result[i] = CertifyHex(mesh, static_cast<Index>(i)); });
  return result;
}
}

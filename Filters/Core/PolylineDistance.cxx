// SPDX-License-Identifier: BSD-3-Clause
#include "PolylineDistance.h"

#include <algorithm>

namespace featurehex
{
namespace
{
constexpr int MaximumHalvings = 30;
constexpr double RelativeAccuracy = 0.01;

/// Parameter in [0, 1] of the point of the segment a b that is closest to p.
double ClosestParameter(const Vec3& p, const Vec3& a, const Vec3& b)
{
  const Vec3 edge = b - a;
  const double square = edge.squaredNorm();
  return square > 0.0 ? std::clamp((p - a).dot(edge) / square, 0.0, 1.0) : 0.0;
}

/// Distance of two points to one segment, the larger one.
double LargerDistance(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b)
{
  const Vec3 edge = b - a;
  return std::max((p - (a + ClosestParameter(p, a, b) * edge)).norm(),
    (q - (a + ClosestParameter(q, a, b) * edge)).norm());
}

class Measure
{
public:
  Measure(const Polyline& to, double accuracy)
    : To(to)
    , Accuracy(accuracy)
  {
  }

  /// Raises the bounds to those of the segment p q.
  void Piece(const Vec3& p, const Vec3& q, int halvings)
  {
    double lower = std::max(this->To.Closest(p).Distance, this->To.Closest(q).Distance);
    double upper = 1e300;
    const std::vector<Vec3>& points = this->To.Points();
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const Vec3& a = points[i > 0 ? i - 1 : 0];
      upper = std::min(upper, LargerDistance(p, q, a, points[i]));
    }
    this->Bounds.Lower = std::max(this->Bounds.Lower, lower);
    const double goal = std::max(
      this->Bounds.Lower + this->Accuracy, (1.0 + RelativeAccuracy) * this->Bounds.Lower);
    if (upper <= goal || halvings == 0)
    {
      this->Bounds.Upper = std::max(this->Bounds.Upper, upper);
      return;
    }
    const Vec3 middle = 0.5 * (p + q);
    this->Piece(p, middle, halvings - 1);
    this->Piece(middle, q, halvings - 1);
  }

  LengthBounds Bounds;

private:
  const Polyline& To;
  double Accuracy;
};
}

Polyline::Polyline(std::vector<Vec3> points)
  : Chain(std::move(points))
{
  for (std::size_t i = 0; i < this->Chain.size(); ++i)
  {
    this->Lengths.push_back(
      i == 0 ? 0.0 : this->Lengths.back() + (this->Chain[i] - this->Chain[i - 1]).norm());
  }
}

PolylinePoint Polyline::Closest(const Vec3& p) const
{
  PolylinePoint best;
  for (std::size_t i = 0; i < this->Chain.size(); ++i)
  {
    const Vec3& a = this->Chain[i > 0 ? i - 1 : 0];
    const double t = ClosestParameter(p, a, this->Chain[i]);
    const Vec3 point = a + t * (this->Chain[i] - a);
    const double distance = (p - point).norm();
    if (distance < best.Distance)
    {
      const double start = this->Lengths[i > 0 ? i - 1 : 0];
      best = { point, distance, start + t * (this->Lengths[i] - start) };
    }
  }
  return best;
}

Polyline Polyline::Between(double from, double to) const
{
  std::vector<Vec3> points;
  for (std::size_t i = 1; i < this->Chain.size(); ++i)
  {
    const double a = this->Lengths[i - 1], b = this->Lengths[i];
    if (b < from || a > to || b <= a)
    {
      continue;
    }
    const auto at = [&](double arc) {
      return Vec3(this->Chain[i - 1] + (arc - a) / (b - a) * (this->Chain[i] - this->Chain[i - 1]));
    };
    if (points.empty())
    {
      points.push_back(at(std::max(a, from)));
    }
    points.push_back(at(std::min(b, to)));
  }
  return Polyline(std::move(points));
}

Polyline Polyline::At(const std::vector<double>& arcs) const
{
  std::vector<Vec3> points;
  std::size_t i = 1;
  for (double arc : arcs)
  {
    while (i + 1 < this->Chain.size() && this->Lengths[i] < arc)
    {
      ++i;
    }
    if (i >= this->Chain.size())
    {
      points.push_back(this->Chain.back());
      continue;
    }
    const double length = this->Lengths[i] - this->Lengths[i - 1];
    const double t =
      length > 0.0 ? std::clamp((arc - this->Lengths[i - 1]) / length, 0.0, 1.0) : 1.0;
    points.push_back(this->Chain[i - 1] + t * (this->Chain[i] - this->Chain[i - 1]));
  }
  return Polyline(std::move(points));
}

LengthBounds LargestDistance(const Polyline& from, const Polyline& to, double accuracy)
{
  if (to.Points().empty() || from.Points().empty())
  {
    return from.Points().empty() ? LengthBounds() : LengthBounds{ 1e300, 1e300 };
  }
  // Where the closest segment changes a piece should end: near the points of the other chain.
  std::vector<double> arcs = from.Arcs();
  for (const Vec3& p : to.Points())
  {
    arcs.push_back(from.Closest(p).Arc);
  }
  std::sort(arcs.begin(), arcs.end());
  Measure measure(to, accuracy);
  const Polyline cut = from.At(arcs);
  for (std::size_t i = 0; i < cut.Points().size(); ++i)
  {
    measure.Piece(cut.Points()[i > 0 ? i - 1 : 0], cut.Points()[i], MaximumHalvings);
  }
  return measure.Bounds;
}
}

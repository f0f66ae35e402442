// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceSizing.h"

#include "Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace featurehex
{
namespace
{
/// Bound of the samples before thinning; a wider spacing keeps it. A surface with more cells than
/// that could not be meshed anyway.
constexpr double MaximumSamples = 2e7;

constexpr double Pi = 3.14159265358979323846;
constexpr int MaximumShrinks = 12;
constexpr int MaximumClimbs = 30;

/// Radii are lower bounds; this much less than wanted is enough, and this much larger edges.
constexpr double LevelTolerance = 0.97;

/// A climb ends when steps of this fraction of the ball's radius no longer help.
constexpr double ShortestStep = 0.01;

/// Relative accuracy of radii: cells are chosen in factors of two.
constexpr double RadiusAccuracy = 1e-2;

/// Normals that turn by more belong to two sides of a sharp edge.
constexpr double SharpCosine = 0.70710678118654752;

/// Ids of the entries that are the first with their key, ascending.
template <typename Key>
std::vector<std::size_t> FirstOfEachKey(const std::vector<Key>& keys)
{
  std::vector<std::size_t> order(keys.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return keys[a] < keys[b] || (keys[a] == keys[b] && a < b);
  });
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    if (i == 0 || keys[order[i]] != keys[order[i - 1]])
    {
      first.push_back(order[i]);
    }
  }
  std::sort(first.begin(), first.end());
  return first;
}

/// 0..5: the axis and sign of the largest component.
int MainDirection(const Vec3& v)
{
  int axis = 0;
  v.cwiseAbs().maxCoeff(&axis);
  return 2 * axis + (v[axis] < 0 ? 1 : 0);
}

/// A triangle seen as rows parallel to its longest edge.
struct Rows
{
  Vec3 Start;
  Vec3 Base; ///< longest edge
  Vec3 Side; ///< from Start to the corner opposite to it
  Vec3 Normal;
  double Height;

  Rows(const SurfaceMesh& surface, const Triangle& triangle)
  {
    double longest = -1.0;
    for (int k = 0; k < 3; ++k)
    {
      const Vec3& a = surface.Points[triangle[k]];
      const Vec3 edge = surface.Points[triangle[(k + 1) % 3]] - a;
      if (edge.squaredNorm() > longest)
      {
        longest = edge.squaredNorm();
        this->Start = a;
        this->Base = edge;
        this->Side = surface.Points[triangle[(k + 2) % 3]] - a;
      }
    }
    this->Normal = this->Base.cross(this->Side);
    this->Height = longest > 0 ? this->Normal.norm() / std::sqrt(longest) : 0.0;
  }
};

/// Point of the convex hull of unit vectors that is nearest to the origin: the direction in which
/// all distances grow at least with its length (a few Frank-Wolfe steps; the hull has at most a
/// few corners).
Vec3 SteepestAscent(const std::vector<Vec3>& gradients)
{
  Vec3 best = gradients.back();
  for (int step = 0; step < 20; ++step)
  {
    const Vec3* lowest = &gradients[0];
    for (const Vec3& g : gradients)
    {
      if (g.dot(best) < lowest->dot(best))
      {
        lowest = &g;
      }
    }
    const Vec3 difference = best - *lowest;
    const double gain = difference.dot(best);
    if (gain < 1e-3)
    {
      break;
    }
    best -= std::min(1.0, gain / difference.squaredNorm()) * difference;
  }
  return best;
}

/// An empty ball: the surface doesn't come closer to Center than Radius.
struct EmptyBall
{
  Vec3 Center;
  double Radius;
  Vec3 Contact;
  Index Triangle;
};

EmptyBall BallAt(const TriangleSearch& search, const Vec3& center, Index hint)
{
  const TrianglePoint closest = search.Closest(center, hint);
  return { center, closest.Distance, closest.Point, closest.Triangle };
}

/// Largest ball that touches the surface at @a p from the side of @a normal, at most @a radius.
EmptyBall ShrinkBall(const TriangleSearch& search, const Vec3& p, const Vec3& normal,
  Index triangle, double radius)
{
  EmptyBall ball = BallAt(search, p + radius * normal, triangle);
  for (int step = 0; step < MaximumShrinks && ball.Radius < (1 - RadiusAccuracy) * radius; ++step)
  {
    const Vec3 chord = ball.Contact - p;
    const double height = chord.dot(normal);
    // The ball through p and the contact; shrinks at least a little when rounding spoils it.
    const double touching = height > 0 ? chord.squaredNorm() / (2 * height) : 0.0;
    radius = std::clamp(touching, 0.1 * radius, 0.95 * radius);
    ball = BallAt(search, p + radius * normal, triangle);
  }
  return ball;
}

/// One sample, one side.
class Climber
{
public:
  Climber(const TriangleSearch& search, const Vec3& p, const ClearanceOptions& options)
    : Search(search)
    , Sample(p)
    , Options(options)
  {
  }

  /// Move the ball up the distance field until it has the wanted radius, stops growing or leaves
  /// the sample. Returns the largest radius on the way.
  double Climb(EmptyBall ball)
  {
    double best = this->NearSample(ball) ? ball.Radius : 0.0;
    // Contacts of the last balls: where several are equally near, the distance has a crease.
    std::vector<Vec3> contacts = { ball.Contact };
    double step = this->LongestStep(ball);
    for (int i = 0; i < MaximumClimbs && best < this->Wanted() && step > ShortestStep * ball.Radius;
         ++i)
    {
      const Vec3 ascent = this->Ascent(ball, contacts, step);
      const double rate = ascent.norm();
      if (rate < 0.1)
      {
        // Surrounded by contacts as far as this step goes.
        step *= 0.4;
        continue;
      }
      const EmptyBall next =
        BallAt(this->Search, ball.Center + step / rate * ascent, ball.Triangle);
      contacts.push_back(next.Contact);
      if (next.Radius > ball.Radius + 0.1 * rate * step && this->NearSample(next))
      {
        ball = next;
        best = std::max(best, ball.Radius);
        step = std::min(2 * step, this->LongestStep(ball));
      }
      else
      {
        step *= 0.4;
      }
    }
    return std::min(best, this->Options.MaximumRadius);
  }

  double Wanted() const { return (1 - RadiusAccuracy) * this->Options.MaximumRadius; }

  bool NearSample(const EmptyBall& ball) const
  {
    const double slack = std::max(this->Options.Slack, this->Options.RelativeSlack * ball.Radius);
    // The accuracy of the radius: a ball that touches the sample is near it without any slack.
    return (ball.Center - this->Sample).norm() - ball.Radius <=
      slack + 2 * RadiusAccuracy * ball.Radius;
  }

private:
  /// Within the ball, so that the path can't cross the surface.
  double LongestStep(const EmptyBall& ball) const
  {
    return std::min(0.9 * ball.Radius, 1.01 * this->Options.MaximumRadius - ball.Radius);
  }

  /// Contacts that a step could make the nearest ones count.
  Vec3 Ascent(const EmptyBall& ball, const std::vector<Vec3>& contacts, double step) const
  {
    std::vector<Vec3> gradients;
    for (const Vec3& contact : contacts)
    {
      const Vec3 away = ball.Center - contact;
      const double distance = away.norm();
      if (distance > 0 && distance <= ball.Radius + step)
      {
        gradients.push_back(away / distance);
      }
    }
    return gradients.empty() ? Vec3(Vec3::Zero()) : SteepestAscent(gradients);
  }

  const TriangleSearch& Search;
  const Vec3& Sample;
  const ClearanceOptions& Options;
};

/// The clearance that cells of @a level need: half the thickness or gap for that many cells.
double WantedRadius(const SizingOptions& options, double cells, int level)
{
  return 0.5 * cells * options.TargetEdgeLength * std::ldexp(1.0, -level);
}

/// For thickness and gaps.
int ClearanceLevel(
  const TriangleSearch& search, const SurfaceSample& sample, const SizingOptions& options)
{
  int level = 0;
  for (SurfaceSide side : { SurfaceSide::Inside, SurfaceSide::Outside })
  {
    const double cells =
      side == SurfaceSide::Inside ? options.CellsPerThickness : options.CellsPerGap;
    ClearanceOptions clearance;
    clearance.MaximumRadius = WantedRadius(options, cells, 0);
    clearance.Slack = options.Slack;
    clearance.RelativeSlack = options.RelativeSlack;
    const double radius = ClearanceRadius(search, sample, side, clearance);
    while (level < options.MaximumSizingLevel &&
      radius < LevelTolerance * WantedRadius(options, cells, level))
    {
      ++level;
    }
  }
  return level;
}

int NeededLevel(
  const TriangleSearch& search, const SurfaceSample& sample, const SizingOptions& options)
{
  int level = ClearanceLevel(search, sample, options);
  for (; options.Sag > 0 && level < options.MaximumCurvatureLevel; ++level)
  {
    bool sharp = false;
    const double sag =
      QuadSag(search, sample, std::ldexp(options.TargetEdgeLength, -level), &sharp);
    if (sag <= options.Sag || sharp)
    {
      break;
    }
  }
  return level;
}
}

std::vector<SurfaceSample> SampleSurface(const SurfaceMesh& surface, double spacing)
{
  std::vector<SurfaceSample> samples;
  std::vector<std::array<int, 4>> keys;
  const Box box = BoundingBox(surface);
  if (!(spacing > 0))
  {
    return samples;
  }
  double area = 0.0;
  double length = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    const Rows rows(surface, t);
    area += rows.Base.norm() * rows.Height;
    length += rows.Base.norm();
  }
  spacing = std::max({ spacing, std::sqrt(area / MaximumSamples), length / MaximumSamples,
    1e-6 * box.Diagonal() });
  const auto add = [&](const Vec3& p, std::size_t triangle, int direction) {
    const Vec3 local = (p - box.Low) / spacing;
    samples.push_back({ p, static_cast<Index>(triangle) });
    keys.push_back({ static_cast<int>(local[0]), static_cast<int>(local[1]),
      static_cast<int>(local[2]), direction });
  };
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    const Rows rows(surface, surface.Triangles[t]);
    if (rows.Normal.isZero(0))
    {
      continue;
    }
    const int direction = MainDirection(rows.Normal);
    const int rowCount = std::max(1, static_cast<int>(std::ceil(rows.Height / spacing)));
    for (int j = 0; j < rowCount; ++j)
    {
      const double up = (j + 0.5) / rowCount;
      const Vec3 along = (1 - up) * rows.Base;
      const int count = std::max(1, static_cast<int>(std::ceil(along.norm() / spacing)));
      for (int i = 0; i < count; ++i)
      {
        add(rows.Start + up * rows.Side + (i + 0.5) / count * along, t, direction);
      }
    }
  }
  std::vector<SurfaceSample> result;
  for (std::size_t i : FirstOfEachKey(keys))
  {
    result.push_back(samples[i]);
  }
  return result;
}

std::vector<RefinementPoint> ThinRefinementPoints(
  const std::vector<RefinementPoint>& points, double baseSize)
{
  Box box;
  for (const RefinementPoint& point : points)
  {
    box.Extend(point.Position);
  }
  std::vector<std::array<int, 4>> keys;
  keys.reserve(points.size());
  for (const RefinementPoint& point : points)
  {
    const Vec3 local = (point.Position - box.Low) * std::ldexp(1.0, point.Level) / baseSize;
    keys.push_back({ point.Level, static_cast<int>(local[0]), static_cast<int>(local[1]),
      static_cast<int>(local[2]) });
  }
  std::vector<RefinementPoint> result;
  for (std::size_t i : FirstOfEachKey(keys))
  {
    result.push_back(points[i]);
  }
  return result;
}

double ClearanceRadius(const TriangleSearch& search, const SurfaceSample& sample, SurfaceSide side,
  const ClearanceOptions& options)
{
  const Vec3& p = sample.Position;
  const Vec3 normal =
    search.Normal(sample.Triangle) * (side == SurfaceSide::Outside ? 1.0 : -1.0);
  const EmptyBall ball = ShrinkBall(search, p, normal, sample.Triangle, options.MaximumRadius);
  Climber climber(search, p, options);
  return ball.Radius >= climber.Wanted() ? options.MaximumRadius : climber.Climb(ball);
}

double QuadSag(
  const TriangleSearch& search, const SurfaceSample& sample, double size, bool* sharp)
{
  const Vec3 normal = search.Normal(sample.Triangle);
  const Vec3 u = normal.unitOrthogonal();
  const Vec3 v = normal.cross(u);
  constexpr int count = 8; // corners and sides, on a circle
  const double radius = size / std::sqrt(2.0);
  std::array<double, count + 1> heights;
  double turn = 1;
  double alongU = 0;
  double alongV = 0;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2 * Pi * i / count;
    const Vec3 p = sample.Position + radius * (std::cos(angle) * u + std::sin(angle) * v);
    const TrianglePoint closest = search.Closest(p, sample.Triangle);
    heights[i] = (closest.Point - sample.Position).dot(normal);
    turn = std::min(turn, normal.dot(search.Normal(closest.Triangle)));
    alongU += 2 * heights[i] * std::cos(angle) / count;
    alongV += 2 * heights[i] * std::sin(angle) / count;
  }
  heights[count] = 0;
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2 * Pi * i / count;
    heights[i] -= alongU * std::cos(angle) + alongV * std::sin(angle);
  }
  if (sharp)
  {
    *sharp = turn < SharpCosine;
  }
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  return 0.5 * (*high - *low);
}

double SaggingShare(const std::vector<SurfaceSample>& samples, const TriangleSearch& search,
  const SizingOptions& options, Monitor& monitor)
{
  std::vector<char> sags(samples.size(), 0);
  std::vector<char> smooth(samples.size(), 0);
  ParallelFor(samples.size(), 64, &monitor, [&](std::size_t i) {
    const int level = ClearanceLevel(search, samples[i], options);
    bool sharp = false;
    sags[i] = QuadSag(search, samples[i], std::ldexp(options.TargetEdgeLength, -level), &sharp) >
      options.Sag;
    smooth[i] = !sharp;
  });
  double count = 0;
  double sagging = 0;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    count += smooth[i];
    sagging += smooth[i] && sags[i];
  }
  return count > 0 ? sagging / count : 0.0;
}

std::vector<RefinementPoint> ComputeWantedSizing(const SurfaceMesh& surface,
  const TriangleSearch& search, const std::vector<double>& lengths, double targetEdgeLength,
  int maximumLevel, Monitor& monitor)
{
  const auto wanted = [&](Index point) {
    return lengths[point] > 0 ? lengths[point] : targetEdgeLength;
  };
  double least = targetEdgeLength;
  for (std::size_t p = 0; p < lengths.size(); ++p)
  {
    least = std::min(least, wanted(static_cast<Index>(p)));
  }
  const double finest = std::max(least, std::ldexp(targetEdgeLength, -maximumLevel));
  if (!(finest < targetEdgeLength))
  {
    return {};
  }
  std::vector<RefinementPoint> points;
  for (const SurfaceSample& sample :
    SampleSurface(surface, SizingOptions().SampleSpacing * finest))
  {
    if (monitor.Stopped())
    {
      return {};
    }
    const Triangle& t = surface.Triangles[sample.Triangle];
    const Vec3 weights = search.ClosestOn(sample.Position, sample.Triangle).Barycentric;
    const double length = weights.dot(Vec3(wanted(t[0]), wanted(t[1]), wanted(t[2])));
    int level = 0;
    while (level < maximumLevel && length < LevelTolerance * std::ldexp(targetEdgeLength, -level))
    {
      ++level;
    }
    if (level > 0)
    {
      points.push_back({ sample.Position, level });
    }
  }
  return ThinRefinementPoints(points, targetEdgeLength);
}

std::vector<RefinementPoint> ComputeSizing(const SurfaceMesh& surface,
  const TriangleSearch& search, const SizingOptions& options, Monitor& monitor)
{
  const std::vector<SurfaceSample> samples =
    SampleSurface(surface, options.SampleSpacing * options.TargetEdgeLength);
  std::vector<int> levels(samples.size(), 0);
  // In parts, so that the monitor is asked now and then.
  constexpr std::size_t part = 4096;
  for (std::size_t first = 0; first < samples.size(); first += part)
  {
    if (!monitor.Update(static_cast<double>(first) / samples.size()))
    {
      return {};
    }
    ParallelFor(std::min(part, samples.size() - first), 64, [&](std::size_t i) {
      levels[first + i] = NeededLevel(search, samples[first + i], options);
    });
  }
  std::vector<RefinementPoint> points;
  for (std::size_t i = 0; i < samples.size(); ++i)
  {
    if (levels[i] > 0)
    {
      points.push_back({ samples[i].Position, levels[i] });
    }
  }
  return ThinRefinementPoints(points, options.TargetEdgeLength);
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureDetection.h"

#include "SurfaceTopology.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
/// Triangles lower than this fraction of the diagonal have no normal worth the name: coordinates of
/// files in single precision are that exact.
constexpr double SliverHeight = 1e-6;
/// Slivers beside slivers, at most this many.
constexpr int SliverRounds = 8;
/// A chain goes on where it turns by less than this, degrees.
constexpr double MaximumTurn = 45.0;
/// Gaps of detected features are at least that sharp, compared with the deviation by FeatureAngle.
constexpr double GapSharpness = 0.25;
/// Fewer edges than this on their own are noise.
constexpr std::size_t MinimumEdgesOfChain = 3;

/// 0 for a straight line a b c, degrees.
double TurnAt(const Vec3& a, const Vec3& b, const Vec3& c)
{
  return 180.0 - AngleAt(a, b, c);
}

int LongestSide(const SurfaceMesh& surface, const Triangle& t)
{
  int longest = 0;
  double length = -1.0;
  for (int k = 0; k < 3; ++k)
  {
    const double d = (surface.Points[t[(k + 1) % 3]] - surface.Points[t[k]]).squaredNorm();
    longest = d > length ? k : longest;
    length = std::max(length, d);
  }
  return longest;
}

/// Normals, not normalised; slivers have that of their neighbour.
std::vector<Vec3> ReliableNormals(const SurfaceMesh& surface, const EdgeTable& sides)
{
  const double lowest = SliverHeight * BoundingBox(surface).Diagonal();
  std::vector<Vec3> normals(surface.Triangles.size());
  std::vector<std::array<Index, 2>> slivers; // and the side to look across
  std::vector<char> reliable(surface.Triangles.size(), 1);
  for (std::size_t i = 0; i < normals.size(); ++i)
  {
    const Triangle& t = surface.Triangles[i];
    const Vec3& a = surface.Points[t[0]];
    normals[i] = (surface.Points[t[1]] - a).cross(surface.Points[t[2]] - a);
    const int side = LongestSide(surface, t);
    const double base = (surface.Points[t[(side + 1) % 3]] - surface.Points[t[side]]).norm();
    if (normals[i].norm() < lowest * base)
    {
      reliable[i] = 0;
      slivers.push_back({ static_cast<Index>(i), static_cast<Index>(3 * i) + side });
    }
  }
  if (slivers.empty())
  {
    return normals;
  }
  const std::vector<Index> opposite = OppositeSides(sides);
  for (int round = 0; round < SliverRounds; ++round)
  {
    std::vector<Index> found;
    for (const auto& sliver : slivers)
    {
      const Index neighbor = opposite[sliver[1]] / 3;
      if (!reliable[sliver[0]] && opposite[sliver[1]] >= 0 && reliable[neighbor])
      {
        normals[sliver[0]] = normals[neighbor];
        found.push_back(sliver[0]);
      }
    }
    for (const Index t : found)
    {
      reliable[t] = 1;
    }
  }
  return normals;
}

/// All edges of a surface, some of them chosen.
class EdgeChoice
{
public:
  EdgeChoice(
    const SurfaceMesh& surface, std::vector<SurfaceEdge> edges, FeatureDetectionReport& report)
    : Points(surface.Points)
    , Edges(std::move(edges))
    , Report(report)
    , Diagonal(BoundingBox(surface).Diagonal())
    , Chosen(this->Edges.size(), 0)
    , Valence(surface.Points.size(), 0)
    , First(surface.Points.size() + 1, 0)
    , Around(2 * this->Edges.size())
    , LastPath(surface.Points.size(), 0)
  {
    for (const SurfaceEdge& edge : this->Edges)
    {
      ++this->First[edge.Low + 1];
      ++this->First[edge.High + 1];
    }
    for (std::size_t p = 0; p < surface.Points.size(); ++p)
    {
      this->First[p + 1] += this->First[p];
    }
    std::vector<Index> next(this->First.begin(), this->First.end() - 1);
    for (std::size_t e = 0; e < this->Edges.size(); ++e)
    {
      this->Around[next[this->Edges[e].Low]++] = static_cast<Index>(e);
      this->Around[next[this->Edges[e].High]++] = static_cast<Index>(e);
    }
  }

  void Choose(const std::vector<PointPair>& edges);
  void ChooseSharp(double deviation);
  void Continue(double deviation);
  void CloseGaps(int maximumEdges, double deviation);
  void DropSpurs(double minimumLength);
  std::vector<PointPair> Result() const;

private:
  /// From a chosen point along edges that aren't chosen.
  struct Path
  {
    std::vector<Index> Points;
    std::vector<Index> Edges;
    bool Arrived = false;
  };
  /// From a loose end to a junction, or the other loose end.
  struct Chain
  {
    std::vector<Index> Edges;
    double Length = 0.0;
    Index Junction = -1; ///< -1: on its own
  };

  Index Other(Index edge, Index point) const
  {
    return this->Edges[edge].Low == point ? this->Edges[edge].High : this->Edges[edge].Low;
  }
  Vec3 Middle(Index edge) const
  {
    return 0.5 * (this->Points[this->Edges[edge].Low] + this->Points[this->Edges[edge].High]);
  }
  template <typename Visitor>
  void VisitEdges(Index point, const Visitor& visit) const
  {
    for (Index i = this->First[point]; i < this->First[point + 1]; ++i)
    {
      visit(this->Around[i]);
    }
  }
  void Set(Index edge, bool chosen);
  Index ChosenEdge(Index point, Index except) const;
  bool IsKink(Index point) const;
  bool IsAcute(Index from, Index to) const;
  bool MayArrive(const Path& path, bool loose) const;
  Path Follow(Index before, Index start, Index firstEdge, double deviation);
  std::vector<Path> Continuations(double deviation);
  void SearchGap(
    Index before, const Vec3& direction, int depth, Path& path, Path& best, double& bestCost) const;
  Chain ChainFrom(Index end) const;

  const std::vector<Vec3>& Points;
  std::vector<SurfaceEdge> Edges;
  FeatureDetectionReport& Report;
  double Diagonal;
  double GapDeviation = 0.0;   ///< of a gap edge at least
  std::vector<char> Chosen;    ///< of each edge
  std::vector<Index> Valence;  ///< chosen edges at each point
  std::vector<Index> First;    ///< of each point in Around
  std::vector<Index> Around;   ///< edges at a point, ascending
  std::vector<Index> LastPath; ///< of each point the last path that came by
  Index NumberOfPaths = 0;
};

void EdgeChoice::Set(Index edge, bool chosen)
{
  if (static_cast<bool>(this->Chosen[edge]) != chosen)
  {
    this->Chosen[edge] = chosen;
    this->Valence[this->Edges[edge].Low] += chosen ? 1 : -1;
    this->Valence[this->Edges[edge].High] += chosen ? 1 : -1;
  }
}

void EdgeChoice::Choose(const std::vector<PointPair>& edges)
{
  for (const PointPair& pair : edges)
  {
    const std::uint64_t key = EdgeKey(pair[0], pair[1]);
    const auto edge = std::lower_bound(this->Edges.begin(), this->Edges.end(), key,
      [](const SurfaceEdge& e, std::uint64_t k) { return EdgeKey(e.Low, e.High) < k; });
    if (edge != this->Edges.end() && EdgeKey(edge->Low, edge->High) == key)
    {
      this->Set(static_cast<Index>(edge - this->Edges.begin()), true);
    }
  }
}

void EdgeChoice::ChooseSharp(double deviation)
{
  for (std::size_t e = 0; e < this->Edges.size(); ++e)
  {
    this->Set(static_cast<Index>(e), this->Edges[e].Deviation > deviation);
  }
}

/// A chosen edge at the point other than @a except, -1: none.
Index EdgeChoice::ChosenEdge(Index point, Index except) const
{
  Index found = -1;
  this->VisitEdges(point,
    [&](Index edge)
    {
      if (this->Chosen[edge] && edge != except && found < 0)
      {
        found = edge;
      }
    });
  return found;
}

bool EdgeChoice::IsKink(Index point) const
{
  if (this->Valence[point] != 2)
  {
    return false;
  }
  const Index first = this->ChosenEdge(point, -1);
  const Index second = this->ChosenEdge(point, first);
  return TurnAt(this->Points[this->Other(first, point)], this->Points[point],
           this->Points[this->Other(second, point)]) > MaximumTurn;
}

/// A new edge @a from @a to would make an acute corner there: a strip too thin to be meshed.
bool EdgeChoice::IsAcute(Index from, Index to) const
{
  bool acute = false;
  this->VisitEdges(to,
    [&](Index edge)
    {
      acute = acute ||
              (this->Chosen[edge] && AngleAt(this->Points[from], this->Points[to],
                                       this->Points[this->Other(edge, to)]) < MinimumAngleOfCurves);
    });
  return acute;
}

/// A loose end may go on to any feature, a kink only to another corner.
bool EdgeChoice::MayArrive(const Path& path, bool loose) const
{
  const Index end = path.Points.back();
  return end != path.Points.front() && !this->IsAcute(path.Points[path.Points.size() - 2], end) &&
         (this->Valence[end] > 0 && (loose || this->Valence[end] != 2 || this->IsKink(end)));
}

/// Along the sharpest edges over @a deviation that turn little, until a feature or nothing is
/// there.
EdgeChoice::Path EdgeChoice::Follow(Index before, Index start, Index firstEdge, double deviation)
{
  Path path;
  this->LastPath[start] = ++this->NumberOfPaths;
  path.Points.push_back(start);
  Index next = firstEdge;
  for (;;)
  {
    const Index at = path.Points.back();
    if (next < 0)
    {
      this->VisitEdges(at,
        [&](Index edge)
        {
          const double sharpness = this->Edges[edge].Deviation;
          if (!this->Chosen[edge] && sharpness > deviation &&
              (next < 0 || sharpness > this->Edges[next].Deviation) &&
              TurnAt(this->Points[before], this->Points[at], this->Points[this->Other(edge, at)]) <
                MaximumTurn)
          {
            next = edge;
          }
        });
    }
    if (next < 0)
    {
      return path;
    }
    const Index to = this->Other(next, at);
    if (this->LastPath[to] == this->NumberOfPaths)
    {
      return path; // round in a circle
    }
    this->LastPath[to] = this->NumberOfPaths;
    path.Points.push_back(to);
    path.Edges.push_back(next);
    if (this->Valence[to] > 0)
    {
      return path;
    }
    before = at;
    next = -1;
  }
}

/// Of every loose end and every kink.
std::vector<EdgeChoice::Path> EdgeChoice::Continuations(double deviation)
{
  std::vector<Path> paths;
  const auto add = [&](Path path, bool loose)
  {
    path.Arrived = !path.Edges.empty() && this->MayArrive(path, loose);
    if (path.Arrived || (loose && !path.Edges.empty() && this->Valence[path.Points.back()] == 0))
    {
      paths.push_back(std::move(path));
    }
  };
  for (Index p = 0; p < static_cast<Index>(this->Points.size()); ++p)
  {
    if (this->Valence[p] == 1)
    {
      add(this->Follow(this->Other(this->ChosenEdge(p, -1), p), p, -1, deviation), true);
    }
    else if (this->IsKink(p))
    {
      this->VisitEdges(p,
        [&](Index edge)
        {
          if (!this->Chosen[edge] && this->Edges[edge].Deviation > deviation)
          {
            add(this->Follow(-1, p, edge, deviation), false);
          }
        });
    }
  }
  return paths;
}

void EdgeChoice::Continue(double deviation)
{
  std::vector<Path> paths = this->Continuations(deviation);
  // Chains that fade out towards a common point arrive there, though it has no feature yet.
  std::vector<char> met(this->Points.size(), 0);
  for (const Path& path : paths)
  {
    for (std::size_t i = 1; i < path.Points.size(); ++i)
    {
      char& count = met[path.Points[i]];
      count = static_cast<char>(std::min(2, count + 1));
    }
  }
  for (Path& path : paths)
  {
    while (!path.Arrived && !path.Edges.empty() && met[path.Points.back()] < 2)
    {
      path.Points.pop_back();
      path.Edges.pop_back();
    }
    for (const Index edge : path.Edges)
    {
      if (!this->Chosen[edge])
      {
        this->Set(edge, true);
        this->Report.Continued.push_back(this->Middle(edge));
        ++this->Report.NumberOfContinuedEdges;
      }
    }
  }
}

/// Depth first, few edges deep. The best path is short, straight and sharp.
void EdgeChoice::SearchGap(
  Index before, const Vec3& direction, int depth, Path& path, Path& best, double& bestCost) const
{
  const Index at = path.Points.back();
  this->VisitEdges(at,
    [&](Index edge)
    {
      const Index to = this->Other(edge, at);
      const Vec3 step = this->Points[to] - this->Points[at];
      const double all = AngleAt(this->Points[at] + direction, this->Points[at], this->Points[to]);
      if (this->Chosen[edge] || this->Edges[edge].Deviation < this->GapDeviation ||
          all > MaximumTurn ||
          TurnAt(this->Points[before], this->Points[at], this->Points[to]) > MaximumTurn)
      {
        return;
      }
      path.Points.push_back(to);
      path.Edges.push_back(edge);
      if (this->Valence[to] > 0)
      {
        // Another loose end has to go on in this direction.
        const Index onward = this->ChosenEdge(to, -1);
        const double turn = this->Valence[to] > 1 ? 0.0
                                                  : TurnAt(this->Points[at], this->Points[to],
                                                      this->Points[this->Other(onward, to)]);
        double cost = turn / MaximumTurn;
        for (const Index e : path.Edges)
        {
          cost += 1.0 + 1.0 / (1.0 + this->Edges[e].Deviation);
        }
        cost += (step.normalized() - direction.normalized()).norm();
        if (turn <= MaximumTurn && cost < bestCost && !this->IsAcute(at, to))
        {
          bestCost = cost;
          best = path;
        }
      }
      else if (depth > 1)
      {
        this->SearchGap(at, direction, depth - 1, path, best, bestCost);
      }
      path.Points.pop_back();
      path.Edges.pop_back();
    });
}

void EdgeChoice::CloseGaps(int maximumEdges, double deviation)
{
  this->GapDeviation = deviation;
  for (Index p = 0; maximumEdges > 0 && p < static_cast<Index>(this->Points.size()); ++p)
  {
    if (this->Valence[p] != 1)
    {
      continue;
    }
    const Index before = this->Other(this->ChosenEdge(p, -1), p);
    const Vec3 direction = this->Points[p] - this->Points[before];
    Path path, best;
    path.Points.push_back(p);
    double cost = 1e300;
    this->SearchGap(before, direction, maximumEdges, path, best, cost);
    for (const Index edge : best.Edges)
    {
      this->Set(edge, true);
      this->Report.Gaps.push_back(this->Middle(edge));
      ++this->Report.NumberOfGapEdges;
    }
    this->Report.NumberOfGaps += best.Edges.empty() ? 0 : 1;
  }
}

EdgeChoice::Chain EdgeChoice::ChainFrom(Index end) const
{
  Chain chain;
  Index at = end;
  Index edge = this->ChosenEdge(at, -1);
  for (;;)
  {
    chain.Edges.push_back(edge);
    const Index to = this->Other(edge, at);
    chain.Length += (this->Points[to] - this->Points[at]).norm();
    at = to;
    if (this->Valence[at] != 2)
    {
      chain.Junction = this->Valence[at] == 1 ? -1 : at;
      return chain;
    }
    edge = this->ChosenEdge(at, edge);
  }
}

/// The shortest chain of each junction goes first: what is left there may be one long chain.
void EdgeChoice::DropSpurs(double minimumLength)
{
  const double length = minimumLength * this->Diagonal;
  std::vector<Index> shortest(this->Points.size(), -1); // chain at each junction
  for (bool again = minimumLength > 0.0; again;)
  {
    again = false;
    std::vector<Chain> chains;
    for (Index p = 0; p < static_cast<Index>(this->Points.size()); ++p)
    {
      if (this->Valence[p] == 1)
      {
        Chain chain = this->ChainFrom(p);
        const bool noise = chain.Junction < 0 && chain.Edges.size() < MinimumEdgesOfChain;
        if (noise || chain.Length < length)
        {
          chains.push_back(std::move(chain));
        }
      }
    }
    for (std::size_t c = 0; c < chains.size(); ++c)
    {
      if (chains[c].Junction >= 0)
      {
        Index& best = shortest[chains[c].Junction];
        best = best < 0 || chains[c].Length < chains[best].Length ? static_cast<Index>(c) : best;
      }
    }
    for (std::size_t c = 0; c < chains.size(); ++c)
    {
      const Chain& chain = chains[c];
      if ((chain.Junction >= 0 && shortest[chain.Junction] != static_cast<Index>(c)) ||
          !this->Chosen[chain.Edges[0]])
      {
        continue;
      }
      again = true;
      ++this->Report.NumberOfSpurs;
      for (const Index edge : chain.Edges)
      {
        this->Set(edge, false);
        this->Report.Spurs.push_back(this->Middle(edge));
        ++this->Report.NumberOfSpurEdges;
      }
    }
    for (const Chain& chain : chains)
    {
      if (chain.Junction >= 0)
      {
        shortest[chain.Junction] = -1;
      }
    }
  }
}

std::vector<PointPair> EdgeChoice::Result() const
{
  std::vector<PointPair> edges;
  for (std::size_t e = 0; e < this->Edges.size(); ++e)
  {
    if (this->Chosen[e])
    {
      edges.push_back({ this->Edges[e].Low, this->Edges[e].High });
    }
  }
  return edges;
}
} // namespace

std::vector<SurfaceEdge> MeasureEdges(const SurfaceMesh& surface)
{
  const EdgeTable sides(surface.Triangles);
  const std::vector<Vec3> normals = ReliableNormals(surface, sides);
  std::vector<SurfaceEdge> edges;
  edges.reserve(sides.Uses().size() / 2);
  sides.VisitEdges(
    [&](const EdgeUse* first, const EdgeUse* last)
    {
      SurfaceEdge edge = { first->Low(), first->High(), 0.0 };
      if (last - first == 2)
      {
        edge.Deviation =
          AngleAt(normals[first->Triangle()], Vec3::Zero(), normals[first[1].Triangle()]);
      }
      edges.push_back(edge);
    });
  return edges;
}

std::vector<PointPair> FindSharpEdges(const SurfaceMesh& surface,
  const FeatureDetectionOptions& options, FeatureDetectionReport& report)
{
  report = FeatureDetectionReport();
  EdgeChoice choice(surface, MeasureEdges(surface), report);
  const double sharp = 180.0 - options.FeatureAngle;
  choice.ChooseSharp(sharp);
  report.NumberOfSharpEdges = static_cast<Index>(choice.Result().size());
  if (options.Hysteresis > 0.0)
  {
    choice.Continue(std::max(0.0, sharp - options.Hysteresis));
  }
  choice.CloseGaps(options.MaximumGap, sharp * GapSharpness);
  choice.DropSpurs(options.MinimumLength);
  return choice.Result();
}

void CleanFeatureEdges(const SurfaceMesh& surface, const FeatureDetectionOptions& options,
  std::vector<PointPair>& edges, FeatureDetectionReport& report)
{
  EdgeChoice choice(surface, MeasureEdges(surface), report);
  choice.Choose(edges);
  choice.CloseGaps(options.MaximumGap, 0.0);
  choice.DropSpurs(options.MinimumLength);
  edges = choice.Result();
}
} // namespace featurehex

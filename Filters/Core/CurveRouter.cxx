// SPDX-License-Identifier: BSD-3-Clause
#include "CurveRouter.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <queue>

namespace featurehex
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr Index CornerOwner = -2;
/// Of an edge one edge length away from the curve, per its length.
constexpr double DistancePrice = 2.0;
constexpr double ArcSlack = 2.0;      // progress along the curve per edge length at most
constexpr double SpokePrice = 1.0;    // edge lengths per dart away from the preferred one
constexpr double ReservedPrice = 1.5; // edge lengths
constexpr double OwnedPrice = 4.0;    // edge lengths: a vertex of another path in a relaxed search
constexpr double ShortCurve = 0.6;    // of an edge length
constexpr int LegsOfLoop = 3;
constexpr int ShiftsOfLoop = 3;
constexpr double WideReach = 2.4; // of the usual reach, when it is not enough

/// Price of a turn with so many quads on one side, in edge lengths. One quad there would have a
/// straight angle.
double SidePrice(int quads)
{
  constexpr double prices[] = { 10.0, 0.4, 0.0, 0.05, 0.3, 0.8 };
  return prices[std::min(quads, 5)];
}

/// How badly a sector of @a angle (radians) is served by so many quads.
double SectorCost(double angle, int quads)
{
  const double perQuad = angle / quads * 180 / Pi;
  const double off = (perQuad - 90) / 60;
  return 0.3 * off * off;
}
}

/// A part of a curve with a given start and end.
struct CurveRouter::Leg
{
  Index Curve;
  double From, To;        ///< arcs
  Index Start, End;       ///< vertices
  Index Incoming = -1;    ///< dart that arrives at the start, -1: none
  Index Outgoing = -1;    ///< dart that leaves the end, -1: none
  int FirstSpoke = -1, LastSpoke = -1; ///< when start or end are corners of the curve
};

CurveRouter::CurveRouter(const std::vector<Vec3>& points, const QuadGraph& graph,
  const FeatureGeometry& geometry, const std::vector<Index>& cornerVertices, double reach)
  : Points(points)
  , Graph(graph)
  , Geometry(geometry)
  , CornerVertices(cornerVertices)
  , Reach(reach)
  , CurrentReach(reach)
  , Sizes(points.size(), 0.0)
  , Owner(points.size(), -1)
  , ReservedBy(points.size(), -1)
  , History(points.size(), 0.0)
  , Preferred(cornerVertices.size())
  , Taken(cornerVertices.size())
  , PathOfCurve(geometry.Curves().size())
  , Contested(geometry.Curves().size())
  , Cost(graph.NumberOfDarts(), 0.0)
  , Previous(graph.NumberOfDarts(), -1)
  , Stamp(graph.NumberOfDarts(), 0)
  , OwnPath(points.size(), 0)
{
  for (Index d = 0; d < graph.NumberOfDarts(); ++d)
  {
    const Index v = graph.Tail(d);
    this->Sizes[v] += (points[graph.Head(d)] - points[v]).norm() / graph.Valence(v);
  }
}

std::vector<Index> CurveRouter::ArrangeSpokes(Index corner, Index vertex, double& cost) const
{
  const CornerFan& fan = this->Geometry.Fans()[corner];
  const int spokes = static_cast<int>(fan.Spokes.size());
  const int valence = this->Graph.Valence(vertex);
  cost = 0;
  if (spokes == 0 || spokes > valence)
  {
    cost = spokes == 0 ? 0.0 : 1e300;
    return {};
  }
  std::vector<Index> ring;
  std::vector<Vec3> ringDirections;
  for (Index dart = this->Graph.Leaving(vertex); static_cast<int>(ring.size()) < valence;
       dart = this->Graph.Rotate(dart))
  {
    ring.push_back(dart);
    ringDirections.push_back(
      (this->Points[this->Graph.Head(dart)] - this->Points[vertex]).normalized());
  }
  std::vector<Vec3> directions;
  std::vector<double> sectors;
  for (int i = 0; i < spokes; ++i)
  {
    const CornerFan::Spoke& spoke = fan.Spokes[i];
    const EnforcedCurve& curve = this->Geometry.Curves()[spoke.Curve];
    const Index other = spoke.AtEnd ? curve.FirstCorner : curve.LastCorner;
    const Index neighbor = other >= 0 ? this->CornerVertices[other] : -1;
    const double arc = std::min(1.2 * this->Sizes[vertex], 0.5 * curve.Length());
    const Vec3 target = curve.At(spoke.AtEnd ? curve.Length() - arc : arc);
    // The direction of what is shorter than the edges is that of its edge.
    directions.push_back(
      neighbor >= 0 && neighbor != vertex && this->IsShort(spoke.Curve, vertex)
        ? (this->Points[neighbor] - this->Points[vertex]).normalized()
        : (target - this->Geometry.CornerPoint(corner)).normalized());
    const double next = i + 1 < spokes ? fan.Spokes[i + 1].Angle : fan.FullAngle;
    sectors.push_back(next - spoke.Angle);
  }
  // All ways to choose ring positions in cyclic order.
  std::vector<int> chosen(spokes);
  std::vector<int> best;
  cost = 1e300;
  const auto extend = [&](const auto& self, int spoke, double sum) -> void {
    if (sum >= cost)
    {
      return;
    }
    if (spoke == spokes)
    {
      const double total =
        sum + SectorCost(sectors.back(), chosen.front() + valence - chosen.back());
      if (total < cost)
      {
        cost = total;
        best = chosen;
      }
      return;
    }
    const int first = spoke == 0 ? 0 : chosen[spoke - 1] + 1;
    const int last = spoke == 0 ? valence - 1 : chosen[0] + valence - (spokes - spoke);
    for (int position = first; position <= last; ++position)
    {
      chosen[spoke] = position;
      double price = 1 - directions[spoke].dot(ringDirections[position % valence]);
      if (spoke > 0)
      {
        price += SectorCost(sectors[spoke - 1], position - chosen[spoke - 1]);
      }
      self(self, spoke + 1, sum + price);
    }
  };
  extend(extend, 0, 0.0);
  std::vector<Index> darts;
  for (int position : best)
  {
    darts.push_back(ring[position % valence]);
  }
  return darts;
}

bool CurveRouter::IsShort(Index curve, Index vertex) const
{
  return this->Geometry.Curves()[curve].Length() < ShortCurve * this->Sizes[vertex];
}

int CurveRouter::SpokeOf(Index corner, Index curve, bool atEnd) const
{
  const std::vector<CornerFan::Spoke>& spokes = this->Geometry.Fans()[corner].Spokes;
  for (std::size_t i = 0; i < spokes.size(); ++i)
  {
    if (spokes[i].Curve == curve && spokes[i].AtEnd == atEnd)
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

/// Price of leaving the corner through @a dart, in edge lengths. When the routed spokes leave no
/// place for it: 1e300, or what taking it from them costs.
double CurveRouter::SpokeCost(Index corner, int spoke, Index dart, bool relaxed) const
{
  const Index wanted = this->Preferred[corner][spoke];
  const double price = SpokePrice *
    std::min(this->Graph.Steps(wanted, dart), this->Graph.Steps(dart, wanted));
  if (this->HasRoom(corner, spoke, dart))
  {
    return price;
  }
  return relaxed ? price + OwnedPrice : 1e300;
}

/// The routed spokes of the corner keep their cyclic order, and places for those between, when this
/// one leaves through @a dart.
bool CurveRouter::HasRoom(Index corner, int spoke, Index dart) const
{
  const std::vector<Index>& taken = this->Taken[corner];
  const int spokes = static_cast<int>(taken.size());
  const int valence = this->Graph.Valence(this->CornerVertices[corner]);
  int before = 1;
  while (before < spokes && taken[(spoke + spokes - before) % spokes] < 0)
  {
    ++before;
  }
  int after = 1;
  while (after < spokes && taken[(spoke + after) % spokes] < 0)
  {
    ++after;
  }
  if (before < spokes) // otherwise no other spoke is routed
  {
    const int fromBefore = this->Graph.Steps(taken[(spoke + spokes - before) % spokes], dart);
    int toAfter = this->Graph.Steps(dart, taken[(spoke + after) % spokes]);
    toAfter = toAfter == 0 ? valence : toAfter;
    if (fromBefore < before || toAfter < after)
    {
      return false;
    }
    const int between =
      this->Graph.Steps(taken[(spoke + spokes - before) % spokes], taken[(spoke + after) % spokes]);
    if (fromBefore + toAfter != (between == 0 ? valence : between))
    {
      return false; // not between the two
    }
  }
  return true;
}

double CurveRouter::TurnCost(Index incoming, Index outgoing) const
{
  const int left = this->Graph.QuadsOnLeft(incoming, outgoing);
  const int right = this->Graph.Valence(this->Graph.Tail(outgoing)) - left;
  return left == 0 || right == 0 ? 1e300 : SidePrice(left) + SidePrice(right);
}

bool CurveRouter::Passable(Index vertex, Index curve, bool relaxed) const
{
  const Index owner = this->Owner[vertex];
  return !this->OwnPath[vertex] &&
    (owner == -1 || (relaxed && owner != CornerOwner && owner != curve));
}

/// Dijkstra on darts: the price of a dart holds the turn into it.
bool CurveRouter::RouteLeg(const Leg& leg, bool relaxed, std::vector<Index>& darts)
{
  const EnforcedCurve& curve = this->Geometry.Curves()[leg.Curve];
  struct Entry
  {
    double Cost;
    Index Dart;
    double Arc, Distance; ///< of the head
    bool operator>(const Entry& other) const
    {
      return this->Cost != other.Cost ? this->Cost > other.Cost : this->Dart > other.Dart;
    }
  };
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  ++this->Search;
  const auto visit = [&](Index from, Index dart, double base, double tailArc, double tailDistance) {
    const Index head = this->Graph.Head(dart);
    const bool arrives = head == leg.End;
    if (!arrives && !this->Passable(head, leg.Curve, relaxed))
    {
      return;
    }
    const double size = this->Sizes[head];
    const CurvePoint closest = curve.Closest(this->Points[head], leg.From, leg.To);
    const double length = (this->Points[head] - this->Points[this->Graph.Tail(dart)]).norm();
    if ((!arrives && closest.Distance > this->CurrentReach * size) ||
      std::abs(closest.Arc - tailArc) > ArcSlack * length + 0.3 * size)
    {
      return;
    }
    double turn = 0;
    if (from >= 0)
    {
      turn = this->TurnCost(from, dart);
    }
    else if (leg.FirstSpoke >= 0)
    {
      turn = this->SpokeCost(curve.FirstCorner, leg.FirstSpoke, dart, relaxed);
    }
    if (arrives && leg.LastSpoke >= 0)
    {
      turn += this->SpokeCost(
        curve.LastCorner, leg.LastSpoke, this->Graph.Opposite(dart), relaxed);
    }
    else if (arrives && leg.Outgoing >= 0)
    {
      turn += this->TurnCost(dart, leg.Outgoing);
    }
    if (turn >= 1e300)
    {
      return;
    }
    const double off =
      0.5 * (closest.Distance * closest.Distance + tailDistance * tailDistance) / (size * size);
    double price = length * (1 + DistancePrice * off) + size * turn + size * this->History[head];
    if (!arrives)
    {
      price += this->Owner[head] >= 0 ? OwnedPrice * size : 0.0;
      price += this->ReservedBy[head] >= 0 && this->ReservedBy[head] != leg.Curve
        ? ReservedPrice * size
        : 0.0;
    }
    if (this->Stamp[dart] != this->Search || base + price < this->Cost[dart])
    {
      this->Stamp[dart] = this->Search;
      this->Cost[dart] = base + price;
      this->Previous[dart] = from;
      queue.push({ base + price, dart, closest.Arc, closest.Distance });
    }
  };
  const CurvePoint start = curve.Closest(this->Points[leg.Start], leg.From, leg.To);
  Index dart = this->Graph.Leaving(leg.Start);
  for (int i = 0; i < this->Graph.Valence(leg.Start); ++i, dart = this->Graph.Rotate(dart))
  {
    visit(leg.Incoming, dart, 0.0, start.Arc, start.Distance);
  }
  while (!queue.empty())
  {
    const Entry entry = queue.top();
    queue.pop();
    if (entry.Cost > this->Cost[entry.Dart])
    {
      continue;
    }
    const Index head = this->Graph.Head(entry.Dart);
    if (head == leg.End)
    {
      darts.clear();
      for (Index d = entry.Dart; d != leg.Incoming && d >= 0; d = this->Previous[d])
      {
        darts.push_back(d);
      }
      std::reverse(darts.begin(), darts.end());
      return true;
    }
    const Index back = this->Graph.Opposite(entry.Dart);
    for (Index next = this->Graph.Rotate(back); next != back; next = this->Graph.Rotate(next))
    {
      visit(entry.Dart, next, entry.Cost, entry.Arc, entry.Distance);
    }
  }
  return false;
}

Index CurveRouter::FreeVertexNear(const Vec3& p) const
{
  Index best = -1;
  double least = 1e300;
  for (std::size_t v = 0; v < this->Points.size(); ++v)
  {
    const double square = (this->Points[v] - p).squaredNorm();
    if (square < least && this->Graph.Leaving(static_cast<Index>(v)) >= 0 &&
      this->Owner[v] == -1 && !this->OwnPath[v])
    {
      least = square;
      best = static_cast<Index>(v);
    }
  }
  return best;
}

/// Along a thin wedge the interface ends far from the edge: looks farther when nothing is near. The
/// stops of a loop are tried at other places then, too.
bool CurveRouter::Route(Index c, bool relaxed, std::vector<Index>& path)
{
  const int shifts = this->Geometry.Curves()[c].Closed ? ShiftsOfLoop : 1;
  for (double reach : { this->Reach, WideReach * this->Reach })
  {
    this->CurrentReach = reach;
    for (int shift = 0; shift < shifts; ++shift)
    {
      if (this->RouteFrom(static_cast<double>(shift) / shifts, c, relaxed, path))
      {
        return true;
      }
    }
  }
  return false;
}

/// @a shift: of the stops of a loop, in legs.
bool CurveRouter::RouteFrom(double shift, Index c, bool relaxed, std::vector<Index>& path)
{
  const EnforcedCurve& curve = this->Geometry.Curves()[c];
  path.clear();
  const bool loop = curve.Closed;
  const bool cornerLoop = !loop && curve.FirstCorner >= 0 && curve.FirstCorner == curve.LastCorner;
  const int legs = loop || cornerLoop ? LegsOfLoop : 1;
  const auto arcOf = [&](int i) { return curve.Length() * (i + shift) / legs; };
  std::vector<Index> stops;
  for (int i = 0; i <= legs; ++i)
  {
    const Index corner = i == 0 ? curve.FirstCorner : i == legs ? curve.LastCorner : -1;
    Index stop;
    if (corner >= 0)
    {
      stop = this->CornerVertices[corner];
    }
    else if (i == legs && loop)
    {
      stop = stops.front();
    }
    else
    {
      stop = this->FreeVertexNear(curve.At(arcOf(i) - (i == legs ? 1e-12 : 0)));
    }
    if (stop < 0 || (std::find(stops.begin(), stops.end(), stop) != stops.end() &&
                      !(i == legs && (loop || cornerLoop))))
    {
      return false;
    }
    stops.push_back(stop);
  }
  std::vector<Index> marked(stops.begin() + 1, stops.end() - 1);
  if (loop || curve.FirstCorner < 0)
  {
    marked.push_back(stops.front());
  }
  for (Index v : marked)
  {
    this->OwnPath[v] = 1;
  }
  bool found = true;
  for (int i = 0; i < legs && found; ++i)
  {
    Leg leg = { c, arcOf(i), arcOf(i + 1), stops[i], stops[i + 1] };
    leg.FirstSpoke =
      i == 0 && curve.FirstCorner >= 0 ? this->SpokeOf(curve.FirstCorner, c, false) : -1;
    leg.LastSpoke =
      i + 1 == legs && curve.LastCorner >= 0 ? this->SpokeOf(curve.LastCorner, c, true) : -1;
    leg.Incoming = i > 0 ? path.back() : -1;
    leg.Outgoing = loop && i + 1 == legs ? path.front() : -1;
    std::vector<Index> darts;
    found = this->RouteLeg(leg, relaxed, darts);
    for (Index d : darts)
    {
      path.push_back(d);
      this->OwnPath[this->Graph.Head(d)] = 1;
      marked.push_back(this->Graph.Head(d));
    }
  }
  for (Index v : marked)
  {
    this->OwnPath[v] = 0;
  }
  for (int i = loop ? 0 : 1; found && i < legs; ++i)
  {
    this->SmoothJunction(c, arcOf(i), path, relaxed, loop);
  }
  return found;
}

/// The stops of a loop were chosen blindly: routes once more from the middle of one leg to the
/// middle of the next.
void CurveRouter::SmoothJunction(
  Index c, double arc, std::vector<Index>& path, bool relaxed, bool loop)
{
  const EnforcedCurve& curve = this->Geometry.Curves()[c];
  const double length = curve.Length();
  const double half = 0.5 * length / LegsOfLoop;
  const Index count = static_cast<Index>(path.size());
  // Position of the first dart whose head is past the arc.
  const auto positionOf = [&](double wanted) {
    Index best = 0;
    double least = 1e300;
    for (Index i = 0; i < count; ++i)
    {
      const double distance =
        (this->Points[this->Graph.Tail(path[i])] - curve.At(wanted)).squaredNorm();
      if (distance < least)
      {
        least = distance;
        best = i;
      }
    }
    return best;
  };
  const Index from = positionOf(loop && arc < half ? arc - half + length : arc - half);
  const Index to = positionOf(arc + half);
  const Index span = loop ? (to - from + count) % count : to - from;
  if (span < 2 || span >= count - 2 || (!loop && from == 0))
  {
    return;
  }
  std::vector<Index> rest; // from `to` round to `from`, the part that stays
  for (Index i = 0; i < count - span; ++i)
  {
    rest.push_back(path[(to + i) % count]);
  }
  std::vector<Index> marked;
  for (Index d : rest)
  {
    for (Index v : { this->Graph.Tail(d), this->Graph.Head(d) })
    {
      marked.push_back(v);
      this->OwnPath[v] = 1;
    }
  }
  Leg leg = { c, arc - half, arc + half, this->Graph.Tail(path[from]), this->Graph.Tail(path[to]) };
  if (loop && leg.From < 0)
  {
    leg.From += length;
    leg.To += length;
  }
  leg.Incoming = path[(from + count - 1) % count];
  leg.Outgoing = path[to];
  std::vector<Index> darts;
  const bool found = this->RouteLeg(leg, relaxed, darts);
  for (Index v : marked)
  {
    this->OwnPath[v] = 0;
  }
  if (!found)
  {
    return;
  }
  if (loop)
  {
    path = std::move(rest);
    path.insert(path.end(), darts.begin(), darts.end());
  }
  else
  {
    path.erase(path.begin() + from, path.begin() + to);
    path.insert(path.begin() + from, darts.begin(), darts.end());
  }
}

void CurveRouter::Claim(Index c, const std::vector<Index>& path)
{
  const EnforcedCurve& curve = this->Geometry.Curves()[c];
  for (Index d : path)
  {
    for (Index v : { this->Graph.Tail(d), this->Graph.Head(d) })
    {
      if (this->Owner[v] != CornerOwner)
      {
        this->Owner[v] = c;
      }
    }
  }
  this->PathOfCurve[c] = path;
  if (curve.FirstCorner >= 0)
  {
    this->Taken[curve.FirstCorner][this->SpokeOf(curve.FirstCorner, c, false)] = path.front();
  }
  if (curve.LastCorner >= 0)
  {
    this->Taken[curve.LastCorner][this->SpokeOf(curve.LastCorner, c, true)] =
      this->Graph.Opposite(path.back());
  }
}

void CurveRouter::Release(Index c)
{
  const EnforcedCurve& curve = this->Geometry.Curves()[c];
  for (Index d : this->PathOfCurve[c])
  {
    for (Index v : { this->Graph.Tail(d), this->Graph.Head(d) })
    {
      if (this->Owner[v] == c)
      {
        this->Owner[v] = -1;
      }
    }
  }
  this->PathOfCurve[c].clear();
  if (curve.FirstCorner >= 0)
  {
    this->Taken[curve.FirstCorner][this->SpokeOf(curve.FirstCorner, c, false)] = -1;
  }
  if (curve.LastCorner >= 0)
  {
    this->Taken[curve.LastCorner][this->SpokeOf(curve.LastCorner, c, true)] = -1;
  }
}

/// Releases all curves in the way of a path of @a c and returns them.
std::vector<Index> CurveRouter::MakeWay(Index c, const std::vector<Index>& path)
{
  const EnforcedCurve& curve = this->Geometry.Curves()[c];
  std::vector<Index> released;
  const auto release = [&](Index owner, const Vec3& place) {
    this->Contested[c].push_back(curve.Closest(place).Point);
    this->Contested[owner].push_back(this->Contested[c].back());
    this->Release(owner);
    released.push_back(owner);
  };
  for (Index d : path)
  {
    const Index v = this->Graph.Head(d);
    const Index owner = this->Owner[v];
    if (owner >= 0 && owner != c)
    {
      this->History[v] += 1;
      release(owner, this->Points[v]);
    }
  }
  for (const bool atEnd : { false, true })
  {
    const Index corner = atEnd ? curve.LastCorner : curve.FirstCorner;
    if (corner < 0)
    {
      continue;
    }
    const Index dart = atEnd ? this->Graph.Opposite(path.back()) : path.front();
    const int spoke = this->SpokeOf(corner, c, atEnd);
    const std::vector<Index>& taken = this->Taken[corner];
    const int spokes = static_cast<int>(taken.size());
    const int valence = this->Graph.Valence(this->CornerVertices[corner]);
    for (int i = 1; i < 2 * spokes && !this->HasRoom(corner, spoke, dart); ++i)
    {
      const int ahead = i % spokes;
      const int other = (spoke + ahead) % spokes;
      const int steps = taken[other] < 0 ? 0 : this->Graph.Steps(dart, taken[other]);
      const bool near = steps < ahead || valence - steps < spokes - ahead;
      // First those that are too near, then, for the order, all.
      if (taken[other] >= 0 && (near || i > spokes))
      {
        release(this->Geometry.Fans()[corner].Spokes[other].Curve,
          this->Geometry.CornerPoint(corner));
      }
    }
  }
  return released;
}

std::vector<Index> CurveRouter::RouteAll(int maximumAttempts)
{
  for (std::size_t corner = 0; corner < this->CornerVertices.size(); ++corner)
  {
    const Index vertex = this->CornerVertices[corner];
    if (vertex < 0)
    {
      continue;
    }
    this->Owner[vertex] = CornerOwner;
    double cost;
    this->Preferred[corner] = this->ArrangeSpokes(static_cast<Index>(corner), vertex, cost);
    this->Taken[corner].assign(this->Preferred[corner].size(), -1);
    for (std::size_t i = 0; i < this->Preferred[corner].size(); ++i)
    {
      this->ReservedBy[this->Graph.Head(this->Preferred[corner][i])] =
        this->Geometry.Fans()[corner].Spokes[i].Curve;
    }
  }
  const auto& curves = this->Geometry.Curves();
  std::vector<Index> order;
  std::vector<Index> failed;
  for (Index c = 0; c < static_cast<Index>(curves.size()); ++c)
  {
    const auto placed = [&](Index corner) {
      return corner < 0 || !this->Taken[corner].empty();
    };
    if (curves[c].Points.empty())
    {
      continue;
    }
    (placed(curves[c].FirstCorner) && placed(curves[c].LastCorner) ? order : failed).push_back(c);
  }
  // Short curves have the least choice.
  std::sort(order.begin(), order.end(),
    [&](Index a, Index b)
    {
      return curves[a].Length() != curves[b].Length() ? curves[a].Length() < curves[b].Length()
                                                      : a < b;
    });
  std::deque<Index> queue(order.begin(), order.end());
  std::vector<int> attempts(curves.size(), 0);
  while (!queue.empty())
  {
    const Index c = queue.front();
    queue.pop_front();
    std::vector<Index> path;
    if (this->Route(c, false, path))
    {
      this->Claim(c, path);
      continue;
    }
    if (++attempts[c] > maximumAttempts || !this->Route(c, true, path))
    {
      failed.push_back(c);
      continue;
    }
    for (Index owner : this->MakeWay(c, path))
    {
      queue.push_back(owner);
      ++this->NumberOfReroutes;
    }
    std::vector<Index> better;
    this->Claim(c, this->Route(c, false, better) ? better : path);
  }
  std::sort(failed.begin(), failed.end());
  return failed;
}
} // namespace featurehex

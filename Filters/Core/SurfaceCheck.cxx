// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceCheck.h"

#include "ExactPredicates.h"
#include "SelfIntersection.h"
#include "SurfaceTopology.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <numeric>
#include <sstream>

namespace featurehex
{
namespace
{
/// Coordinates beyond this, and surfaces smaller than its inverse, overflow or underflow when
/// distances and volumes are computed.
constexpr double LargestCoordinate = 1e100;

/// A component whose volume is below this fraction of its area times its diagonal encloses nothing
/// that could be told from rounding errors.
constexpr double FlatVolume = 1e-13;

std::string Count(std::size_t count, const char* singular, const char* plural)
{
  return std::to_string(count) + " " + (count == 1 ? singular : plural);
}

std::string Place(const Vec3& p)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(10);
  out << "(" << p[0] << ", " << p[1] << ", " << p[2] << ")";
  return out.str();
}

/// One check of one surface, step by step. Triangles and points keep their input ids until Finish().
class Checker
{
public:
  Checker(const SurfaceMesh& surface, const SurfaceCheckOptions& options,
    SurfaceCheckReport& report, Monitor& monitor)
    : Input(surface)
    , Options(options)
    , Report(report)
    , Observer(monitor)
  {
  }

  Status Run();
  SurfaceMesh Finish();

private:
  Status CheckIndices() const;
  Status CheckCoordinates() const;
  void MergePoints();
  void DropCollapsedTriangles();
  void DropDuplicateTriangles();
  void Keep(const std::vector<char>& keep);
  Status CheckEdges(const EdgeTable& edges) const;
  Status OverusedEdges(const EdgeTable& edges, std::size_t count) const;
  Status OpenEdges(const EdgeTable& edges, std::size_t count) const;
  Status CoincidentTriangles() const;
  Status CheckFans() const;
  Status FlipDegenerateTriangles();
  Status Orient();
  Status CheckVolumes();
  Status CheckIntersections();
  Status Nest();
  void CountGenus();

  const Vec3& Point(Index id) const { return this->Input.Points[id]; }
  Vec3 Center(Index triangle) const
  {
    const Triangle& t = this->Triangles[triangle];
    return this->Point(t[0]) / 3.0 + this->Point(t[1]) / 3.0 + this->Point(t[2]) / 3.0;
  }
  std::string Name(Index triangle) const
  {
    return std::to_string(this->Source[triangle]);
  }
  /// "from point 3 at (0, 0, 0) to point 8 at (1, 0, 0)"
  std::string EdgeName(const EdgeUse& edge) const
  {
    return "from point " + std::to_string(edge.Low()) + " at " + Place(this->Point(edge.Low())) +
      " to point " + std::to_string(edge.High()) + " at " + Place(this->Point(edge.High()));
  }
  void AddPlace(std::vector<Vec3>& places, const Vec3& p) const
  {
    if (places.size() < this->Options.MaximumNumberOfPlaces)
    {
      places.push_back(p);
    }
  }

  const SurfaceMesh& Input;
  const SurfaceCheckOptions& Options;
  SurfaceCheckReport& Report;
  Monitor& Observer;

  std::vector<Index> Lowest;         ///< of each input point the lowest one at its place
  std::vector<Vec3> Exact;           ///< input points within the range of the predicates
  std::vector<Triangle> Triangles;   ///< kept ones, merged points
  std::vector<Index> Source;         ///< input id of each of Triangles
  std::vector<Index> Twin;           ///< other triangle with the same corners that had to stay, or -1
  std::vector<Index> Opposite;       ///< OppositeSides()
  std::vector<Index> ComponentIds;   ///< component of each of Triangles
  std::vector<char> Reversed;        ///< orientation to be changed
  std::vector<Index> Members;        ///< triangles by component
  std::vector<Index> FirstMember;    ///< of each component in Members, and the end
};

Status Checker::CheckIndices() const
{
  const std::size_t numberOfPoints = this->Input.Points.size();
  if (this->Input.Triangles.empty())
  {
    return Status(StatusCode::EmptySurface,
      numberOfPoints == 0
        ? "The surface is empty: it has no points and no faces. Give a closed triangle surface."
        : "The surface has " + Count(numberOfPoints, "point", "points") +
          " but no faces. Give a closed triangle surface; point clouds have to be reconstructed first.");
  }
  constexpr std::size_t largest = std::numeric_limits<Index>::max() / 3;
  if (numberOfPoints > largest || this->Input.Triangles.size() > largest)
  {
    return Status(StatusCode::IndexOutOfRange, "Index out of range: more than " +
        std::to_string(largest) + " points or triangles. Decimate the surface first.");
  }
  std::size_t bad = 0;
  std::string first;
  for (std::size_t t = 0; t < this->Input.Triangles.size(); ++t)
  {
    for (Index v : this->Input.Triangles[t])
    {
      if ((v < 0 || static_cast<std::size_t>(v) >= numberOfPoints) && bad++ == 0)
      {
        first = "triangle " + std::to_string(t) + " uses point " + std::to_string(v);
      }
    }
  }
  if (bad > 0)
  {
    return Status(StatusCode::IndexOutOfRange,
      "Index out of range: " + Count(bad, "triangle corner uses a point", "triangle corners use points") +
        " that the surface does not have; first, " + first + ", but point ids go from 0 to " +
        std::to_string(static_cast<long long>(numberOfPoints) - 1) +
        ". The file is damaged or truncated: export it again.");
  }
  return Status();
}

Status Checker::CheckCoordinates() const
{
  std::size_t bad = 0;
  std::string first;
  for (std::size_t v = 0; v < this->Input.Points.size(); ++v)
  {
    const Vec3& p = this->Input.Points[v];
    for (int k = 0; k < 3; ++k)
    {
      // Negated, so that NaN is caught.
      if (!(std::abs(p[k]) <= LargestCoordinate))
      {
        if (bad++ == 0)
        {
          first = "point " + std::to_string(v) + " at " + Place(p);
        }
        break;
      }
    }
  }
  if (bad > 0)
  {
    return Status(StatusCode::NonFinite,
      "Non-finite coordinate (not a number, infinite or beyond 1e100) in " +
        Count(bad, "point", "points") + "; first, " + first +
        ". Correct or remove these points where the surface was made.");
  }
  return Status();
}

void Checker::MergePoints()
{
  const std::size_t count = this->Input.Points.size();
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [this](Index a, Index b) {
    const Vec3& p = this->Point(a);
    const Vec3& q = this->Point(b);
    for (int k = 0; k < 3; ++k)
    {
      if (p[k] != q[k])
      {
        return p[k] < q[k];
      }
    }
    return a < b;
  });
  this->Lowest.resize(count);
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool same = i > 0 && this->Point(order[i]) == this->Point(order[i - 1]);
    this->Lowest[order[i]] = same ? this->Lowest[order[i - 1]] : order[i];
  }
  this->Triangles = this->Input.Triangles;
  std::vector<char> merged(count, 0);
  for (Triangle& t : this->Triangles)
  {
    for (Index& v : t)
    {
      merged[v] = this->Lowest[v] != v;
      v = this->Lowest[v];
    }
  }
  this->Report.NumberOfMergedPoints =
    static_cast<Index>(std::count(merged.begin(), merged.end(), char(1)));
  this->Source.resize(this->Triangles.size());
  std::iota(this->Source.begin(), this->Source.end(), 0);
}

void Checker::Keep(const std::vector<char>& keep)
{
  std::size_t kept = 0;
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    if (keep[t])
    {
      this->Triangles[kept] = this->Triangles[t];
      this->Source[kept++] = this->Source[t];
    }
  }
  this->Triangles.resize(kept);
  this->Source.resize(kept);
}

/// A triangle u u w only connects its two neighbours at the edge u w: without it they are neighbours
/// of each other. The number of faces at an edge changes by two, a closed surface stays closed.
void Checker::DropCollapsedTriangles()
{
  std::vector<char> keep(this->Triangles.size(), 1);
  Index dropped = 0;
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    const Triangle& t = this->Triangles[i];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0])
    {
      keep[i] = 0;
      ++dropped;
    }
  }
  this->Report.NumberOfCollapsedTriangles = dropped;
  if (dropped > 0)
  {
    this->Keep(keep);
    this->Report.Warnings.push_back(Count(dropped, "degenerate triangle", "degenerate triangles") +
      " with two corners at the same place dropped.");
  }
}

/// A copy is dropped when it is what makes an edge have more than two faces. It stays when the edges
/// have too many faces without it (two bodies that share a face) or need it (a flat closed piece).
void Checker::DropDuplicateTriangles()
{
  const std::vector<Index> first = FirstDuplicates(this->Triangles);
  std::vector<Triangle> unique;
  for (std::size_t t = 0; t < first.size(); ++t)
  {
    if (first[t] == static_cast<Index>(t))
    {
      unique.push_back(this->Triangles[t]);
    }
  }
  this->Twin.assign(this->Triangles.size(), -1);
  if (unique.size() == this->Triangles.size())
  {
    return;
  }
  const EdgeTable all(this->Triangles);
  const EdgeTable once(unique);
  std::vector<char> keep(this->Triangles.size(), 1);
  std::vector<Index> twin = this->Twin;
  for (std::size_t t = 0; t < first.size(); ++t)
  {
    if (first[t] == static_cast<Index>(t))
    {
      continue;
    }
    bool superfluous = false;
    bool enough = true;
    for (int k = 0; k < 3; ++k)
    {
      const Index u = this->Triangles[t][k];
      const Index v = this->Triangles[t][(k + 1) % 3];
      superfluous = superfluous || all.NumberOfFaces(u, v) > 2;
      enough = enough && once.NumberOfFaces(u, v) <= 2;
    }
    keep[t] = !(superfluous && enough);
    twin[t] = first[t];
  }
  // Ids of the triangles that stay.
  std::vector<Index> next(this->Triangles.size());
  std::transform_exclusive_scan(keep.begin(), keep.end(), next.begin(), Index(0),
    std::plus<Index>(), [](char kept) { return static_cast<Index>(kept); });
  this->Keep(keep);
  this->Twin.assign(this->Triangles.size(), -1);
  for (std::size_t t = 0; t < keep.size(); ++t)
  {
    if (keep[t] && twin[t] >= 0)
    {
      this->Twin[next[t]] = next[twin[t]];
      this->Twin[next[twin[t]]] = next[t];
    }
  }
  this->Report.NumberOfDuplicateTriangles =
    static_cast<Index>(keep.size() - this->Triangles.size());
  if (this->Report.NumberOfDuplicateTriangles > 0)
  {
    this->Report.Warnings.push_back(
      Count(this->Report.NumberOfDuplicateTriangles, "duplicate triangle", "duplicate triangles") +
      " dropped.");
  }
}

Status Checker::CheckEdges(const EdgeTable& edges) const
{
  std::size_t open = 0, overused = 0;
  bool coincident = false;
  edges.VisitEdges([&](const EdgeUse* first, const EdgeUse* last) {
    open += last - first == 1 ? 1 : 0;
    overused += last - first > 2 ? 1 : 0;
    for (const EdgeUse* use = first; last - first > 2 && use != last; ++use)
    {
      coincident = coincident || this->Twin[use->Triangle()] >= 0;
    }
  });
  if (coincident)
  {
    return this->CoincidentTriangles();
  }
  if (overused > 0)
  {
    return this->OverusedEdges(edges, overused);
  }
  return open > 0 ? this->OpenEdges(edges, open) : Status();
}

Status Checker::CoincidentTriangles() const
{
  std::vector<Vec3> places;
  std::size_t count = 0;
  std::string first;
  for (std::size_t t = 0; t < this->Twin.size(); ++t)
  {
    if (this->Twin[t] > static_cast<Index>(t))
    {
      if (count++ == 0)
      {
        first = "triangles " + this->Name(static_cast<Index>(t)) + " and " +
          this->Name(this->Twin[t]) + " at " + Place(this->Center(static_cast<Index>(t)));
      }
      this->AddPlace(places, this->Center(static_cast<Index>(t)));
    }
  }
  return Status(StatusCode::SelfIntersection,
    "Self-intersection (coplanar overlap): " + Count(count, "pair", "pairs") +
      " of triangles with the same corners; first, " + first +
      ". Two bodies or sheets touch there: unite them (Boolean union) or move them apart.",
    std::move(places));
}

Status Checker::OverusedEdges(const EdgeTable& edges, std::size_t count) const
{
  std::vector<Vec3> places;
  std::string first;
  edges.VisitEdges([&](const EdgeUse* begin, const EdgeUse* end) {
    if (end - begin <= 2)
    {
      return;
    }
    if (places.empty() && first.empty())
    {
      first = this->EdgeName(*begin) + " has " + std::to_string(end - begin) + " faces (triangles";
      for (const EdgeUse* use = begin; use != end && use - begin < 8; ++use)
      {
        first += (use == begin ? " " : ", ") + this->Name(use->Triangle());
      }
      first += end - begin > 8 ? ", ...)" : ")";
    }
    this->AddPlace(places, 0.5 * this->Point(begin->Low()) + 0.5 * this->Point(begin->High()));
  });
  return Status(StatusCode::NonManifold,
    Count(count, "non-manifold edge", "non-manifold edges") + ": the " +
      (count == 1 ? "edge " : "first, ") + first +
      ", but an edge of a closed surface has 2. Remove inner faces and fins, or move bodies that touch "
      "along an edge apart or unite them.",
    std::move(places));
}

Status Checker::OpenEdges(const EdgeTable& edges, std::size_t count) const
{
  // Loops are the connected sets of open edges.
  std::vector<Index> root(this->Input.Points.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&root](Index v) {
    while (root[v] != v)
    {
      root[v] = root[root[v]];
      v = root[v];
    }
    return v;
  };
  std::vector<Index> used;
  std::vector<Vec3> places;
  std::string first;
  edges.VisitEdges([&](const EdgeUse* begin, const EdgeUse* end) {
    if (end - begin != 1)
    {
      return;
    }
    if (used.empty())
    {
      first = this->EdgeName(*begin) + " (triangle " + this->Name(begin->Triangle()) + ")";
    }
    this->AddPlace(places, 0.5 * this->Point(begin->Low()) + 0.5 * this->Point(begin->High()));
    used.push_back(begin->Low());
    used.push_back(begin->High());
    const Index a = find(begin->Low());
    const Index b = find(begin->High());
    root[std::max(a, b)] = std::min(a, b);
  });
  for (Index& v : used)
  {
    v = find(v);
  }
  std::sort(used.begin(), used.end());
  const std::size_t loops = std::unique(used.begin(), used.end()) - used.begin();
  return Status(StatusCode::OpenBoundary,
    "Open boundary: " + Count(count, "edge has", "edges have") + " only one face, in " +
      Count(loops, "loop", "loops") + "; the first goes " + first +
      ". Close the holes (fill holes, or merge points that should coincide).",
    std::move(places));
}

Status Checker::CheckFans() const
{
  const std::vector<Index> fans =
    CountFans(this->Triangles, this->Opposite, this->Input.Points.size());
  std::vector<Vec3> places;
  std::size_t count = 0;
  std::string first;
  for (std::size_t v = 0; v < fans.size(); ++v)
  {
    if (fans[v] > 1)
    {
      if (count++ == 0)
      {
        first = "point " + std::to_string(v) + " at " + Place(this->Input.Points[v]) + " joins " +
          std::to_string(fans[v]) + " separate fans of triangles";
      }
      this->AddPlace(places, this->Input.Points[v]);
    }
  }
  if (count == 0)
  {
    return Status();
  }
  return Status(StatusCode::NonManifold,
    Count(count, "non-manifold vertex", "non-manifold vertices") + ": " +
      (count == 1 ? "" : "first, ") + first +
      ". Parts of the surface touch there in a point: move them apart or unite them.",
    std::move(places));
}

Status Checker::FlipDegenerateTriangles()
{
  const CollinearFlips flips =
    FlipCollinearTriangles(this->Exact, this->Triangles, this->Opposite);
  this->Report.NumberOfFlippedEdges = flips.NumberOfFlips;
  if (flips.NumberOfFlips > 0)
  {
    this->Report.Warnings.push_back("Degenerate triangles with corners on one line removed by " +
      Count(flips.NumberOfFlips, "edge flip", "edge flips") + "; the shape is unchanged.");
  }
  if (flips.Remaining.empty())
  {
    return Status();
  }
  std::vector<Vec3> places;
  for (Index t : flips.Remaining)
  {
    this->AddPlace(places, this->Center(t));
  }
  return Status(StatusCode::Degenerate,
    Count(flips.Remaining.size(), "degenerate triangle", "degenerate triangles") +
      " with zero area and corners on one line can't be removed without changing the topology; first, triangle " +
      this->Name(flips.Remaining.front()) + " at " + Place(this->Center(flips.Remaining.front())) +
      ". Remesh or simplify the surface there.",
    std::move(places));
}

/// Components by lowest triangle; each keeps the orientation of its first triangle for now.
Status Checker::Orient()
{
  const Index count = static_cast<Index>(this->Triangles.size());
  this->ComponentIds.assign(count, -1);
  this->Reversed.assign(count, 0);
  this->Members.reserve(count);
  for (Index seed = 0; seed < count; ++seed)
  {
    if (this->ComponentIds[seed] >= 0)
    {
      continue;
    }
    const Index component = static_cast<Index>(this->FirstMember.size());
    this->FirstMember.push_back(static_cast<Index>(this->Members.size()));
    this->ComponentIds[seed] = component;
    this->Members.push_back(seed);
    for (std::size_t head = this->FirstMember.back(); head < this->Members.size(); ++head)
    {
      const Index t = this->Members[head];
      for (int k = 0; k < 3; ++k)
      {
        const Index side = this->Opposite[3 * t + k];
        const Index n = side / 3;
        // Neighbours agree when they run along their edge in opposite directions.
        const bool differ = this->Triangles[n][side % 3] == this->Triangles[t][k];
        const char reversed = this->Reversed[t] ^ static_cast<char>(differ);
        if (this->ComponentIds[n] < 0)
        {
          this->ComponentIds[n] = component;
          this->Reversed[n] = reversed;
          this->Members.push_back(n);
        }
        else if (this->Reversed[n] != reversed)
        {
          return Status(StatusCode::NotOrientable,
            "The surface is not orientable: it has no inside (as a Moebius strip or Klein bottle); no consistent "
            "orientation exists for triangles " +
              this->Name(t) + " and " + this->Name(n) + " at " + Place(this->Center(t)) +
              ". Such a surface does not bound a body: check how it was stitched.",
            { this->Center(t) });
        }
      }
    }
  }
  this->FirstMember.push_back(count);
  this->Report.Components.resize(this->FirstMember.size() - 1);
  return Status();
}

/// Volumes relative to the size of each component, so that neither offset nor scale matter. Afterwards
/// all components are oriented outwards.
Status Checker::CheckVolumes()
{
  for (std::size_t c = 0; c < this->Report.Components.size(); ++c)
  {
    SurfaceComponent& component = this->Report.Components[c];
    component.NumberOfTriangles = this->FirstMember[c + 1] - this->FirstMember[c];
    Box box;
    for (Index i = this->FirstMember[c]; i < this->FirstMember[c + 1]; ++i)
    {
      for (Index v : this->Triangles[this->Members[i]])
      {
        box.Extend(this->Point(v));
      }
    }
    const double size = box.Size().maxCoeff();
    const double scale = size > 1.0 / LargestCoordinate ? 1.0 / size : 0.0;
    double volume = 0.0, area = 0.0;
    for (Index i = this->FirstMember[c]; i < this->FirstMember[c + 1]; ++i)
    {
      const Index t = this->Members[i];
      Vec3 p[3];
      for (int k = 0; k < 3; ++k)
      {
        p[k] = (this->Point(this->Triangles[t][k]) - box.Center()) * scale;
      }
      const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
      volume += (this->Reversed[t] ? -1.0 : 1.0) * p[0].dot(normal) / 6.0;
      area += 0.5 * normal.norm();
    }
    if (std::abs(volume) <= FlatVolume * area)
    {
      const Index t = this->Members[this->FirstMember[c]];
      return Status(StatusCode::Degenerate,
        "Zero volume: the component of " +
          Count(component.NumberOfTriangles, "triangle", "triangles") + " with triangle " +
          this->Name(t) + " at " + Place(this->Center(t)) +
          " encloses no volume (flat, folded onto itself, or smaller than 1e-100). Remove it or give it thickness.",
        { this->Center(t) });
    }
    component.Volume = std::abs(volume) * size * size * size;
    for (Index i = this->FirstMember[c]; volume < 0.0 && i < this->FirstMember[c + 1]; ++i)
    {
      this->Reversed[this->Members[i]] ^= 1;
    }
  }
  return Status();
}

Status Checker::CheckIntersections()
{
  const std::size_t limit = std::max<std::size_t>(1, this->Options.MaximumNumberOfPlaces);
  const std::vector<TrianglePair> pairs =
    FindSelfIntersections(this->Exact, this->Triangles, limit, &this->Observer);
  if (this->Observer.Stopped())
  {
    return this->Observer.StopStatus();
  }
  if (pairs.empty())
  {
    return Status();
  }
  std::vector<Vec3> places;
  for (const TrianglePair& pair : pairs)
  {
    this->AddPlace(places, IntersectionPlace(this->Input.Points, this->Triangles, pair));
  }
  std::string first;
  for (std::size_t i = 0; i < pairs.size() && i < 3; ++i)
  {
    first += (i == 0 ? "" : ", ") + this->Name(pairs[i].First) + " and " +
      this->Name(pairs[i].Second) + " near " +
      Place(IntersectionPlace(this->Input.Points, this->Triangles, pairs[i]));
  }
  return Status(StatusCode::SelfIntersection,
    "Self-intersection: " + std::string(pairs.size() == limit ? "at least " : "") +
      Count(pairs.size(), "pair of triangles crosses or touches", "pairs of triangles cross or touch") +
      "; first, triangles " + first +
      ". Unite overlapping bodies (Boolean union), or repair or remesh the surface there.",
    std::move(places));
}

/// Components don't touch, so one point of each decides.
Status Checker::Nest()
{
  std::vector<SurfaceComponent>& components = this->Report.Components;
  const std::size_t count = components.size();
  std::vector<Box> boxes(count);
  for (std::size_t c = 0; c < count; ++c)
  {
    for (Index i = this->FirstMember[c]; i < this->FirstMember[c + 1]; ++i)
    {
      for (Index v : this->Triangles[this->Members[i]])
      {
        boxes[c].Extend(this->Exact[v]);
      }
    }
  }
  std::vector<std::vector<Index>> around(count);
  for (std::size_t c = 0; c < count; ++c)
  {
    if (c % 64 == 0 && !this->Observer.Update(static_cast<double>(c) / count))
    {
      return this->Observer.StopStatus();
    }
    const Vec3& p = this->Exact[this->Triangles[this->Members[this->FirstMember[c]]][0]];
    for (std::size_t other = 0; other < count; ++other)
    {
      if (other != c && (boxes[other].Low.array() < boxes[c].Low.array()).all() &&
        (boxes[other].High.array() > boxes[c].High.array()).all() &&
        Surrounds(this->Exact, this->Triangles, &this->Members[this->FirstMember[other]],
          this->Members.data() + this->FirstMember[other + 1], p))
      {
        around[c].push_back(static_cast<Index>(other));
      }
    }
    components[c].Depth = static_cast<Index>(around[c].size());
    components[c].Cavity = around[c].size() % 2 == 1;
  }
  // The ones around a component are nested in each other: the deepest is the innermost.
  for (std::size_t c = 0; c < count; ++c)
  {
    for (Index other : around[c])
    {
      if (components[c].Parent < 0 || components[other].Depth > components[components[c].Parent].Depth)
      {
        components[c].Parent = other;
      }
    }
    for (Index i = this->FirstMember[c]; components[c].Cavity && i < this->FirstMember[c + 1]; ++i)
    {
      this->Reversed[this->Members[i]] ^= 1;
    }
    this->Report.Volume += components[c].Cavity ? -components[c].Volume : components[c].Volume;
  }
  return Status();
}

/// Euler characteristic V - E + F = 2 - 2 genus, with 2 E = 3 F.
void Checker::CountGenus()
{
  std::vector<Index> points(this->Report.Components.size(), 0);
  std::vector<char> seen(this->Input.Points.size(), 0);
  for (std::size_t t = 0; t < this->Triangles.size(); ++t)
  {
    for (Index v : this->Triangles[t])
    {
      points[this->ComponentIds[t]] += seen[v] ? 0 : 1;
      seen[v] = 1;
    }
  }
  for (std::size_t c = 0; c < points.size(); ++c)
  {
    SurfaceComponent& component = this->Report.Components[c];
    component.Genus = (2 - points[c] + component.NumberOfTriangles / 2) / 2;
  }
}

Status Checker::Run()
{
  Status status = this->CheckIndices();
  if (status.Ok())
  {
    status = this->CheckCoordinates();
  }
  if (!status.Ok())
  {
    return status;
  }
  this->MergePoints();
  this->DropCollapsedTriangles();
  if (this->Triangles.empty())
  {
    return Status(StatusCode::Degenerate,
      "Zero volume: all " + Count(this->Input.Triangles.size(), "triangle is", "triangles are") +
        " degenerate (two corners at the same place). Check the units and the precision of the file.");
  }
  this->DropDuplicateTriangles();
  {
    const EdgeTable edges(this->Triangles);
    status = this->CheckEdges(edges);
    this->Opposite = OppositeSides(edges);
  }
  this->Exact = PointsForPredicates(this->Input.Points);
  using Step = Status (Checker::*)();
  constexpr Step steps[] = { &Checker::FlipDegenerateTriangles, &Checker::Orient,
    &Checker::CheckVolumes, &Checker::CheckIntersections, &Checker::Nest };
  if (status.Ok())
  {
    status = this->CheckFans();
  }
  for (Step step : steps)
  {
    if (status.Ok() && !this->Observer.Update(0.0))
    {
      return this->Observer.StopStatus();
    }
    if (status.Ok())
    {
      status = (this->*step)();
    }
  }
  if (status.Ok())
  {
    this->CountGenus();
  }
  return status;
}

/// New ids, in the order of the input.
SurfaceMesh Checker::Finish()
{
  SurfaceMesh result;
  const std::size_t numberOfPoints = this->Input.Points.size();
  std::vector<Index> newId(numberOfPoints, -1);
  for (const Triangle& t : this->Triangles)
  {
    for (Index v : t)
    {
      newId[v] = 0;
    }
  }
  for (std::size_t v = 0; v < numberOfPoints; ++v)
  {
    if (newId[v] == 0)
    {
      newId[v] = static_cast<Index>(result.Points.size());
      result.Points.push_back(this->Input.Points[v]);
    }
  }
  this->Report.Points.resize(numberOfPoints);
  for (std::size_t v = 0; v < numberOfPoints; ++v)
  {
    this->Report.Points[v] = newId[this->Lowest[v]];
    this->Report.NumberOfUnusedPoints += this->Report.Points[v] < 0 ? 1 : 0;
  }
  this->Report.Triangles.assign(this->Input.Triangles.size(), -1);
  result.Triangles.reserve(this->Triangles.size());
  for (std::size_t i = 0; i < this->Triangles.size(); ++i)
  {
    const Triangle& t = this->Triangles[i];
    this->Report.Triangles[this->Source[i]] = static_cast<Index>(i);
    result.Triangles.push_back({ newId[t[0]], newId[t[1]], newId[t[2]] });
    if (this->Reversed[i])
    {
      std::swap(result.Triangles.back()[1], result.Triangles.back()[2]);
      ++this->Report.NumberOfReorientedTriangles;
    }
  }
  this->Report.ComponentOfTriangle = this->ComponentIds;
  this->Report.Diagonal = BoundingBox(result).Diagonal();
  if (this->Report.NumberOfUnusedPoints > 0)
  {
    this->Report.Warnings.push_back(
      Count(this->Report.NumberOfUnusedPoints, "point", "points") + " of no triangle dropped.");
  }
  if (this->Report.NumberOfReorientedTriangles > 0)
  {
    this->Report.Warnings.push_back(std::to_string(this->Report.NumberOfReorientedTriangles) +
      " of " + Count(this->Triangles.size(), "triangle", "triangles") +
      " reversed, so that all normals point out of the material.");
  }
  return result;
}
}

Status CheckSurface(SurfaceMesh& surface, const SurfaceCheckOptions& options,
  SurfaceCheckReport& report, Monitor& monitor)
{
  report = SurfaceCheckReport();
  Checker checker(surface, options, report, monitor);
  const Status status = checker.Run();
  if (status.Ok())
  {
    surface = checker.Finish();
  }
  return status;
}
}

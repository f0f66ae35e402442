// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceCheck.h"

#include "BoxTree.h"
#include "ExactPredicates.h"
#include "MessageText.h"
#include "SelfIntersection.h"
#include "SurfaceFlaws.h"
#include "SurfaceTopology.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

namespace featurehex
{
namespace
{
/// A component whose volume is below this fraction of its area times its diagonal encloses nothing
/// that could be told from rounding errors.
constexpr double FlatVolume = 1e-13;

/// One check of one surface, step by step. Triangles and points keep their input ids until
/// Finish().
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
  void MergePoints();
  void DropCollapsedTriangles();
  void DropDuplicateTriangles();
  void Keep(const std::vector<char>& keep);
  Status FlipDegenerateTriangles();
  Status Orient();
  Status CheckVolumes();
  Status CheckIntersections();
  std::vector<Index> Around(Index component, const BoxTree& tree) const;
  Status Nest();
  void CountGenus();

  const Vec3& Point(Index id) const { return this->Input.Points[id]; }
  CheckedSurface State() const
  {
    return { this->Input.Points, this->Triangles, this->Source,
      this->Options.MaximumNumberOfPlaces };
  }

  const SurfaceMesh& Input;
  const SurfaceCheckOptions& Options;
  SurfaceCheckReport& Report;
  Monitor& Observer;

  std::vector<Index> Lowest;       ///< of each input point the lowest one at its place
  std::vector<Vec3> Exact;         ///< input points within the range of the predicates
  std::vector<Triangle> Triangles; ///< kept ones, merged points
  std::vector<Index> Source;       ///< input id of each of Triangles
  std::vector<Index> Twin;         ///< other triangle with the same corners that had to stay, or -1
  std::vector<Index> Opposite;     ///< OppositeSides()
  std::vector<Index> ComponentIds; ///< component of each of Triangles
  std::vector<char> Reversed;      ///< orientation to be changed
  std::vector<Index> Members;      ///< triangles by component
  std::vector<Index> FirstMember;  ///< of each component in Members, and the end
};

void Checker::MergePoints()
{
  const std::size_t count = this->Input.Points.size();
  std::vector<Index> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
    [this](Index a, Index b)
    {
      const Vec3& p = this->Exact[a];
      const Vec3& q = this->Exact[b];
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
    const bool same = i > 0 && this->Exact[order[i]] == this->Exact[order[i - 1]];
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

/// A triangle u u w only connects its two neighbours at the edge u w: without it they are
/// neighbours of each other. The number of faces at an edge changes by two, a closed surface stays
/// closed.
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
    this->Report.Warnings.push_back(
      CountText(dropped, "degenerate triangle", "degenerate triangles") +
      " with two corners at the same place dropped.");
  }
}

/// A copy is dropped when it is what makes an edge have more than two faces. It stays when the
/// edges have too many faces without it (two bodies that share a face) or need it (a flat closed
/// piece).
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
    this->Report.Warnings.push_back(CountText(this->Report.NumberOfDuplicateTriangles,
                                      "duplicate triangle", "duplicate triangles") +
                                    " dropped.");
  }
}

Status Checker::FlipDegenerateTriangles()
{
  const CollinearFlips flips = FlipCollinearTriangles(this->Exact, this->Triangles, this->Opposite);
  this->Report.NumberOfFlippedEdges = flips.NumberOfFlips;
  if (flips.NumberOfFlips > 0)
  {
    this->Report.Warnings.push_back("Degenerate triangles with corners on one line removed by " +
                                    CountText(flips.NumberOfFlips, "edge flip", "edge flips") +
                                    "; the shape is unchanged.");
  }
  if (flips.Remaining.empty())
  {
    return Status();
  }
  std::vector<Vec3> places;
  for (Index t : flips.Remaining)
  {
    this->State().AddPlace(places, this->State().Center(t));
  }
  return Status(StatusCode::Degenerate,
    CountText(flips.Remaining.size(), "degenerate triangle", "degenerate triangles") +
      " with zero area and corners on one line can't be removed without changing the topology; "
      "first, triangle " +
      this->State().Name(flips.Remaining.front()) + " at " +
      PlaceText(this->State().Center(flips.Remaining.front())) +
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
            "The surface is not orientable: it has no inside, as a Moebius strip; no "
            "consistent orientation exists for triangles " +
              this->State().Name(t) + " and " + this->State().Name(n) + " at " +
              PlaceText(this->State().Center(t)) +
              ". Such a surface does not bound a body: check how it was stitched.",
            { this->State().Center(t) });
        }
      }
    }
  }
  this->FirstMember.push_back(count);
  this->Report.Components.resize(this->FirstMember.size() - 1);
  return Status();
}

/// Volumes relative to the size of each component, so that neither offset nor scale matter.
/// Afterwards all components are oriented outwards.
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
          CountText(component.NumberOfTriangles, "triangle", "triangles") + " with triangle " +
          this->State().Name(t) + " at " + PlaceText(this->State().Center(t)) +
          " encloses no volume (flat, folded onto itself, or smaller than 1e-100). Remove it or "
          "give it thickness.",
        { this->State().Center(t) });
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
  return pairs.empty() ? Status()
                       : DescribeIntersections(this->State(), pairs, pairs.size() == limit);
}

/// Components around one point of component @a c, ascending: those whose triangles the ray from
/// there crosses an odd number of times. Components don't touch, so any point will do.
std::vector<Index> Checker::Around(Index c, const BoxTree& tree) const
{
  Box ray;
  const Vec3& p = this->Exact[this->Triangles[this->Members[this->FirstMember[c]]][0]];
  ray.Extend(p);
  ray.High[0] = std::numeric_limits<double>::max();
  std::vector<Index> crossed;
  tree.VisitBox(ray,
    [&](Index id)
    {
      const Triangle& t = this->Triangles[id];
      if (this->ComponentIds[id] != c &&
          RayCrosses(p, this->Exact[t[0]], this->Exact[t[1]], this->Exact[t[2]]))
      {
        crossed.push_back(this->ComponentIds[id]);
      }
    });
  std::sort(crossed.begin(), crossed.end());
  std::vector<Index> around;
  for (std::size_t i = 0; i < crossed.size();)
  {
    const auto end = std::upper_bound(crossed.begin() + i, crossed.end(), crossed[i]);
    const std::size_t next = end - crossed.begin();
    if ((next - i) % 2 == 1)
    {
      around.push_back(crossed[i]);
    }
    i = next;
  }
  return around;
}

Status Checker::Nest()
{
  std::vector<SurfaceComponent>& components = this->Report.Components;
  const Index count = static_cast<Index>(components.size());
  if (count > 1)
  {
    const BoxTree tree(this->Exact, this->Triangles);
    std::vector<std::vector<Index>> around(count);
    for (Index c = 0; c < count; ++c)
    {
      if (c % 1024 == 0 && !this->Observer.Update(1.0))
      {
        return this->Observer.StopStatus();
      }
      around[c] = this->Around(c, tree);
      components[c].Depth = static_cast<Index>(around[c].size());
      components[c].Cavity = components[c].Depth % 2 == 1;
    }
    // The ones around a component are nested in each other: the deepest is the innermost.
    for (Index c = 0; c < count; ++c)
    {
      for (Index other : around[c])
      {
        const Index parent = components[c].Parent;
        if (parent < 0 || components[other].Depth > components[parent].Depth)
        {
          components[c].Parent = other;
        }
      }
    }
  }
  for (Index t = 0; t < static_cast<Index>(this->Triangles.size()); ++t)
  {
    this->Reversed[t] ^= static_cast<char>(components[this->ComponentIds[t]].Cavity);
  }
  for (const SurfaceComponent& component : components)
  {
    this->Report.Volume += component.Cavity ? -component.Volume : component.Volume;
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
  Status status = CheckIndices(this->Input);
  if (status.Ok())
  {
    status = CheckCoordinates(this->Input);
  }
  if (!status.Ok())
  {
    return status;
  }
  this->Exact = PointsForPredicates(this->Input.Points);
  this->MergePoints();
  this->DropCollapsedTriangles();
  if (this->Triangles.empty())
  {
    return Status(StatusCode::Degenerate,
      "Zero volume: all " +
        CountText(this->Input.Triangles.size(), "triangle is", "triangles are") +
        " degenerate (two corners at the same place). Check the units and the precision of the "
        "file.");
  }
  this->DropDuplicateTriangles();
  {
    const EdgeTable edges(this->Triangles);
    status = CheckEdges(this->State(), edges, this->Twin);
    this->Opposite = OppositeSides(edges);
  }
  using Step = Status (Checker::*)();
  constexpr Step steps[] = { &Checker::FlipDegenerateTriangles, &Checker::Orient,
    &Checker::CheckVolumes, &Checker::CheckIntersections, &Checker::Nest };
  if (status.Ok())
  {
    status = CheckFans(this->State(), this->Opposite);
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
      CountText(this->Report.NumberOfUnusedPoints, "point", "points") + " of no triangle dropped.");
  }
  if (this->Report.NumberOfReorientedTriangles > 0)
  {
    this->Report.Warnings.push_back(std::to_string(this->Report.NumberOfReorientedTriangles) +
                                    " of " +
                                    CountText(this->Triangles.size(), "triangle", "triangles") +
                                    " reversed, so that all normals point out of the material.");
  }
  return result;
}
} // namespace

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
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause

#include "DistancePieces.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace featurehex
{
namespace
{
/// Pieces larger than this many times the nearest triangle are halved, smaller ones cut along its
/// prism.
constexpr double PrismSize = 3.0;

/// A cut leaves at least this share of an edge on each side.
constexpr double LeastShare = 0.05;

constexpr double TwoTriangles = 0.25; // share of the twist of a patch by which they differ from it

/// Greatest distance between two corners, and which.
double LongestSide(const DistancePiece& p, int& from, int& to)
{
  double longest = -1.0;
  for (int i = 0; i < p.Count; ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      const double length = (p.Corner[i] - p.Corner[j]).squaredNorm();
      if (length > longest)
      {
        longest = length;
        from = j;
        to = i;
      }
    }
  }
  return std::sqrt(longest);
}

/// Every point of the hull is this near to some corner: sum of l_i |x - v_i|^2 = sum of
/// l_i |c - v_i|^2 - |x - c|^2 <= R^2 for the ball (c, R) around the corners. Jung's theorem and
/// the ball around the centroid bound R.
double CoveringRadius(const DistancePiece& p)
{
  int from = 0, to = 0;
  const double longest = LongestSide(p, from, to);
  Vec3 centroid = p.Corner[0];
  for (int i = 1; i < p.Count; ++i)
  {
    centroid += p.Corner[i];
  }
  centroid /= p.Count;
  double radius = 0.0;
  for (int i = 0; i < p.Count; ++i)
  {
    radius = std::max(radius, (p.Corner[i] - centroid).squaredNorm());
  }
  // sqrt(n / (2 (n + 1))) for dimension n = Count - 1, rounded up.
  return std::min(std::sqrt(radius), (p.Count == 3 ? 0.57736 : 0.61238) * longest);
}

/// Greatest distance of a corner to one triangle, slack included; gives up beyond @a limit.
double HullDistance(
  const DistanceTarget& target, const DistancePiece& p, Index triangle, double limit)
{
  double greatest = 0.0;
  const double slack = target.SlackOf(triangle) + p.Slack;
  for (int i = 0; i < p.Count; ++i)
  {
    const double d = p.Near[i] == triangle
      ? p.Distance[i]
      : target.Search->ClosestOn(p.Corner[i], triangle).Distance;
    greatest = std::max(greatest, d + slack);
    if (greatest >= limit)
    {
      return limit;
    }
  }
  return greatest;
}

/// Lowers the bound of a piece by what its corners know.
void Improve(const DistanceTarget& target, DistancePiece& p, double enough)
{
  double corners = 0.0;
  for (int i = 0; i < p.Count; ++i)
  {
    if (p.Near[i] < 0)
    {
      return;
    }
    corners = std::max(corners, p.Distance[i] + target.SlackOf(p.Near[i]));
  }
  p.Bound = std::min(p.Bound, corners + CoveringRadius(p) + p.Slack);
  if (p.Best < 0)
  {
    p.Best = p.Near[0];
  }
  double best = 1e300;
  for (int i = 0; i < p.Count && p.Bound > enough; ++i)
  {
    if (std::find(p.Near, p.Near + i, p.Near[i]) == p.Near + i)
    {
      const double d = HullDistance(target, p, p.Near[i], best);
      if (d < best)
      {
        best = d;
        p.Best = p.Near[i];
      }
      p.Bound = std::min(p.Bound, d);
    }
  }
}

/// Searches the nearest triangle of the corners that only know a near one. True: something new.
bool MakeExact(const DistanceTarget& target, DistancePiece& p, ElementDistance& result)
{
  bool any = false;
  for (int i = 0; i < p.Count; ++i)
  {
    if (!p.Exact[i])
    {
      const Index hint = p.Near[i] >= 0 ? p.Near[i] : p.Near[(i + 1) % p.Count];
      const TrianglePoint q = target.Search->Closest(p.Corner[i], hint);
      p.Near[i] = q.Triangle;
      p.Distance[i] = q.Distance;
      p.Exact[i] = true;
      result.Found(p.Corner[i], q.Distance, target, p.Slack);
      any = true;
    }
  }
  return any;
}

/// Puts a point between corners i and j of @a p in place of corner @a slot of @a child.
void PlaceBetween(const DistanceTarget& target, const DistancePiece& p, int i, int j, double share,
  DistancePiece& child, int slot)
{
  child.Corner[slot] = p.Corner[i] + share * (p.Corner[j] - p.Corner[i]);
  child.Exact[slot] = false;
  child.Near[slot] = p.Near[i];
  child.Distance[slot] = target.Search->ClosestOn(child.Corner[slot], p.Near[i]).Distance;
  for (Index other : { p.Near[j], p.Best })
  {
    const double d = other == child.Near[slot]
      ? 1e300
      : target.Search->ClosestOn(child.Corner[slot], other).Distance;
    if (d < child.Distance[slot])
    {
      child.Distance[slot] = d;
      child.Near[slot] = other;
    }
  }
}

/// Where a wall of the prism over triangle p.Best cuts an edge of the piece best.
bool FindWall(
  const DistanceTarget& target, const DistancePiece& p, int& from, int& to, double& share)
{
  const Triangle& t = target.Search->Triangles()[p.Best];
  const Vec3& normal = target.Search->Normal(p.Best);
  double balance = LeastShare;
  bool found = false;
  for (int e = 0; e < 3; ++e)
  {
    const Vec3& a = target.Search->Points()[t[e]];
    const Vec3 outward = (target.Search->Points()[t[(e + 1) % 3]] - a).cross(normal);
    double height[3];
    for (int i = 0; i < 3; ++i)
    {
      height[i] = outward.dot(p.Corner[i] - a);
    }
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      if (height[i] * height[j] < 0.0)
      {
        const double s = height[i] / (height[i] - height[j]);
        if (std::min(s, 1.0 - s) > balance)
        {
          balance = std::min(s, 1.0 - s);
          from = i;
          to = j;
          share = s;
          found = true;
        }
      }
    }
  }
  return found;
}

double TriangleSize(const DistanceTarget& target, Index triangle)
{
  const Triangle& t = target.Search->Triangles()[triangle];
  const std::vector<Vec3>& x = target.Search->Points();
  return std::sqrt(std::max({ (x[t[1]] - x[t[0]]).squaredNorm(), (x[t[2]] - x[t[1]]).squaredNorm(),
    (x[t[0]] - x[t[2]]).squaredNorm() }));
}

/// Cuts a triangle at a point of one of its edges.
void CutTriangle(const DistanceTarget& target, const DistancePiece& p, bool prism,
  DistancePiece& first, DistancePiece& second)
{
  int from = 0, to = 0;
  double share = 0.5;
  // Every fourth cut halves the longest side, so that pieces shrink whatever the walls do.
  if (!prism || p.Depth % 4 == 3 || !FindWall(target, p, from, to, share))
  {
    LongestSide(p, from, to);
  }
  PlaceBetween(target, p, from, to, share, first, to);
  second.Corner[from] = first.Corner[to];
  second.Near[from] = first.Near[to];
  second.Distance[from] = first.Distance[to];
  second.Exact[from] = false;
}

/// Halves a patch across its longer direction: sub-patches of a bilinear patch are bilinear.
void CutPatch(const DistanceTarget& target, const DistancePiece& p, DistancePiece& first,
  DistancePiece& second)
{
  const auto length = [&](int i, int j) { return (p.Corner[i] - p.Corner[j]).squaredNorm(); };
  const bool along = std::max(length(0, 1), length(3, 2)) >= std::max(length(1, 2), length(0, 3));
  // Edges a-b and d-c are halved.
  const int a = along ? 0 : 1, b = along ? 1 : 2, c = along ? 2 : 3, d = along ? 3 : 0;
  PlaceBetween(target, p, a, b, 0.5, first, b);
  PlaceBetween(target, p, d, c, 0.5, first, c);
  for (const auto& [mine, theirs] : { std::make_pair(a, b), std::make_pair(d, c) })
  {
    second.Corner[mine] = first.Corner[theirs];
    second.Near[mine] = first.Near[theirs];
    second.Distance[mine] = first.Distance[theirs];
    second.Exact[mine] = false;
  }
}

/// The two triangles of a nearly flat patch.
void SplitPatch(const DistancePiece& p, DistancePiece& first, DistancePiece& second)
{
  first.Slack = second.Slack = p.Slack + TriangleError(p.Corner, TwoTriangles);
  first.Count = second.Count = 3; // corners 0 1 2
  second.Corner[1] = p.Corner[3]; // corners 0 3 2
  second.Near[1] = p.Near[3];
  second.Distance[1] = p.Distance[3];
  second.Exact[1] = p.Exact[3];
  // The triangles aren't part of the patch: their bound may be the greater one.
  first.Bound = second.Bound = 1e300;
}

void Cut(const DistanceTarget& target, const DistancePiece& p, double flat, DistancePiece& first,
  DistancePiece& second)
{
  first = second = p;
  ++first.Depth;
  ++second.Depth;
  int from = 0, to = 0;
  const bool prism = LongestSide(p, from, to) <= PrismSize * TriangleSize(target, p.Best);
  if (p.Count == 3)
  {
    CutTriangle(target, p, prism, first, second);
  }
  else if (prism && TriangleError(p.Corner, TwoTriangles) <= flat)
  {
    SplitPatch(p, first, second);
  }
  else
  {
    CutPatch(target, p, first, second);
  }
}

/// The state of one branch and bound.
class Search
{
public:
  Search(const DistanceTarget& target, const DistanceGoal& goal, ElementDistance& result)
    : Target(target)
    , Goal(goal)
    , Result(result)
  {
  }

  void Run(const DistancePiece& root)
  {
    this->Result.Unproven = root.Corner[0];
    this->Add(root);
    while (!this->Open.empty() && !this->GiveUp())
    {
      DistancePiece p = this->Open.back();
      this->Open.pop_back();
      ++this->Result.Pieces;
      this->Refine(p);
    }
    double upper = std::max(this->Retired, this->Result.Lower);
    for (const DistancePiece& p : this->Open)
    {
      if (p.Bound > upper)
      {
        upper = p.Bound;
        this->Result.Unproven = (p.Corner[0] + p.Corner[1] + p.Corner[2]) / 3.0;
      }
    }
    this->Result.Upper = upper;
  }

private:
  double Enough() const
  {
    return this->Goal.Decide ? this->Goal.Accept
                             : std::max(this->Goal.Accept, this->Result.Lower + this->Goal.Gap);
  }

  bool GiveUp() const
  {
    return (this->Goal.Decide && this->Result.Lower > this->Goal.GiveUp) ||
      this->Result.Pieces >= this->Goal.Budget;
  }

  /// Settles a piece, or leaves it for later.
  void Add(DistancePiece p)
  {
    Improve(this->Target, p, this->Enough());
    if (p.Bound <= this->Enough())
    {
      this->Retired = std::max(this->Retired, p.Bound);
    }
    else
    {
      this->Open.push_back(p);
    }
  }

  void Refine(DistancePiece& p)
  {
    if (p.Bound <= this->Enough()) // a greater distance was found since
    {
      this->Retired = std::max(this->Retired, p.Bound);
      return;
    }
    if (MakeExact(this->Target, p, this->Result))
    {
      this->Add(p);
      return;
    }
    if (p.Best < 0 || CoveringRadius(p) <= this->Goal.Tiny)
    {
      this->Retired = std::max(this->Retired, p.Bound);
      this->Result.Unproven = p.Corner[0]; // as good as any of its points
      return;
    }
    DistancePiece child[2];
    Cut(this->Target, p, this->Goal.Flat, child[0], child[1]);
    this->Add(child[0]);
    this->Add(child[1]);
  }

  const DistanceTarget& Target;
  const DistanceGoal& Goal;
  ElementDistance& Result;
  std::vector<DistancePiece> Open; ///< depth first: stays short
  double Retired = 0.0;            ///< greatest bound of the settled pieces
};
}

double TriangleError(const Vec3* corners, double share)
{
  const Vec3 twist = corners[0] - corners[1] + corners[2] - corners[3];
  const double parametric = share * twist.norm();
  const Vec3 normal = (corners[2] - corners[0]).cross(corners[3] - corners[1]).stableNormalized();
  for (int k = 0; k < 4; ++k)
  {
    const Vec3& corner = corners[k];
    const Vec3 turn = (corners[(k + 1) & 3] - corner).cross(corners[(k + 3) & 3] - corner);
    if (!(turn.dot(normal) > 0.0))
    {
      return parametric;
    }
  }
  return std::min(parametric, 0.5 * std::abs(twist.dot(normal)));
}

void BoundElement(const DistanceTarget& target, const DistancePiece& root, const DistanceGoal& goal,
  ElementDistance& result)
{
  for (int i = 0; i < root.Count; ++i)
  {
    if (root.Exact[i])
    {
      result.Found(root.Corner[i], root.Distance[i], target);
    }
  }
  Search(target, goal, result).Run(root);
}
}

// SPDX-License-Identifier: BSD-3-Clause
#include "PaddingGroups.h"

#include "CreaseAngles.h"
#include "DisjointSets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <tuple>

namespace featurehex
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
/// Of the length of a curve, at either end of its angles.
constexpr double IgnoredShare = 0.02;
constexpr double WidestQuadAngle = 150.0 / 180 * Pi; // that a layer may leave at a corner
constexpr double LeastCornerJacobian = 0.2;     // of the one hex where three layers cross
/// Of one hex against two: it also has no quad with two edges on the curve.
constexpr double LeastGain = -0.05;

/// Least scaled Jacobian along the curve with one hex, less that with two.
double GainOfOneHex(const CreaseAngles& creases, Index curve)
{
  const std::vector<CreaseAngles::Piece> pieces = creases.Pieces(curve);
  double length = 0;
  for (const CreaseAngles::Piece& piece : pieces)
  {
    length += piece.Length;
  }
  double one = 1;
  double two = 1;
  double arc = 0;
  for (const CreaseAngles::Piece& piece : pieces)
  {
    arc += piece.Length;
    if (arc > IgnoredShare * length && arc - piece.Length < (1 - IgnoredShare) * length)
    {
      one = std::min(one, std::sin(piece.Angle));
      two = std::min(two, std::sin(piece.Angle / 2));
    }
  }
  return one - two;
}

/// Merges groups until all layers can cross.
class Grouping
{
public:
  explicit Grouping(const FeatureGeometry& geometry)
    : Geometry(geometry)
    , Sets(geometry.Features().NumberOfPatches)
  {
  }

  std::vector<int> Run();

private:
  struct Sector
  {
    Index Group;
    double Angle;
    Vec3 Start;  ///< direction of its first curve
    Index Curve; ///< its first one: between this sector and the one before
  };

  std::vector<Sector> SectorsAt(Index corner);
  bool Crossable(const std::vector<Sector>& sectors) const;
  bool MergeAt(const std::vector<Sector>& sectors);

  const FeatureGeometry& Geometry;
  DisjointSets Sets;
  std::vector<double> Gains; ///< of one hex along each curve
};

std::vector<Grouping::Sector> Grouping::SectorsAt(Index corner)
{
  const CornerFan& fan = this->Geometry.Fans()[corner];
  std::vector<Sector> sectors;
  for (std::size_t i = 0; i < fan.Spokes.size(); ++i)
  {
    const CornerFan::Spoke& spoke = fan.Spokes[i];
    const FeatureCurve& curve = this->Geometry.Features().Curves[spoke.Curve];
    const int patch = spoke.AtEnd ? curve.RightPatch : curve.LeftPatch;
    const double end = i + 1 < fan.Spokes.size() ? fan.Spokes[i + 1].Angle : fan.FullAngle;
    const std::vector<Index>& points = curve.Points;
    const Index next = spoke.AtEnd ? points[points.size() - 2] : points[1];
    sectors.push_back({ this->Sets.Find(this->Geometry.PatchOf(patch)), end - spoke.Angle,
      (this->Geometry.Surface().Points[next] - this->Geometry.CornerPoint(corner))
        .stableNormalized(),
      spoke.Curve });
  }
  return sectors;
}

bool Grouping::Crossable(const std::vector<Sector>& sectors) const
{
  std::set<Index> groups;
  int borders = 0;
  for (std::size_t i = 0; i < sectors.size(); ++i)
  {
    groups.insert(sectors[i].Group);
    borders += sectors[i].Group != sectors[(i + 1) % sectors.size()].Group;
  }
  if (groups.size() <= 1)
  {
    return true;
  }
  // Each group one fan; without any of them at most two sectors are left.
  if (borders != static_cast<int>(groups.size()) || sectors.size() > (groups.size() == 2 ? 4u : 3u))
  {
    return false;
  }
  for (const Sector& sector : sectors)
  {
    const auto sameGroup = std::count_if(sectors.begin(), sectors.end(),
      [&](const Sector& other) { return other.Group == sector.Group; });
    if (sameGroup > 2)
    {
      return false;
    }
    const int quads = groups.size() == 2 && sameGroup == 1 ? 2 : 1;
    if (sector.Angle > quads * WidestQuadAngle)
    {
      return false;
    }
  }
  return groups.size() == 2 ||
    -sectors[0].Start.dot(sectors[1].Start.cross(sectors[2].Start)) > LeastCornerJacobian;
}

/// Joins two neighbouring groups: such that the layers can cross then, or where one hex gains
/// least. False: no need.
bool Grouping::MergeAt(const std::vector<Sector>& sectors)
{
  if (this->Crossable(sectors))
  {
    return false;
  }
  std::tuple<bool, double, std::size_t> best(true, 1e300, 0);
  for (std::size_t i = 0; i < sectors.size(); ++i)
  {
    const Index before = sectors[(i + sectors.size() - 1) % sectors.size()].Group;
    const Index after = sectors[i].Group;
    if (before != after)
    {
      std::vector<Sector> merged = sectors;
      for (Sector& sector : merged)
      {
        sector.Group = sector.Group == before ? after : sector.Group;
      }
      best = std::min(best,
        std::make_tuple(!this->Crossable(merged), this->Gains[sectors[i].Curve], i));
    }
  }
  const std::size_t i = std::get<2>(best);
  this->Sets.Join(sectors[i].Group, sectors[(i + sectors.size() - 1) % sectors.size()].Group);
  return true;
}

std::vector<int> Grouping::Run()
{
  const SurfaceFeatures& features = this->Geometry.Features();
  for (int patch = 0; patch < features.NumberOfPatches; ++patch)
  {
    this->Sets.Join(patch, this->Geometry.PatchOf(patch));
  }
  const CreaseAngles creases(this->Geometry);
  for (std::size_t c = 0; c < features.Curves.size(); ++c)
  {
    this->Gains.push_back(GainOfOneHex(creases, static_cast<Index>(c)));
    if (this->Gains.back() < LeastGain)
    {
      this->Sets.Join(features.Curves[c].LeftPatch, features.Curves[c].RightPatch);
    }
  }
  for (bool changed = true; changed;)
  {
    changed = false;
    for (Index corner = 0; corner < static_cast<Index>(features.Corners.size()); ++corner)
    {
      while (this->MergeAt(this->SectorsAt(corner)))
      {
        changed = true;
      }
    }
  }
  std::vector<int> groups;
  std::map<Index, int> number;
  for (int patch = 0; patch < features.NumberOfPatches; ++patch)
  {
    groups.push_back(
      number.emplace(this->Sets.Find(patch), static_cast<int>(number.size())).first->second);
  }
  return groups;
}
}

std::vector<int> GroupPatches(const FeatureGeometry& geometry)
{
  return Grouping(geometry).Run();
}
} // namespace featurehex

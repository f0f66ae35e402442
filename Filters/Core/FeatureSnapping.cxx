// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureSnapping.h"

#include "BoundarySpreading.h"
#include "VertexImprover.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
constexpr int SnapSweeps = 40;     // attempts to put feature vertices on their features
constexpr double SnapGrowth = 1.5; // of the weight of features per attempt ...
constexpr double SnapWeight = 1e6; // ... up to this
constexpr double SnapNear = 0.02;  // local sizes: nearer vertices are put on their features ...
constexpr int SnapFarStart = 25;   // ... and, after so many attempts, all others
constexpr double InPlace = 1e-9;   // local sizes: a fixed vertex is on its feature
constexpr int SnapTrials = 4;      // halvings of one such move
constexpr int PatientSweeps = 6;   // without success

constexpr int ForceRings[] = { 3, 5 }; // neighbourhood that gives way to a trapped vertex
constexpr int ForceSweeps = 40;
constexpr int CertifySweeps = 20; // to make untangled hexes valid over their whole volume
/// Scaled Jacobian: what is flatter than this, no improvement opens.
constexpr double LeastForcedQuality = 0.03;

/// The parts of SnapFeatures() with what they share.
class Snapper
{
public:
  Snapper(HexMesh& mesh, const HexStars& stars, FeatureTargets& features, HexOptimizer& optimizer)
    : Mesh(mesh)
    , Stars(stars)
    , Features(features)
    , Optimizer(optimizer)
    , Fixed(optimizer.Fixed)
  {
  }

  Index SnapNearer(double reach);
  void ForceTrapped(Monitor& monitor);

private:
  /// Vertices that may move, with where they were, and the hexes they touch.
  struct Region
  {
    std::vector<Index> Vertices;
    std::vector<Vec3> Before;
    std::vector<Index> Hexes;
  };

  bool Force(Index vertex, int rings, bool withNeighbors);
  Region RegionAround(Index vertex, int rings) const;
  double LeastDeterminant(const Region& region) const;
  Index CountFolded(const Region& region) const;
  bool Untangle(const Region& region);
  bool Certified(const Region& region) const;

  HexMesh& Mesh;
  const HexStars& Stars;
  FeatureTargets& Features;
  HexOptimizer& Optimizer;
  const std::vector<bool> Fixed; ///< in place before, on its feature or not
};

/// Moves feature vertices within @a reach (local sizes) of their features there, one at a time;
/// those that arrive are locked. Returns how many are not.
Index Snapper::SnapNearer(double reach)
{
  Index left = 0;
  for (Index v : this->Features.Vertices())
  {
    if (this->Features.Locked(v))
    {
      continue;
    }
    const Vec3 target = this->Features.Project(v, this->Mesh.Points[v]);
    const Vec3 displacement = target - this->Mesh.Points[v];
    if (this->Fixed[v])
    {
      if (displacement.norm() < InPlace * this->Optimizer.SizeAt(v))
      {
        this->Features.Lock(v);
      }
      continue;
    }
    ++left;
    if (displacement.norm() > reach * this->Optimizer.SizeAt(v))
    {
      continue;
    }
    double alpha = 1;
    int trial = 0;
    while (trial < SnapTrials && !this->Optimizer.TryMove(v, alpha * displacement))
    {
      alpha *= 0.5;
      ++trial;
    }
    if (trial == 0)
    {
      this->Mesh.Points[v] = target; // without the rounding of the sum
      this->Features.Lock(v);
      --left;
    }
  }
  return left;
}

Snapper::Region Snapper::RegionAround(Index vertex, int rings) const
{
  Region region;
  region.Vertices = { vertex };
  std::vector<char> seenVertex(this->Mesh.Points.size(), 0);
  std::vector<char> seenHex(this->Mesh.Hexes.size(), 0);
  seenVertex[vertex] = 1;
  std::size_t first = 0;
  for (int ring = 0; ring <= rings; ++ring)
  {
    for (const std::size_t last = region.Vertices.size(); first < last; ++first)
    {
      for (Index h : this->Stars.Hexes[region.Vertices[first]])
      {
        if (seenHex[h])
        {
          continue;
        }
        seenHex[h] = 1;
        region.Hexes.push_back(h);
        for (Index v : this->Mesh.Hexes[h])
        {
          if (!seenVertex[v] && ring < rings)
          {
            seenVertex[v] = 1;
            region.Vertices.push_back(v);
          }
        }
      }
    }
  }
  for (Index v : region.Vertices)
  {
    region.Before.push_back(this->Mesh.Points[v]);
  }
  return region;
}

double Snapper::LeastDeterminant(const Region& region) const
{
  double least = 1e300;
  for (Index h : region.Hexes)
  {
    const double size = this->Optimizer.SizeAt(this->Mesh.Hexes[h][0]);
    least = std::min(least, LeastCornerDeterminant(this->Mesh, h) / (size * size * size));
  }
  return least;
}

bool Snapper::Certified(const Region& region) const
{
  return std::all_of(region.Hexes.begin(), region.Hexes.end(), [this](Index h) {
    return LeastBezierCoefficient(this->Mesh, h) > 0 &&
      LeastScaledJacobian(this->Mesh, h) > LeastForcedQuality;
  });
}

Index Snapper::CountFolded(const Region& region) const
{
  Index folded = 0;
  for (Index v : region.Vertices)
  {
    for (Index q : this->Stars.QuadsOfVertex[v])
    {
      folded += IsFolded(this->Mesh, this->Stars, this->Features, q) ? 1 : 0;
    }
  }
  return folded;
}

bool Snapper::Untangle(const Region& region)
{
  double least = this->LeastDeterminant(region);
  for (int sweep = 0; sweep < ForceSweeps && !(least > 0); ++sweep)
  {
    const double delta = std::sqrt(1e-6 + 0.04 * least * least);
    this->Optimizer.ActivateAll();
    this->Optimizer.Sweep(sweep < ForceSweeps / 3 ? std::max(delta, 0.05) : delta);
    least = this->LeastDeterminant(region);
  }
  bool sound = least > 0 && this->Certified(region);
  for (int sweep = 0; sweep < CertifySweeps && least > 0 && !sound; ++sweep)
  {
    this->Optimizer.ActivateAll();
    this->Optimizer.Sweep(-1.0);
    sound = this->Certified(region);
  }
  return sound;
}

/// Puts a trapped vertex, and the trapped ones near it, on their features although that inverts
/// hexes, and untangles the neighbourhood. False: that failed, and nothing has changed.
bool Snapper::Force(Index vertex, int rings, bool withNeighbors)
{
  const Region region = this->RegionAround(vertex, rings);
  const Index folded = this->CountFolded(region);
  std::fill(this->Optimizer.Fixed.begin(), this->Optimizer.Fixed.end(), true);
  std::vector<Index> forced;
  for (Index v : region.Vertices)
  {
    this->Optimizer.Fixed[v] = false;
    if (v == vertex || (withNeighbors && this->Features.OnFeature(v) && !this->Features.Locked(v)))
    {
      forced.push_back(v);
      this->Mesh.Points[v] = this->Features.Project(v, this->Mesh.Points[v]);
      this->Features.Lock(v);
    }
  }
  const bool sound = this->Untangle(region) && this->CountFolded(region) <= folded;
  if (!sound)
  {
    for (Index v : forced)
    {
      this->Features.Unlock(v);
    }
    for (std::size_t i = 0; i < region.Vertices.size(); ++i)
    {
      this->Mesh.Points[region.Vertices[i]] = region.Before[i];
    }
  }
  this->Optimizer.Fixed = this->Fixed;
  return sound;
}

void Snapper::ForceTrapped(Monitor& monitor)
{
  for (Index v : this->Features.Vertices())
  {
    for (int rings : ForceRings)
    {
      for (bool withNeighbors : { true, false })
      {
        if (!this->Features.Locked(v) && !this->Fixed[v] && monitor.Update(1.0) &&
          this->Force(v, rings, withNeighbors))
        {
          this->Features.FollowCurves(this->Mesh.Points);
        }
      }
    }
  }
}
}

Status SnapFeatures(HexMesh& mesh, const HexStars& stars, FeatureTargets& features,
  SurfaceTerms& terms, HexOptimizer& optimizer, double weight, Monitor& monitor)
{
  optimizer.Features = &features;
  Snapper snapper(mesh, stars, features, optimizer);
  double featureWeight = FeatureShare * weight;
  Index last = -1;
  int idle = 0;
  for (int sweep = 0; sweep < SnapSweeps && idle < PatientSweeps && monitor.Update(1.0); ++sweep)
  {
    // Locking far ones early would trap their neighbours.
    const bool far = sweep >= SnapFarStart;
    features.FollowCurves(mesh.Points);
    const Index left = snapper.SnapNearer(far ? 1e300 : SnapNear);
    if (left == 0)
    {
      break;
    }
    optimizer.UpdateSizes();
    terms.UpdatePlanes(optimizer, weight, featureWeight);
    optimizer.ActivateBoundary();
    for (int relax = 0; relax < 2; ++relax)
    {
      optimizer.Sweep(-1.0, &monitor);
    }
    featureWeight = std::min(featureWeight * SnapGrowth, SnapWeight);
    idle = far && left == last ? idle + 1 : 0;
    last = left;
  }
  snapper.ForceTrapped(monitor);
  return monitor.StopStatus();
}
} // namespace featurehex

// SPDX-License-Identifier: BSD-3-Clause
#include "HexImprovement.h"

#include "Parallel.h"
#include "PatchImprover.h"
#include "VertexImprover.h"
#include "VertexSchedule.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
constexpr int SweepsPerStage = 25;
constexpr int PatientSweeps = 6;
constexpr double LeastGain = 1e-3;
constexpr int DrawSweeps = 40;
constexpr double DrawWeight = 20.0;
constexpr double DrawGrowth = 1.17; // to 1e4 in 40 sweeps
constexpr double LastGap = 0.003; // of the barrier below the minimum
constexpr int OtherSweeps = 12;
constexpr double AcceptableShare = 0.8; // of the target: what may be given up for the surface
constexpr int CertifySweeps = 20;
constexpr int AverageSweeps = 12;
constexpr int ProjectionSweeps = 2;
/// Of the tolerance: no certificate is possible when samples are as far as this.
constexpr double HopelessShare = 0.97;
constexpr double SnapFloor = 0.05; // scaled Jacobian that a snapped feature vertex must leave
constexpr std::size_t FewHexes = 150; // patches only when fewer hexes are below the target

/// True when the minimum has not risen for several sweeps: another stage may free what is stuck.
class StallRule
{
public:
  bool Stalled(double minimum)
  {
    this->Idle = minimum > this->Best + LeastGain ? 0 : this->Idle + 1;
    this->Best = std::max(this->Best, minimum);
    return this->Idle > PatientSweeps;
  }

private:
  double Best = -2;
  int Idle = 0;
};

/// The rounds of recipe-quality 2 with what they share.
class Improvement
{
public:
  Improvement(HexMesh& mesh, const HexStars& stars, const SurfaceGeometry& surface,
    SurfaceEnvelope& envelope, const ImprovementOptions& options, Monitor& monitor)
    : Mesh(mesh)
    , Stars(stars)
    , Surface(surface)
    , Envelope(envelope)
    , Options(options)
    , Progress(monitor)
    , Schedule(mesh.Hexes, stars.Hexes, 3)
    , Vertices(mesh, stars, envelope,
        options.EnvelopeShare * options.Tolerance * surface.Diagonal(), options.Features)
    , Active(mesh.Hexes.size(), 1)
    , Qualities(mesh.Hexes.size())
    , Chosen(mesh.Points.size())
    , Start(mesh.Points)
  {
    if (options.Changed && options.OnlyChanged)
    {
      for (std::size_t h = 0; h < mesh.Hexes.size(); ++h)
      {
        const Hex& hex = mesh.Hexes[h];
        this->Active[h] = std::any_of(
          hex.begin(), hex.end(), [&options](Index v) { return (*options.Changed)[v] != 0; });
      }
    }
    this->UpdateQualities();
  }

  /// Of all hexes, those that stay included.
  void ReportMinimum(ImprovementReport& report) const
  {
    std::vector<double> qualities(this->Mesh.Hexes.size());
    ParallelFor(qualities.size(), 1024, [&](std::size_t h) {
      qualities[h] = LeastScaledJacobian(this->Mesh, static_cast<Index>(h));
    });
    const double target = this->Options.MinimumScaledJacobian;
    report.MinimumAfter = *std::min_element(qualities.begin(), qualities.end());
    report.BelowTarget = static_cast<Index>(std::count_if(qualities.begin(), qualities.end(),
      [target](double quality) { return quality < target; }));
  }

  /// Of the hexes that may change.
  double Minimum() const
  {
    return *std::min_element(this->Qualities.begin(), this->Qualities.end());
  }

  /// Quads beyond the limit are drawn back (env).
  void DrawInside()
  {
    const double limit = this->Vertices.Limit();
    for (int sweep = 0; sweep < DrawSweeps && this->Progress.Update(this->Fraction); ++sweep)
    {
      if (sweep % 4 == 3)
      {
        this->Envelope.Update(limit);
      }
      this->Envelope.Measure(limit);
      std::fill(this->Chosen.begin(), this->Chosen.end(), 0);
      bool any = false;
      for (std::size_t v = 0; v < this->Chosen.size(); ++v)
      {
        if (this->Envelope.BoundAround(static_cast<Index>(v)) > limit)
        {
          any = true;
          for (Index h : this->Stars.Hexes[static_cast<Index>(v)])
          {
            for (Index u : this->Mesh.Hexes[h])
            {
              this->Chosen[u] = 1;
            }
          }
        }
      }
      // The weight rises slowly: a quad should be drawn back by all its vertices, not by the first
      // one visited.
      const double weight = DrawWeight * std::pow(DrawGrowth, sweep);
      if (!any ||
        !this->Sweep([&](Index v) { return this->Vertices.DrawInside(v, weight); }))
      {
        break;
      }
    }
    this->Envelope.Measure(limit);
    this->UpdateQualities();
  }

  /// The fit looks at the corners of hexes only: relaxes those that are not valid over their whole
  /// volume. Where that fails, feature vertices are let go.
  void Certify()
  {
    std::vector<Index> suspects = this->Uncertified();
    for (int sweep = 0; sweep < CertifySweeps && !suspects.empty(); ++sweep)
    {
      std::fill(this->Chosen.begin(), this->Chosen.end(), 0);
      for (Index h : suspects)
      {
        for (Index v : this->Mesh.Hexes[h])
        {
          this->Chosen[v] = 1;
          if (this->Options.Features && sweep == CertifySweeps / 2)
          {
            this->Options.Features->Unlock(v);
          }
        }
      }
      this->Sweep([this](Index v) { return this->Vertices.DrawInside(v, DrawWeight); });
      suspects.erase(std::remove_if(suspects.begin(), suspects.end(),
                       [this](Index h) { return LeastBezierCoefficient(this->Mesh, h) > 0; }),
        suspects.end());
    }
    this->UpdateQualities();
  }

  /// Sampled distance, exact where it is beyond the limit of the moves.
  double Distance() const
  {
    return std::max({ this->Vertices.Limit(), this->Envelope.ForwardMaximum(),
      this->Envelope.ReverseMaximum() });
  }

  /// Per-vertex steepest ascent of the minimum (mm).
  void RaiseMinima(double target, double band)
  {
    StallRule stall;
    for (int sweep = 0; sweep < SweepsPerStage && this->Progress.Update(this->Fraction); ++sweep)
    {
      const double minimum = this->Minimum();
      if (minimum >= target || stall.Stalled(minimum))
      {
        return;
      }
      this->ChooseBelow(std::min(target, minimum + band));
      const bool moved = this->Sweep([this](Index v) { return this->Vertices.RaiseMinimum(v); });
      this->UpdateQualities();
      if (!moved)
      {
        return;
      }
    }
  }

  /// The same for all hexes below the target, whatever the minimum: a few that are stuck don't hold
  /// up the others.
  void RaiseOthers(double target)
  {
    for (int sweep = 0; sweep < OtherSweeps && this->Progress.Update(this->Fraction); ++sweep)
    {
      this->ChooseBelow(target);
      if (!this->Sweep([this](Index v) { return this->Vertices.RaiseMinimum(v); }))
      {
        return;
      }
      this->UpdateQualities();
    }
  }

  /// Moving barrier, vertex by vertex (bar).
  void PushBarrier(double target, double gap)
  {
    StallRule stall;
    for (int sweep = 0; sweep < SweepsPerStage && this->Progress.Update(this->Fraction); ++sweep)
    {
      const double minimum = this->Minimum();
      if (minimum >= target || stall.Stalled(minimum))
      {
        return;
      }
      const BarrierParameters parameters = { std::min(target + 0.005, minimum + 0.1), minimum - gap,
        gap };
      this->ChooseBelow(parameters.Theta);
      const bool moved = this->Sweep(
        [this, &parameters](Index v) { return this->Vertices.PushBarrier(v, parameters); });
      this->UpdateQualities();
      if (!moved)
      {
        return;
      }
    }
  }

  /// Newton on small neighbourhoods of the worst hexes.
  void SolvePatches(double target)
  {
    const std::vector<Index> bad = this->Below(target);
    if (bad.size() < FewHexes)
    {
      PatchImprover patches(this->Mesh, this->Stars, this->Envelope, this->Vertices);
      patches.RaiseWorst(bad, target, this->Options.MaximumPatches, this->Progress);
      this->UpdateQualities();
    }
  }

  void RaiseAverage(double floor)
  {
    this->ChooseChanged();
    for (int sweep = 0; sweep < AverageSweeps && this->Progress.Update(this->Fraction); ++sweep)
    {
      this->Sweep([this, floor](Index v) {
        return this->Vertices.RaiseAverage(v, this->Surface, floor);
      });
    }
    this->UpdateQualities();
  }

  /// Feature vertices onto their features where the mesh stays valid; the quality may suffer, it is
  /// raised later. Returns how many are not there.
  Index SnapFeatures()
  {
    FeatureTargets* const features = this->Options.Features;
    if (!features)
    {
      return 0;
    }
    features->FollowCurves(this->Mesh.Points);
    Index left = 0;
    for (Index v : features->Vertices())
    {
      left += this->Vertices.Project(v, this->Surface, SnapFloor) ? 0 : 1;
    }
    this->UpdateQualities();
    return left;
  }

  /// Boundary vertices onto the surface, one at a time, where nothing gets worse. Returns how many
  /// are on it.
  Index Project(double floor)
  {
    this->ChooseChanged();
    for (std::size_t v = 0; v < this->Chosen.size(); ++v)
    {
      this->Chosen[v] = this->Chosen[v] && this->Stars.OnBoundary(static_cast<Index>(v));
    }
    std::size_t arrived = 0;
    for (int sweep = 0; sweep < ProjectionSweeps && this->Progress.Update(this->Fraction); ++sweep)
    {
      const auto project = [this, floor](Index v) {
        return this->Chosen[v] && this->Vertices.Project(v, this->Surface, floor);
      };
      arrived = this->Schedule.Sweep(project, &this->Progress);
    }
    this->UpdateQualities();
    return static_cast<Index>(arrived);
  }

  void SetFraction(double fraction) { this->Fraction = fraction; }

private:
  std::vector<Index> Uncertified() const
  {
    std::vector<char> bad(this->Mesh.Hexes.size());
    ParallelFor(bad.size(), 1024, [&](std::size_t h) {
      bad[h] = !(LeastBezierCoefficient(this->Mesh, static_cast<Index>(h)) > 0);
    });
    std::vector<Index> hexes;
    for (std::size_t h = 0; h < bad.size(); ++h)
    {
      if (bad[h])
      {
        hexes.push_back(static_cast<Index>(h));
      }
    }
    return hexes;
  }

  /// Those that stay count as perfect; none stays once a vertex of it has been moved.
  void UpdateQualities()
  {
    ParallelFor(this->Mesh.Hexes.size(), 1024, [this](std::size_t h) {
      const Hex& hex = this->Mesh.Hexes[h];
      this->Active[h] = this->Active[h] || std::any_of(hex.begin(), hex.end(), [this](Index v) {
        return this->Mesh.Points[v] != this->Start[v];
      });
      this->Qualities[h] =
        this->Active[h] ? LeastScaledJacobian(this->Mesh, static_cast<Index>(h)) : 1.0;
    });
  }

  std::vector<Index> Below(double level) const
  {
    std::vector<Index> hexes;
    for (std::size_t h = 0; h < this->Qualities.size(); ++h)
    {
      if (this->Qualities[h] < level)
      {
        hexes.push_back(static_cast<Index>(h));
      }
    }
    return hexes;
  }

  /// Vertices that are new or have moved, and those round them.
  void ChooseChanged()
  {
    std::fill(this->Chosen.begin(), this->Chosen.end(), 1);
    if (!this->Options.Changed)
    {
      return;
    }
    this->Chosen = *this->Options.Changed;
    for (std::size_t v = 0; v < this->Chosen.size(); ++v)
    {
      if (this->Mesh.Points[v] != this->Start[v])
      {
        for (Index h : this->Stars.Hexes[static_cast<Index>(v)])
        {
          for (Index u : this->Mesh.Hexes[h])
          {
            this->Chosen[u] = 1;
          }
        }
      }
    }
  }

  void ChooseBelow(double level)
  {
    std::fill(this->Chosen.begin(), this->Chosen.end(), 0);
    for (Index h : this->Below(level))
    {
      for (Index v : this->Mesh.Hexes[h])
      {
        this->Chosen[v] = 1;
      }
    }
  }

  template <typename Move>
  bool Sweep(const Move& move)
  {
    const auto visit = [&](Index v) { return this->Chosen[v] && move(v); };
    return this->Schedule.Sweep(visit, &this->Progress) > 0;
  }

  HexMesh& Mesh;
  const HexStars& Stars;
  const SurfaceGeometry& Surface;
  SurfaceEnvelope& Envelope;
  const ImprovementOptions& Options;
  Monitor& Progress;
  VertexSchedule Schedule;
  VertexImprover Vertices;
  std::vector<char> Active; ///< hexes that are improved
  std::vector<double> Qualities;
  std::vector<char> Chosen;
  const std::vector<Vec3> Start;
  double Fraction = 0;
};
}

Status ImproveHexes(HexMesh& mesh, const HexStars& stars, const SurfaceGeometry& surface,
  SurfaceEnvelope& envelope, const ImprovementOptions& options, ImprovementReport& report,
  Monitor& monitor)
{
  report = ImprovementReport();
  if (mesh.Hexes.empty())
  {
    return Status();
  }
  Improvement improvement(mesh, stars, surface, envelope, options, monitor);
  improvement.ReportMinimum(report);
  report.MinimumBefore = report.MinimumAfter;
  improvement.Certify();
  improvement.DrawInside();
  report.Distance = improvement.Distance();
  report.OffFeatures = improvement.SnapFeatures();
  report.Drawn = report.Distance <= HopelessShare * options.Tolerance * surface.Diagonal();
  if (!report.Drawn)
  {
    return monitor.StopStatus(); // only other cells can help: spend no time on quality
  }

  const double target = options.MinimumScaledJacobian;
  double last = improvement.Minimum();
  int stalled = 0;
  for (int round = 0; round < options.MaximumRounds && stalled < 2; ++round)
  {
    improvement.SetFraction(static_cast<double>(round) / options.MaximumRounds);
    if (!monitor.Update(static_cast<double>(round) / options.MaximumRounds))
    {
      return monitor.StopStatus();
    }
    if (improvement.Minimum() >= target)
    {
      break;
    }
    if (report.OffFeatures > 0)
    {
      report.OffFeatures = improvement.SnapFeatures();
    }
    const double gap = round == 0 ? 0.01 : round == 1 ? 0.005 : LastGap;
    improvement.RaiseMinima(target, round == 0 ? 0.2 : 0.1);
    improvement.PushBarrier(target, gap);
    improvement.SolvePatches(target);
    const double minimum = improvement.Minimum();
    stalled = minimum - last < 1e-3 ? stalled + 1 : 0;
    last = minimum;
    ++report.Rounds;
  }
  double floor = std::min(target, improvement.Minimum());
  if (options.Features && floor < target)
  {
    // Creases bound the quality of a few hexes: they don't hold up the others, nor allow them to
    // get as bad.
    improvement.RaiseOthers(target);
    floor = std::max(floor, AcceptableShare * target);
  }
  improvement.RaiseAverage(floor);
  report.OnSurface = improvement.Project(floor);
  envelope.Rebuild();
  improvement.DrawInside();
  if (monitor.Stopped())
  {
    return monitor.StopStatus();
  }
  const double before = std::min(improvement.Minimum(), target);
  report.OffFeatures = improvement.SnapFeatures();
  if (improvement.Minimum() < before)
  {
    improvement.RaiseMinima(target, 0.1);
    improvement.PushBarrier(target, LastGap);
  }
  report.Distance = improvement.Distance();
  improvement.ReportMinimum(report);
  return Status();
}
}

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The loop of MeshSurface(): rounds of all stages with finer cells where one fails. Internal.

#ifndef featurehex_MeshingRounds_h
#define featurehex_MeshingRounds_h

#include "BlockOctree.h"
#include "CarriedPositions.h"
#include "EnforcedFeatures.h"
#include "FeatureHexMesher.h"
#include "HexDomain.h"
#include "HexFeatureMapping.h"
#include "HexPadding.h"
#include "HexUntangling.h"
#include "OctreeDual.h"
#include "ProvenFitting.h"
#include "WindingNumber.h"

#include <chrono>
#include <memory>

namespace featurehex
{
/// Adds the wall time between construction and destruction to a stage.
class StageClock
{
public:
  StageClock(std::vector<StageTiming>& timings, const std::string& stage)
    : Timings(timings)
    , Stage(stage)
  {
  }
  ~StageClock()
  {
    const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
    for (StageTiming& timing : this->Timings)
    {
      if (timing.Stage == this->Stage)
      {
        timing.Seconds += seconds;
        return;
      }
    }
    this->Timings.push_back({ this->Stage, seconds });
  }
  StageClock(const StageClock&) = delete;
  StageClock& operator=(const StageClock&) = delete;

private:
  std::vector<StageTiming>& Timings;
  std::string Stage;
  std::chrono::steady_clock::time_point Start = std::chrono::steady_clock::now();
};

/// The refinement loop: what lasts from round to round, and the stages of one round. Status and
/// figures go to @a result, progress to @a monitor.
class MeshingRounds
{
public:
  MeshingRounds(const MeshingOptions& options, Monitor& monitor, MeshingResult& result)
    : Options(options)
    , Progress(monitor)
    , Result(result)
    , LastRound(options.MaximumRounds)
  {
  }

  Status Run(const SurfaceMesh& input);

private:
  enum class Outcome
  {
    Done,
    Refine,
    Failed
  };

  Status CheckOptions(const SurfaceMesh& surface) const;
  Status Prepare(const SurfaceMesh& input);
  Status FindFeatures(const SurfaceMesh& checked);
  void PrepareSizing();
  void MoveToOrigin(SurfaceMesh& surface);
  std::vector<Vec3> MovedBack(std::vector<Vec3> points) const;
  Outcome RunRound(int round, Status& status);
  Outcome BuildDomain(Status& status);
  Outcome MapFeatures(Status& status);
  std::set<FeatureName> FeaturesAt(const std::vector<Index>& hexes) const;
  bool GiveUpSpoilers();
  FeatureLabels Labels() const;
  Status Untangle(UntangleReport& report);
  Outcome BuildBody(Status& status);
  Outcome Fit(Status& status);
  Outcome Validate(Status& status);
  Outcome FollowFeatures(Status& status);
  Outcome RaiseQuality(Status& status);
  Index CountStuckHexes() const;
  void KeepBest();
  Outcome Refine(const std::string& reason, StatusCode code, const std::vector<Vec3>& places,
    Status& status);
  void BeginPhase(const std::string& name, double from, double to);
  std::vector<double> WantedLengths() const;
  double AbsoluteTolerance() const { return this->Options.Tolerance * this->Surface->Diagonal(); }

  const MeshingOptions& Options;
  Monitor& Progress;
  MeshingResult& Result;
  double EdgeLength = 0;
  Vec3 Offset = Vec3::Zero(); ///< from the coordinates of the stages to those of the input
  int Round = 0;

  std::unique_ptr<SurfaceGeometry> Surface;
  WindingNumber Winding;
  EnforcedFeatures Enforced;
  std::unique_ptr<ProvenFitting> Fitting;
  std::vector<RefinementPoint> Points;
  int LastRound = 0; ///< rounds before it gives up
  bool Halved = false;
  bool FitGrid = true; ///< to flat faces
  std::string LastReason; ///< of a further round, with the first place
  int FeatureRounds = 0;
  int QualityRounds = 0;
  CarriedPositions Carried; ///< from the last valid mesh
  MeshingResult Best; ///< valid mesh with the highest minimum so far: mesh, arrays and figures

  // Of the current round.
  BlockOctree Octree;
  HexMesh Dual;
  OctreeDualArrays DualArrays;
  HexDomain Domain;
  FeatureMapping Mapping;
  PaddedMesh Body;
  HexFeatures Features;
  HexStars Stars;
  std::unique_ptr<FeatureTargets> Targets;
  std::vector<Vec3> Unfitted;  ///< points of the body after padding
  std::vector<char> Changed;   ///< per point of the body: not carried over; empty: all
};
}

#endif

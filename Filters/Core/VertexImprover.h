// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Moves single vertices so that the worst scaled Jacobian round them rises, inside the tolerance.

#ifndef featurehex_VertexImprover_h
#define featurehex_VertexImprover_h

#include "CornerMeasures.h"
#include "FeatureTargets.h"
#include "HexStars.h"
#include "SurfaceEnvelope.h"

namespace featurehex
{
/// Parameters of one barrier sweep (recipe-quality 2.4).
struct BarrierParameters
{
  double Theta; ///< corners above it exert no force
  double Floor; ///< no corner may fall below it ...
  double Gap;   ///< ... nor by more than this where it is below already
};

/// The moves of recipe-quality 2 for one vertex. Hard checks on every accepted move: the Bezier
/// coefficients of the touching hexes stay positive (or don't fall where they weren't), the ratio
/// of shortest to longest edge at the vertex stays above 0.2 (or doesn't fall), and the boundary
/// stays inside the envelope. Calls for vertices more than three hexes apart may run in parallel.
class VertexImprover
{
public:
  /// Keeps references. @a limit: largest sampled distance (model units) that a move may reach.
  /// @a features: locked vertices stay on them; may be null.
  VertexImprover(HexMesh& mesh, const HexStars& stars, SurfaceEnvelope& envelope, double limit,
    FeatureTargets* features = nullptr);

  /// Raise the smallest scaled Jacobian round the vertex: steepest ascent of the minimum by a
  /// proximal bundle.
  bool RaiseMinimum(Index vertex);

  /// Newton step on a moving barrier over the corners below Theta.
  bool PushBarrier(Index vertex, const BarrierParameters& parameters);

  /// Newton step on the distortion, with quads beyond 0.9 of the limit drawn back with @a weight.
  bool DrawInside(Index vertex, double weight);

  /// Newton step on the squared angle errors of the corners near the surface; corners stay above
  /// min(their value, floor).
  bool RaiseAverage(Index vertex, const SurfaceGeometry& surface, double floor);

  /// Move towards the closest surface point (of its patch), or to its corner or curve, where it is
  /// then locked; corners of hexes stay above min(their value, floor). True: it got there.
  bool Project(Index vertex, const SurfaceGeometry& surface, double floor);

  const FeatureTargets* Features() const { return this->FeaturesOfMesh; }

  double Limit() const { return this->EnvelopeLimit; }

  /// Shortest / longest edge at the vertex if it were at @a position.
  double EdgeRatio(Index vertex, const Vec3& position) const;

private:
  static constexpr double LeastEdgeRatio = 0.2;

  using Corner = VertexCorner;
  struct Pull;
  struct Star;
  struct PullLaw;
  struct Model;
  static const PullLaw BarrierPull;

  static Model DistortionModel(const Star& star);
  static Model MeanModel(const Star& star);
  static Vec3 StepOf(const Model& model, const Star& star, double least);
  void AddPulls(const Star& star, const PullLaw& law, Model& model) const;
  double WithPulls(double energy, const Star& star, const PullLaw& law, const Vec3& x) const;
  bool Pinned(Index vertex) const;
  TrianglePoint ClosestOnSurface(
    Index vertex, const Vec3& p, const SurfaceGeometry& surface, Vec3& normal);
  void Gather(Index vertex, Star& star) const;
  void WeighCorners(Index vertex, Star& star) const;
  void GatherPulls(Index vertex, double threshold, Star& star);
  template <typename Accept>
  bool Search(Index vertex, const Star& star, const Vec3& step, int trials, const Accept& accept,
    double leastRatio = LeastEdgeRatio);

  HexMesh& Mesh;
  const HexStars& Stars;
  SurfaceEnvelope& Envelope;
  double EnvelopeLimit;
  FeatureTargets* FeaturesOfMesh;
  std::vector<double> Lengths; ///< mean edge length at each vertex at the start
  std::vector<Index> Hints;    ///< closest triangle of each vertex the last time, on its patch
};
}

#endif

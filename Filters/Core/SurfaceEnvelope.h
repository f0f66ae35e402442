// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Two-sided sampled distance between the boundary of a moving hex mesh and the input surface.

#ifndef featurehex_SurfaceEnvelope_h
#define featurehex_SurfaceEnvelope_h

#include "HexStars.h"
#include "Monitor.h"
#include "SurfaceGeometry.h"

namespace featurehex
{
/// A point of a boundary quad and the point of the input surface that it belongs to.
struct EnvelopeContact
{
  Index Quad = -1;
  std::array<double, 4> Weights = { 0, 0, 0, 0 }; ///< of the quad's vertices
  Vec3 QuadPoint = Vec3::Zero();
  Vec3 SurfacePoint = Vec3::Zero();
  double Distance = 0.0;
};

/// Answers "does the boundary stay within a limit of the surface, both ways, if this vertex moves?"
/// fast enough to be asked for every move (recipe-quality 2).
///
/// Forward: a grid of points on each boundary quad, each with its last closest triangle. Reverse:
/// samples of the input, each owned by a quad close to it. Both distances change by no more than
/// the vertex moves, so each quad carries an upper bound that is simply raised until it would reach
/// the limit; only then are its samples measured again. A measurement first tries the triangle, or
/// the point of the quad, that was closest the last time: when that is near enough, nothing is
/// searched.
///
/// A call for a vertex touches the quads round it and passes samples on to quads next to those:
/// calls run beside each other under a VertexSchedule with 3 rings.
class SurfaceEnvelope
{
public:
  /// Keeps references; nothing is known before Rebuild(). @a grid: points per quad side, >= 2.
  /// @a monitor is asked during Rebuild(), Update() and Measure(); when it says stop they end
  /// early, and what this object knows is wrong.
  SurfaceEnvelope(const SurfaceGeometry& surface, const std::vector<Vec3>& samples,
    const HexMesh& mesh, const HexStars& stars, int grid, Monitor* monitor = nullptr);

  /// Give each sample, new ones at the end of the samples included, to its closest quad (search
  /// over the whole boundary). Bounds of their distances become unknown; those of the points of the
  /// quads stay: vertices move by AcceptMove() only, once the first Measure() has been called.
  void Rebuild();

  /// As Rebuild(), but each sample farther than @a enough walks from its quad to closer ones next
  /// to it.
  void Update(double enough);

  /// Measure the quads whose bound is beyond @a enough: afterwards a bound beyond it is the sampled
  /// distance.
  void Measure(double enough);

  /// Largest sampled distance known for the quads round @a vertex (an upper bound).
  double BoundAround(Index vertex) const;

  /// Vertices of @a quads have just been moved by up to @a shift. True: the quads stay within
  /// @a limit, and the state is updated. False: they don't; the caller moves the vertices back.
  bool AcceptMove(IdLists::Range quads, double shift, double limit);

  /// Appends the contacts of @a quad farther than @a threshold.
  void Collect(Index quad, double threshold, std::vector<EnvelopeContact>& contacts);

  /// Farthest sample of the input owned by @a quad; Quad = -1 when none is farther than
  /// @a threshold.
  EnvelopeContact WorstReverse(Index quad, double threshold) const;

  /// Upper bounds of the sampled distances, whole boundary.
  double ForwardMaximum() const;
  double ReverseMaximum() const;

private:
  struct Transfer
  {
    Index Sample, From, To;
    double Distance;
  };

  /// Where a sample was closest to the boundary the last time.
  struct Witness
  {
    Index Quad = -1;
    std::array<float, 4> Weights = { 0, 0, 0, 0 };
  };

  EnvelopeContact ClosestOnQuad(Index sample, Index quad) const;
  EnvelopeContact AtWitness(Index sample, Index quad) const;
  EnvelopeContact ClosestNear(Index sample, Index quad, double enough);
  /// What a measurement is for.
  enum class Purpose
  {
    Distance, ///< the largest one
    Decision  ///< whether any is beyond enough: the first one ends it
  };

  double MeasureForward(
    Index quad, double enough, Purpose purpose, std::vector<EnvelopeContact>* contacts);
  double MeasureReverse(Index quad, double enough, Purpose purpose,
    std::vector<Transfer>& transfers, std::vector<EnvelopeContact>* contacts);
  void Apply(const std::vector<Transfer>& transfers);
  void LinkSamples(const std::vector<Index>& owners);
  Vec3 GridPoint(Index quad, int i) const;

  const SurfaceGeometry& Surface;
  const std::vector<Vec3>& Samples;
  const HexMesh& Mesh;
  const HexStars& Stars;
  Monitor* Progress;
  std::vector<std::array<double, 4>> GridWeights;
  std::vector<Index> Closest;      ///< of each sample, among the triangles of the last Rebuild()
  std::vector<Witness> Witnesses;  ///< of each sample
  std::vector<Index> Hints;        ///< closest triangle of each grid point of each quad
  std::vector<Index> FirstSample;  ///< of each quad, -1: none
  std::vector<Index> NextSample;   ///< of each sample in its quad, -1: last
  std::vector<double> Forward;     ///< upper bound for each quad
  std::vector<double> Reverse;     ///< upper bound for each quad
};
}

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Block coordinate descent on the distortion of a hex mesh plus quadratic surface terms
/// (design 4).

#ifndef featurehex_HexOptimizer_h
#define featurehex_HexOptimizer_h

#include "FeatureTargets.h"
#include "HexStars.h"
#include "VertexSchedule.h"

#include <atomic>
#include <memory>

namespace featurehex
{
/// Least of the eight corner determinants of a hex.
double LeastCornerDeterminant(const HexMesh& mesh, Index hex);

/// Weight (Stiffness (n . d)^2 + Tether |d|^2) with d = (weighted mean of the vertices) - Target.
/// Zero weight: absent. A plane has Stiffness 1; a line along n Stiffness -1 and Tether 1; a point
/// 0 and 1.
struct SurfaceTerm
{
  Vec3 Target = Vec3::Zero();
  Vec3 Normal = Vec3::Zero();
  double Weight = 0.0; ///< already divided by the square of the local size
  double Stiffness = 1.0;
  double Tether = 0.0;
};

/// A term on a boundary quad, with the weights of its four vertices.
struct QuadTerm
{
  SurfaceTerm Term;
  std::array<double, 4> Weights = { 0.25, 0.25, 0.25, 0.25 };
};

/// Minimises, one vertex at a time by Newton steps in closed form,
///
///   E = sum over hexes and corners of f(J) + surface terms,
///   f = (|J|^2)^(3/2) / (3^(3/2) det J)                            (3-D MIPS, 1 for a cube corner)
///
/// with J the three edge vectors at the corner. For one moving vertex |J|^2 is quadratic with a
/// scalar Hessian and det J is affine, so that gradient and Hessian are closed forms. Steps are
/// limited by the ratio test: no corner determinant loses more than 80 % of its value. In
/// untangling mode det J is replaced by chi = (det + sqrt(det^2 + delta^2)) / 2, which is positive
/// for inverted corners too.
///
/// References: Hormann, Greiner, MIPS, 2000; Garanzha, Kaporin, Kudryavtseva, Protais, Ray,
/// Sokolov, Foldover-free maps in 50 lines of code, ACM TOG 40(4), 2021,
/// doi:10.1145/3450626.3459847.
class HexOptimizer
{
public:
  /// Keeps references to @a mesh and @a stars; moves the points of the mesh.
  HexOptimizer(HexMesh& mesh, const HexStars& stars);

  /// Mean edge length round each vertex and of each hex; frozen until the next call.
  void UpdateSizes();

  double SizeAt(Index vertex) const { return this->VertexSizes[vertex]; }

  /// One term per vertex (absent for interior vertices) and two per boundary quad.
  std::vector<SurfaceTerm> VertexTerms;
  std::vector<QuadTerm> CentroidTerms;
  std::vector<QuadTerm> ReverseTerms;

  /// Vertices that must not move.
  std::vector<bool> Fixed;

  /// Fix those that are 0 in @a changed; null: none.
  void FixUnchanged(const std::vector<char>* changed)
  {
    for (std::size_t v = 0; changed && v < changed->size(); ++v)
    {
      this->Fixed[v] = this->Fixed[v] || !(*changed)[v];
    }
  }

  bool AllFixed(const Quad& quad) const
  {
    return this->Fixed[quad[0]] && this->Fixed[quad[1]] && this->Fixed[quad[2]] &&
      this->Fixed[quad[3]];
  }

  /// Locked vertices stay on their features; may be null. The caller keeps it alive.
  const FeatureTargets* Features = nullptr;

  /// Move the vertex by @a displacement if no corner determinant loses more than the ratio test
  /// allows.
  bool TryMove(Index vertex, const Vec3& displacement);

  /// One sweep over the vertices marked active; a moved vertex marks its neighbours. Returns the
  /// number of vertices that moved. @a regularization: delta relative to the cube of the hex size,
  /// negative: the mesh is valid and stays so. When @a monitor says stop, the sweep ends early.
  std::size_t Sweep(double regularization, Monitor* monitor = nullptr);

  void ActivateAll();
  void ActivateBoundary();
  /// The vertices of the hexes at the vertex.
  void ActivateAround(Index vertex);
  /// The vertices of the hex and of those that touch it.
  void ActivateAround(const Hex& hex);

  /// Least determinant, relative to the cube of the hex size, of the corners that can move.
  double LeastDeterminant() const;

  /// A corner whose four vertices are all fixed is inverted: no move of the others makes this hex
  /// valid.
  bool Hopeless(Index hex) const;

private:
  struct Corner;

  bool CanMove(const Hex& hex, int corner) const;
  bool MoveVertex(Index vertex, double regularization);
  void CollectCorners(Index vertex, double regularization, std::vector<Corner>& corners) const;
  template <typename Visitor>
  void VisitTerms(Index vertex, const Visitor& visit) const;

  HexMesh& Mesh;
  const HexStars& Stars;
  VertexSchedule Schedule;
  std::vector<double> VertexSizes;
  std::vector<double> HexSizes;
  std::unique_ptr<std::atomic<bool>[]> Active;
};
}

#endif

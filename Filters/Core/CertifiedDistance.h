// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Proven bounds of the two-sided Hausdorff distance between the boundary of a hex mesh (bilinear
/// patches) and a triangle surface.

#ifndef featurehex_CertifiedDistance_h
#define featurehex_CertifiedDistance_h

#include "Monitor.h"
#include "TriangleSearch.h"
#include "Types.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace featurehex
{
/// A point that is farther away than allowed, or could not be proven to be near enough.
struct DistanceWitness
{
  Vec3 Point = Vec3::Zero();
  double Distance = 0.0; ///< of Point to the other surface, model units
  Index Element = -1;    ///< quad (mesh to surface) or triangle (surface to mesh) of the point
};

/// Distance from all points of one surface to the other. Model units.
struct DirectedDistance
{
  double Lower = 0.0;     ///< the distance of a point that was found
  double Upper = 1e300;   ///< proven: no point is farther
  double Mean = 0.0;      ///< area-weighted mean over samples, not certified
  Vec3 Where = Vec3::Zero(); ///< the point with distance Lower
  bool Converged = false; ///< the bounds are as close as was asked
  std::int64_t Pieces = 0;
  /// Elements with a point beyond the tolerance (at most one point each), by element.
  std::vector<DistanceWitness> Witnesses;
};

/// Result of CertifiedDistance::Measure(). The Hausdorff distance lies in [Lower(), Upper()].
struct DistanceBounds
{
  DirectedDistance MeshToSurface;
  DirectedDistance SurfaceToMesh;
  /// Per quad: proven bound of the distance of its points to the surface. No tighter than needed:
  /// may be as large as the greatest deviation of the mesh where the quad's own is smaller.
  std::vector<double> Deviation;
  std::vector<double> DeviationFound; ///< per quad: greatest distance of a point looked at
  double SplitError = 0.0; ///< greatest distance of a patch from the triangles that stand for it

  double Lower() const { return std::max(this->MeshToSurface.Lower, this->SurfaceToMesh.Lower); }
  double Upper() const { return std::max(this->MeshToSurface.Upper, this->SurfaceToMesh.Upper); }
  double Mean() const { return std::max(this->MeshToSurface.Mean, this->SurfaceToMesh.Mean); }
  bool Converged() const { return this->MeshToSurface.Converged && this->SurfaceToMesh.Converged; }
};

/// Result of CertifiedDistance::DistanceWithin().
struct DistanceDecision
{
  bool Within = false; ///< proven in both directions
  std::vector<DistanceWitness> Quads;     ///< points of the mesh that are not within, by quad
  /// Points of the surface that are not within, by triangle.
  std::vector<DistanceWitness> Triangles;
};

/// Distances to one surface; build it once and ask for many meshes.
///
/// Method (design.md section 5): the distance to a convex triangle is a convex function, so over a
/// piece of surface it is greatest at a corner of the piece's convex hull; a bilinear patch lies in
/// the hull of its four corners. For corners v_i a piece is no farther than min over candidate
/// triangles t of max_i d(v_i, t), nor than max_i d(v_i) + R, R the radius of a ball around the
/// corners (distances are 1-Lipschitz). Pieces whose bound is not good enough are cut: in halves,
/// or along the prism over the nearest triangle, inside which the first bound is tight. For the
/// direction to the mesh every patch is split into triangles at most SplitError away, which is
/// included in both bounds.
/// Branch and bound for the value: L. Sacht, A. Jacobson, "Cascading upper bounds for triangle soup
/// Pompeiu-Hausdorff distance", Computer Graphics Forum 43(5), 2024, doi 10.1111/cgf.15129.
///
/// Always ends: each element has a budget of pieces; what is unproven then keeps its bound and the
/// result is not converged. Parallel over elements, which don't exchange bounds: the same bits for
/// any number of threads. When @a monitor stops, the result is neither converged nor within.
/// Coordinates are recentred. 1e-12 of the surface's diagonal is added to the upper bounds for
/// rounding.
class CertifiedDistance
{
public:
  explicit CertifiedDistance(const SurfaceMesh& surface);

  /// Are both surfaces within @a tolerance (model units) of each other? False also where the answer
  /// could not be proven: distances between 0.97 and 1 times the tolerance may go either way.
  DistanceDecision DistanceWithin(const std::vector<Vec3>& points, const std::vector<Quad>& quads,
    double tolerance, Monitor& monitor) const;

  /// Bounds of the distance, at most 1 % of the larger of @a tolerance and the distance apart.
  DistanceBounds Measure(const std::vector<Vec3>& points, const std::vector<Quad>& quads,
    double tolerance, Monitor& monitor) const;

  /// Diagonal of the bounding box of the surface, model units.
  double Diagonal() const { return this->SurfaceDiagonal; }

private:
  Vec3 Center = Vec3::Zero();
  double SurfaceDiagonal = 0.0;
  TriangleSearch Search;
};
}

#endif

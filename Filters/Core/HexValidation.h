// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Every figure that proves or refutes the promises about a finished hex mesh.

#ifndef featurehex_HexValidation_h
#define featurehex_HexValidation_h

#include "CertifiedDistance.h"
#include "FeatureValidation.h"
#include "HexQuality.h"
#include "MeshTopology.h"
#include "Monitor.h"
#include "Types.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace featurehex
{
/// What a mesh is measured against.
struct HexValidationOptions
{
  /// Allowed Hausdorff distance, fraction of the diagonal of the surface's bounding box.
  double Tolerance = 0.005;
  /// Both null: features are not looked at. Needs a surface.
  FeatureCorrespondence Features;
};

/// Why a hex is offending; several may apply. Values are stable: they are written to files.
enum HexDefect : std::uint32_t
{
  NonFinitePoint = 1 << 0,
  IdOutOfRange = 1 << 1,
  RepeatedId = 1 << 2,
  DuplicateHex = 1 << 3,
  NonPositiveCorner = 1 << 4,   ///< scaled Jacobian <= 0
  NotCertified = 1 << 5,        ///< a determinant <= 0 inside, or positivity not provable
  OverusedFaceHex = 1 << 6,     ///< a face of three hexes or more
  TwistedFaceHex = 1 << 7,      ///< a face that the neighbour runs through in another order
  MisorientedFaceHex = 1 << 8,  ///< a face that the neighbour sees in the same direction
  NonManifoldBoundary = 1 << 9, ///< has a boundary quad at a non-manifold edge or vertex
  SelfIntersecting = 1 << 10,   ///< has a boundary quad that meets another one
  /// Has a boundary quad beyond, or closest to a surface point beyond.
  BeyondTolerance = 1 << 11
};

/// Name of a single defect, e.g. "NotCertified".
const char* HexDefectName(HexDefect defect);

/// A hex that breaks a promise.
struct OffendingHex
{
  Index Hex = -1;
  std::uint32_t Defects = 0; ///< HexDefect, combined
};

/// The verdict on a mesh. Lengths named Hausdorff are fractions of the surface's diagonal; volumes
/// and areas are in model units.
struct HexValidationReport
{
  /// Ok: the mesh keeps every promise that was checked. Validation: it doesn't, the message says
  /// which; other codes: the validation itself could not be done (stopped, ids out of range).
  Status Result;

  HexTopology Topology;
  SurfaceTopology Input;   ///< of the surface
  bool HasSurface = false; ///< the promises that compare with a surface were checked

  std::vector<double> ScaledJacobians; ///< per hex, for the quality array
  QualityStatistics Quality;
  Index NonFinitePoints = 0;
  Index CertifiedValid = 0;
  Index CertifiedInvalid = 0;
  Index CertifiedUndecided = 0;
  /// Certified: smallest / largest determinant, least over hexes.
  double MinimumJacobianRatio = 0.0;
  double Volume = 0.0;               ///< sum over the hexes

  bool IntersectionsChecked = false; ///< false: not all points are finite
  Index SelfIntersections = 0; ///< pairs that meet on the finest subdivision looked at
  Index SuspectQuads = 0;      ///< quads with a finding in a coarse split, decided by the finest

  DistanceBounds Distance; ///< model units
  double Diagonal = 0.0;   ///< of the surface's bounding box, model units
  double Tolerance = 0.0;  ///< as in the options

  bool HasFeatures = false;         ///< the features were checked
  FeatureValidationReport Features; ///< no part of Valid(): the few that can't be met are listed

  std::vector<OffendingHex> Offending; ///< ascending

  bool PureConforming() const; ///< P1: conforming, no repeated id, no orphan or duplicate point
  bool PositiveCorners() const; ///< P2, first half: scaled Jacobian > 0 everywhere
  bool Certified() const;       ///< P2: finite, every element certified
  bool Manifold() const { return this->Topology.Surface.ClosedManifold(); } ///< P3, first half
  bool TopologyMatches() const; ///< P3: components, genus and cavities of the surface
  bool WithinTolerance() const; ///< P4: proven
  bool FreeOfIntersections() const
  {
    return this->IntersectionsChecked && this->SelfIntersections == 0;
  }
  /// Volumes differ by no more than the distance allows. Finds filled cavities and hollowed solids.
  bool VolumeFits() const;
  bool Valid() const; ///< all of them; those that need a surface only if there is one

  /// All figures under their public names, in a fixed order: the one source of names for field
  /// data, table, report and command line. Truth values are 0 or 1. Figures that need a surface are
  /// missing without one. Names are API.
  std::vector<std::pair<std::string, double>> Figures() const;
};

/// Measures everything. @a surface may be null; features need the ids of its points. Never fails:
/// broken meshes, empty ones and ids out of range give a report that is not Valid(). Parallel, the
/// same bits for any number of threads.
HexValidationReport ValidateHexMesh(const HexMesh& mesh, const SurfaceMesh* surface,
  const HexValidationOptions& options, Monitor& monitor);

/// Boundary quads that meet others beyond their common points: both diagonal splits are tested with
/// exact predicates; quads with a finding are decided on an 8 x 8 subdivision of their bilinear
/// patches. Coordinates must be finite.
struct BoundaryIntersections
{
  Index Pairs = 0; ///< on the subdivision; counting stops at 100,000
  Index SuspectQuads = 0;
  std::vector<Index> Quads; ///< that take part in pairs, ascending
};
BoundaryIntersections FindBoundaryIntersections(
  const std::vector<Vec3>& points, const std::vector<Quad>& quads, Monitor& monitor);
}

#endif

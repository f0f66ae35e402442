// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Connectivity of a finished mesh: conformity, boundary, manifoldness, components, genus,
/// cavities, singular edges. Works on ids; coordinates decide only volumes and coincident points.

#ifndef featurehex_MeshTopology_h
#define featurehex_MeshTopology_h

#include "Types.h"

#include <array>
#include <vector>

namespace featurehex
{
/// Topology of a surface given by faces with shared point ids. Two faces are connected when they
/// share an edge. A point counts once per umbrella (fan of faces connected through edges at it), so
/// that components that touch in a point keep their own Euler characteristic.
struct SurfaceTopology
{
  Index Vertices = 0; ///< points that faces use
  Index Edges = 0;
  Index Faces = 0;
  Index Components = 0;
  std::vector<Index> Genus;      ///< (2 - Euler characteristic) / 2 of each component, ascending
  Index EulerCharacteristic = 0; ///< sum over the components
  Index Cavities = 0;            ///< components with negative volume: they bound a void
  double Volume = 0.0;           ///< signed, of all components; faces seen as bilinear patches
  /// Triangles exact; quads: half the cross product of the diagonals.
  double Area = 0.0;
  Index OpenEdges = 0;           ///< edges of one face
  Index NonManifoldEdges = 0;    ///< edges of three faces or more
  Index MisorientedEdges = 0;    ///< edges that two faces run through in the same direction
  Index NonManifoldVertices = 0; ///< points with more than one umbrella
  Index DegenerateFaces = 0;     ///< faces that repeat an id

  std::vector<std::array<Index, 2>> BadEdges; ///< open, non-manifold and misoriented ones, sorted
  std::vector<Index> BadVertices;             ///< the non-manifold ones, ascending

  /// Closed 2-manifold with a consistent orientation.
  bool ClosedManifold() const
  {
    return this->Faces > 0 && this->OpenEdges == 0 && this->NonManifoldEdges == 0 &&
      this->MisorientedEdges == 0 && this->NonManifoldVertices == 0 && this->DegenerateFaces == 0;
  }
};

/// Topology of triangles or of quads. Ids must exist in @a points.
SurfaceTopology AnalyzeSurface(
  const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
SurfaceTopology AnalyzeSurface(const std::vector<Vec3>& points, const std::vector<Quad>& quads);

/// Both closed manifolds with the same components, sorted genera and cavities. Cavities are
/// compared up to the orientation of the whole surface.
bool SameTopology(const SurfaceTopology& a, const SurfaceTopology& b);

/// The boundary of a hex mesh: faces of exactly one hex.
struct HexBoundary
{
  std::vector<Quad> Quads;   ///< counter-clockwise from outside; ids of the mesh's points
  std::vector<Index> Owners; ///< the hex of each quad, ascending
};

/// Hexes at faces that break conformity, ascending.
struct FaceDefects
{
  std::vector<Index> Overused;    ///< hexes with a face that three hexes or more share
  /// Hexes with a face that its neighbour runs through in another order.
  std::vector<Index> Twisted;
  std::vector<Index> Misoriented; ///< hexes with a face that both hexes see in the same direction
};

/// Connectivity of a hex mesh. Counts of faces are of faces, not of hexes.
struct HexTopology
{
  Index Points = 0;
  Index Hexes = 0;
  Index OrphanPoints = 0;    ///< points of no hex
  Index DuplicatePoints = 0; ///< used points that coincide with one of a lower id
  Index DuplicateHexes = 0;  ///< hexes with the eight ids of an earlier one
  Index DegenerateHexes = 0; ///< hexes that repeat an id
  Index Faces = 0;
  Index InteriorFaces = 0;
  Index OverusedFaces = 0;
  Index TwistedFaces = 0;
  Index MisorientedFaces = 0;
  Index Bodies = 0; ///< sets of hexes connected through faces
  Index Edges = 0;
  Index BoundaryEdges = 0;
  Index SingularInteriorEdges = 0; ///< interior edges in other than 4 hexes
  Index SingularBoundaryEdges = 0; ///< boundary edges in other than 2 hexes
  FaceDefects Defects;
  std::vector<Index> DuplicateHexIds;  ///< ascending
  std::vector<Index> DegenerateHexIds; ///< ascending
  HexBoundary Boundary;
  SurfaceTopology Surface; ///< of Boundary.Quads

  bool Conforming() const
  {
    return this->Hexes > 0 && this->OverusedFaces == 0 && this->TwistedFaces == 0 &&
      this->MisorientedFaces == 0 && this->DuplicateHexes == 0 && this->DegenerateHexes == 0;
  }
};

/// Everything about the connectivity. Ids must exist. Points count as coincident within 1e-12 of
/// the bounding box diagonal. Faces are matched by a counting sort on their lowest id: linear time,
/// 24 bytes per hex for the faces, parallel, the same result for any number of threads.
HexTopology AnalyzeHexMesh(const HexMesh& mesh);

/// Only the boundary quads, with their hexes. Ids must exist.
HexBoundary ExtractBoundary(const HexMesh& mesh);

/// Number of finite points with another one of lower index within @a tolerance.
Index CountCoincidentPoints(const std::vector<Vec3>& points, double tolerance);
}

#endif

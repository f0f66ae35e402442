// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A hex mesh as solvers want it: bodies, patches of boundary faces, curves and corners, all named.

#ifndef featurehex_SolverMesh_h
#define featurehex_SolverMesh_h

#include "Status.h"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace featurehex
{
/// Linear or quadratic hexes with labelled faces, edges and vertices. All ids 0-based.
struct SolverMesh
{
  /// A face of a hex: row of HexFaces.
  struct Side
  {
    Index Hex;
    int Face;
    std::int32_t Patch;
  };
  /// An edge of a hex: row of HexEdges.
  struct Segment
  {
    Index Hex;
    int Edge;
    std::int32_t Curve;
  };
  /// A vertex on a feature corner.
  struct Corner
  {
    Index Point;
    std::int32_t Id;
  };

  std::vector<Vec3> Points;
  /// 8, 20 (mid-edge nodes) or 27 (also those of faces and of the hex).
  int NodesPerHex = 8;
  /// Of each hex in turn: corners in the order of VTK_HEXAHEDRON, mid-edge nodes in that of
  /// HexEdges, mid-face nodes in that of HexFaces, the node in the middle.
  std::vector<Index> HexNodes;
  std::vector<std::int32_t> Regions; ///< body of each hex, 1 and up; as long as the hexes
  std::vector<Side> Sides;
  std::vector<Segment> Segments;
  std::vector<Corner> Corners;

  Index NumberOfHexes() const
  {
    return static_cast<Index>(this->HexNodes.size()) / this->NodesPerHex;
  }
  const Index* Nodes(Index hex) const
  {
    return this->HexNodes.data() + static_cast<std::size_t>(hex) * this->NodesPerHex;
  }
};

/// Nodes of a face: 4, 8 or 9: corners counter-clockwise seen from outside, the mid-edge nodes
/// after each of them, the node in the middle.
std::vector<Index> NodesOfSide(const SolverMesh& mesh, Index hex, int face);

/// Nodes of an edge: its ends, and with mid-edge nodes the one between them.
std::vector<Index> NodesOfSegment(const SolverMesh& mesh, Index hex, int edge);

/// What is known about faces, edges and vertices by their corner points.
struct SolverLabels
{
  std::vector<Quad> Quads;
  std::vector<std::int32_t> Patches; ///< of each quad
  std::vector<std::array<Index, 2>> Edges;
  std::vector<std::int32_t> Curves; ///< of each edge
  std::vector<SolverMesh::Corner> Corners;
  /// Patch of each point that lies in a patch, else -1; empty: not known. For boundary faces that
  /// are not among Quads.
  std::vector<std::int32_t> PatchOfPoint;
};

/// Sets Sides, Segments and Corners of @a mesh. Each boundary face gets a side: patch of the quad
/// with the same corners, else that of its points where they agree, else one more than the highest
/// patch (a cut through the mesh). Quads between two hexes give a side of the first hex. Quads and
/// edges that the mesh doesn't have are left out.
/// @return EmptySurface (no hexes), IndexOutOfRange, NonFinite.
Status LabelSolverMesh(const SolverLabels& labels, SolverMesh& mesh);

/// Ids of points, hexes, faces and edges exist, coordinates are finite. All writers check it.
/// @return EmptySurface, IndexOutOfRange, NonFinite.
Status CheckSolverMesh(const SolverMesh& mesh);

/// Groups by label, ascending; positions in the lists of @a mesh, ascending.
struct SolverGroups
{
  std::map<std::int32_t, std::vector<Index>> Bodies;  ///< hexes
  std::map<std::int32_t, std::vector<Index>> Patches; ///< sides
  std::map<std::int32_t, std::vector<Index>> Curves;  ///< segments
  std::map<std::int32_t, std::vector<Index>> Corners; ///< corners

  explicit SolverGroups(const SolverMesh& mesh);
};

/// The name of a group in all formats: body_1, patch_0, curve_3, corner_7. A negative label is
/// written as n and the number: patch_n1.
std::string GroupName(const char* kind, std::int32_t label);

/// Points of sides or segments, each once, ascending.
std::vector<Index> PointsOfSides(const SolverMesh& mesh, const std::vector<Index>& sides);
std::vector<Index> PointsOfSegments(const SolverMesh& mesh, const std::vector<Index>& segments);
} // namespace featurehex

#endif

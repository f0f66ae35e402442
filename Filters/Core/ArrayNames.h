// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Names of the arrays that travel through the pipeline. They are API: files, state files and
/// scripts hold them.

#ifndef featurehex_ArrayNames_h
#define featurehex_ArrayNames_h

namespace featurehex
{
namespace ArrayNames
{
// Points of hex meshes.
constexpr const char* FeatureKind = "FeatureKind"; ///< 0 interior, 1 surface, 2 curve, 3 corner
constexpr const char* FeatureId = "FeatureId";     ///< patch, curve or corner; -1 interior

// Cells of hex meshes.
constexpr const char* Region = "Region";                 ///< 0 outside, 1... body
/// Halvings of the target edge length: 0 cells of that length, 1 of half, -1 of twice. Cells of
/// octrees and hex meshes; points: refinement points ask for it.
constexpr const char* Level = "Level";
constexpr const char* ScaledJacobian = "ScaledJacobian"; ///< smallest of the 8 corners
constexpr const char* Certified = "Certified"; ///< 1: Jacobian proven positive in the whole hex
constexpr const char* Defects = "Defects";     ///< HexDefect bits, 0: none
constexpr const char* DualHexKind = "DualHexKind";   ///< 0 cube, 1... transition hexes
constexpr const char* PaddingLayer = "PaddingLayer"; ///< 1: hex of the layer under the boundary

// Cells and points that a stage complains about.
constexpr const char* Reason = "Reason";                 ///< in words
constexpr const char* OriginalCellId = "OriginalCellId"; ///< id of the cell in the whole mesh

// Cells of surfaces and boundaries.
constexpr const char* PatchId = "PatchId";     ///< 0...; -1 none
constexpr const char* ComponentId = "ComponentId"; ///< connected piece of a surface, 0...
constexpr const char* Deviation = "Deviation"; ///< distance to the input, model units

constexpr const char* DeviationOfTolerance = "DeviationOfTolerance"; ///< 1: as far as allowed

// Columns of histograms.
/// ParaView's charts take a column of this name as their axis.
constexpr const char* BinMiddles = "bin_extents";
constexpr const char* Hexes = "Hexes"; ///< how many are in the bin
constexpr const char* Quads = "Quads"; ///< how many are in the bin

// Cells of feature graphs.
constexpr const char* CornerId = "CornerId";
constexpr const char* CurveId = "CurveId";
constexpr const char* FeatureValid = "FeatureValid"; ///< 0: found, but not enforced

constexpr const char* Captured = "Captured"; ///< of feature polylines of a mesh, 1: one to one

// Points of feature polylines of a mesh.
constexpr const char* MeshPointId = "MeshPointId"; ///< id of the point in the mesh

// Points of feature graphs.
constexpr const char* SurfacePointId = "SurfacePointId"; ///< id of the point in the surface

// Octree leaves and their field data.
constexpr const char* OctreeIndex = "OctreeIndex"; ///< 3 integers, units of the finest cell
constexpr const char* OctreeOrigin = "OctreeOrigin"; ///< 3 coordinates, model units
constexpr const char* OctreeAxes = "OctreeAxes";     ///< 3 unit vectors, one after another
constexpr const char* OctreeFinestCellSize = "OctreeFinestCellSize"; ///< model units
constexpr const char* OctreeDepth = "OctreeDepth";         ///< level of the finest cells, root 0
constexpr const char* OctreeBaseLevel = "OctreeBaseLevel"; ///< of the target edge length, root 0

// Field data of octrees and hex meshes.
constexpr const char* TargetEdgeLength = "TargetEdgeLength"; ///< model units
/// Of an output that is empty because a filter failed: code and message. Filters after it pass it
/// on instead of complaining about their empty input.
constexpr const char* Error = "FeatureHexError";

// Field data of hex meshes with features. Ids are those of the mesh's points.
constexpr const char* FeatureQuads = "FeatureQuads"; ///< boundary quads: four points, patch
constexpr const char* FeatureEdges = "FeatureEdges"; ///< edges of curves: two points, curve

// Field data of feature graphs.
constexpr const char* FeatureAngle = "FeatureAngle"; ///< degrees
constexpr const char* OrphanCurve = "OrphanCurve";
constexpr const char* OrphanCurveSingle = "OrphanCurveSingle";
} // namespace ArrayNames
} // namespace featurehex

#endif

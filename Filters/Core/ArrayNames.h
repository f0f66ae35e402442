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
constexpr const char* Level = "Level";                   ///< octree level, 0 coarsest
constexpr const char* ScaledJacobian = "ScaledJacobian"; ///< smallest of the 8 corners

// Cells of surfaces and boundaries.
constexpr const char* PatchId = "PatchId";     ///< 0...; -1 none
constexpr const char* Deviation = "Deviation"; ///< distance to the input, model units

// Cells of feature graphs.
constexpr const char* CornerId = "CornerId";
constexpr const char* CurveId = "CurveId";
constexpr const char* FeatureValid = "FeatureValid"; ///< 0: found, but not enforced

// Points of feature graphs.
constexpr const char* SurfacePointId = "SurfacePointId"; ///< id of the point in the surface

// Octree leaves and their field data.
constexpr const char* OctreeIndex = "OctreeIndex"; ///< 3 integers, units of the finest cell

// Field data of feature graphs.
constexpr const char* FeatureAngle = "FeatureAngle"; ///< degrees
constexpr const char* OrphanCurve = "OrphanCurve";
constexpr const char* OrphanCurveSingle = "OrphanCurveSingle";
} // namespace ArrayNames
} // namespace featurehex

#endif

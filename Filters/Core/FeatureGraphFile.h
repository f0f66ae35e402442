// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// .fgraph: the feature file of Gao, Shen, Panozzo, "Feature Preserving Octree-Based Hexahedral
/// Meshing", Computer Graphics Forum 38(5), 2019, doi:10.1111/cgf.13795.

#ifndef featurehex_FeatureGraphFile_h
#define featurehex_FeatureGraphFile_h

#include "Status.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace featurehex
{
/// Sharp features as ids of surface points; the file has no coordinates of its own.
///
/// Text: line 1 "angle orphan_curve orphan_curve_single", line 2 "#corners #edges", then a point id
/// for each corner, then two for each edge, all 0-based.
struct FeatureGraph
{
  std::vector<Index> Corners;
  std::vector<std::array<Index, 2>> Edges;
  double Angle = 0.0;            ///< the angle the features were found with, degrees; informative
  bool OrphanCurve = true;       ///< keep curves that bound no patch on both sides
  bool OrphanCurveSingle = true; ///< keep single curves of that kind
};

/// Reads @a path. @a numberOfPoints: of the surface the ids refer to; negative: not known, ids are
/// only checked to be no negative ones.
/// @return UnreadableFile (missing, truncated, not of the format, something after its end),
/// IndexOutOfRange, Degenerate (an edge from a point to itself), each with the line. @a graph is
/// empty then. A file without corners and edges is fine: a surface without features.
Status ReadFeatureGraph(const std::string& path, std::int64_t numberOfPoints, FeatureGraph& graph);

/// The same for the content of a file; @a name is used in messages.
Status ParseFeatureGraph(std::string_view bytes, const std::string& name,
  std::int64_t numberOfPoints, FeatureGraph& graph);

/// Writes @a graph; the file appears when it is complete.
/// @return UnwritableFile, IndexOutOfRange (negative id).
Status WriteFeatureGraph(const std::string& path, const FeatureGraph& graph);
} // namespace featurehex

#endif

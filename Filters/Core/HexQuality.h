// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Guarded scaled Jacobian of hexahedra and its statistics. Shares nothing with the optimiser: this
/// is what a finished mesh is judged by.

#ifndef featurehex_HexQuality_h
#define featurehex_HexQuality_h

#include "Types.h"

#include <array>
#include <vector>

namespace featurehex
{
/// Determinants of the unit edge vectors at the 8 corners of a hex, each in [-1, 1], 1 for a right
/// angled corner. A corner with a zero edge has -1. All are -1 when the hex repeats an id, refers
/// to a point that does not exist, or has a non-finite point: a broken hex never looks good (VTK
/// gives 1e30 for a collapsed hex and 1 for one with a NaN).
std::array<double, 8> CornerScaledJacobians(const HexMesh& mesh, Index hex);

/// Scaled Jacobian of a hex: the least of CornerScaledJacobians() (the paper's MSJ; P. Knupp,
/// "Algebraic mesh quality metrics for unstructured initial meshes", Finite Elements in Analysis
/// and Design 39, 2003, doi 10.1016/S0168-874X(02)00070-7).
double ScaledJacobian(const HexMesh& mesh, Index hex);

/// ScaledJacobian() of every hex. Parallel.
std::vector<double> ScaledJacobians(const HexMesh& mesh);

/// Statistics of a quality over the hexes of a mesh. Zero for an empty mesh.
struct QualityStatistics
{
  static constexpr int Bins = 20;
  double Minimum = 0.0;
  double Maximum = 0.0;
  double Mean = 0.0;
  double StandardDeviation = 0.0;        ///< of the population (divided by the count)
  Index NonPositive = 0;                 ///< values <= 0
  std::array<Index, Bins> Histogram{};   ///< positive values in equal bins over (0, 1]
};

/// Minimum, mean, standard deviation and histogram. The sums run in index order: same bits always.
QualityStatistics SummarizeQuality(const std::vector<double>& values);
}

#endif

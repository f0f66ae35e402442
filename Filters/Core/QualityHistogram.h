// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Histograms and the worst of a quality: what charts and pictures of a mesh are made of.

#ifndef featurehex_QualityHistogram_h
#define featurehex_QualityHistogram_h

#include "Types.h"

#include <vector>

namespace featurehex
{
/// Counts of values in equal bins.
struct ValueHistogram
{
  std::vector<double> Middles; ///< of the bins, ascending
  std::vector<double> Counts;
};

/// Bins of width 1 / @a binsPerUnit from 0 to 1, and as many more on either side as the values
/// need, but none below @a lowest or above @a highest: values beyond are counted in the first or
/// last one. A value between two bins belongs to the upper one, except 1 and @a highest. Values
/// that are no numbers count as @a lowest.
ValueHistogram MakeHistogram(
  const std::vector<double>& values, int binsPerUnit, double lowest, double highest);

/// Ids of the @a count smallest values, the smallest first, equal ones by id.
std::vector<Index> SmallestValues(const std::vector<double>& values, Index count);
} // namespace featurehex

#endif

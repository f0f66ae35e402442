// SPDX-License-Identifier: BSD-3-Clause
#include "QualityHistogram.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace featurehex
{
namespace
{
double Guarded(double value, double lowest, double highest)
{
  return std::isnan(value) ? lowest : std::clamp(value, lowest, highest);
}
} // namespace

//------------------------------------------------------------------------------
ValueHistogram MakeHistogram(
  const std::vector<double>& values, int binsPerUnit, double lowest, double highest)
{
  // Bins are numbered from that which begins at 0.
  long first = 0;
  long last = binsPerUnit - 1;
  std::vector<long> bins;
  bins.reserve(values.size());
  for (double value : values)
  {
    const double guarded = Guarded(value, lowest, highest);
    const double scaled = guarded * binsPerUnit;
    long bin = static_cast<long>(std::floor(scaled));
    if (guarded == 1.0 || guarded == highest)
    {
      bin = static_cast<long>(std::ceil(scaled)) - 1;
    }
    first = std::min(first, bin);
    last = std::max(last, bin);
    bins.push_back(bin);
  }
  ValueHistogram histogram;
  for (long bin = first; bin <= last; ++bin)
  {
    histogram.Middles.push_back((static_cast<double>(bin) + 0.5) / binsPerUnit);
  }
  histogram.Counts.assign(histogram.Middles.size(), 0.0);
  for (long bin : bins)
  {
    histogram.Counts[static_cast<std::size_t>(bin - first)] += 1.0;
  }
  return histogram;
}

//------------------------------------------------------------------------------
std::vector<Index> SmallestValues(const std::vector<double>& values, Index count)
{
  std::vector<Index> ids(values.size());
  std::iota(ids.begin(), ids.end(), Index(0));
  const auto end = ids.begin() + std::min<std::ptrdiff_t>(count, ids.size());
  std::partial_sort(ids.begin(), end, ids.end(),
    [&values](Index a, Index b) { return values[a] != values[b] ? values[a] < values[b] : a < b; });
  ids.erase(end, ids.end());
  return ids;
}
} // namespace featurehex

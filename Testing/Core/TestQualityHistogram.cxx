// SPDX-License-Identifier: BSD-3-Clause
#include "QualityHistogram.h"

#include <gtest/gtest.h>

#include <limits>
#include <numeric>

using namespace featurehex;

namespace
{
double Sum(const ValueHistogram& histogram)
{
  return std::accumulate(histogram.Counts.begin(), histogram.Counts.end(), 0.0);
}
} // namespace

TEST(QualityHistogram, BinsFromZeroToOne)
{
  const ValueHistogram histogram = MakeHistogram({ 0.0, 0.25, 0.3, 0.99, 1.0 }, 4, -1.0, 1.0);
  EXPECT_EQ(histogram.Middles, (std::vector<double>{ 0.125, 0.375, 0.625, 0.875 }));
  EXPECT_EQ(histogram.Counts, (std::vector<double>{ 1, 2, 0, 2 }));
}

TEST(QualityHistogram, MoreBinsForValuesOutside)
{
  const ValueHistogram broken = MakeHistogram({ -1.0, -0.1, 0.6 }, 2, -1.0, 1.0);
  EXPECT_EQ(broken.Middles, (std::vector<double>{ -0.75, -0.25, 0.25, 0.75 }));
  EXPECT_EQ(broken.Counts, (std::vector<double>{ 1, 1, 0, 1 }));
  // What is beyond the last bin is in it.
  const ValueHistogram far = MakeHistogram({ 0.1, 1.3, 7.0, 1e300 }, 2, 0.0, 2.0);
  EXPECT_EQ(far.Middles, (std::vector<double>{ 0.25, 0.75, 1.25, 1.75 }));
  EXPECT_EQ(far.Counts, (std::vector<double>{ 1, 0, 1, 2 }));
}

TEST(QualityHistogram, EachValueIsCounted)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(Sum(MakeHistogram({ nan, 0.5, -3.0, 9.0 }, 20, -1.0, 1.0)), 4.0);
  EXPECT_EQ(MakeHistogram({ nan }, 2, -1.0, 1.0).Counts, (std::vector<double>{ 1, 0, 0, 0 }));
  const ValueHistogram none = MakeHistogram({}, 20, -1.0, 1.0);
  EXPECT_EQ(none.Counts, std::vector<double>(20, 0.0));
}

TEST(QualityHistogram, SmallestFirst)
{
  const std::vector<double> values = { 0.5, 0.1, 0.9, 0.1, -1.0 };
  EXPECT_EQ(SmallestValues(values, 3), (std::vector<Index>{ 4, 1, 3 }));
  EXPECT_EQ(SmallestValues(values, 9), (std::vector<Index>{ 4, 1, 3, 0, 2 }));
  EXPECT_TRUE(SmallestValues(values, 0).empty());
  EXPECT_TRUE(SmallestValues({}, 5).empty());
}

// SPDX-License-Identifier: BSD-3-Clause
#include "MessageText.h"

#include <gtest/gtest.h>

#include <locale>

using namespace featurehex;

TEST(MessageText, ShortestDigits)
{
  EXPECT_EQ(NumberText(30), "30");
  EXPECT_EQ(NumberText(0.005), "0.005");
  EXPECT_EQ(NumberText(1.0 / 3, 3), "0.333");
  EXPECT_EQ(NumberText(1e-12), "1e-12");
  EXPECT_EQ(CountText(1, "edge", "edges"), "1 edge");
  EXPECT_EQ(CountText(0, "edge", "edges"), "0 edges");
  EXPECT_EQ(PlaceText(Vec3(1, -2.5, 0.1 + 0.2)), "(1, -2.5, 0.3)");
}

TEST(MessageText, NoCommaInAnyLocale)
{
  struct Commas : std::numpunct<char>
  {
    char do_decimal_point() const override { return ','; }
  };
  const std::locale before = std::locale::global(std::locale(std::locale(), new Commas));
  EXPECT_EQ(NumberText(2.5), "2.5");
  std::locale::global(before);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "Parallel.h"

#include <gtest/gtest.h>

#include <vector>

using namespace featurehex;

namespace
{
/// Says stop at the question with this number, from 0.
class StopAt : public Monitor
{
public:
  explicit StopAt(int question)
    : Question(question)
  {
  }
  int Asked = 0;

protected:
  bool AbortRequested() override { return this->Asked++ == this->Question; }

private:
  int Question;
};
}

TEST(Parallel, EachIndexOnceWithAndWithoutMonitor)
{
  StopAt never(-1);
  for (std::size_t count : { 0, 1, 7, 1000, 12345 })
  {
    for (Monitor* monitor : { static_cast<Monitor*>(nullptr), static_cast<Monitor*>(&never) })
    {
      std::vector<int> visits(count, 0);
      EXPECT_TRUE(ParallelFor(count, 16, monitor, [&](std::size_t i) { ++visits[i]; }));
      EXPECT_EQ(visits, std::vector<int>(count, 1));
    }
  }
}

TEST(Parallel, StopsBetweenBatches)
{
  StopAt third(2);
  std::vector<int> visits(1000, 0);
  EXPECT_FALSE(ParallelFor(visits.size(), 1, &third, [&](std::size_t i) { ++visits[i]; }));
  EXPECT_EQ(third.Asked, 3);
  EXPECT_EQ(visits[99], 1);
  EXPECT_EQ(visits[100], 0);
  EXPECT_TRUE(third.Stopped());
}

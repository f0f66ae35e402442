// SPDX-License-Identifier: BSD-3-Clause
#include "VertexSchedule.h"

#include "TangledMesh.h"

#include <gtest/gtest.h>

#include <vtkSMPTools.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <thread>

using namespace featurehex;

namespace
{
/// Vertices in the order of a sweep with one thread.
std::vector<Index> Order(const VertexSchedule& schedule)
{
  std::vector<Index> order;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ std::string("Sequential") }, [&] {
    schedule.Sweep([&](Index v) {
      order.push_back(v);
      return true;
    });
  });
  return order;
}

/// Vertices within @a rings hexes of those of a block.
std::vector<char> Reach(const HexMesh& mesh, const VertexSchedule::Block& block, int rings)
{
  std::vector<char> reached(mesh.Points.size(), 0);
  std::fill(reached.begin() + block.First, reached.begin() + block.Last, 1);
  for (int ring = 0; ring < rings; ++ring)
  {
    std::vector<char> next = reached;
    for (const Hex& hex : mesh.Hexes)
    {
      if (std::any_of(hex.begin(), hex.end(), [&](Index v) { return reached[v] != 0; }))
      {
        for (Index v : hex)
        {
          next[v] = 1;
        }
      }
    }
    reached.swap(next);
  }
  return reached;
}

HexMesh Lattice(int kind)
{
  switch (kind)
  {
    case 0:
      return CubeMesh(1);
    case 1:
      return CubeMesh(14);
    default:
      return LatticeMesh({ 60, 4, 4 }, [](int i, int j, int k) { return (i + j * k) % 7 != 0; });
  }
}
}

TEST(VertexSchedule, EveryVertexIsVisitedOnce)
{
  for (int kind = 0; kind < 3; ++kind)
  {
    const HexMesh mesh = Lattice(kind);
    const VertexSchedule schedule(
      mesh.Hexes, CellsOfVertices(mesh.Hexes, mesh.Points.size()), 1);
    std::vector<Index> order = Order(schedule);
    std::sort(order.begin(), order.end());
    ASSERT_EQ(order.size(), mesh.Points.size());
    for (std::size_t v = 0; v < order.size(); ++v)
    {
      EXPECT_EQ(order[v], static_cast<Index>(v));
    }
  }
}

TEST(VertexSchedule, BlocksOfAColourAreFartherApartThanTheRings)
{
  for (int kind = 1; kind < 3; ++kind)
  {
    const HexMesh mesh = Lattice(kind);
    const IdLists hexes = CellsOfVertices(mesh.Hexes, mesh.Points.size());
    for (int rings : { 1, 3 })
    {
      const VertexSchedule schedule(mesh.Hexes, hexes, rings);
      const auto& colors = schedule.BlocksByColor();
      EXPECT_GT(colors.size(), 1u);
      EXPECT_LT(colors.size(), 40u);
      for (const auto& blocks : colors)
      {
        for (std::size_t a = 0; a < blocks.size(); ++a)
        {
          const std::vector<char> reached = Reach(mesh, blocks[a], rings);
          for (std::size_t b = 0; b < blocks.size(); ++b)
          {
            if (b != a)
            {
              EXPECT_TRUE(std::none_of(reached.begin() + blocks[b].First,
                reached.begin() + blocks[b].Last, [](char r) { return r != 0; }));
            }
          }
        }
      }
    }
  }
}

TEST(VertexSchedule, CountsVisitsThatReturnTrue)
{
  const HexMesh mesh = CubeMesh(9);
  const VertexSchedule schedule(mesh.Hexes, CellsOfVertices(mesh.Hexes, mesh.Points.size()), 1);
  EXPECT_EQ(schedule.Sweep([](Index v) { return v % 10 == 0; }), 100u);
  EXPECT_EQ(VertexSchedule().Sweep([](Index) { return true; }), 0u);
}

TEST(VertexSchedule, StopsInTheMiddleOfASweep)
{
  class StopAt : public Monitor
  {
  public:
    explicit StopAt(int question)
      : Question(question)
    {
    }

  private:
    int Question;
    int Asked = 0;
    bool AbortRequested() override { return ++this->Asked == this->Question; }
  };
  const HexMesh mesh = CubeMesh(20);
  const VertexSchedule schedule(mesh.Hexes, CellsOfVertices(mesh.Hexes, mesh.Points.size()), 1);
  const auto visit = [](Index v) {
    if (v % 100 == 0)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(10)); // some 0.4 s with two threads
    }
    return true;
  };
  StopAt first(1);
  EXPECT_EQ(schedule.Sweep(visit, &first), 0u);
  StopAt second(2);
  const std::size_t count = schedule.Sweep(visit, &second);
  EXPECT_GT(count, 0u);
  EXPECT_LT(count, mesh.Points.size());
}

TEST(VertexSchedule, NoBlockWaitsForAnotherOutOfItsReach)
{
  // The visit of the first vertex lasts until the last block of the second colour is reached.
  const HexMesh mesh = LatticeMesh({ 1, 1, 4000 }, [](int, int, int) { return true; });
  const VertexSchedule schedule(mesh.Hexes, CellsOfVertices(mesh.Hexes, mesh.Points.size()), 1);
  ASSERT_GT(schedule.BlocksByColor().size(), 1u);
  ASSERT_GT(schedule.BlocksByColor()[1].size(), 2u);
  const Index last = schedule.BlocksByColor()[1].back().First;
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ 2 }, [&] {
    if (vtkSMPTools::GetEstimatedNumberOfThreads() < 2)
    {
      GTEST_SKIP() << "one thread";
    }
    bool seen = false;
    for (int attempt = 0; attempt < 50 && !seen; ++attempt) // the other thread may start late
    {
      std::atomic<bool> reached = false;
      schedule.Sweep([&](Index v) {
        if (v == last)
        {
          reached = true;
        }
        for (int wait = 0; v == 0 && wait < 200 && !reached; ++wait)
        {
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
        seen = v == 0 ? reached.load() : seen;
        return true;
      });
    }
    EXPECT_TRUE(seen);
  });
}

TEST(VertexSchedule, NeighboursSeeEachOtherInTheSameOrderForAnyNumberOfThreads)
{
  const HexMesh mesh = CubeMesh(20);
  const IdLists hexes = CellsOfVertices(mesh.Hexes, mesh.Points.size());
  const VertexSchedule schedule(mesh.Hexes, hexes, 1);
  std::vector<std::vector<double>> results;
  for (int threads : { 1, 2, 1 })
  {
    // Not commutative: the result shows who was visited first.
    std::vector<double> values(mesh.Points.size(), 1.0);
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads }, [&] {
      schedule.Sweep([&](Index v) {
        double sum = 0.3 * v;
        for (Index h : hexes[v])
        {
          for (Index u : mesh.Hexes[h])
          {
            sum = 0.7 * sum + values[u];
          }
        }
        values[v] = sum;
        return true;
      });
    });
    results.push_back(values);
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0], results[2]);
}

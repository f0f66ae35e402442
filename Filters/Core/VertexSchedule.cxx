// SPDX-License-Identifier: BSD-3-Clause
#include "VertexSchedule.h"

#include "Parallel.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <queue>

namespace featurehex
{
namespace
{
using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds BetweenQuestions(100); // to the monitor
constexpr std::size_t SearchTasks = 16;

/// Which blocks are within reach of each other.
class BlockReach
{
public:
  BlockReach(const std::vector<Hex>& hexes, const IdLists& hexesOfVertex, Index blockSize)
    : Hexes(hexes)
    , HexesOfVertex(hexesOfVertex)
    , BlockSize(blockSize)
    , SeenVertices(hexesOfVertex.size(), -1)
    , SeenHexes(hexes.size(), -1)
  {
  }

  /// Blocks with a vertex within @a rings hexes of block @a block, itself excluded, ascending.
  std::vector<Index> Around(Index block, int rings)
  {
    const Index last = std::min((block + 1) * this->BlockSize, this->HexesOfVertex.size());
    std::vector<Index> front;
    for (Index v = block * this->BlockSize; v < last; ++v)
    {
      this->SeenVertices[v] = block;
      front.push_back(v);
    }
    std::vector<Index> found;
    for (int ring = 0; ring < rings; ++ring)
    {
      std::vector<Index> next;
      for (Index v : front)
      {
        this->VisitNew(v, block, [&](Index u) {
          next.push_back(u);
          found.push_back(u / this->BlockSize);
        });
      }
      front.swap(next);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    found.erase(std::remove(found.begin(), found.end(), block), found.end());
    return found;
  }

private:
  /// Vertices of the hexes of a vertex that this block has not met before.
  template <typename Visit>
  void VisitNew(Index vertex, Index block, const Visit& visit)
  {
    for (Index h : this->HexesOfVertex[vertex])
    {
      if (this->SeenHexes[h] == block)
      {
        continue;
      }
      this->SeenHexes[h] = block;
      for (Index u : this->Hexes[h])
      {
        if (this->SeenVertices[u] != block)
        {
          this->SeenVertices[u] = block;
          visit(u);
        }
      }
    }
  }

  const std::vector<Hex>& Hexes;
  const IdLists& HexesOfVertex;
  Index BlockSize;
  std::vector<Index> SeenVertices; ///< the block that met it last
  std::vector<Index> SeenHexes;
};

/// For each block the least colour that none of those before it within reach has.
std::vector<Index> ColorBlocks(const std::vector<std::vector<Index>>& reach)
{
  std::vector<Index> colors(reach.size(), -1);
  for (std::size_t block = 0; block < reach.size(); ++block)
  {
    std::vector<bool> used(reach[block].size() + 1, false);
    for (Index other : reach[block])
    {
      if (colors[other] >= 0 && colors[other] < static_cast<Index>(used.size()))
      {
        used[colors[other]] = true;
      }
    }
    colors[block] =
      static_cast<Index>(std::find(used.begin(), used.end(), false) - used.begin());
  }
  return colors;
}
}

VertexSchedule::VertexSchedule(
  const std::vector<Hex>& hexes, const IdLists& hexesOfVertex, int rings)
{
  const Index vertexCount = hexesOfVertex.size();
  const Index blockSize = std::clamp(vertexCount / 64, 32, 512);
  const std::size_t blockCount = (vertexCount + blockSize - 1) / blockSize;
  std::vector<std::vector<Index>> reach(blockCount);
  ParallelFor(SearchTasks, 1, [&](std::size_t task) {
    const std::size_t last = (task + 1) * blockCount / SearchTasks;
    BlockReach search(hexes, hexesOfVertex, blockSize);
    for (std::size_t b = task * blockCount / SearchTasks; b < last; ++b)
    {
      reach[b] = search.Around(static_cast<Index>(b), rings);
    }
  });
  const std::vector<Index> colors = ColorBlocks(reach);

  std::vector<Index> order(blockCount);
  for (std::size_t b = 0; b < blockCount; ++b)
  {
    order[b] = static_cast<Index>(b);
  }
  std::stable_sort(
    order.begin(), order.end(), [&](Index a, Index b) { return colors[a] < colors[b]; });
  std::vector<Index> place(blockCount);
  for (std::size_t i = 0; i < blockCount; ++i)
  {
    place[order[i]] = static_cast<Index>(i);
  }
  this->Earlier.assign(blockCount, 0);
  this->Later.Offsets.push_back(0);
  for (std::size_t i = 0; i < blockCount; ++i)
  {
    const Index b = order[i];
    this->Blocks.push_back({ b * blockSize, std::min((b + 1) * blockSize, vertexCount) });
    this->Colors.push_back(colors[b]);
    for (Index other : reach[b])
    {
      if (place[other] > place[b])
      {
        this->Later.Ids.push_back(place[other]);
        ++this->Earlier[place[other]];
      }
    }
    this->Later.Offsets.push_back(static_cast<Index>(this->Later.Ids.size()));
  }
}

std::vector<std::vector<VertexSchedule::Block>> VertexSchedule::BlocksByColor() const
{
  std::vector<std::vector<Block>> result;
  for (std::size_t i = 0; i < this->Blocks.size(); ++i)
  {
    result.resize(this->Colors[i] + 1);
    result.back().push_back(this->Blocks[i]);
  }
  return result;
}

/// One sweep: which blocks may start, shared by the threads that work on it.
class VertexSchedule::Run
{
public:
  Run(const VertexSchedule& schedule, const BlockVisit& visit)
    : Schedule(schedule)
    , Visit(visit)
    , Waiting(schedule.Earlier)
  {
    for (std::size_t i = 0; i < this->Waiting.size(); ++i)
    {
      if (this->Waiting[i] == 0)
      {
        this->Ready.push(static_cast<Index>(i));
      }
    }
  }

  bool Done() const { return this->Finished == this->Waiting.size(); }
  std::size_t Count() const { return this->Total; }

  /// Visits blocks until none is left or the time is over. Several threads may work beside each
  /// other; one alone never waits.
  void Work(Clock::time_point deadline)
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    while (!this->Done() && Clock::now() < deadline)
    {
      if (this->Ready.empty())
      {
        this->Changed.wait_until(lock, deadline);
        continue;
      }
      const Index place = this->Ready.top();
      this->Ready.pop();
      lock.unlock();
      const Block& block = this->Schedule.Blocks[place];
      const std::size_t count = this->Visit(block.First, block.Last);
      lock.lock();
      this->Total += count;
      ++this->Finished;
      for (Index later : this->Schedule.Later[place])
      {
        if (--this->Waiting[later] == 0)
        {
          this->Ready.push(later);
        }
      }
      this->Changed.notify_all();
    }
  }

private:
  const VertexSchedule& Schedule;
  const BlockVisit& Visit;
  std::vector<Index> Waiting; ///< of each block: those before it within reach that aren't done
  /// Blocks that may start, the first in order on top.
  std::priority_queue<Index, std::vector<Index>, std::greater<Index>> Ready;
  std::size_t Finished = 0;
  std::size_t Total = 0;
  std::mutex Mutex;
  std::condition_variable Changed;
};

std::size_t VertexSchedule::VisitBlocks(const BlockVisit& visit, Monitor* monitor) const
{
  Run run(*this, visit);
  const auto threads = static_cast<std::size_t>(vtkSMPTools::GetEstimatedNumberOfThreads());
  while (!run.Done() && (!monitor || monitor->Ask()))
  {
    const Clock::time_point deadline = Clock::now() + BetweenQuestions;
    ParallelFor(threads, 1, [&](std::size_t) { run.Work(deadline); });
  }
  return run.Count();
}
}

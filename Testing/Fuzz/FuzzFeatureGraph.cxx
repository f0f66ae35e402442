// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Any bytes as a .fgraph file, with and without a known number of points.

#include "FeatureGraphFile.h"
#include "FuzzChecks.h"

#include <limits>

using namespace featurehex;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  for (const std::int64_t points : { -1, 0, 20 })
  {
    FeatureGraph graph;
    const Status status = ParseFeatureGraph(BytesOf(data, size), "fuzz.fgraph", points, graph);
    CheckStatus(status);
    if (!status.Ok())
    {
      Require(graph.Corners.empty() && graph.Edges.empty(), "empty after an error");
      continue;
    }
    const std::size_t count = points < 0
      ? static_cast<std::size_t>(std::numeric_limits<Index>::max()) + 1
      : static_cast<std::size_t>(points);
    CheckId(graph.Corners, count);
    CheckIds(graph.Edges, count);
    for (const auto& edge : graph.Edges)
    {
      Require(edge[0] != edge[1], "two points an edge");
    }
  }
  return 0;
}

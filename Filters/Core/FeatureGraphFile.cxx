// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureGraphFile.h"

#include "FileAccess.h"
#include "TextScanner.h"

namespace featurehex
{
namespace
{
class GraphParser
{
public:
  GraphParser(
    std::string_view bytes, const std::string& name, std::int64_t points, FeatureGraph& graph)
    : Scanner(bytes)
    , Name(name)
    , NumberOfPoints(points)
    , Graph(graph)
  {
  }

  Status Parse()
  {
    std::int64_t corners = 0;
    std::int64_t edges = 0;
    Status status = this->Header(corners, edges);
    for (std::int64_t i = 0; i < corners && status.Ok(); ++i)
    {
      Index id = 0;
      status = this->Id(id, "corner", i, corners);
      this->Graph.Corners.push_back(id);
    }
    for (std::int64_t i = 0; i < edges && status.Ok(); ++i)
    {
      status = this->Edge(i, edges);
    }
    std::string_view word;
    if (status.Ok() && this->Scanner.Word(word))
    {
      status =
        this->Error(Quoted(word) + " follows after the last of the promised " +
                    std::to_string(corners) + " corners and " + std::to_string(edges) + " edges.");
    }
    return status;
  }

private:
  Status Error(const std::string& what) const
  {
    return Status(StatusCode::UnreadableFile,
      this->Name + ", line " + std::to_string(this->Scanner.Line()) + ": " + what);
  }

  bool Integer(std::int64_t& value)
  {
    return this->Scanner.Word(this->LastWord) && ParseInteger(this->LastWord, value);
  }

  bool Flag(bool& flag)
  {
    std::int64_t value = 0;
    const bool good = this->Integer(value) && (value == 0 || value == 1);
    flag = value == 1;
    return good;
  }

  Status Header(std::int64_t& corners, std::int64_t& edges)
  {
    if (!this->Scanner.Word(this->LastWord) || !ParseReal(this->LastWord, this->Graph.Angle) ||
        !this->Flag(this->Graph.OrphanCurve) || !this->Flag(this->Graph.OrphanCurveSingle))
    {
      return this->Error(
        Quoted(this->LastWord) + " where a .fgraph file has an angle and two flags (0 or 1).");
    }
    if (!this->Integer(corners) || corners < 0 || !this->Integer(edges) || edges < 0)
    {
      return this->Error(
        Quoted(this->LastWord) + " where the numbers of corners and edges are expected.");
    }
    // An id has at least a digit and a separator.
    const std::int64_t room = (static_cast<std::int64_t>(this->Scanner.Remaining()) + 1) / 2;
    if (corners > room || edges > room || corners + 2 * edges > room)
    {
      return this->Error("truncated: the header promises " + std::to_string(corners) +
                         " corners and " + std::to_string(edges) + " edges, " +
                         std::to_string(this->Scanner.Remaining()) + " bytes follow.");
    }
    this->Graph.Corners.reserve(static_cast<std::size_t>(corners));
    this->Graph.Edges.reserve(static_cast<std::size_t>(edges));
    return {};
  }

  Status Id(Index& id, const char* what, std::int64_t i, std::int64_t count)
  {
    std::int64_t value = 0;
    if (!this->Integer(value))
    {
      return this->Error((this->LastWord.empty() ? std::string("truncated: the file ends")
                                                 : Quoted(this->LastWord)) +
                         " where a point id of " + what + " " + std::to_string(i + 1) + " of " +
                         std::to_string(count) + " is expected.");
    }
    const std::int64_t limit = this->NumberOfPoints < 0 ? MaximumIndex : this->NumberOfPoints;
    if (value < 0 || value >= limit)
    {
      return Status(StatusCode::IndexOutOfRange,
        this->Name + ", line " + std::to_string(this->Scanner.Line()) + ": " + what +
          " refers to point " + std::to_string(value) + ", the surface has " +
          (this->NumberOfPoints < 0 ? std::string("no such") : std::to_string(limit)) +
          " points. Does the file belong to this surface?");
    }
    id = static_cast<Index>(value);
    return {};
  }

  Status Edge(std::int64_t i, std::int64_t count)
  {
    std::array<Index, 2> edge{};
    Status status = this->Id(edge[0], "edge", i, count);
    if (status.Ok())
    {
      status = this->Id(edge[1], "edge", i, count);
    }
    if (status.Ok() && edge[0] == edge[1])
    {
      status = Status(StatusCode::Degenerate,
        this->Name + ", line " + std::to_string(this->Scanner.Line()) + ": the edge from point " +
          std::to_string(edge[0]) + " to itself is no feature. Remove it.");
    }
    this->Graph.Edges.push_back(edge);
    return status;
  }

  TextScanner Scanner;
  const std::string& Name;
  std::int64_t NumberOfPoints;
  FeatureGraph& Graph;
  std::string_view LastWord;
};
} // namespace

Status ParseFeatureGraph(
  std::string_view bytes, const std::string& name, std::int64_t numberOfPoints, FeatureGraph& graph)
{
  graph = {};
  Status status = GraphParser(bytes, name, numberOfPoints, graph).Parse();
  if (!status.Ok())
  {
    graph = {};
  }
  return status;
}

Status ReadFeatureGraph(const std::string& path, std::int64_t numberOfPoints, FeatureGraph& graph)
{
  graph = {};
  std::string bytes;
  Status status = ReadFileBytes(path, bytes);
  return status.Ok() ? ParseFeatureGraph(bytes, FileBaseName(path), numberOfPoints, graph) : status;
}

Status WriteFeatureGraph(const std::string& path, const FeatureGraph& graph)
{
  std::string text;
  AppendReal(text, graph.Angle);
  text += graph.OrphanCurve ? " 1" : " 0";
  text += graph.OrphanCurveSingle ? " 1\n" : " 0\n";
  AppendInteger(text, static_cast<std::int64_t>(graph.Corners.size()));
  text += ' ';
  AppendInteger(text, static_cast<std::int64_t>(graph.Edges.size()));
  text += '\n';
  bool good = true;
  for (Index corner : graph.Corners)
  {
    good = good && corner >= 0;
    AppendInteger(text, corner);
    text += '\n';
  }
  for (const auto& edge : graph.Edges)
  {
    good = good && edge[0] >= 0 && edge[1] >= 0;
    AppendInteger(text, edge[0]);
    text += ' ';
    AppendInteger(text, edge[1]);
    text += '\n';
  }
  return good ? WriteFileBytes(path, text)
              : Status(StatusCode::IndexOutOfRange,
                  "The feature graph to write refers to a negative point id.");
}
} // namespace featurehex

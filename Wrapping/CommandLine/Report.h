// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The JSON report of a run.

#ifndef featurehex_Report_h
#define featurehex_Report_h

#include "ExitCode.h"
#include "RunAlgorithm.h"
#include "Status.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <string>

class vtkTable;

namespace featurehex
{
/// Collects what is known, in the order in which it is added; Write() adds status, time and memory.
class Report
{
public:
  /// @a command is "mesh" or "check".
  explicit Report(const std::string& command);

  nlohmann::ordered_json& operator[](const char* key) { return this->Content[key]; }

  /// Under "figures". Whole numbers are written as such.
  void AddFigure(const std::string& name, double value);

  /// Under "features": a row for each corner, curve and patch. Nothing for an empty table.
  void AddFeatures(vtkTable* table);

  /// Under "stages", seconds of wall time.
  void AddStage(const std::string& name, double seconds);

  /// Under "warnings" and "phases".
  void AddLog(const RunLog& log);

  /// Wall time since construction.
  double Seconds() const;

  /// Completes the report and writes it through a temporary file; an empty @a path: nothing.
  /// @return UnwritableFile.
  Status Write(const std::string& path, const Status& status);

private:
  using Clock = std::chrono::steady_clock;

  nlohmann::ordered_json Content;
  Clock::time_point Start = Clock::now();
};

/// Largest resident size of the process so far, bytes.
double PeakMemory();
} // namespace featurehex

#endif

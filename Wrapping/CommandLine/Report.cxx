// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include "FileAccess.h"

#include "vtkFeatureHexVersion.h"

#include <vtkSMPTools.h>
#include <vtkTable.h>
#include <vtkVariant.h>
#include <vtkVersion.h>

#include <sys/resource.h>

#include <cmath>
#include <cstdint>
#include <thread>

namespace featurehex
{
namespace
{
using Json = nlohmann::ordered_json;

constexpr double LargestWholeNumber = 9007199254740992.0; // 2^53

Json Number(double value)
{
  if (std::abs(value) < LargestWholeNumber && value == std::floor(value))
  {
    return static_cast<std::int64_t>(value);
  }
  return value;
}

double ProcessorSeconds()
{
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& t) { return t.tv_sec + 1e-6 * t.tv_usec; };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}
} // namespace

double PeakMemory()
{
  rusage usage = {};
  getrusage(RUSAGE_SELF, &usage);
  return 1024.0 * static_cast<double>(usage.ru_maxrss);
}

Report::Report(const std::string& command)
{
  this->Content["program"] = "featurehex";
  this->Content["version"] = vtkFeatureHexVersion::GetVersion();
  this->Content["vtk"] = vtkVersion::GetVTKVersion();
  this->Content["command"] = command;
  this->Content["status"] = Json::object();
  for (const char* list : { "warnings", "stages", "phases" })
  {
    this->Content[list] = Json::array();
  }
  this->Content["figures"] = Json::object();
}

void Report::AddFigure(const std::string& name, double value)
{
  this->Content["figures"][name] = Number(value);
}

void Report::AddFeatures(vtkTable* table)
{
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const auto text = [&](const char* column)
    { return std::string(table->GetValueByName(row, column).ToString()); };
    const auto number = [&](const char* column)
    { return table->GetValueByName(row, column).ToDouble(); };
    Json feature = { { "kind", text("Kind") }, { "id", Number(number("Id")) },
      { "outcome", text("Outcome") }, { "deviation", number("Deviation") } };
    if (text("Kind") == "curve")
    {
      feature["vertex-deviation"] = number("VertexDeviation");
    }
    if (!text("Reason").empty())
    {
      feature["reason"] = text("Reason");
    }
    feature["where"] = { number("X"), number("Y"), number("Z") };
    this->Content["features"].push_back(feature);
  }
}

void Report::AddStage(const std::string& name, double seconds)
{
  this->Content["stages"].push_back({ { "stage", name }, { "seconds", seconds } });
}

void Report::AddLog(const RunLog& log)
{
  for (const std::string& warning : log.Warnings)
  {
    this->Content["warnings"].push_back(warning);
  }
  for (const auto& [phase, seconds] : log.Phases)
  {
    this->Content["phases"].push_back({ { "phase", phase }, { "seconds", seconds } });
  }
}

double Report::Seconds() const
{
  return std::chrono::duration<double>(Clock::now() - this->Start).count();
}

Status Report::Write(const std::string& path, const Status& status)
{
  if (path.empty())
  {
    return Status();
  }
  Json& state = this->Content["status"];
  state["code"] = StatusCodeName(status.Code);
  state["message"] = status.Message;
  state["exit-code"] = static_cast<int>(ExitCodeOf(status.Code));
  this->Content["seconds"] = this->Seconds();
  this->Content["processor-seconds"] = ProcessorSeconds();
  this->Content["peak-memory-bytes"] = Number(PeakMemory());
  this->Content["threads"] = vtkSMPTools::GetEstimatedNumberOfThreads();
  this->Content["host-threads"] = std::thread::hardware_concurrency();
  this->Content["thread-backend"] = vtkSMPTools::GetBackend();
  // File names needn't be UTF-8.
  const std::string text = this->Content.dump(2, ' ', false, Json::error_handler_t::replace);
  return WriteFileBytes(path, text + "\n");
}
} // namespace featurehex

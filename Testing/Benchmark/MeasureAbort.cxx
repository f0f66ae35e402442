// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// How long after a request to abort the composite filter returns; prints two tables, tab
/// separated.
///
///   MeasureAbort SURFACE [FEATURE_ANGLE]
///
/// With an angle (degrees) sharp features are found by it, else there are none.
/// The first run asks nothing and lists, for each phase, the longest time between two questions
/// whether to stop: the bound for a request at any moment. The runs after it are stopped by another
/// thread at shares of that time. Exit code 1: one took more than a second or left an output.
/// Result of the last run: abort.tsv beside this file.

#include "FeatureHexMesher.h"
#include "SurfaceReader.h"

#include "vtkFeatureHexMesher.h"
#include "vtkNew.h"
#include "vtkSurfaceFileReader.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>
#include <utility>
#include <vector>

using namespace featurehex;

namespace
{
using Timer = std::chrono::steady_clock;
constexpr double Allowed = 1.0; // seconds

double Since(Timer::time_point start)
{
  return std::chrono::duration<double>(Timer::now() - start).count();
}

/// Measures the time from one question to the next.
class QuestionMonitor final : public Monitor
{
public:
  std::vector<std::pair<std::string, double>> Longest; ///< phase, seconds

  /// Ends the time since the last question; it belongs to the phase of that one.
  void Asked()
  {
    if (!this->Longest.empty())
    {
      double& longest = this->Longest[this->Current].second;
      longest = std::max(longest, Since(this->Last));
    }
    this->Last = Timer::now();
  }

protected:
  void Report(const std::string& phase, double) override
  {
    this->Asked();
    const auto known = std::find_if(this->Longest.begin(), this->Longest.end(),
      [&](const auto& entry) { return entry.first == phase; });
    this->Current = static_cast<std::size_t>(known - this->Longest.begin());
    if (known == this->Longest.end())
    {
      this->Longest.emplace_back(phase, 0.0);
    }
  }

private:
  std::size_t Current = 0;
  Timer::time_point Last;
};
} // namespace

int main(int argc, char* argv[])
{
  if (argc < 2 || argc > 3)
  {
    std::fprintf(stderr, "usage: MeasureAbort SURFACE [FEATURE_ANGLE]\n");
    return 2;
  }
  vtkNew<vtkFeatureHexMesher> mesher;
  MeshingOptions options;
  if (argc == 3)
  {
    mesher->SetFeatureModeToAngle();
    mesher->SetFeatureAngle(std::atof(argv[2]));
    options.Features.Mode = FeatureMode::Angle;
    options.Features.Detection.FeatureAngle = mesher->GetFeatureAngle();
  }
  SurfaceMesh surface;
  MeshingResult result;
  QuestionMonitor monitor;
  Status status = ReadSurface(argv[1], surface);
  const Timer::time_point start = Timer::now();
  if (status.Ok())
  {
    status = MeshSurface(surface, options, monitor, result);
    monitor.Asked();
  }
  if (!status.Ok())
  {
    std::fprintf(stderr, "%s\n", status.Message.c_str());
    return 1;
  }
  const double total = Since(start);
  bool good = true;
  std::printf("# %zu hexes in %.1f s\nphase\tlongest_seconds_between_questions\n",
    result.Mesh.Hexes.size(), total);
  for (const auto& [phase, seconds] : monitor.Longest)
  {
    std::printf("%s\t%.3f\n", phase.c_str(), seconds);
    good = good && seconds <= Allowed;
  }

  std::printf("abort_at\tseconds_until_return\tempty\n");
  vtkNew<vtkSurfaceFileReader> reader;
  reader->SetFileName(argv[1]);
  reader->Update();
  mesher->SetInputConnection(reader->GetOutputPort());
  for (const double share : { 0.1, 0.3, 0.5, 0.7, 0.9 })
  {
    mesher->Modified();
    Timer::time_point asked;
    std::thread stopper(
      [&]
      {
        std::this_thread::sleep_for(std::chrono::duration<double>(share * total));
        asked = Timer::now();
        mesher->SetAbortExecute(1);
      });
    mesher->Update();
    const Timer::time_point returned = Timer::now();
    stopper.join();
    const double seconds = std::chrono::duration<double>(returned - asked).count();
    if (seconds < 0)
    {
      std::printf("%.1f\tended before\n", share);
      continue;
    }
    const bool empty =
      mesher->GetOutputDataObject(0)->GetNumberOfElements(vtkDataObject::CELL) == 0;
    std::printf("%.1f\t%.3f\t%s\n", share, seconds, empty ? "yes" : "no");
    std::fflush(stdout);
    good = good && seconds <= Allowed && empty;
  }
  return good ? 0 : 1;
}

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Connects the progress of core algorithms to a vtkAlgorithm. Private to this module.

#ifndef featurehex_AlgorithmMonitor_h
#define featurehex_AlgorithmMonitor_h

#include "Monitor.h"
#include "VTKCompatibility.h"

#include <algorithm>
#include <chrono>
#include <string>

namespace featurehex
{
/// Progress events with the phase as progress text; stops when the algorithm is told to abort.
class AlgorithmMonitor final : public Monitor
{
public:
  explicit AlgorithmMonitor(vtkAlgorithm* algorithm)
    : Algorithm(algorithm)
  {
  }

protected:
  void Report(const std::string& phase, double progress) override
  {
    // Stages that look at a part twice, or begin phases of their own, report less than before.
    progress = std::max(progress, this->LastProgress);
    // Observers draw: events for each per mille or 50 ms, whatever comes first, are enough.
    const Clock::time_point now = Clock::now();
    const bool newPhase = phase != this->LastPhase;
    if (!newPhase && progress - this->LastProgress < 1e-3 &&
        now - this->LastTime < std::chrono::milliseconds(50))
    {
      return;
    }
    if (newPhase)
    {
      this->LastPhase = phase;
      this->Algorithm->SetProgressText(phase.c_str());
    }
    this->LastProgress = progress;
    this->LastTime = now;
    this->Algorithm->UpdateProgress(progress);
  }
  bool AbortRequested() override { return featurehex::AbortRequested(this->Algorithm); }

private:
  using Clock = std::chrono::steady_clock;

  vtkAlgorithm* Algorithm;
  std::string LastPhase;
  double LastProgress = 0.0;
  Clock::time_point LastTime;
};
} // namespace featurehex

#endif

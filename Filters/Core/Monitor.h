// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Progress, cancellation and time limit of a long computation, as one small object.

#ifndef featurehex_Monitor_h
#define featurehex_Monitor_h

#include "MessageText.h"
#include "Status.h"

#include <algorithm>
#include <chrono>
#include <string>

namespace featurehex
{
/// Core functions call Update() often, from the calling thread only, and return
/// StopStatus() as soon as it is false. Shells derive and implement Report() and AbortRequested().
class Monitor
{
public:
  Monitor() = default;
  virtual ~Monitor() = default;
  Monitor(const Monitor&) = delete;
  Monitor& operator=(const Monitor&) = delete;

  /// Stop @a seconds of wall time from now; 0 or less: no limit.
  void SetTimeLimit(double seconds)
  {
    this->Limited = seconds > 0;
    this->Seconds = seconds;
    this->Start = Clock::now();
  }

  /// The following Update(f), f in [0, 1], map to [from, to] of the whole.
  void BeginPhase(const std::string& name, double from = 0.0, double to = 1.0)
  {
    this->Phase = name;
    this->From = from;
    this->To = to;
    this->Update(0.0);
  }

  /// True: go on. False: the user or the time limit says stop.
  bool Update(double fraction)
  {
    this->Fraction = fraction;
    if (this->Stop.Ok())
    {
      this->Report(
        this->Phase, this->From + std::clamp(fraction, 0.0, 1.0) * (this->To - this->From));
      if (this->AbortRequested())
      {
        this->Stop = Status(StatusCode::Aborted, "Stopped by the user while " + this->Phase + ".");
      }
      else if (this->Limited && this->Elapsed() > this->Seconds)
      {
        this->Stop = Status(StatusCode::TimeLimit,
          "The time limit of " + NumberText(this->Seconds) + " s was reached while " +
            this->Phase +
            ". Raise TimeLimit, or raise TargetEdgeLength or Tolerance for a coarser mesh.");
      }
    }
    return this->Stop.Ok();
  }

  /// Update() without progress, for pieces of work inside a step.
  bool Ask() { return this->Update(this->Fraction); }

  bool Stopped() const { return !this->Stop.Ok(); }
  const Status& StopStatus() const { return this->Stop; }

  /// Seconds left before the time limit; a large number without one.
  double Remaining() const { return this->Limited ? this->Seconds - this->Elapsed() : 1e300; }

protected:
  /// @a phase in words ("fitting"), @a progress of the whole in [0, 1].
  virtual void Report(const std::string& phase, double progress)
  {
    (void)phase;
    (void)progress;
  }
  virtual bool AbortRequested() { return false; }

private:
  using Clock = std::chrono::steady_clock;

  double Elapsed() const
  {
    return std::chrono::duration<double>(Clock::now() - this->Start).count();
  }

  std::string Phase = "working";
  double From = 0.0;
  double To = 1.0;
  double Fraction = 0.0;
  bool Limited = false;
  double Seconds = 0.0;
  Clock::time_point Start = Clock::now();
  Status Stop;
};
}

#endif

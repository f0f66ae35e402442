// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// What the command line shows on standard error, and Ctrl-C.

#ifndef featurehex_Console_h
#define featurehex_Console_h

#include "Status.h"

#include <chrono>
#include <string>

namespace featurehex
{
/// Writes "featurehex: OpenBoundary: the message", always one line.
void PrintError(const Status& status);

/// "featurehex: warning: ...", one line.
void PrintWarning(const std::string& text);

/// The same text without line breaks.
std::string OneLine(const std::string& text);

/// A bar with the name of the phase and the time on a terminal; nothing when standard error is
/// anything else.
class ProgressBar
{
public:
  ProgressBar();
  ~ProgressBar() { this->Clear(); }
  ProgressBar(const ProgressBar&) = delete;
  ProgressBar& operator=(const ProgressBar&) = delete;

  /// @a progress in [0, 1].
  void Show(const std::string& phase, double progress);
  void Clear();

private:
  using Clock = std::chrono::steady_clock;

  bool Terminal = false;
  bool Shown = false;
  std::string Phase;
  Clock::time_point Start = Clock::now();
  Clock::time_point LastDrawn;
};

/// From now on Ctrl-C and SIGTERM ask to stop; the second one ends the process at once.
void CatchStopSignals();
bool StopRequested();
} // namespace featurehex

#endif

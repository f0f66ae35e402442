// SPDX-License-Identifier: BSD-3-Clause
#include "Console.h"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <cstdlib>

namespace featurehex
{
namespace
{
constexpr int BarWidth = 30;
constexpr std::chrono::milliseconds DrawEvery(100);

volatile std::sig_atomic_t StopFlag = 0;

extern "C" void RequestStop(int)
{
  StopFlag = 1;
}

int TerminalWidth()
{
  winsize size = {};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}
} // namespace

std::string OneLine(const std::string& text)
{
  std::string line;
  for (char c : text)
  {
    const bool space = c == '\n' || c == '\r' || c == '\t' || c == ' ';
    if (!space)
    {
      line += c;
    }
    else if (!line.empty() && line.back() != ' ')
    {
      line += ' ';
    }
  }
  if (!line.empty() && line.back() == ' ')
  {
    line.pop_back();
  }
  return line;
}

void PrintError(const Status& status)
{
  std::fprintf(
    stderr, "featurehex: %s: %s\n", StatusCodeName(status.Code), OneLine(status.Message).c_str());
}

void PrintWarning(const std::string& text)
{
  std::fprintf(stderr, "featurehex: warning: %s\n", OneLine(text).c_str());
}

ProgressBar::ProgressBar()
{
  const char* terminal = std::getenv("TERM");
  this->Terminal =
    isatty(STDERR_FILENO) == 1 && terminal != nullptr && std::string(terminal) != "dumb";
}

void ProgressBar::Show(const std::string& phase, double progress)
{
  const Clock::time_point now = Clock::now();
  if (!this->Terminal || (phase == this->Phase && now - this->LastDrawn < DrawEvery))
  {
    return;
  }
  this->Phase = phase;
  this->LastDrawn = now;
  this->Shown = true;
  const double share = std::clamp(progress, 0.0, 1.0);
  const int full = static_cast<int>(share * BarWidth);
  const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(now - this->Start).count();
  char time[32];
  std::snprintf(time, sizeof time, "%lld:%02lld", static_cast<long long>(seconds / 60),
    static_cast<long long>(seconds % 60));
  std::string line = "[" + std::string(full, '#') + std::string(BarWidth - full, '-') + "] " +
                     std::to_string(static_cast<int>(100.0 * share)) + " %  " + time + "  " + phase;
  // A longer line would wrap and could not be drawn over.
  line.resize(std::min<std::size_t>(line.size(), std::max(1, TerminalWidth() - 1)));
  std::fprintf(stderr, "\r%s\033[K", line.c_str());
  std::fflush(stderr);
}

void ProgressBar::Clear()
{
  if (this->Shown)
  {
    std::fprintf(stderr, "\r\033[K");
    std::fflush(stderr);
    this->Shown = false;
  }
}

void CatchStopSignals()
{
  struct sigaction action = {};
  action.sa_handler = RequestStop;
  action.sa_flags = SA_RESETHAND | SA_RESTART;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool StopRequested()
{
  return StopFlag != 0;
}
} // namespace featurehex

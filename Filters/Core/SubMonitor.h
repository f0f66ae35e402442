// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// A part of the progress of another monitor.

#ifndef featurehex_SubMonitor_h
#define featurehex_SubMonitor_h

#include "Monitor.h"

namespace featurehex
{
/// Maps the progress of a function that reports 0 to 1 to [from, to] of the parent's phase, so that
/// functions that are called in a row don't make the progress jump back. Stops with the parent.
class SubMonitor final : public Monitor
{
public:
  SubMonitor(Monitor& parent, double from, double to)
    : Parent(parent)
    , First(from)
    , Last(to)
  {
  }

protected:
  void Report(const std::string&, double progress) override
  {
    this->Parent.Update(this->First + progress * (this->Last - this->First));
  }
  bool AbortRequested() override { return this->Parent.Stopped(); }

private:
  Monitor& Parent;
  double First;
  double Last;
};
}

#endif

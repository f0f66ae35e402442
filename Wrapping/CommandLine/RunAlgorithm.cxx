// SPDX-License-Identifier: BSD-3-Clause
#include "RunAlgorithm.h"

#include "../AlgorithmMessages.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>
#include <vtkWriter.h>

#include <chrono>

namespace featurehex
{
namespace
{
/// Takes what no observer took.
class QuietOutputWindow : public vtkOutputWindow
{
public:
  static QuietOutputWindow* New();
  vtkTypeMacro(QuietOutputWindow, vtkOutputWindow);
  void DisplayText(const char*) override {}
  void DisplayErrorText(const char*) override {}
  void DisplayWarningText(const char*) override {}
  void DisplayGenericWarningText(const char*) override {}
  void DisplayDebugText(const char*) override {}
};
vtkStandardNewMacro(QuietOutputWindow);

/// Hears one algorithm.
class Listener
{
public:
  Listener(vtkAlgorithm* algorithm, RunLog& log)
    : Algorithm(algorithm)
    , Log(log)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long event, void* self, void* data)
      { static_cast<Listener*>(self)->Hear(event, data); });
    for (const unsigned long event :
      { vtkCommand::ErrorEvent, vtkCommand::WarningEvent, vtkCommand::ProgressEvent })
    {
      algorithm->AddObserver(event, this->Command);
    }
    // A failure of the algorithm is repeated by its executive; that comes second.
    algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Command);
  }
  ~Listener()
  {
    this->Algorithm->RemoveObserver(this->Command);
    this->Algorithm->GetExecutive()->RemoveObserver(this->Command);
    this->EndPhase();
    this->Log.Bar.Clear();
  }
  Listener(const Listener&) = delete;
  Listener& operator=(const Listener&) = delete;

  std::vector<std::string> Errors;

private:
  using Clock = std::chrono::steady_clock;

  void Hear(unsigned long event, void* data)
  {
    if (event == vtkCommand::ErrorEvent)
    {
      this->Errors.push_back(OneLine(MessageOf(static_cast<const char*>(data))));
    }
    else if (event == vtkCommand::WarningEvent)
    {
      this->Log.Warnings.push_back(OneLine(MessageOf(static_cast<const char*>(data))));
    }
    else
    {
      this->HearProgress(*static_cast<const double*>(data));
    }
  }

  void HearProgress(double progress)
  {
    const char* text = this->Algorithm->GetProgressText();
    const std::string phase = text ? text : "";
    if (!phase.empty() && phase != this->Phase)
    {
      this->EndPhase();
      this->Phase = phase;
    }
    this->Log.Bar.Show(phase, progress);
    if (StopRequested())
    {
      this->Algorithm->SetAbortExecute(1);
    }
  }

  void EndPhase()
  {
    const Clock::time_point now = Clock::now();
    if (!this->Phase.empty())
    {
      this->Log.Phases.emplace_back(
        this->Phase, std::chrono::duration<double>(now - this->PhaseStart).count());
    }
    this->Phase.clear();
    this->PhaseStart = now;
  }

  vtkAlgorithm* Algorithm;
  RunLog& Log;
  vtkNew<vtkCallbackCommand> Command;
  std::string Phase;
  Clock::time_point PhaseStart = Clock::now();
};
} // namespace

Status RunAlgorithm(vtkAlgorithm* algorithm, StatusCode otherwise, RunLog& log)
{
  const Listener listener(algorithm, log);
  if (auto* writer = vtkWriter::SafeDownCast(algorithm))
  {
    writer->Write();
  }
  else
  {
    algorithm->Update();
  }
  if (!listener.Errors.empty())
  {
    return Status(CodeOf(algorithm->GetErrorCode(), otherwise), listener.Errors.front());
  }
  return StopRequested() ? Status(StatusCode::Aborted, "Stopped by the user.") : Status();
}

void SilenceVTK()
{
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkNew<QuietOutputWindow> window;
  vtkOutputWindow::SetInstance(window);
}
} // namespace featurehex

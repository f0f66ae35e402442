// SPDX-License-Identifier: BSD-3-Clause
// vtkAlgorithm::Update() for Python's ctypes, which releases the global interpreter lock around
// foreign functions and takes it again for callbacks. The wrapped Update() of VTK 9.1 keeps it: one
// Python thread that meshes would stop all others.
#include "../AlgorithmMessages.h"

#include <vtkAlgorithm.h>
#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>

#include <string>

namespace
{
using featurehex::StatusCode;

/// @return other than 0: stop.
using ProgressFunction = int (*)(double progress, const char* phase);
using WarningFunction = void (*)(const char* message);

/// Hears one algorithm.
struct Listener
{
  vtkAlgorithm* Algorithm = nullptr;
  ProgressFunction Progress = nullptr;
  WarningFunction Warning = nullptr;
  bool Stopped = false;
  std::string Error; ///< the first

  void Hear(unsigned long event, void* data)
  {
    if (event == vtkCommand::ProgressEvent)
    {
      const char* phase = this->Algorithm->GetProgressText();
      if (!this->Stopped && this->Progress(*static_cast<double*>(data), phase ? phase : "") != 0)
      {
        this->Stopped = true;
        this->Algorithm->SetAbortExecute(1);
      }
      return;
    }
    const std::string message = featurehex::MessageOf(static_cast<const char*>(data));
    if (event == vtkCommand::WarningEvent)
    {
      this->Warning(message.c_str());
    }
    else if (this->Error.empty())
    {
      this->Error = message;
    }
  }
};
/// For errors without a code of ours: files have those of VTK.
StatusCode CodeOfKind(vtkAlgorithm* algorithm)
{
  if (algorithm->IsA("vtkWriter"))
  {
    return StatusCode::UnwritableFile;
  }
  return algorithm->GetErrorCode() != vtkErrorCode::NoError ? StatusCode::UnreadableFile
                                                            : StatusCode::Validation;
}
} // namespace

extern "C"
{
  /// Updates the vtkAlgorithm at @a object.
  /// @param error receives the first error message, cut to @a size bytes.
  /// @return number of the StatusCode.
  __attribute__((visibility("default"))) int FeatureHexUpdateAlgorithm(vtkObjectBase* object,
    ProgressFunction progress, WarningFunction warning, char* error, std::size_t size)
  {
    Listener listener;
    listener.Algorithm = vtkAlgorithm::SafeDownCast(object);
    listener.Progress = progress;
    listener.Warning = warning;
    vtkNew<vtkCallbackCommand> command;
    command->SetClientData(&listener);
    command->SetCallback([](vtkObject*, unsigned long event, void* self, void* data)
      { static_cast<Listener*>(self)->Hear(event, data); });
    for (const unsigned long event :
      { vtkCommand::ErrorEvent, vtkCommand::WarningEvent, vtkCommand::ProgressEvent })
    {
      listener.Algorithm->AddObserver(event, command);
    }
    // A failure of the algorithm is repeated by its executive; that comes second.
    listener.Algorithm->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, command);
    listener.Algorithm->SetAbortExecute(0);
    listener.Algorithm->Update();
    listener.Algorithm->RemoveObserver(command);
    listener.Algorithm->GetExecutive()->RemoveObserver(command);

    if (listener.Error.empty())
    {
      return static_cast<int>(listener.Stopped ? StatusCode::Aborted : StatusCode::Ok);
    }
    error[listener.Error.copy(error, size - 1)] = '\0';
    return static_cast<int>(
      featurehex::CodeOf(listener.Algorithm->GetErrorCode(), CodeOfKind(listener.Algorithm)));
  }

  /// "OpenBoundary" and so on.
  __attribute__((visibility("default"))) const char* FeatureHexStatusCodeName(int code)
  {
    return featurehex::StatusCodeName(static_cast<StatusCode>(code));
  }
}

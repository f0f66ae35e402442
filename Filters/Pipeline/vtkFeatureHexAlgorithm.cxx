// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFeatureHexAlgorithm.h"

#include "AlgorithmMonitor.h"
#include "ArrayNames.h"

#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkSMPTools.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkStringArray.h"

#include <cstdlib>
#include <exception>
#include <new>
#include <string>

namespace
{
void ClearOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputs, port)->Initialize();
  }
}

void LeaveError(vtkInformationVector* outputs, const std::string& text)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkNew<vtkStringArray> error;
    error->SetName(featurehex::ArrayNames::Error);
    error->InsertNextValue(text);
    vtkDataObject::GetData(outputs, port)->GetFieldData()->AddArray(error);
  }
}

/// What a filter before this one left in an input; empty when all went well.
std::string ErrorOfInputs(vtkInformationVector** inputs, int ports)
{
  for (int port = 0; port < ports; ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkDataObject* data = vtkDataObject::GetData(inputs[port], i);
      vtkStringArray* error =
        data ? vtkStringArray::SafeDownCast(
                 data->GetFieldData()->GetAbstractArray(featurehex::ArrayNames::Error))
             : nullptr;
      if (error && error->GetNumberOfValues() > 0)
      {
        return error->GetValue(0);
      }
    }
  }
  return std::string();
}

int RequestedPiece(vtkInformation* request, vtkInformationVector* outputs)
{
  const int port = request->Has(vtkExecutive::FROM_OUTPUT_PORT())
                     ? request->Get(vtkExecutive::FROM_OUTPUT_PORT())
                     : 0;
  vtkInformation* info = outputs->GetInformationObject(port < 0 ? 0 : port);
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  return info->Has(Pipeline::UPDATE_PIECE_NUMBER()) ? info->Get(Pipeline::UPDATE_PIECE_NUMBER())
                                                    : 0;
}

/// ParaView's VTK does everything on one thread unless told otherwise: there, all cores for @a work.
template <typename Work>
void OnAllCores(const Work& work)
{
#if VTK_SMP_DEFAULT_IMPLEMENTATION_SEQUENTIAL
  if (vtkSMPTools::GetBackend() == std::string("Sequential") &&
    !std::getenv("VTK_SMP_BACKEND_IN_USE"))
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config(0, "STDThread", false), work);
    return;
  }
#endif
  work();
}
} // namespace

//------------------------------------------------------------------------------
vtkFeatureHexAlgorithm::vtkFeatureHexAlgorithm() = default;

//------------------------------------------------------------------------------
vtkFeatureHexAlgorithm::~vtkFeatureHexAlgorithm() = default;

//------------------------------------------------------------------------------
int vtkFeatureHexAlgorithm::RequestDataObject(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1; // The executive makes what FillOutputPortInformation() names.
}

//------------------------------------------------------------------------------
int vtkFeatureHexAlgorithm::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    outputs->GetInformationObject(port)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkFeatureHexAlgorithm::RequestUpdateExtent(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  if (RequestedPiece(request, outputs) > 0)
  {
    return 1; // Passed on as it is: what comes is not looked at.
  }
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = inputs[port]->GetInformationObject(i);
      info->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
      info->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
      info->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
int vtkFeatureHexAlgorithm::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  ClearOutputs(outputs);
  this->SetErrorCode(vtkErrorCode::NoError);
  if (RequestedPiece(request, outputs) > 0)
  {
    return 1;
  }
  const std::string before = ErrorOfInputs(inputs, this->GetNumberOfInputPorts());
  if (!before.empty())
  {
    LeaveError(outputs, before);
    return 1;
  }

  featurehex::Status status;
  featurehex::AlgorithmMonitor monitor(this);
  try
  {
    OnAllCores([&] { status = this->Compute(inputs, outputs, monitor); });
    // A time limit is for Compute() to judge: the composite may have a valid mesh by then.
    if (status.Ok() && monitor.StopStatus().Code == featurehex::StatusCode::Aborted)
    {
      status = monitor.StopStatus();
    }
  }
  catch (const std::bad_alloc&)
  {
    status = featurehex::Status(featurehex::StatusCode::OutOfMemory,
      "Not enough memory. Use larger cells (TargetEdgeLength), fewer levels (MaximumLevel) or a "
      "smaller input.");
  }
  catch (const std::exception& error)
  {
    status = featurehex::Status(
      featurehex::StatusCode::Unexpected, std::string("Unexpected failure: ") + error.what());
  }
  if (!status.Ok())
  {
    ClearOutputs(outputs);
    this->SetErrorCode(vtkErrorCode::UserError + static_cast<unsigned long>(status.Code));
    LeaveError(
      outputs, std::string(featurehex::StatusCodeName(status.Code)) + ": " + status.Message);
    if (status.Code != featurehex::StatusCode::Aborted)
    {
      vtkErrorMacro(<< status.Message);
    }
  }
  return 1;
}

//------------------------------------------------------------------------------
void vtkFeatureHexAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
}

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFeatureHexAlgorithm
 * @brief What all filters of FeatureHex have in common.
 *
 * <b>Errors:</b> a filter that can't do its work reports exactly one error (what, where, how much,
 * what to do), its outputs are empty, GetErrorCode() is vtkErrorCode::UserError +
 * featurehex::StatusCode, and the string array FeatureHexError in the field data of the outputs
 * holds code and message. Filters of FeatureHex after it pass that array on and stay silent. The
 * request itself succeeds: otherwise the executive would add a second, less helpful error.
 *
 * <b>Abort:</b> SetAbortExecute(1), from an observer of the progress event for instance, leaves
 * empty outputs and no error. ErrorCode and FeatureHexError say Aborted. Modified() makes the
 * filter run again.
 *
 * <b>Progress:</b> GetProgressText() names the phase.
 *
 * <b>Parallel pieces:</b> a mesh can't be made of a piece of a surface. Piece 0 asks for the whole
 * input and has the whole output; the output of other pieces is empty.
 *
 * <b>Threads and determinism:</b> vtkSMPTools with the backend that is set. Where that is the
 * Sequential one of ParaView's VTK, and the environment variable VTK_SMP_BACKEND_IN_USE didn't
 * choose it, STDThread with all cores while the filter runs. The same bits for any number of
 * threads. Inputs are never modified.
 */

#ifndef vtkFeatureHexAlgorithm_h
#define vtkFeatureHexAlgorithm_h

#include "vtkDataObjectAlgorithm.h"
#include "vtkFeatureHexPipelineModule.h" // For export macro

namespace featurehex
{
class Monitor;
struct Status;
} // namespace featurehex

class VTKFEATUREHEXPIPELINE_EXPORT vtkFeatureHexAlgorithm : public vtkDataObjectAlgorithm
{
public:
  vtkTypeMacro(vtkFeatureHexAlgorithm, vtkDataObjectAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

protected:
  vtkFeatureHexAlgorithm();
  ~vtkFeatureHexAlgorithm() override;

  /**
   * The work of the filter: fill the (empty) outputs. They are emptied again unless the result is
   * Ok.
   */
  virtual featurehex::Status Compute(
    vtkInformationVector** inputs, vtkInformationVector* outputs, featurehex::Monitor& monitor) = 0;

  int RequestDataObject(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestInformation(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkFeatureHexAlgorithm(const vtkFeatureHexAlgorithm&) = delete;
  void operator=(const vtkFeatureHexAlgorithm&) = delete;
};

#endif

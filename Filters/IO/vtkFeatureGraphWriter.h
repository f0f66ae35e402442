// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFeatureGraphWriter
 * @brief Writes sharp features of a surface as .fgraph file.
 *
 * <b>Input:</b> vtkPolyData: vertex cells are feature corners, lines and polylines feature curves.
 * Point array, needed:
 * - SurfacePointId (integers, 1 component): id of the point in the surface the features belong to.
 *
 * Field data, optional: FeatureAngle (degrees; 0 without), OrphanCurve, OrphanCurveSingle (0 or 1;
 * 1 without).
 *
 * <b>Output:</b> the file: corners and edges in the order of the cells. It is written under another
 * name first, so that there is never half a file; an existing one stays when writing fails.
 *
 * <b>Errors:</b> one: no SurfacePointId, an id that is negative or not 32 bit, a file that can't be
 * written. Write() returns 0 then. GetErrorCode() is a code of
 * vtkErrorCode, or vtkErrorCode::UserError + featurehex::StatusCode.
 *
 * <b>Cost:</b> linear.
 *
 * @sa vtkFeatureGraphReader
 */

#ifndef vtkFeatureGraphWriter_h
#define vtkFeatureGraphWriter_h

#include "vtkFeatureHexIOModule.h" // For export macro
#include "vtkWriter.h"

class VTKFEATUREHEXIO_EXPORT vtkFeatureGraphWriter : public vtkWriter
{
public:
  static vtkFeatureGraphWriter* New();
  vtkTypeMacro(vtkFeatureGraphWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * File to write. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkFeatureGraphWriter();
  ~vtkFeatureGraphWriter() override;

  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkFeatureGraphWriter(const vtkFeatureGraphWriter&) = delete;
  void operator=(const vtkFeatureGraphWriter&) = delete;

  char* FileName = nullptr;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSurfaceFileReader
 * @brief Reads a surface from STL, OBJ, PLY, OFF, VTP or legacy VTK, whatever state the file is in.
 *
 * One reader for all surface files, chosen by the extension, else by the first bytes. Files may be
 * truncated, damaged or made to do harm: counts are compared with the file size before anything is
 * allocated, ids are checked, numbers don't depend on the locale. Whether the surface is closed
 * and can be meshed is the business of the filters.
 *
 * <b>Input:</b> none.
 *
 * <b>Output:</b> vtkPolyData. STL, OBJ, PLY, OFF: triangles (polygons as fans around their first
 * point), points in file order, double precision; STL: three points of its own for each triangle,
 * not merged; no arrays. VTP, VTK: what the file has, with all arrays.
 *
 * <b>Guarantees:</b> at least one polygon, triangle or strip; all ids in range. Coordinates may be
 * NaN or infinite.
 *
 * <b>Errors:</b> one, and an empty output: file missing, truncated or not of its format, no points
 * or no faces, a face that refers to a point that does not exist; with the line, face or byte.
 * GetErrorCode() is a code of vtkErrorCode, or vtkErrorCode::UserError + featurehex::StatusCode.
 *
 * <b>Units:</b> those of the file.
 *
 * <b>Cost:</b> linear; memory some 10 times the file size.
 *
 * @sa vtkHexMeshReader vtkFeatureGraphReader
 */

#ifndef vtkSurfaceFileReader_h
#define vtkSurfaceFileReader_h

#include "vtkFeatureHexIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFEATUREHEXIO_EXPORT vtkSurfaceFileReader : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceFileReader* New();
  vtkTypeMacro(vtkSurfaceFileReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * File to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * 1 if @a name exists and has the extension or the first bytes of one of the formats.
   */
  virtual int CanReadFile(VTK_FILEPATH const char* name);

protected:
  vtkSurfaceFileReader();
  ~vtkSurfaceFileReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSurfaceFileReader(const vtkSurfaceFileReader&) = delete;
  void operator=(const vtkSurfaceFileReader&) = delete;

  char* FileName = nullptr;
};

#endif

// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFeatureGraphReader
 * @brief Reads sharp features of a surface from a .fgraph file.
 *
 * The file names points of a surface by their ids and has no coordinates: these come from the
 * surface on the input, which must be the very one the file was made for, in the same point order.
 *
 * <b>Input:</b> 0 (optional) vtkPolyData: the surface.
 *
 * <b>Output:</b> vtkPolyData: a vertex cell for each feature corner, a line cell for each feature
 * edge. Its points are those of the surface that the features use, in the order of the surface;
 * without an input they are all at the origin. Point array:
 * - SurfacePointId (vtkIdType, 1 component): id of the point in the surface.
 *
 * Field data: FeatureAngle (double, degrees; what the file says, not used), OrphanCurve and
 * OrphanCurveSingle (int, 0 or 1).
 *
 * <b>Guarantees:</b> all ids in the range of the surface. A file without features gives an empty
 * output and no error.
 *
 * <b>Errors:</b> one, and an empty output: file missing, truncated or not of the format, an id that
 * the surface does not have, an edge from a point to itself; with the line. GetErrorCode() is a
 * code of vtkErrorCode, or vtkErrorCode::UserError + featurehex::StatusCode.
 *
 * <b>Cost:</b> linear in the file.
 *
 * <b>References:</b> X. Gao, H. Shen, D. Panozzo, "Feature Preserving Octree-Based Hexahedral
 * Meshing", Computer Graphics Forum 38(5), 2019, doi:10.1111/cgf.13795 (the format is that of its
 * reference implementation).
 *
 * @sa vtkFeatureGraphWriter vtkSurfaceFileReader
 */

#ifndef vtkFeatureGraphReader_h
#define vtkFeatureGraphReader_h

#include "vtkFeatureHexIOModule.h" // For export macro
#include "vtkPolyDataAlgorithm.h"

class VTKFEATUREHEXIO_EXPORT vtkFeatureGraphReader : public vtkPolyDataAlgorithm
{
public:
  static vtkFeatureGraphReader* New();
  vtkTypeMacro(vtkFeatureGraphReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * File to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * 1 if @a name is a file that starts like a .fgraph file: an angle, two flags, two counts.
   */
  virtual int CanReadFile(VTK_FILEPATH const char* name);

protected:
  vtkFeatureGraphReader();
  ~vtkFeatureGraphReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkFeatureGraphReader(const vtkFeatureGraphReader&) = delete;
  void operator=(const vtkFeatureGraphReader&) = delete;

  char* FileName = nullptr;
};

#endif

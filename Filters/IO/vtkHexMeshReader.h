// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkHexMeshReader
 * @brief Reads a volume mesh from .vtu, legacy .vtk or Medit .mesh, by the extension.
 *
 * VTK's own readers trust their files; here everything is checked before it leaves the reader.
 *
 * <b>Input:</b> none.
 *
 * <b>Output:</b> vtkUnstructuredGrid with what the file has; of .mesh the hexahedra with the cell
 * array Region (vtkMeditMeshReader can read more).
 *
 * <b>Guarantees:</b> at least one cell; linear cells only, each with its number of points; all ids
 * in range; arrays as long as they must be. That all cells are hexahedra and valid is for
 * vtkHexValidationFilter to say.
 *
 * <b>Errors:</b> one, and an empty output: file missing, truncated, not of its format, no cells,
 * polyhedra or curved cells, an id that does not exist. GetErrorCode() is a code of
 * vtkErrorCode, or vtkErrorCode::UserError + featurehex::StatusCode.
 *
 * <b>Units:</b> those of the file.
 *
 * <b>Cost:</b> linear; the file is read twice.
 *
 * @sa vtkHexMeshWriter vtkMeditMeshReader
 */

#ifndef vtkHexMeshReader_h
#define vtkHexMeshReader_h

#include "vtkFeatureHexIOModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

class VTKFEATUREHEXIO_EXPORT vtkHexMeshReader : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkHexMeshReader* New();
  vtkTypeMacro(vtkHexMeshReader, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * File to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /**
   * 1 if @a name exists and has one of the extensions; .mesh: and starts like a Medit file.
   */
  virtual int CanReadFile(VTK_FILEPATH const char* name);

protected:
  vtkHexMeshReader();
  ~vtkHexMeshReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkHexMeshReader(const vtkHexMeshReader&) = delete;
  void operator=(const vtkHexMeshReader&) = delete;

  char* FileName = nullptr;
};

#endif

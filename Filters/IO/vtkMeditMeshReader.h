// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeditMeshReader
 * @brief Reads a hexahedral mesh from an ASCII Medit .mesh file.
 *
 * Medit is the format of many open meshing tools (INRIA, P. Frey, "MEDIT: an interactive mesh
 * visualization software", 2001, inria-00069921).
 *
 * <b>Input:</b> none.
 *
 * <b>Output:</b> vtkUnstructuredGrid of VTK_HEXAHEDRON with the cell array
 * - Region (int, 1 component): reference of the hexahedron, the body it belongs to.
 *
 * Where the file has quadrilaterals, features as vtkFeatureHexMesher gives them: point arrays
 * FeatureKind and FeatureId (references of quads: patches, of edges: curves, of points in Corners:
 * corners), field data FeatureQuads and FeatureEdges.
 *
 * With BoundaryElements also the quadrilaterals as VTK_QUAD, the edges as VTK_LINE and the corners
 * as VTK_VERTEX, all after the hexahedra (Region is 0 on them), and
 * - PatchId (int): reference of the quad, -1 on other cells;
 * - CurveId (int): reference of the edge, -1 on other cells.
 *
 * <b>Guarantees:</b> at least one hexahedron, or another cell with BoundaryElements; all ids in
 * range. Whether the mesh is valid is not checked: coordinates may be NaN, hexahedra inverted.
 *
 * <b>Errors:</b> one, and an empty output: file missing, truncated or not of the format (binary
 * .meshb isn't), an id that does not exist, tetrahedra, prisms or pyramids, nothing to show; with
 * the line. GetErrorCode() is a code of
 * vtkErrorCode, or vtkErrorCode::UserError + featurehex::StatusCode.
 *
 * <b>Units:</b> those of the file.
 *
 * <b>Cost:</b> linear.
 *
 * @sa vtkMeditMeshWriter vtkHexMeshReader
 */

#ifndef vtkMeditMeshReader_h
#define vtkMeditMeshReader_h

#include "vtkFeatureHexIOModule.h" // For export macro
#include "vtkUnstructuredGridAlgorithm.h"

class VTKFEATUREHEXIO_EXPORT vtkMeditMeshReader : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkMeditMeshReader* New();
  vtkTypeMacro(vtkMeditMeshReader, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * File to read. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /**
   * Read quadrilaterals, edges and corners too, with the cell arrays PatchId and CurveId. Default:
   * off, because the filters take hexahedra only.
   */
  vtkSetMacro(BoundaryElements, bool);
  vtkGetMacro(BoundaryElements, bool);
  vtkBooleanMacro(BoundaryElements, bool);
  ///@}

  /**
   * 1 if @a name is a file that starts like an ASCII Medit file: other formats use .mesh too.
   */
  virtual int CanReadFile(VTK_FILEPATH const char* name);

protected:
  vtkMeditMeshReader();
  ~vtkMeditMeshReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMeditMeshReader(const vtkMeditMeshReader&) = delete;
  void operator=(const vtkMeditMeshReader&) = delete;

  char* FileName = nullptr;
  bool BoundaryElements = false;
};

#endif

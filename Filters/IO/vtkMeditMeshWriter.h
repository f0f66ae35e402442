// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMeditMeshWriter
 * @brief Writes a hexahedral mesh as ASCII Medit .mesh file.
 *
 * <b>Input:</b> vtkUnstructuredGrid of VTK_HEXAHEDRON, and perhaps VTK_QUAD (boundary), VTK_LINE
 * (feature edges, written as edges and ridges) and VTK_VERTEX (feature corners). Cell arrays, all
 * optional: Region (reference of a hexahedron, 1 without), PatchId (of a quad, 0 without), CurveId
 * (of an edge, 0 without).
 *
 * A mesh of hexahedra alone that vtkFeatureHexMesher made with features (point arrays FeatureKind
 * and FeatureId, field data FeatureQuads and FeatureEdges) is written with its boundary quads
 * (reference: patch), feature edges (reference: curve) as edges and ridges, and feature corners (in
 * Corners; reference of the point: corner); vtkMeditMeshReader reads them back.
 *
 * <b>Output:</b> the file. Coordinates read back with the same bits. It is written under another
 * name first, so that there is never half a file; an existing one stays when writing fails.
 *
 * <b>Errors:</b> one: no hexahedra, another type of cell, a coordinate that is not finite, a file
 * that can't be written. Write() returns 0 then. GetErrorCode() is a code of
 * vtkErrorCode, or vtkErrorCode::UserError + featurehex::StatusCode.
 *
 * <b>Cost:</b> linear; the text is put together in memory, some 60 bytes a hexahedron.
 *
 * @sa vtkMeditMeshReader vtkHexMeshWriter
 */

#ifndef vtkMeditMeshWriter_h
#define vtkMeditMeshWriter_h

#include "vtkFeatureHexIOModule.h" // For export macro
#include "vtkWriter.h"

class VTKFEATUREHEXIO_EXPORT vtkMeditMeshWriter : public vtkWriter
{
public:
  static vtkMeditMeshWriter* New();
  vtkTypeMacro(vtkMeditMeshWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * File to write. Default: none.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkMeditMeshWriter();
  ~vtkMeditMeshWriter() override;

  void WriteData() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;

private:
  vtkMeditMeshWriter(const vtkMeditMeshWriter&) = delete;
  void operator=(const vtkMeditMeshWriter&) = delete;

  char* FileName = nullptr;
};

#endif

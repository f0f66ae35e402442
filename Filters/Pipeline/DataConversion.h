// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Between VTK's data objects and the plain structs of the core. Private to this module.

#ifndef featurehex_DataConversion_h
#define featurehex_DataConversion_h

#include "BlockOctree.h"
#include "Monitor.h"
#include "Status.h"
#include "SurfaceCheck.h"
#include "Types.h"

#include <string>
#include <utility>
#include <vector>

class vtkDataSetAttributes;
class vtkFieldData;
class vtkInformationVector;
class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

namespace featurehex
{
//--- surfaces -------------------------------------------------------------------------------------
/// Triangles, strips and polygons of @a input as triangles. Unchecked; ids beyond 32 bits become
/// -1.
SurfaceMesh SurfaceFromPolyData(vtkPolyData* input);

/// SurfaceFromPolyData() and CheckSurface(): ready for every stage.
Status CheckedSurface(vtkPolyData* input, SurfaceMesh& surface, Monitor& monitor);

/// Points and triangles in @a output.
void PolyDataFromSurface(const SurfaceMesh& surface, vtkPolyData* output);

/// Quads of a hex mesh with only the points they use.
void PolyDataFromQuads(
  const std::vector<Vec3>& points, const std::vector<Quad>& quads, vtkPolyData* output);

//--- hex meshes -----------------------------------------------------------------------------------
/// How much of a hex mesh is checked.
enum class MeshCheck
{
  Ids,       ///< hexahedra or voxels only, ids exist; points may be NaN
  Conforming ///< and points finite, no repeated id, no overused or twisted face
};

/// Fails with InvalidMesh, IndexOutOfRange or NonFinite.
Status MeshFromGrid(vtkUnstructuredGrid* grid, MeshCheck check, HexMesh& mesh);

/// Points and VTK_HEXAHEDRON cells in @a output.
void GridFromMesh(const HexMesh& mesh, vtkUnstructuredGrid* output);

/// The hexes @a ids with only the points they use; cell arrays of @a grid are copied.
void GridFromHexes(const HexMesh& mesh, const std::vector<Index>& ids, vtkUnstructuredGrid* grid,
  vtkUnstructuredGrid* output);

/// All arrays of @a input for an output whose points were moved: measures of the old ones are left
/// out.
void PassArrays(vtkUnstructuredGrid* input, vtkUnstructuredGrid* output);

/// One array of @a from after another, rows by @a source.
void CopyRows(
  vtkDataSetAttributes* from, const std::vector<Index>& source, vtkDataSetAttributes* to);

//--- octrees and refinement points ----------------------------------------------------------------
/// Cells (voxels; hexahedra when the axes are turned) with OctreeIndex and Level, field data with
/// the frame.
void GridFromOctree(const BlockOctree& octree, vtkUnstructuredGrid* output);

/// Back. Fails with InvalidMesh when arrays are missing or the cells are no balanced block octree.
Status OctreeFromGrid(vtkUnstructuredGrid* grid, BlockOctree& octree);

/// Appends the points of @a input; Level from the array of this name, without it 1.
Status AppendRefinementPoints(vtkPolyData* input, std::vector<RefinementPoint>& points);

/// Vertices with Level and Reason.
void PolyDataFromRefinementPoints(
  const std::vector<std::pair<RefinementPoint, std::string>>& points, vtkPolyData* output);

//--- arrays and figures ---------------------------------------------------------------------------
void AddArray(vtkFieldData* data, const char* name, const std::vector<int>& values);
void AddArray(vtkFieldData* data, const char* name, const std::vector<double>& values);
void AddArray(vtkFieldData* data, const char* name, const std::vector<std::string>& values);

/// Cell array of one number per cell. Fails with InvalidMesh; @a hint says which filter makes it.
Status ReadCellArray(
  vtkUnstructuredGrid* grid, const char* name, const char* hint, std::vector<int>& values);

/// A number in the field data, or @a otherwise.
double FieldValue(vtkFieldData* data, const char* name, double otherwise);

/// One row of figures: columns of a table, or arrays of one value in field data.
struct FigureRow
{
  std::vector<std::pair<std::string, double>> Numbers;
  std::vector<std::pair<std::string, std::string>> Texts;

  void Write(vtkFieldData* data) const;
  void Write(vtkTable* table) const;
};
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Own reader for legacy .vtk files: VTK's crashes on damaged ones. Private to this module.

#ifndef featurehex_LegacyVTKFile_h
#define featurehex_LegacyVTKFile_h

#include "Status.h"

#include <string>
#include <string_view>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace featurehex
{
/// Reads POLYDATA or UNSTRUCTURED_GRID, ASCII or binary, versions 1 to 5, with points, cells and
/// arrays (SCALARS, VECTORS, NORMALS, TENSORS, TEXTURE_COORDINATES, FIELD). Text arrays, colours
/// and lookup tables are skipped. Counts are compared with the file size before anything is
/// allocated. Ids of cells are not negative, but may be beyond the last point; arrays may be of any
/// length.
/// @a name is used in messages, which have the line.
/// @return UnreadableFile, IndexOutOfRange, InvalidMesh (polyhedra).
Status ParseLegacyVTK(std::string_view bytes, const std::string& name, vtkPolyData* output);
Status ParseLegacyVTK(std::string_view bytes, const std::string& name, vtkUnstructuredGrid* output);
} // namespace featurehex

#endif

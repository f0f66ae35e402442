// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Between vtkUnstructuredGrid and MeditMesh. Private to this module.

#ifndef featurehex_MeditConversion_h
#define featurehex_MeditConversion_h

#include "MeditFile.h"

#include <string>

class vtkUnstructuredGrid;

namespace featurehex
{
/// Hexahedra, quads, lines and vertices of @a grid; references from the cell arrays Region, PatchId
/// and CurveId where they are there, else 1 for hexahedra and 0 for the others.
///
/// A grid of hexahedra alone with the features of vtkFeatureHexMesher (points: FeatureKind,
/// FeatureId; field data: FeatureQuads, FeatureEdges) gives boundary quads, edges and corners from
/// these; points of corners have the id of the corner as reference. Features of another mesh than
/// that of the cells (of which a filter took a part) are left out.
/// @return EmptySurface (no hexahedra), InvalidMesh (other cells, or an id that is not 32 bit).
Status MeditFromGrid(vtkUnstructuredGrid* grid, MeditMesh& mesh);

/// Hexahedra with Region, and, where the file has quads, features as above; with @a boundary also
/// quads, lines and vertices, and PatchId and CurveId (-1 on other cells; Region is 0 on these).
void GridFromMedit(const MeditMesh& mesh, bool boundary, vtkUnstructuredGrid* grid);

/// ReadMedit() and GridFromMedit().
Status ReadMeditGrid(const std::string& path, bool boundary, vtkUnstructuredGrid* grid);

/// MeditFromGrid() and WriteMedit().
Status WriteMeditGrid(const std::string& path, vtkUnstructuredGrid* grid);
} // namespace featurehex

#endif

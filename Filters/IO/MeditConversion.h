// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Between vtkUnstructuredGrid and MeditMesh. Private to this module.

#ifndef featurehex_MeditConversion_h
#define featurehex_MeditConversion_h

#include "MeditFile.h"

class vtkUnstructuredGrid;

namespace featurehex
{
/// Hexahedra, quads, lines and vertices of @a grid; references from the cell arrays Region, PatchId
/// and CurveId where they are there, else 1 for hexahedra and 0 for the others.
/// @return EmptySurface (no hexahedra), InvalidMesh (other cells, or an id that is not 32 bit).
Status MeditFromGrid(vtkUnstructuredGrid* grid, MeditMesh& mesh);

/// Hexahedra with Region; with @a boundary also quads, lines and vertices, and PatchId and CurveId
/// (-1 on other cells; Region is 0 on these).
void GridFromMedit(const MeditMesh& mesh, bool boundary, vtkUnstructuredGrid* grid);
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// From vtkUnstructuredGrid to SolverMesh. Private to this module.

#ifndef featurehex_SolverConversion_h
#define featurehex_SolverConversion_h

#include "SolverMesh.h"

class vtkUnstructuredGrid;

namespace featurehex
{
/// Hexahedra of one order (8, 20 or 27 points) and perhaps quads, lines and vertices of @a grid.
///
/// Labels of faces, edges and vertices come from, in this order: the quads with PatchId, lines with
/// CurveId and vertices of the grid; what vtkFeatureHexMesher says (points: FeatureKind, FeatureId;
/// field data: FeatureQuads, FeatureEdges), where it fits the cells; FeatureKind and FeatureId
/// alone, which give patches and corners, but no curves.
/// @return EmptySurface, InvalidMesh (other cells, mixed orders, too many), and those of
/// LabelSolverMesh().
Status SolverMeshFromGrid(vtkUnstructuredGrid* grid, SolverMesh& mesh);
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Gmsh's .msh files, ASCII, versions 4.1 and 2.2.

#ifndef featurehex_GmshWriter_h
#define featurehex_GmshWriter_h

#include "SolverMesh.h"

namespace featurehex
{
enum class GmshVersion
{
  V22,
  V41
};

/// Writes @a mesh with the named physical groups body_#, patch_#, curve_#, corner_#. A label that
/// starts at 0 has the physical tag label + 1, because Gmsh's start at 1; bodies keep their number.
/// Element types: hexahedra of 8, 20 or 27 nodes with quadrilaterals of 4, 8 or 9, lines of 2 or 3,
/// points. Coordinates read back with the same bits.
/// @return UnwritableFile, InvalidMesh (a negative label), and those of CheckSolverMesh().
Status WriteGmsh(const std::string& path, const SolverMesh& mesh, GmshVersion version);
} // namespace featurehex

#endif

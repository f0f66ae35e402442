// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Abaqus input files (.inp), which CalculiX and many other solvers read.

#ifndef featurehex_AbaqusWriter_h
#define featurehex_AbaqusWriter_h

#include "SolverMesh.h"

namespace featurehex
{
/// Writes @a mesh: nodes and elements (C3D8 or C3D20) with ids from 1 in the order of the mesh;
/// element sets body_#; for each patch the element set patch_#, one for each face number
/// (patch_#_S3), the surface patch_# of them, the node set patch_#; for each curve and corner a
/// node set. No material, step or load: the file is for *INCLUDE. Numbers have at most 20
/// characters, the width that Abaqus and CalculiX read: 13 digits or more.
/// @return UnwritableFile, InvalidMesh (27 nodes: CalculiX has no such element), and those of
/// CheckSolverMesh().
Status WriteAbaqus(const std::string& path, const SolverMesh& mesh);
} // namespace featurehex

#endif

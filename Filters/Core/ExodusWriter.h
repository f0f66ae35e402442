// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Exodus II files (.exo, .e), written without a library: netCDF's classic format with 64-bit
/// offsets is simple enough, and the bytes depend on nothing but the mesh.
///
/// References: "Exodus: a finite element data model", Sandia National Laboratories,
/// SAND92-2137; "The NetCDF Classic Format Specification", Unidata.

#ifndef featurehex_ExodusWriter_h
#define featurehex_ExodusWriter_h

#include "SolverMesh.h"

namespace featurehex
{
/// Writes @a mesh: an element block body_# (HEX8, HEX20 or HEX27; id: the body's number) with
/// elements in the order of the mesh, a side set patch_# (id: patch + 1) for each patch, a node
/// set curve_# (id: curve + 1) for each curve, and a node set corner_# for each corner (id: its
/// number + 1 + the highest id of a curve).
/// @return UnwritableFile, InvalidMesh (a negative label), and those of CheckSolverMesh().
Status WriteExodus(const std::string& path, const SolverMesh& mesh);
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// AVS UCD files (.ucd, also .inp), as deal.II reads them.

#ifndef featurehex_UcdWriter_h
#define featurehex_UcdWriter_h

#include "SolverMesh.h"

namespace featurehex
{
/// Writes @a mesh: hexes with their body as material, then the quads of Sides with patch + 1 and
/// the lines of Segments with curve + 1, which deal.II takes as boundary and manifold ids (0 is
/// that of faces without any). Linear only.
/// @return UnwritableFile, InvalidMesh (quadratic, or a negative body, patch or curve), and those
/// of CheckSolverMesh().
Status WriteUcd(const std::string& path, const SolverMesh& mesh);
} // namespace featurehex

#endif

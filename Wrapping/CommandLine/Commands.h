// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The subcommands.

#ifndef featurehex_Commands_h
#define featurehex_Commands_h

#include "Arguments.h"
#include "Status.h"

namespace featurehex
{
/// featurehex mesh: reads, meshes, writes mesh and report, prints one line.
/// @return what went wrong; already in the report, not printed.
Status RunMesh(const MeshArguments& arguments);

/// featurehex check: prints a table of the promises, writes the report.
/// @return Validation when the mesh breaks one.
Status RunCheck(const CheckArguments& arguments);
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Feature curves that run beside others too closely to be told apart.

#ifndef featurehex_RedundantCurves_h
#define featurehex_RedundantCurves_h

#include "SurfaceFeatures.h"

namespace featurehex
{
/// Curves that stay within @a distance (model units) of the others along their whole length, and
/// whose removal joins no patches but slivers: they have the same patch on both sides, or one whose
/// points all lie so near to the other curves. CAD exports have such doubles where a face was
/// trimmed with a tolerance. Of several that cover each other the shortest stays. Ascending.
std::vector<Index> FindRedundantCurves(
  const SurfaceMesh& surface, const SurfaceFeatures& features, double distance);
} // namespace featurehex

#endif

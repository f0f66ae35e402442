// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The features of a hex mesh from the labels of its points, as files have them.

#ifndef featurehex_FeatureRecovery_h
#define featurehex_FeatureRecovery_h

#include "HexFeatures.h"
#include "MeshTopology.h"
#include "SurfaceFeatures.h"

namespace featurehex
{
/// Inverse of FeatureLabels: corner vertices, chains and patches of quads, for ids of @a features.
///
/// The vertices of a chain are put in the order in which they lie along their curve; whether they
/// are connected is for ValidateFeatures() to say. Quads between chains have the patch that most of
/// their points name, or, without such points, the one on that side of a chain. Of several points
/// with the label of one corner the closest counts. Labels that the surface doesn't have count as
/// none. @a labels: as long as the points.
HexFeatures RecoverFeatures(const HexMesh& mesh, const HexBoundary& boundary,
  const SurfaceMesh& surface, const SurfaceFeatures& features, const FeatureLabels& labels);
} // namespace featurehex

#endif

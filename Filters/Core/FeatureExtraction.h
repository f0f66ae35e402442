// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The features of a surface as a user wants them: by angle, by annotation, or both.

#ifndef featurehex_FeatureExtraction_h
#define featurehex_FeatureExtraction_h

#include "FeatureDetection.h"
#include "SurfaceFeatures.h"

#include <string>
#include <vector>

namespace featurehex
{
/// What a user names: edges and corner points of a surface.
struct FeatureAnnotation
{
  std::vector<PointPair> Edges;
  std::vector<Index> Corners;
};

/// What an annotation does to the features found by angle.
enum class AnnotationMode
{
  Replace, ///< only the annotation counts
  Add,
  Remove
};

/// Where features come from and what is cleaned up.
struct FeatureExtractionOptions
{
  bool PreserveFeatures = true; ///< false: no features, the patches are the components
  AnnotationMode Mode = AnnotationMode::Replace;
  /// True: gaps are closed and spurs dropped in what the annotation gives, too.
  bool CleanUpAnnotation = false;
  /// Curves so near to others along their whole length are dropped, fraction of the diagonal of the
  /// bounding box: see FindRedundantCurves(). Not with Graph.EnforceAll. 0: none.
  double RedundantDistance = 5e-4;
  FeatureDetectionOptions Detection;
  FeatureGraphOptions Graph;
};

/// What was found, cleaned up and doubted.
struct FeatureExtractionReport
{
  FeatureDetectionReport Detection;
  FeatureGraphReport Graph;
  std::vector<Vec3> RedundantCurves; ///< middle point of each curve dropped
  /// Share of the length of the curves that has the same patch on both sides. CAD parts have less
  /// than a half, scans more: what an angle finds there is noise.
  double LooseShare = 0.0;
  std::vector<std::string> Notes; ///< a sentence for each kind of clean-up, with the first place
  /// A sentence for each kind of corner that is not enforced, and one for doubtful features.
  std::vector<std::string> Warnings;
};

/// Features of a checked @a surface. @a annotation, ids of that surface: null where there is none;
/// an empty one that replaces means no features. An edge to be removed that is no feature is
/// ignored; a corner to be removed is no corner any more where two curves meet, and stays one
/// elsewhere.
/// @return what BuildSurfaceFeatures() says of the annotation.
Status ExtractFeatures(const SurfaceMesh& surface, const FeatureAnnotation* annotation,
  const FeatureExtractionOptions& options, SurfaceFeatures& features,
  FeatureExtractionReport& report);
} // namespace featurehex

#endif

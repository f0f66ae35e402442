// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Between feature graphs as vtkPolyData and SurfaceFeatures. Private to this module.

#ifndef featurehex_FeatureConversion_h
#define featurehex_FeatureConversion_h

#include "FeatureExtraction.h"
#include "Status.h"

#include <vector>

class vtkPointSet;
class vtkPolyData;

namespace featurehex
{
/// Vertex cells: corners; polylines: curves. Cells: CornerId, CurveId (-1 for the other kind),
/// FeatureValid. Points: SurfacePointId; they are those the features use, in the order of the
/// surface.
void PolyDataFromFeatures(
  const SurfaceMesh& surface, const SurfaceFeatures& features, vtkPolyData* output);

/// Back: the features of the checked @a surface that @a graph names. Ids of corners, curves and
/// patches are those of the SurfaceFeatures it was made of. FeatureValid = 1 keeps a corner
/// enforced whatever meets there.
///
/// Takes any graph of lines and vertices, that of vtkFeatureGraphReader too: without CornerId
/// corners are found as by BuildSurfaceFeatures(). Null or empty: no features, the patches are the
/// components. Errors: those of AnnotationFromPointSet() and BuildSurfaceFeatures().
Status FeaturesFromPolyData(
  const SurfaceMesh& surface, vtkPolyData* graph, SurfaceFeatures& features);

/// Lines and polylines as edges, vertex cells as corners, ids of @a surface:
/// RecognizeSurfacePoints().
/// @param otherCells number of those that are neither; ignored
/// @return IndexOutOfRange: a point that isn't one of the surface.
Status AnnotationFromPointSet(
  const SurfaceMesh& surface, vtkPointSet* input, FeatureAnnotation& annotation, Index& otherCells);
} // namespace featurehex

#endif

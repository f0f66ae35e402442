// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Between features of hex meshes and VTK's data objects. Private to this module.

#ifndef featurehex_HexFeatureConversion_h
#define featurehex_HexFeatureConversion_h

#include "FeatureValidation.h"

class vtkFieldData;
class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

namespace featurehex
{
/// FeatureKind and FeatureId.
void AddLabels(const FeatureLabels& labels, vtkFieldData* points);

/// FeatureQuads and FeatureEdges: what the labels of the points don't say.
void AddElements(
  const HexFeatures& features, const std::vector<Quad>& quads, vtkFieldData* fields);

/// Of AddLabels(). @return InvalidMesh: an array is missing or has a kind that doesn't exist.
Status LabelsFromGrid(vtkUnstructuredGrid* grid, FeatureLabels& labels);

/// Vertex cells: corners, polylines: chains of those that the mesh has. Cells: CornerId, CurveId,
/// Captured, Deviation. Points: MeshPointId.
void PolyDataFromHexFeatures(const std::vector<Vec3>& points, const HexFeatures& features,
  const FeatureValidationReport& report, vtkPolyData* output);

/// A row for each corner, curve and patch: Kind, Id, Outcome, Reason, Deviation, VertexDeviation,
/// X, Y, Z.
void TableFromFindings(const FeatureValidationReport& report, vtkTable* table);
} // namespace featurehex

#endif

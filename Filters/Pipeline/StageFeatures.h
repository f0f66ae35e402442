// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// The features with which the stages between mapping and fitting work. Private to this module.

#ifndef featurehex_StageFeatures_h
#define featurehex_StageFeatures_h

#include "FeatureTargets.h"
#include "Status.h"

#include <memory>
#include <string>
#include <vector>

class vtkObject;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace featurehex
{
/// True when Hex Feature Mapping has been here: the mesh has FeatureQuads.
bool HasHexFeatures(vtkUnstructuredGrid* grid);

/// Inverse of AddLabels() and AddElements(): corners from the labels, paths and patches from the
/// field data. Lists are as long as the highest id asks for.
/// @param quads the boundary (or the interface) in the order that PatchOfQuad shall have
/// @return InvalidMesh: an array is missing or damaged, a quad has no patch, edges are no chain.
Status HexFeaturesFromGrid(
  vtkUnstructuredGrid* grid, const std::vector<Quad>& quads, HexFeatures& features);

/// Features of the surface and of the mesh, as a stage gets them from its ports.
class StageFeatures
{
public:
  StageFeatures() = default;
  StageFeatures(const StageFeatures&) = delete;
  void operator=(const StageFeatures&) = delete;

  /// @a surface, checked, is kept. A null @a graph, or one without curves: no features.
  /// @param edgeLength target edge length: curves are cut short by TrimCells of it at corners that
  /// are not enforced, as in the composite
  Status Read(const SurfaceMesh& surface, vtkPolyData* graph, double edgeLength);

  bool Any() const { return this->Prepared != nullptr; }
  const FeatureGeometry& Geometry() const { return *this->Prepared; }

  /// HexFeaturesFromGrid(), and a check that these are features of the surface.
  /// @param warning why features of the surface or of the mesh are not used; empty: they are, or
  /// there are none
  Status ReadMapped(
    vtkUnstructuredGrid* grid, const std::vector<Quad>& quads, std::string& warning);

  /// Empty unless both the surface and the mesh have features.
  const HexFeatures& Mapped() const { return this->OfMesh; }

  /// ReadMapped() for a @a stage whose points move; it gives the warning. @a mesh is that of the
  /// grid.
  Status ReadTargets(
    vtkObject* stage, vtkUnstructuredGrid* grid, const HexMesh& mesh, const HexStars& stars);

  /// Null without ReadTargets() or Mapped().
  FeatureTargets* Targets() { return this->OfPoints.get(); }

private:
  bool Agree() const;

  SurfaceFeatures Graph;
  std::unique_ptr<FeatureGeometry> Prepared;
  HexFeatures OfMesh;
  std::unique_ptr<FeatureTargets> OfPoints;
};
} // namespace featurehex

#endif

// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where to put the octree's grid so that flat faces lie between layers of hexes.

#ifndef featurehex_GridFit_h
#define featurehex_GridFit_h

#include "Types.h"

#include <array>
#include <vector>

namespace featurehex
{
/// Flat faces across the axes of a grid. The hexes have their vertices at the centres of the cells:
/// where such a face goes through centres it is a plane of quads already, and needs neither stairs
/// nor a layer.
class GridFit
{
public:
  /// @a axes: columns, unit axes of the grid.
  GridFit(const SurfaceMesh& surface, const Mat3& axes);

  /// Coordinate along @a axis through which planes of cell centres should go, for cells of @a size
  /// (model units); @a otherwise where too little of the surface is flat.
  double CenterPlane(int axis, double size, double otherwise) const;

  /// Size between 0.8 and 1 of @a size for which planes of cell centres go through most of the flat
  /// faces.
  double BestSize(double size) const;

private:
  struct Face
  {
    double Position;
    double Area;
  };
  struct Plane
  {
    double Position = 0;
    double Area = 0; ///< of faces near it or a multiple of the size away, the nearer the more
  };

  Plane BestPlane(int axis, double size) const;

  std::array<std::vector<Face>, 3> Faces; ///< by position
  double TotalArea = 0;
};
} // namespace featurehex

#endif

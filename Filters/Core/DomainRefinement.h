// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Where the octree has to be finer because the labelled hexes lose parts or topology of the
/// surface.

#ifndef featurehex_DomainRefinement_h
#define featurehex_DomainRefinement_h

#include "HexDomain.h"
#include "Types.h"

#include <array>
#include <vector>

namespace featurehex
{
/// Size of the cells at any place near given cells.
class CellSizeMap
{
public:
  CellSizeMap(const std::vector<Vec3>& centers, const std::vector<double>& sizes);

  /// Size of the cell nearest to @a p, measured in its own size; the largest one when none is near.
  double At(const Vec3& p) const;
  double Largest() const { return this->LargestSize; }

private:
  struct Entry
  {
    std::array<int, 4> Key; ///< halvings of the largest size, and grid position of that size
    Index Cell;
  };
  std::array<int, 4> Key(const Vec3& p, int level) const;

  std::vector<Vec3> Centers;
  std::vector<double> Sizes;
  std::vector<Entry> Entries; ///< sorted
  Vec3 Origin = Vec3::Zero();
  double LargestSize = 0.0;
  int Levels = 0;
};

/// Fill domain.MissingPoints and, when the topology differs, domain.TopologyPoints: in the shells
/// that differ the missing samples; without any, samples where the solid or the gap outside is
/// thinner than ThinLimit cells, with a limit that grows until there are some; for extra shells of
/// the interface their own places.
void FindDomainRefinement(const HexMesh& mesh, const SurfaceMesh& surface,
  const TriangleSearch& search, const CellSizeMap& sizes, const DomainOptions& options,
  HexDomain& domain);
}

#endif

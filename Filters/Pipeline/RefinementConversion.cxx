// SPDX-License-Identifier: BSD-3-Clause
#include "RefinementConversion.h"

#include "BoundaryPatches.h"
#include "SurfaceSizing.h"

namespace featurehex
{
void AppendPlaces(const RefinableQuads& quads, const std::vector<Vec3>& places, int maximumLevel,
  const std::string& reason, std::vector<std::pair<RefinementPoint, std::string>>& points)
{
  std::vector<RefinementPoint> wanted;
  const std::vector<Index> nearest = NearestQuads(quads.Points, quads.Quads, places);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const int level = quads.Level.empty() ? 0 : quads.Level[quads.Owners[nearest[i]]];
    if (level < maximumLevel)
    {
      wanted.push_back({ places[i], level + 1 });
    }
  }
  if (quads.EdgeLength > 0)
  {
    wanted = ThinRefinementPoints(wanted, quads.EdgeLength);
  }
  for (const RefinementPoint& point : wanted)
  {
    points.emplace_back(point, reason);
  }
}
} // namespace featurehex

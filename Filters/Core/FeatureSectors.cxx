// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureSectors.h"

namespace featurehex
{
FeatureSectors::FeatureSectors(const QuadGraph& graph, const HexFeatures& features)
  : Graph(graph)
  , CurveOfDart(graph.NumberOfDarts(), -1)
  , AlongCurve(graph.NumberOfDarts(), false)
{
  for (std::size_t c = 0; c < features.CurvePaths.size(); ++c)
  {
    const std::vector<Index>& path = features.CurvePaths[c];
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      const Index dart = graph.Find(path[i - 1], path[i]);
      this->CurveOfDart[dart] = this->CurveOfDart[graph.Opposite(dart)] = static_cast<Index>(c);
      this->AlongCurve[dart] = true;
    }
  }
}

/// The feature edge that ends the sector.
Index FeatureSectors::LastOf(Index dart) const
{
  Index next = this->Graph.Rotate(dart);
  while (this->CurveOfDart[next] < 0)
  {
    next = this->Graph.Rotate(next);
  }
  return next;
}

std::vector<Index> FeatureSectors::QuadsOf(Index dart) const
{
  std::vector<Index> quads;
  const Index last = this->LastOf(dart);
  for (Index d = dart; last != dart && d != last; d = this->Graph.Rotate(d))
  {
    quads.push_back(d / 4);
  }
  return quads;
}

double FeatureSectors::AngleAt(Index corner, Index dart, const FeatureGeometry& geometry) const
{
  const CornerFan& fan = geometry.Fans()[corner];
  const Index last = this->LastOf(dart);
  for (std::size_t i = 0; i < fan.Spokes.size(); ++i)
  {
    const CornerFan::Spoke& spoke = fan.Spokes[i];
    const CornerFan::Spoke& next = fan.Spokes[(i + 1) % fan.Spokes.size()];
    if (this->IsSpoke(spoke, dart) && this->IsSpoke(next, last))
    {
      const double angle = next.Angle - spoke.Angle;
      return angle > 0 ? angle : angle + fan.FullAngle;
    }
  }
  return 0;
}
} // namespace featurehex

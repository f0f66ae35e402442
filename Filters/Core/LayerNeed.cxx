// SPDX-License-Identifier: BSD-3-Clause
#include "LayerNeed.h"

#include "CreaseAngles.h"
#include "FeatureSectors.h"
#include "HexAdjacency.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int FewestQuads = 3; // round a vertex inside a patch
constexpr int MostQuads = 5;

/// The groups start without layers; what doesn't look like a grid asks for them.
class LayerNeed
{
public:
  LayerNeed(const HexMesh& mesh, const QuadGraph& graph, const HexFeatures& features,
    const FeatureGeometry& geometry, const std::vector<int>& groupOfPatch)
    : Mesh(mesh)
    , HexesOfVertex(CellsOfVertices(mesh.Hexes, mesh.Points.size()))
    , Graph(graph)
    , Patches(features.PatchOfQuad)
    , Geometry(geometry)
    , Sectors(graph, features)
    , Labels(features, graph.Quads(), mesh.Points.size())
    , GroupOfPatch(groupOfPatch)
    , Needs(1 + *std::max_element(groupOfPatch.begin(), groupOfPatch.end()), 0)
  {
  }

  std::vector<char> Run();

private:
  int GroupOf(Index dart) const
  {
    const int patch = this->Patches[dart / 4];
    return patch < 0 ? 0 : this->GroupOfPatch[patch];
  }
  int HexesAlong(Index dart) const;
  double InteriorAngle(Index dart) const;
  void LookInside(Index dart);
  bool LookAcross(Index dart);
  bool LookBetween(Index dart);
  bool Ask(int group)
  {
    const bool changed = !this->Needs[group];
    this->Needs[group] = 1;
    return changed;
  }

  const HexMesh& Mesh;
  IdLists HexesOfVertex;
  const QuadGraph& Graph;
  const std::vector<int>& Patches;
  const FeatureGeometry& Geometry;
  FeatureSectors Sectors;
  FeatureLabels Labels;
  const std::vector<int>& GroupOfPatch;
  std::vector<char> Needs; ///< of each group
};

int LayerNeed::HexesAlong(Index dart) const
{
  const IdLists::Range others = this->HexesOfVertex[this->Graph.Head(dart)];
  int count = 0;
  for (Index hex : this->HexesOfVertex[this->Graph.Tail(dart)])
  {
    count += std::binary_search(others.begin(), others.end(), hex) ? 1 : 0;
  }
  return count;
}

/// Of the surface between the patches on the two sides of a feature edge.
double LayerNeed::InteriorAngle(Index dart) const
{
  const Vec3& tail = this->Mesh.Points[this->Graph.Tail(dart)];
  const Vec3& head = this->Mesh.Points[this->Graph.Head(dart)];
  const Vec3 onCurve =
    this->Geometry.Curves()[this->Sectors.CurveOf(dart)].Closest(0.5 * (tail + head)).Point;
  const auto normal = [&](Index side) {
    const SurfaceGeometry& patch = this->Geometry.Patch(this->Patches[side / 4]);
    return patch.NormalAt(patch.Search().Closest(onCurve));
  };
  const Vec3 left = normal(dart);
  const Vec3 right = normal(this->Graph.Opposite(dart));
  return Pi -
    std::atan2(left.cross(right).dot((head - tail).stableNormalized()), left.dot(right));
}

/// Edges and vertices inside a patch.
void LayerNeed::LookInside(Index dart)
{
  const Index opposite = this->Graph.Opposite(dart);
  const Index v = this->Graph.Tail(dart);
  const int quads = this->Graph.Valence(v);
  if (this->HexesAlong(dart) != 2 || this->GroupOf(dart) != this->GroupOf(opposite) ||
    (this->Labels.Kind[v] == FeatureKind::Surface && (quads < FewestQuads || quads > MostQuads)))
  {
    this->Ask(this->GroupOf(dart));
    this->Ask(this->GroupOf(opposite));
  }
}

/// A feature edge. True: another group needs a layer.
bool LayerNeed::LookAcross(Index dart)
{
  const int left = this->GroupOf(dart);
  const int right = this->GroupOf(this->Graph.Opposite(dart));
  if (this->Needs[left] && this->Needs[right])
  {
    return false;
  }
  // The layer of one side ends on the other one and adds a hex: two in the plane.
  const int wanted =
    this->Needs[left] || this->Needs[right] ? 1 : RightAnglesIn(this->InteriorAngle(dart));
  const bool asked = this->HexesAlong(dart) != wanted && (this->Ask(left) | this->Ask(right));
  return asked;
}

/// A sector between two feature edges. True: another group needs a layer.
bool LayerNeed::LookBetween(Index dart)
{
  const std::vector<Index> quads = this->Sectors.QuadsOf(dart);
  const int group = this->GroupOf(dart);
  if (quads.empty() || this->Needs[group])
  {
    return false;
  }
  const Index v = this->Graph.Tail(dart);
  Index last = dart;
  for (std::size_t i = 0; i < quads.size(); ++i)
  {
    last = this->Graph.Rotate(last);
  }
  const int before = this->GroupOf(this->Graph.Opposite(dart));
  const int after = this->GroupOf(last);
  const int count = static_cast<int>(quads.size());
  const bool corner = this->Labels.Kind[v] == FeatureKind::Corner;
  const double angle =
    corner ? this->Sectors.AngleAt(this->Labels.Id[v], dart, this->Geometry) : Pi;
  if (count == RightAnglesIn(angle))
  {
    return false;
  }
  // Layers of the groups on both sides end in this one and leave the vertex inside it.
  if (before != group && after != group && count <= FewestQuads)
  {
    return this->Ask(before) | this->Ask(after);
  }
  return this->Ask(group);
}

std::vector<char> LayerNeed::Run()
{
  std::vector<Index> featureDarts;
  for (Index d = 0; d < this->Graph.NumberOfDarts(); ++d)
  {
    if (this->Sectors.CurveOf(d) < 0)
    {
      this->LookInside(d);
    }
    else
    {
      featureDarts.push_back(d);
    }
  }
  for (bool changed = true; changed;)
  {
    changed = false;
    for (Index d : featureDarts)
    {
      changed = this->LookAcross(d) || changed;
      changed = this->LookBetween(d) || changed;
    }
  }
  return this->Needs;
}
}

std::vector<char> GroupsThatNeedLayers(const HexMesh& mesh, const std::vector<Quad>& quads,
  const HexFeatures& features, const FeatureGeometry& geometry,
  const std::vector<int>& groupOfPatch)
{
  if (std::count(features.PatchOfQuad.begin(), features.PatchOfQuad.end(), -1) > 0)
  {
    // Nobody knows what those quads should look like.
    const int groups = 1 + *std::max_element(groupOfPatch.begin(), groupOfPatch.end());
    return std::vector<char>(groups, 1);
  }
  const QuadGraph graph(quads, mesh.Points.size());
  return LayerNeed(mesh, graph, features, geometry, groupOfPatch).Run();
}
} // namespace featurehex

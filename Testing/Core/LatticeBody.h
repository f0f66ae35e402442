// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bodies of unit cubes among others, with the features of a surface mapped to their boundary.

#ifndef featurehex_Testing_LatticeBody_h
#define featurehex_Testing_LatticeBody_h

#include "FeatureShapes.h"
#include "HexFeatureMapping.h"
#include "PaddingGroups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>

namespace featurehex
{
/// Cubes of a lattice, among others outside.
struct LatticeBody
{
  using Inside = std::function<bool(int, int, int)>;

  HexMesh Mesh;
  std::vector<int> Region; ///< 3: inside
  SurfaceMesh Surface;
  SurfaceFeatures Graph;
  std::unique_ptr<FeatureGeometry> Geometry;
  HexFeatures Features; ///< of the interface
  std::vector<int> Groups;

  /// The surface is that of the cubes, its edges are the features. @a line: a further curve, along
  /// edges and diagonals of the quads.
  LatticeBody(const std::array<int, 3>& n, const Inside& inside, const std::vector<Vec3>& line = {})
  {
    const HexMesh solid = LatticeMesh(n, inside);
    const HexBoundary boundary = ExtractBoundary(solid);
    this->Surface = SplitQuads(solid.Points, boundary.Quads);
    FeatureGraphReport report;
    const Status built = BuildSurfaceFeatures(this->Surface, Creases(solid, boundary.Quads, line),
      {}, FeatureGraphOptions(), this->Graph, report);
    EXPECT_TRUE(built.Ok()) << built.Message;
    this->Fill(n, inside);
  }

  /// The cubes follow another surface in stairs.
  LatticeBody(
    const std::array<int, 3>& n, const Inside& inside, SurfaceMesh surface, SurfaceFeatures graph)
    : Surface(std::move(surface))
    , Graph(std::move(graph))
  {
    this->Fill(n, inside);
  }

  void Map(const GivenUpFeatures& givenUp = GivenUpFeatures())
  {
    this->Geometry = std::make_unique<FeatureGeometry>(this->Surface, this->Graph, 1.0, givenUp);
    this->Groups = GroupPatches(*this->Geometry);
    const HexGraph graph(this->Mesh);
    Monitor monitor;
    FeatureMapping mapping;
    const Status mapped =
      MapFeaturesToInterface(this->Mesh, InterfaceQuads(this->Mesh, graph.Neighbors, this->Region),
        *this->Geometry, FeatureMappingOptions(), monitor, mapping);
    EXPECT_TRUE(mapped.Ok()) << mapped.Message;
    EXPECT_TRUE(mapping.Complete());
    this->Features = mapping.Features;
  }

  /// Layers come in the order of the patches.
  void RenumberPatches(const std::vector<int>& ids)
  {
    for (int& patch : this->Graph.PatchOfTriangle)
    {
      patch = ids[patch];
    }
    for (FeatureCurve& curve : this->Graph.Curves)
    {
      curve.LeftPatch = ids[curve.LeftPatch];
      curve.RightPatch = ids[curve.RightPatch];
    }
    this->Map();
  }

  Index CurveThrough(const Vec3& p) const
  {
    for (std::size_t c = 0; c < this->Graph.Curves.size(); ++c)
    {
      for (Index v : this->Graph.Curves[c].Points)
      {
        if (this->Surface.Points[v] == p)
        {
          return static_cast<Index>(c);
        }
      }
    }
    ADD_FAILURE() << "no curve through " << p.transpose();
    return 0;
  }

  /// Of the triangle whose plane goes through @a p in the direction @a normal.
  int PatchAt(const Vec3& p, const Vec3& normal) const
  {
    int best = -1;
    double nearest = 1e300;
    for (std::size_t t = 0; t < this->Surface.Triangles.size(); ++t)
    {
      const Triangle& abc = this->Surface.Triangles[t];
      const Vec3& a = this->Surface.Points[abc[0]];
      const Vec3 n = (this->Surface.Points[abc[1]] - a).cross(this->Surface.Points[abc[2]] - a);
      const Vec3 center = (a + this->Surface.Points[abc[1]] + this->Surface.Points[abc[2]]) / 3;
      if (n.normalized().dot(normal) > 0.99 && (center - p).norm() < nearest)
      {
        nearest = (center - p).norm();
        best = this->Graph.PatchOfTriangle[t];
      }
    }
    EXPECT_GE(best, 0) << "no patch at " << p.transpose();
    return best;
  }

private:
  /// Cubes inside and, one more on all sides, outside.
  void Fill(const std::array<int, 3>& n, const Inside& inside)
  {
    this->Mesh = LatticeMesh({ n[0] + 2, n[1] + 2, n[2] + 2 },
      [&](int i, int j, int k)
      {
        const bool solidHere = i > 0 && j > 0 && k > 0 && i <= n[0] && j <= n[1] && k <= n[2] &&
                               inside(i - 1, j - 1, k - 1);
        this->Region.push_back(solidHere ? 3 : 0);
        return true;
      });
    for (Vec3& p : this->Mesh.Points)
    {
      p -= Vec3::Ones();
    }
    this->Map();
  }

  static std::vector<PointPair> Creases(
    const HexMesh& solid, const std::vector<Quad>& quads, const std::vector<Vec3>& line)
  {
    std::map<PointPair, Vec3> normals; // by directed edge
    for (const Quad& q : quads)
    {
      for (int k = 0; k < 4; ++k)
      {
        normals[{ q[k], q[(k + 1) & 3] }] =
          (solid.Points[q[1]] - solid.Points[q[0]]).cross(solid.Points[q[3]] - solid.Points[q[0]]);
      }
    }
    std::vector<PointPair> edges;
    for (const auto& [edge, normal] : normals)
    {
      if (edge[0] < edge[1] && normal != normals.at({ edge[1], edge[0] }))
      {
        edges.push_back(edge);
      }
    }
    const auto id = [&](const Vec3& p)
    {
      return static_cast<Index>(
        std::find(solid.Points.begin(), solid.Points.end(), p) - solid.Points.begin());
    };
    for (std::size_t i = 1; i < line.size(); ++i)
    {
      edges.push_back({ id(line[i - 1]), id(line[i]) });
    }
    return edges;
  }
};

inline LatticeBody BoxBody(const std::array<int, 3>& n, const std::vector<Vec3>& line = {})
{
  return LatticeBody(
    n, [](int, int, int) { return true; }, line);
}

/// 5 x 5 x 3 cubes without 3 x 2 x 3 at a corner: a concave edge at (2, 3, z).
inline LatticeBody AngleBody()
{
  return LatticeBody({ 5, 5, 3 }, [](int i, int j, int) { return i < 2 || j < 3; });
}

/// A box whose top ends one cube lower on one half in the mesh: one stair across it.
inline LatticeBody StairBody()
{
  LatticeBody box = BoxBody({ 4, 4, 3 });
  return LatticeBody(
    { 4, 4, 3 }, [](int i, int, int k) { return i >= 2 || k < 2; }, std::move(box.Surface),
    std::move(box.Graph));
}
} // namespace featurehex

#endif

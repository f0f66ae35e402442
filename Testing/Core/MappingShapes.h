// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Bodies of unit cubes whose surface has feature curves along edges and diagonals of its quads.

#ifndef featurehex_Testing_MappingShapes_h
#define featurehex_Testing_MappingShapes_h

#include "FeatureShapes.h"
#include "HexFeatureMapping.h"

#include <memory>

namespace featurehex
{
/// A box of n[0] x n[1] x n[2] unit cubes on a surface with features.
struct MappingShape
{
  HexMesh Mesh;
  std::vector<InterfaceQuad> Interface;
  SurfaceMesh Surface;
  SurfaceFeatures Graph;
  GivenUpFeatures GivenUp;
  std::unique_ptr<FeatureGeometry> Geometry;
  FeatureMapping Mapping;

  /// The box with its twelve edges and further polylines along edges of the triangles.
  explicit MappingShape(const std::array<int, 3>& n,
    const std::vector<std::vector<Vec3>>& lines = {}, double cornerAngle = 140.0)
    : Mesh(LatticeMesh(n, [](int, int, int) { return true; }))
  {
    this->UseMesh();
    this->Surface = SplitQuads(this->Mesh.Points, ExtractBoundary(this->Mesh).Quads);
    const Vec3 high(n[0], n[1], n[2]);
    std::set<PointPair> edges;
    for (const Quad& quad : ExtractBoundary(this->Mesh).Quads)
    {
      for (int k = 0; k < 4; ++k)
      {
        const Index a = quad[k], b = quad[(k + 1) % 4];
        int sides = 0;
        for (int axis = 0; axis < 3; ++axis)
        {
          const double x = this->Mesh.Points[a][axis];
          sides += x == this->Mesh.Points[b][axis] && (x == 0 || x == high[axis]);
        }
        if (sides == 2)
        {
          edges.insert({ std::min(a, b), std::max(a, b) });
        }
      }
    }
    for (const std::vector<Vec3>& line : lines)
    {
      for (std::size_t i = 1; i < line.size(); ++i)
      {
        edges.insert({ this->PointAt(line[i - 1]), this->PointAt(line[i]) });
      }
    }
    FeatureGraphOptions options;
    options.CornerAngle = cornerAngle;
    FeatureGraphReport report;
    const Status status = BuildSurfaceFeatures(
      this->Surface, { edges.begin(), edges.end() }, {}, options, this->Graph, report);
    EXPECT_TRUE(status.Ok()) << status.Message;
  }

  /// Another body whose interface shall become the surface.
  void UseMesh()
  {
    const HexGraph graph(this->Mesh);
    this->Interface =
      InterfaceQuads(this->Mesh, graph.Neighbors, std::vector<char>(this->Mesh.Hexes.size(), 1));
  }

  Index PointAt(const Vec3& p) const
  {
    for (std::size_t v = 0; v < this->Surface.Points.size(); ++v)
    {
      if ((this->Surface.Points[v] - p).norm() < 1e-9)
      {
        return static_cast<Index>(v);
      }
    }
    ADD_FAILURE() << "no point at " << p.transpose();
    return 0;
  }

  Status Map(Monitor& monitor)
  {
    this->Geometry =
      std::make_unique<FeatureGeometry>(this->Surface, this->Graph, 1.0, this->GivenUp);
    return MapFeaturesToInterface(this->Mesh, this->Interface, *this->Geometry,
      FeatureMappingOptions(), monitor, this->Mapping);
  }
  void Map()
  {
    Monitor monitor;
    const Status status = this->Map(monitor);
    EXPECT_TRUE(status.Ok()) << status.Message;
  }

  std::string Reasons() const
  {
    std::string text;
    for (const MappingFailure& failure : this->Mapping.Failures)
    {
      text += failure.Reason + "\n";
    }
    return text;
  }

  /// The curve that runs through (or starts or ends at) a point of the surface and no box edge.
  Index CurveThrough(const Vec3& p) const
  {
    for (std::size_t c = 0; c < this->Graph.Curves.size(); ++c)
    {
      for (Index v : this->Graph.Curves[c].Points)
      {
        if ((this->Surface.Points[v] - p).norm() < 1e-9)
        {
          return static_cast<Index>(c);
        }
      }
    }
    return -1;
  }
};
} // namespace featurehex

#endif

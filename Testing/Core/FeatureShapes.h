// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Hex meshes with their surfaces and the features of both, for the tests of the validation.

#ifndef featurehex_Testing_FeatureShapes_h
#define featurehex_Testing_FeatureShapes_h

#include "FeatureRecovery.h"
#include "FeatureValidation.h"
#include "ValidationShapes.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

namespace featurehex
{
/// A mesh whose features are all captured.
struct FeatureShape
{
  HexMesh Mesh;
  HexBoundary Boundary;
  SurfaceMesh Surface;
  SurfaceFeatures Graph;
  FeatureLabels Labels;
  HexFeatures Features;

  FeatureValidationReport Validate(double tolerance = 0.005) const
  {
    return ValidateFeatures(
      this->Mesh, this->Boundary, this->Surface, { &this->Graph, &this->Features }, tolerance);
  }

  /// Features of the surface with these sharp edges, labels by position.
  void Finish(const std::vector<PointPair>& edges)
  {
    FeatureGraphReport report;
    ASSERT_TRUE(
      BuildSurfaceFeatures(this->Surface, edges, {}, FeatureGraphOptions(), this->Graph, report)
        .Ok());
    this->Boundary = ExtractBoundary(this->Mesh);
    this->Labels.Kind.assign(this->Mesh.Points.size(), FeatureKind::Interior);
    this->Labels.Id.assign(this->Mesh.Points.size(), -1);
    for (const Quad& quad : this->Boundary.Quads)
    {
      for (Index v : quad)
      {
        this->LabelByPosition(v);
      }
    }
    this->Features = RecoverFeatures(
      this->Mesh, this->Boundary, this->Surface, this->Graph, this->Labels);
  }

private:
  void LabelByPosition(Index v)
  {
    const Vec3& p = this->Mesh.Points[v];
    const auto label = [&](FeatureKind kind, std::size_t id) {
      this->Labels.Kind[v] = kind;
      this->Labels.Id[v] = static_cast<Index>(id);
    };
    for (std::size_t t = 0; t < this->Surface.Triangles.size(); ++t)
    {
      const Triangle& abc = this->Surface.Triangles[t];
      const std::vector<Vec3>& points = this->Surface.Points;
      const Vec3 normal =
        (points[abc[1]] - points[abc[0]]).cross(points[abc[2]] - points[abc[0]]).normalized();
      if (std::abs(normal.dot(p - points[abc[0]])) < 1e-9)
      {
        label(FeatureKind::Surface, this->Graph.PatchOfTriangle[t]);
      }
    }
    for (std::size_t c = 0; c < this->Graph.Curves.size(); ++c)
    {
      const std::vector<Index>& chain = this->Graph.Curves[c].Points;
      for (std::size_t i = 1; i < chain.size(); ++i)
      {
        const Vec3& a = this->Surface.Points[chain[i - 1]];
        const Vec3& b = this->Surface.Points[chain[i]];
        if (std::abs((p - a).norm() + (p - b).norm() - (a - b).norm()) < 1e-9)
        {
          label(FeatureKind::Curve, c);
        }
      }
    }
    for (std::size_t c = 0; c < this->Graph.Corners.size(); ++c)
    {
      if ((p - this->Surface.Points[this->Graph.Corners[c].Point]).norm() < 1e-9)
      {
        label(FeatureKind::Corner, c);
      }
    }
  }
};

/// [0, n]^3: 8 corners, 12 curves, 6 patches.
inline FeatureShape CubeWithFeatures(int n)
{
  FeatureShape shape;
  shape.Mesh = CubeMesh(n);
  const HexMesh box = CubeMesh(1);
  shape.Surface = SplitQuads(box.Points, ExtractBoundary(box).Quads);
  std::vector<PointPair> edges;
  for (const auto& e : HexEdges)
  {
    edges.push_back({ box.Hexes[0][e[0]], box.Hexes[0][e[1]] });
  }
  for (Vec3& p : shape.Surface.Points)
  {
    p *= n;
  }
  shape.Finish(edges);
  return shape;
}

/// A prism over a regular polygon of 4 n corners with the rims as curves: 2 loops, 3 patches.
inline FeatureShape CylinderWithFeatures(int n)
{
  FeatureShape shape;
  shape.Mesh = CubeMesh(n);
  for (Vec3& p : shape.Mesh.Points)
  {
    // Concentric squares become concentric polygons.
    const double x = p.x() - 0.5 * n, y = p.y() - 0.5 * n;
    const double r = std::max(std::abs(x), std::abs(y));
    const double quarter = 0.25 * std::acos(-1.0);
    const double angle = r == 0.0      ? 0.0
      : std::abs(x) >= std::abs(y) ? quarter * y / x + (x < 0 ? 4 * quarter : 0.0)
                                   : 2 * quarter - quarter * x / y + (y < 0 ? 4 * quarter : 0.0);
    p.x() = r * std::cos(angle);
    p.y() = r * std::sin(angle);
  }
  const HexBoundary boundary = ExtractBoundary(shape.Mesh);
  shape.Surface = SplitQuads(shape.Mesh.Points, boundary.Quads);
  std::set<PointPair> rims;
  for (const Quad& quad : boundary.Quads)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Index a = quad[k], b = quad[(k + 1) % 4];
      const auto outside = [&](Index v) {
        const Vec3& p = shape.Mesh.Points[v];
        return Vec3(p.x(), p.y(), 0).norm() > 0.5 * n - 1e-9 && (p.z() == 0 || p.z() == n);
      };
      if (outside(a) && outside(b) && shape.Mesh.Points[a].z() == shape.Mesh.Points[b].z())
      {
        rims.insert({ std::min(a, b), std::max(a, b) });
      }
    }
  }
  shape.Finish({ rims.begin(), rims.end() });
  return shape;
}
} // namespace featurehex

#endif

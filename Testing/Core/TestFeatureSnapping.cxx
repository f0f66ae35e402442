// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureSnapping.h"

#include "FeatureShapes.h"
#include "HexCertificate.h"

#include <gtest/gtest.h>

#include <vtkSMPTools.h>

#include <random>

using namespace featurehex;

namespace
{
/// A cube with features whose mesh has been displaced, and what SnapFeatures() needs.
struct Setting
{
  FeatureShape Shape;
  FeatureGeometry Geometry;
  SurfaceGeometry Surface;
  HexStars Stars;
  FeatureTargets Targets;
  SurfaceTerms Terms;
  HexOptimizer Optimizer;

  Setting(int n, double reach)
    : Shape(Displaced(n, reach))
    , Geometry(Shape.Surface, Shape.Graph, 1.0)
    , Surface(Shape.Surface)
    , Stars(Shape.Mesh)
    , Targets(Geometry, Shape.Features, Stars, Shape.Mesh.Points)
    , Terms(Shape.Mesh, Stars, Surface, &Targets)
    , Optimizer(Shape.Mesh, Stars)
  {
  }

  /// Every point up to @a reach away in each direction, all hexes still valid.
  static FeatureShape Displaced(int n, double reach)
  {
    FeatureShape shape = CubeWithFeatures(n);
    const HexStars stars(shape.Mesh);
    std::mt19937 random(3);
    for (Index v = 0; v < static_cast<Index>(shape.Mesh.Points.size()); ++v)
    {
      const Vec3 before = shape.Mesh.Points[v];
      for (int k = 0; k < 3; ++k)
      {
        shape.Mesh.Points[v][k] += reach * (2.0 * random() / 4294967295.0 - 1.0);
      }
      for (Index h : stars.Hexes[v])
      {
        if (CertifyHex(shape.Mesh, h).State != Validity::Valid)
        {
          shape.Mesh.Points[v] = before;
        }
      }
    }
    return shape;
  }

  Status Snap()
  {
    Monitor monitor;
    return SnapFeatures(this->Shape.Mesh, this->Stars, this->Targets, this->Terms, this->Optimizer,
      50.0, monitor);
  }
};
}

TEST(FeatureSnapping, PutsAllVerticesOnTheirFeatures)
{
  for (double reach : { 0.1, 0.35 })
  {
    Setting setting(6, reach);
    const Status status = setting.Snap();
    ASSERT_TRUE(status.Ok()) << status.Message;
    const HexMesh& mesh = setting.Shape.Mesh;
    for (Index v : setting.Targets.Vertices())
    {
      EXPECT_TRUE(setting.Targets.Locked(v));
      const Vec3& p = mesh.Points[v];
      EXPECT_LT((setting.Targets.Project(v, p) - p).norm(), 1e-12);
    }
    for (const HexCertificate& certificate : CertifyHexes(mesh))
    {
      EXPECT_EQ(certificate.State, Validity::Valid);
    }
    // The other boundary vertices are drawn to the faces, too.
    const FeatureValidationReport report = setting.Shape.Validate(0.05);
    EXPECT_EQ(report.CornerTotals().Captured, 8) << report.Complaint();
    EXPECT_EQ(report.CurveTotals().Captured, 12) << report.Complaint();
  }
}

TEST(FeatureSnapping, ForcesATrappedVertex)
{
  // A corner of the cube far inside: the hex there is flat when it arrives, unless the others give
  // way.
  Setting setting(4, 0.0);
  const Index corner = setting.Shape.Features.CornerVertices[0];
  Vec3& p = setting.Shape.Mesh.Points[corner];
  p += 0.3 * (Vec3::Constant(2) - p).normalized();
  ASSERT_TRUE(setting.Snap().Ok());
  EXPECT_TRUE(setting.Targets.Locked(corner));
  EXPECT_EQ(p, setting.Geometry.CornerPoint(0));
}

TEST(FeatureSnapping, SameBitsForAnyNumberOfThreads)
{
  std::vector<Vec3> points[2];
  for (int threads : { 1, 2 })
  {
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads }, [&] {
      Setting setting(10, 0.3);
      EXPECT_TRUE(setting.Snap().Ok());
      points[threads - 1] = setting.Shape.Mesh.Points;
    });
  }
  EXPECT_EQ(points[0], points[1]);
}

TEST(FeatureSnapping, StopsWhenAsked)
{
  class AbortAtOnce : public Monitor
  {
    bool AbortRequested() override { return true; }
  } monitor;
  Setting setting(4, 0.1);
  EXPECT_EQ(SnapFeatures(setting.Shape.Mesh, setting.Stars, setting.Targets, setting.Terms,
              setting.Optimizer, 50.0, monitor)
              .Code,
    StatusCode::Aborted);
}

// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureTargets.h"

#include "FeatureShapes.h"
#include "HexOptimizer.h"
#include "VertexImprover.h"

#include <gtest/gtest.h>

#include <random>

using namespace featurehex;

namespace
{
/// A shape with features and targets of its mesh.
struct Setting
{
  FeatureShape Shape;
  FeatureGeometry Geometry;
  HexStars Stars;
  FeatureTargets Targets;
  double Diagonal;

  explicit Setting(FeatureShape shape)
    : Shape(std::move(shape))
    , Geometry(Shape.Surface, Shape.Graph, 1.0)
    , Stars(Shape.Mesh)
    , Targets(Geometry, Shape.Features, Stars, Shape.Mesh.Points)
    , Diagonal(BoundingBox(Shape.Surface).Diagonal())
  {
  }

  void LockAll()
  {
    for (Index v : this->Targets.Vertices())
    {
      this->Targets.Lock(v);
    }
  }

  /// Farthest that a locked vertex is from its feature.
  double OffFeatures() const
  {
    double farthest = 0;
    for (Index v : this->Targets.Vertices())
    {
      if (this->Targets.Locked(v))
      {
        const Vec3& p = this->Shape.Mesh.Points[v];
        farthest = std::max(farthest, (this->Targets.Project(v, p) - p).norm());
      }
    }
    return farthest;
  }
};

/// Displaces the vertices that are on no feature, those of curves along them.
void Disturb(Setting& setting, double reach)
{
  std::mt19937 random(5);
  const auto step = [&] { return reach * (2.0 * random() / 4294967295.0 - 1.0); };
  for (Index v = 0; v < static_cast<Index>(setting.Shape.Mesh.Points.size()); ++v)
  {
    Vec3& p = setting.Shape.Mesh.Points[v];
    const Vec3 displacement(step(), step(), step());
    if (!setting.Targets.OnFeature(v))
    {
      p += displacement;
    }
    else if (setting.Targets.KindOf(v) == FeatureKind::Curve)
    {
      p = setting.Targets.Project(v, p + displacement);
    }
  }
}

std::vector<double> ArcsOf(const Setting& setting, Index curve)
{
  std::vector<double> arcs;
  for (Index v : setting.Shape.Features.CurvePaths[curve])
  {
    if (setting.Targets.KindOf(v) == FeatureKind::Curve)
    {
      arcs.push_back(setting.Targets.OnCurve(v, setting.Shape.Mesh.Points[v]).Arc);
    }
  }
  return arcs;
}
}

TEST(FeatureTargets, VerticesOfACube)
{
  const Setting setting(CubeWithFeatures(4));
  EXPECT_EQ(setting.Targets.Vertices().size(), 8u + 12 * 3);
  EXPECT_TRUE(
    std::is_sorted(setting.Targets.Vertices().begin(), setting.Targets.Vertices().end()));
  for (Index v : setting.Targets.Vertices())
  {
    EXPECT_TRUE(setting.Targets.OnFeature(v));
    EXPECT_FALSE(setting.Targets.Locked(v));
  }
}

TEST(FeatureTargets, ProjectsToCornersAndCurves)
{
  const Setting setting(CubeWithFeatures(4));
  const Vec3 off(0.2, -0.3, 0.25);
  for (Index v : setting.Targets.Vertices())
  {
    const Vec3& p = setting.Shape.Mesh.Points[v];
    const Vec3 target = setting.Targets.Project(v, p + off);
    const Vec3 allowed = setting.Targets.Allowed(v, p, off);
    if (setting.Targets.KindOf(v) == FeatureKind::Corner)
    {
      EXPECT_EQ(target, p);
      EXPECT_EQ(allowed, Vec3(Vec3::Zero()));
      continue;
    }
    const Vec3 tangent = setting.Targets.OnCurve(v, p).Tangent;
    EXPECT_NEAR((target - p - tangent.dot(off) * tangent).norm(), 0, 1e-14);
    EXPECT_NEAR((allowed - tangent.dot(off) * tangent).norm(), 0, 1e-14);
  }
}

TEST(FeatureTargets, PatchesOfVerticesAndQuads)
{
  const Setting setting(CubeWithFeatures(3));
  const SurfaceGeometry whole(setting.Shape.Surface);
  for (Index v = 0; v < static_cast<Index>(setting.Shape.Mesh.Points.size()); ++v)
  {
    if (setting.Targets.KindOf(v) == FeatureKind::Surface)
    {
      const SurfaceGeometry& patch = setting.Targets.PatchAt(v, whole);
      EXPECT_NE(&patch, &whole);
      EXPECT_LT(patch.Search().Closest(setting.Shape.Mesh.Points[v]).Distance, 1e-12);
    }
  }
  for (std::size_t q = 0; q < setting.Stars.Quads.size(); ++q)
  {
    for (Index v : setting.Stars.Quads[q])
    {
      EXPECT_LT(setting.Targets.PatchOfQuad(static_cast<Index>(q))
                  .Search()
                  .Closest(setting.Shape.Mesh.Points[v])
                  .Distance,
        1e-12);
    }
  }
}

TEST(FeatureTargets, LoopsAreFollowedOverTheirEnd)
{
  Setting setting(CylinderWithFeatures(6));
  for (Index v : setting.Targets.Vertices())
  {
    const Vec3& p = setting.Shape.Mesh.Points[v];
    EXPECT_LT((setting.Targets.Project(v, p) - p).norm(), 1e-12);
    EXPECT_NEAR(setting.Targets.SpreadFrom(v, setting.Targets.OnCurve(v, p).Arc), 0, 1e-12);
  }
  // Turned by some steps in either direction, followed on the way.
  for (double turn : { 0.2, -0.2 })
  {
    for (int i = 0; i < 20; ++i)
    {
      const Eigen::AngleAxisd rotation(turn, Vec3::UnitZ());
      for (Vec3& p : setting.Shape.Mesh.Points)
      {
        p = rotation * p;
      }
      setting.Targets.FollowCurves(setting.Shape.Mesh.Points);
      for (Index v : setting.Targets.Vertices())
      {
        const Vec3& p = setting.Shape.Mesh.Points[v];
        EXPECT_LT((setting.Targets.Project(v, p) - p).norm(), 0.06); // sagitta of the polygon
      }
    }
  }
}

TEST(FeatureTargets, WindowsKeepTheOrderOfAPath)
{
  Setting setting(CubeWithFeatures(12));
  for (int round = 0; round < 5; ++round)
  {
    Disturb(setting, 0.45);
    setting.Targets.FollowCurves(setting.Shape.Mesh.Points);
    for (Index c = 0; c < 12; ++c)
    {
      const std::vector<Index>& path = setting.Shape.Features.CurvePaths[c];
      // Nobody is projected farther away than the windows reach, wherever it is.
      for (std::size_t i = 1; i + 1 < path.size(); ++i)
      {
        const Vec3& p = setting.Shape.Mesh.Points[path[i]];
        const double arc = setting.Targets.OnCurve(path[i], p).Arc;
        const double first =
          setting.Targets.OnCurve(path[i], setting.Geometry.Curves()[c].At(0)).Arc;
        const double last =
          setting.Targets.OnCurve(path[i], setting.Geometry.Curves()[c].At(12)).Arc;
        EXPECT_LE(first, arc);
        EXPECT_GE(last, arc);
        if (i > 6)
        {
          EXPECT_GT(first, 0.5);
        }
        if (i < 6)
        {
          EXPECT_LT(last, 11.5);
        }
      }
    }
  }
}

TEST(FeatureTargets, SpreadDrawsCrowdedVerticesApart)
{
  Setting setting(CubeWithFeatures(4));
  const std::vector<Index>& path = setting.Shape.Features.CurvePaths[0];
  const EnforcedCurve& curve = setting.Geometry.Curves()[0];
  for (int i : { 1, 2, 3 })
  {
    EXPECT_NEAR(setting.Targets.SpreadFrom(path[i], i), 0, 1e-12); // evenly spread already
    setting.Shape.Mesh.Points[path[i]] = curve.At(0.2 * i);
  }
  setting.Targets.FollowCurves(setting.Shape.Mesh.Points);
  EXPECT_GT(setting.Targets.SpreadFrom(path[3], 0.6), 0.3); // room ahead
  // Those that have changed places are drawn past each other.
  setting.Shape.Mesh.Points[path[1]] = curve.At(2.5);
  setting.Shape.Mesh.Points[path[2]] = curve.At(1.5);
  setting.Shape.Mesh.Points[path[3]] = curve.At(3);
  setting.Targets.FollowCurves(setting.Shape.Mesh.Points);
  EXPECT_LT(setting.Targets.SpreadFrom(path[1], 2.5), 0);
  EXPECT_GT(setting.Targets.SpreadFrom(path[2], 1.5), 0);
}

TEST(FeatureTargets, LockedVerticesStayOnTheirFeaturesInSweeps)
{
  for (const bool loops : { false, true })
  {
    Setting setting(loops ? CylinderWithFeatures(6) : CubeWithFeatures(6));
    Disturb(setting, 0.15);
    setting.Targets.FollowCurves(setting.Shape.Mesh.Points);
    setting.LockAll();
    const std::vector<Vec3> before = setting.Shape.Mesh.Points;
    HexOptimizer optimizer(setting.Shape.Mesh, setting.Stars);
    optimizer.Features = &setting.Targets;
    for (double regularization : { 0.1, -1.0 })
    {
      for (int sweep = 0; sweep < 5; ++sweep)
      {
        optimizer.ActivateAll();
        EXPECT_GT(optimizer.Sweep(regularization), 0u);
        EXPECT_LT(setting.OffFeatures(), 1e-12 * setting.Diagonal);
      }
    }
    int slid = 0;
    for (Index v : setting.Targets.Vertices())
    {
      const bool moved = setting.Shape.Mesh.Points[v] != before[v];
      slid += moved;
      EXPECT_FALSE(moved && setting.Targets.KindOf(v) == FeatureKind::Corner);
    }
    EXPECT_GT(slid, 12);
    for (Index c = 0; !loops && c < 12; ++c)
    {
      const std::vector<double> arcs = ArcsOf(setting, c);
      EXPECT_TRUE(std::is_sorted(arcs.begin(), arcs.end()));
    }
  }
}

TEST(FeatureTargets, LockedVerticesStayOnTheirFeaturesInImprovement)
{
  Setting setting(CubeWithFeatures(6));
  Disturb(setting, 0.2);
  setting.Targets.FollowCurves(setting.Shape.Mesh.Points);
  setting.LockAll();
  const std::vector<Vec3> before = setting.Shape.Mesh.Points;
  const SurfaceGeometry surface(setting.Shape.Surface);
  const std::vector<Vec3> samples = surface.Samples(0.3);
  HexMesh& mesh = setting.Shape.Mesh;
  SurfaceEnvelope envelope(surface, samples, mesh, setting.Stars, 4);
  envelope.Rebuild();
  envelope.Rebuild();
  envelope.Measure(0.0);
  VertexImprover improver(mesh, setting.Stars, envelope, 0.5, &setting.Targets);
  for (int round = 0; round < 3; ++round)
  {
    for (Index v = 0; v < static_cast<Index>(mesh.Points.size()); ++v)
    {
      improver.RaiseMinimum(v);
      improver.PushBarrier(v, { 0.9, 0.1, 0.01 });
      improver.DrawInside(v, 10.0);
      improver.RaiseAverage(v, surface, 0.1);
      if (setting.Stars.OnBoundary(v))
      {
        improver.Project(v, surface, 0.1);
      }
    }
    EXPECT_LT(setting.OffFeatures(), 1e-12 * setting.Diagonal);
  }
  int slid = 0;
  for (Index v : setting.Targets.Vertices())
  {
    EXPECT_TRUE(setting.Targets.Locked(v));
    const bool moved = mesh.Points[v] != before[v];
    slid += moved;
    EXPECT_FALSE(moved && setting.Targets.KindOf(v) == FeatureKind::Corner);
  }
  EXPECT_GT(slid, 12);
}

TEST(FeatureTargets, ImprovementLocksVerticesThatArrive)
{
  Setting setting(CubeWithFeatures(4));
  HexMesh& mesh = setting.Shape.Mesh;
  for (Index v : setting.Targets.Vertices())
  {
    mesh.Points[v] += 0.05 * (Vec3::Constant(2) - mesh.Points[v]).normalized();
  }
  const SurfaceGeometry surface(setting.Shape.Surface);
  const std::vector<Vec3> samples = surface.Samples(0.3);
  SurfaceEnvelope envelope(surface, samples, mesh, setting.Stars, 4);
  envelope.Rebuild();
  envelope.Rebuild();
  envelope.Measure(0.0);
  VertexImprover improver(mesh, setting.Stars, envelope, 0.5, &setting.Targets);
  for (Index v : setting.Targets.Vertices())
  {
    EXPECT_TRUE(improver.Project(v, surface, 0.3));
    EXPECT_TRUE(setting.Targets.Locked(v));
  }
  EXPECT_LT(setting.OffFeatures(), 1e-15);
}

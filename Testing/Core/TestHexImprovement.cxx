// SPDX-License-Identifier: BSD-3-Clause
#include "HexImprovement.h"

#include "CertifiedDistance.h"
#include "HexCertificate.h"
#include "HexQuality.h"
#include "TangledMesh.h"

#include <gtest/gtest.h>

#include <vtkSMPTools.h>

using namespace featurehex;

namespace
{
constexpr int GridSize = 7;
constexpr double Tolerance = 0.02; // few samples: the tests stay quick

struct Setting
{
  SurfaceGeometry Surface;
  ImprovementOptions Options;
  std::vector<Vec3> Samples;
  HexMesh Mesh;
  HexStars Stars;
  SurfaceEnvelope Envelope;
  ImprovementReport Report;

  explicit Setting(HexMesh mesh)
    : Surface(SphereSurface(24))
    , Samples(Surface.Samples(0.7 * Tolerance * Surface.Diagonal()))
    , Mesh(std::move(mesh))
    , Stars(Mesh)
    , Envelope(Surface, Samples, Mesh, Stars, GridSize)
  {
    this->Options.Tolerance = Tolerance;
    this->Envelope.Rebuild();
  }

  double Limit() const { return this->Options.Tolerance * this->Surface.Diagonal(); }

  Status Improve(Monitor& monitor)
  {
    return ImproveHexes(
      this->Mesh, this->Stars, this->Surface, this->Envelope, this->Options, this->Report, monitor);
  }
};

/// A ball on the sphere whose inner points are in disorder, but valid.
HexMesh RoughBall(int n)
{
  HexMesh mesh = BallMesh(n);
  const HexStars stars(mesh);
  std::mt19937 random(11);
  for (std::size_t v = 0; v < mesh.Points.size(); ++v)
  {
    const Vec3 before = mesh.Points[v];
    if (!stars.OnBoundary(static_cast<Index>(v)))
    {
      for (int k = 0; k < 3; ++k)
      {
        mesh.Points[v][k] += 0.6 / n * (2.0 * random() / 4294967295.0 - 1.0);
      }
    }
    for (Index h : stars.Hexes[static_cast<Index>(v)])
    {
      if (CertifyHex(mesh, h).State != Validity::Valid)
      {
        mesh.Points[v] = before;
      }
    }
  }
  return mesh;
}

Index CountInvalid(const HexMesh& mesh)
{
  Index count = 0;
  for (const HexCertificate& certificate : CertifyHexes(mesh))
  {
    count += certificate.State == Validity::Valid ? 0 : 1;
  }
  return count;
}

class AbortAtOnce : public Monitor
{
  bool AbortRequested() override { return true; }
};
}

TEST(HexImprovement, RaisesTheMinimumAndKeepsEveryPromise)
{
  Setting setting(RoughBall(10));
  ASSERT_EQ(CountInvalid(setting.Mesh), 0);
  const double before = SummarizeQuality(ScaledJacobians(setting.Mesh)).Minimum;
  Monitor monitor;
  const Status status = setting.Improve(monitor);
  ASSERT_TRUE(status.Ok()) << status.Message;

  const double after = SummarizeQuality(ScaledJacobians(setting.Mesh)).Minimum;
  EXPECT_NEAR(setting.Report.MinimumBefore, before, 1e-9);
  EXPECT_NEAR(setting.Report.MinimumAfter, after, 1e-9);
  EXPECT_GT(after, before + 0.2);
  EXPECT_GT(after, 0.4);
  EXPECT_EQ(CountInvalid(setting.Mesh), 0);

  EXPECT_LE(setting.Report.Distance, setting.Options.EnvelopeShare * setting.Limit());
  const DistanceDecision decision =
    CertifiedDistance(setting.Surface.Mesh())
      .DistanceWithin(setting.Mesh.Points, setting.Stars.Quads, setting.Limit(), monitor);
  EXPECT_TRUE(decision.Within);
}

TEST(HexImprovement, DrawsABoundaryThatIsTooFarInside)
{
  HexMesh mesh = RoughBall(10);
  for (Vec3& p : mesh.Points)
  {
    if (p.norm() > 0.999 && p.x() > 0.95)
    {
      p *= 1.09;
    }
  }
  Setting setting(std::move(mesh));
  ASSERT_EQ(CountInvalid(setting.Mesh), 0);
  setting.Envelope.Measure(0.0);
  EXPECT_GT(setting.Envelope.ForwardMaximum(), setting.Limit());
  Monitor monitor;
  ASSERT_TRUE(setting.Improve(monitor).Ok());
  EXPECT_TRUE(setting.Report.Drawn);
  EXPECT_LE(setting.Report.Distance, setting.Options.EnvelopeShare * setting.Limit());
  EXPECT_EQ(CountInvalid(setting.Mesh), 0);
}

TEST(HexImprovement, SameBitsForAnyNumberOfThreads)
{
  std::vector<std::vector<Vec3>> results;
  for (int threads : { 1, 2 })
  {
    Setting setting(RoughBall(8));
    setting.Options.MaximumRounds = 2;
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads }, [&] {
      Monitor monitor;
      EXPECT_TRUE(setting.Improve(monitor).Ok());
    });
    results.push_back(setting.Mesh.Points);
  }
  EXPECT_EQ(results[0], results[1]);
}

TEST(HexImprovement, EmptyMeshAndAbort)
{
  Monitor monitor;
  Setting empty{ HexMesh() };
  EXPECT_TRUE(empty.Improve(monitor).Ok());
  Setting setting(RoughBall(4));
  AbortAtOnce abort;
  EXPECT_EQ(setting.Improve(abort).Code, StatusCode::Aborted);
  EXPECT_EQ(CountInvalid(setting.Mesh), 0) << "valid at any moment";
}

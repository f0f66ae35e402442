// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceEnvelope.h"

#include "TangledMesh.h"

#include <gtest/gtest.h>

using namespace featurehex;

namespace
{
constexpr int Grid = 5;

/// A ball of hexes in a sphere of triangles, and distances by brute force.
struct Setting
{
  SurfaceGeometry Surface;
  std::vector<Vec3> Samples;
  HexMesh Mesh;
  HexStars Stars;

  Setting()
    : Surface(SphereSurface(16, 1.02))
    , Samples(Surface.Samples(0.08))
    , Mesh(BallMesh(5))
    , Stars(Mesh)
  {
  }

  Vec3 Center(const Quad& q) const
  {
    return 0.25 *
      (this->Mesh.Points[q[0]] + this->Mesh.Points[q[1]] + this->Mesh.Points[q[2]] +
        this->Mesh.Points[q[3]]);
  }

  /// Farthest grid point of a quad from the surface.
  double Forward(Index quad) const
  {
    const Quad& q = this->Stars.Quads[quad];
    double largest = 0;
    for (int i = 0; i < Grid; ++i)
    {
      for (int j = 0; j < Grid; ++j)
      {
        const double u = i / (Grid - 1.0), v = j / (Grid - 1.0);
        const Vec3 p = (1 - u) * (1 - v) * this->Mesh.Points[q[0]] +
          u * (1 - v) * this->Mesh.Points[q[1]] + u * v * this->Mesh.Points[q[2]] +
          (1 - u) * v * this->Mesh.Points[q[3]];
        double closest = 1e300;
        for (const Triangle& t : this->Surface.Mesh().Triangles)
        {
          const std::vector<Vec3>& points = this->Surface.Mesh().Points;
          closest = std::min(
            closest, ClosestPointOnTriangle(p, points[t[0]], points[t[1]], points[t[2]]).Distance);
        }
        largest = std::max(largest, closest);
      }
    }
    return largest;
  }

  double ForwardAll() const
  {
    double largest = 0;
    for (std::size_t q = 0; q < this->Stars.Quads.size(); ++q)
    {
      largest = std::max(largest, this->Forward(static_cast<Index>(q)));
    }
    return largest;
  }

  /// Distance of a sample to the whole boundary, each quad as four triangles round its centre.
  double Reverse(const Vec3& sample) const
  {
    double closest = 1e300;
    for (const Quad& q : this->Stars.Quads)
    {
      const Vec3 center = this->Center(q);
      for (int k = 0; k < 4; ++k)
      {
        closest = std::min(closest,
          ClosestPointOnTriangle(
            sample, this->Mesh.Points[q[k]], this->Mesh.Points[q[(k + 1) % 4]], center)
            .Distance);
      }
    }
    return closest;
  }

  double ReverseAll() const
  {
    double largest = 0;
    for (const Vec3& sample : this->Samples)
    {
      largest = std::max(largest, this->Reverse(sample));
    }
    return largest;
  }
};
}

TEST(SurfaceEnvelope, MeasuresAsBruteForceDoes)
{
  Setting setting;
  SurfaceEnvelope envelope(setting.Surface, setting.Samples, setting.Mesh, setting.Stars, Grid);
  envelope.Rebuild();
  EXPECT_GT(envelope.ForwardMaximum(), 1e200) << "unknown until measured";
  envelope.Measure(0.0);
  EXPECT_NEAR(envelope.ForwardMaximum(), setting.ForwardAll(), 1e-12);
  EXPECT_NEAR(envelope.ReverseMaximum(), setting.ReverseAll(), 1e-12);
}

TEST(SurfaceEnvelope, BoundsHoldAfterManyMoves)
{
  Setting setting;
  SurfaceEnvelope envelope(setting.Surface, setting.Samples, setting.Mesh, setting.Stars, Grid);
  envelope.Rebuild();
  envelope.Measure(0.0);
  const double limit = 1.2 * std::max(envelope.ForwardMaximum(), envelope.ReverseMaximum());
  std::mt19937 random(5);
  const auto unit = [&] { return 2.0 * random() / 4294967295.0 - 1.0; };
  int accepted = 0, rejected = 0;
  for (int round = 0; round < 20; ++round)
  {
    for (std::size_t v = 0; v < setting.Mesh.Points.size(); ++v)
    {
      const IdLists::Range quads = setting.Stars.QuadsOfVertex[static_cast<Index>(v)];
      if (quads.size() == 0)
      {
        continue;
      }
      const Vec3 before = setting.Mesh.Points[v];
      const Vec3 step = 0.02 * Vec3(unit(), unit(), unit());
      setting.Mesh.Points[v] += step;
      if (envelope.AcceptMove(quads, step.norm(), limit))
      {
        ++accepted;
      }
      else
      {
        ++rejected;
        setting.Mesh.Points[v] = before;
      }
    }
  }
  EXPECT_GT(accepted, 100);
  EXPECT_GT(rejected, 100);

  EXPECT_LE(envelope.ForwardMaximum(), limit);
  EXPECT_LE(envelope.ReverseMaximum(), limit);
  EXPECT_GE(envelope.ReverseMaximum() + 1e-12, setting.ReverseAll());
  for (std::size_t v = 0; v < setting.Mesh.Points.size(); ++v)
  {
    for (Index q : setting.Stars.QuadsOfVertex[static_cast<Index>(v)])
    {
      EXPECT_GE(envelope.BoundAround(static_cast<Index>(v)) + 1e-12, setting.Forward(q));
    }
  }
  EXPECT_LE(setting.ForwardAll(), limit);
  EXPECT_LE(setting.ReverseAll(), limit);

  // Samples walked from quad to quad: none may be lost.
  envelope.Measure(0.0);
  EXPECT_GE(envelope.ReverseMaximum() + 1e-12, setting.ReverseAll());
  envelope.Rebuild();
  envelope.Measure(0.0);
  EXPECT_NEAR(envelope.ReverseMaximum(), setting.ReverseAll(), 1e-12);
}

TEST(SurfaceEnvelope, RejectsAMoveOutOfTheLimit)
{
  Setting setting;
  SurfaceEnvelope envelope(setting.Surface, setting.Samples, setting.Mesh, setting.Stars, Grid);
  envelope.Rebuild();
  envelope.Measure(0.0);
  const double limit = 1.1 * std::max(envelope.ForwardMaximum(), envelope.ReverseMaximum());
  const Index v = setting.Stars.Quads[0][0];
  const Vec3 before = setting.Mesh.Points[v];
  setting.Mesh.Points[v] *= 1.5;
  EXPECT_FALSE(envelope.AcceptMove(
    setting.Stars.QuadsOfVertex[v], (setting.Mesh.Points[v] - before).norm(), limit));
  setting.Mesh.Points[v] = before;
  EXPECT_TRUE(envelope.AcceptMove(setting.Stars.QuadsOfVertex[v], 0.0, limit));
}

TEST(SurfaceEnvelope, CollectsAllContactsBeyondAThreshold)
{
  Setting setting;
  setting.Mesh.Points[setting.Stars.Quads[7][1]] *= 1.3;
  SurfaceEnvelope envelope(setting.Surface, setting.Samples, setting.Mesh, setting.Stars, Grid);
  envelope.Rebuild();
  const double threshold = 0.1;
  std::vector<EnvelopeContact> contacts;
  double farthest = 0;
  for (std::size_t q = 0; q < setting.Stars.Quads.size(); ++q)
  {
    contacts.clear();
    envelope.Collect(static_cast<Index>(q), threshold, contacts);
    const double forward = setting.Forward(static_cast<Index>(q));
    double largest = 0;
    for (const EnvelopeContact& contact : contacts)
    {
      EXPECT_GT(contact.Distance, threshold);
      EXPECT_NEAR((contact.QuadPoint - contact.SurfacePoint).norm(), contact.Distance, 1e-12);
      largest = std::max(largest, contact.Distance);
    }
    if (forward > threshold)
    {
      EXPECT_GE(largest + 1e-12, forward);
    }
    farthest = std::max(farthest, largest);
  }
  EXPECT_NEAR(
    farthest, std::max(setting.ForwardAll(), setting.ReverseAll()), 1e-9);
}

TEST(SurfaceEnvelope, UpdateFindsCloserQuads)
{
  Setting setting;
  SurfaceEnvelope envelope(setting.Surface, setting.Samples, setting.Mesh, setting.Stars, Grid);
  envelope.Rebuild();
  // All turn about an axis by half a hex: the owners are wrong now.
  const Mat3 turn = Eigen::AngleAxisd(0.15, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  for (Vec3& p : setting.Mesh.Points)
  {
    p = turn * p;
  }
  envelope.Update(0.0);
  envelope.Measure(0.0);
  EXPECT_NEAR(envelope.ReverseMaximum(), setting.ReverseAll(), 1e-12);
}

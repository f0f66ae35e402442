// SPDX-License-Identifier: BSD-3-Clause
#include "BoundarySpreading.h"

#include "DomainShapes.h"
#include "FeatureExtraction.h"
#include "HexDomain.h"
#include "HexLocalPadding.h"
#include "HexUntangling.h"
#include "MappingShapes.h"

#include <gtest/gtest.h>

#include <random>

using namespace featurehex;

namespace
{
using Inside = std::function<bool(int, int, int)>;

bool Everywhere(int, int, int)
{
  return true;
}

void ExpectOk(const Status& status)
{
  EXPECT_TRUE(status.Ok()) << status.Message;
}

Mat3 Rotation(double degrees, const Vec3& axis)
{
  return Eigen::AngleAxisd(degrees * std::acos(-1.0) / 180, axis.stableNormalized()).matrix();
}

/// A body of unit cubes turned in a lattice: the hexes inside, with mapped features and layers.
struct Body
{
  SurfaceMesh Surface;
  SurfaceFeatures Graph;
  std::unique_ptr<FeatureGeometry> Geometry;
  HexMesh Mesh;
  HexFeatures Features;
  HexStars Stars;
  std::unique_ptr<FeatureTargets> Targets;
  std::vector<Vec3> Before;

  Body(const Body&) = delete; // the targets refer to it
  Body(const std::array<int, 3>& n, const Inside& inside, const Vec3& turn)
  {
    const HexMesh solid = LatticeMesh(n, inside);
    this->Surface = SplitQuads(solid.Points, ExtractBoundary(solid).Quads);
    FeatureExtractionReport found;
    ExpectOk(ExtractFeatures(
      this->Surface, nullptr, FeatureExtractionOptions(), this->Graph, found));
    const Vec3 center = 0.5 * Vec3(n[0], n[1], n[2]);
    for (Vec3& p : this->Surface.Points)
    {
      p = Rotation(turn.norm(), turn) * (p - center) + center;
    }
    this->Geometry = std::make_unique<FeatureGeometry>(this->Surface, this->Graph, 1.0);

    HexMesh lattice = LatticeMesh({ n[0] + 8, n[1] + 8, n[2] + 8 }, Everywhere);
    for (Vec3& p : lattice.Points)
    {
      p -= Vec3::Constant(4);
    }
    const domainshapes::Shape shape(this->Surface);
    HexDomain domain;
    Monitor monitor;
    ExpectOk(ComputeHexDomain(
      lattice, this->Surface, shape.Search, shape.Winding, DomainOptions(), monitor, domain));
    FeatureMapping mapping;
    ExpectOk(MapFeaturesToInterface(lattice,
      InterfaceQuads(lattice, HexGraph(lattice).Neighbors, domain.Region), *this->Geometry,
      FeatureMappingOptions(), monitor, mapping));
    EXPECT_TRUE(mapping.Complete());
    this->Features = mapping.Features;
    PaddedMesh padded;
    PaddingOptions padding;
    padding.EveryGroup = true;
    ExpectOk(PadInterface(
      lattice, domain.Region, padding, padded, &this->Features, this->Geometry.get()));
    PadDegenerateQuads(padded, this->Features, *this->Geometry, LocalPaddingOptions());
    this->Mesh = padded.Mesh;
    this->Stars = HexStars(this->Mesh);
    this->Start();
  }

  /// Targets for the points as they are.
  void Start()
  {
    this->Targets = std::make_unique<FeatureTargets>(
      *this->Geometry, this->Features, this->Stars, this->Mesh.Points);
    this->Before = this->Mesh.Points;
  }

  /// Steps from quad to quad that a vertex is away from these; -1: no boundary vertex.
  std::vector<int> RingsFrom(const std::vector<Index>& start) const
  {
    std::vector<int> ring(this->Mesh.Points.size(), -1);
    std::vector<Index> queue = start;
    for (Index v : start)
    {
      ring[v] = 0;
    }
    for (std::size_t i = 0; i < queue.size(); ++i)
    {
      for (Index q : this->Stars.QuadsOfVertex[queue[i]])
      {
        for (Index v : this->Stars.Quads[q])
        {
          if (ring[v] < 0)
          {
            ring[v] = ring[queue[i]] + 1;
            queue.push_back(v);
          }
        }
      }
    }
    return ring;
  }

  std::vector<Index> Folded() const
  {
    std::vector<Index> folded;
    for (Index q = 0; q < static_cast<Index>(this->Stars.Quads.size()); ++q)
    {
      if (IsFolded(this->Mesh, this->Stars, *this->Targets, q))
      {
        folded.push_back(q);
      }
    }
    return folded;
  }

  /// Corners exactly, curve vertices on their curves in even steps.
  void ExpectOnFeatures() const
  {
    for (std::size_t c = 0; c < this->Graph.Corners.size(); ++c)
    {
      EXPECT_EQ(this->Mesh.Points[this->Features.CornerVertices[c]],
        this->Geometry->CornerPoint(static_cast<Index>(c)));
    }
    for (std::size_t c = 0; c < this->Graph.Curves.size(); ++c)
    {
      const EnforcedCurve& curve = this->Geometry->Curves()[c];
      const std::vector<Index>& path = this->Features.CurvePaths[c];
      const double step = curve.Length() / static_cast<double>(path.size() - 1);
      for (std::size_t i = 1; i < path.size(); ++i)
      {
        const CurvePoint at = curve.Closest(this->Mesh.Points[path[i]]);
        EXPECT_LT(at.Distance, 1e-12);
        EXPECT_NEAR(at.Arc - curve.Closest(this->Mesh.Points[path[i - 1]]).Arc, step, 0.3 * step);
      }
    }
  }

  void ExpectUnfolded() const
  {
    EXPECT_TRUE(this->Folded().empty());
    const std::vector<Vec3>& p = this->Mesh.Points;
    for (std::size_t q = 0; q < this->Stars.Quads.size(); ++q)
    {
      const Quad& ids = this->Stars.Quads[q];
      const Vec3 normal = (p[ids[2]] - p[ids[0]]).cross(p[ids[3]] - p[ids[1]]).normalized();
      const Vec3& plane =
        this->Targets->PatchOfQuad(static_cast<Index>(q)).Search().Normal(0); // of the whole patch
      EXPECT_GT(normal.dot(plane), -0.2) << "quad " << q;
    }
  }
};

/// 9 x 9 x 7 without 5 x 5 x 7 at a corner.
bool Angle(int i, int j, int)
{
  return i < 4 || j < 4;
}

std::vector<std::unique_ptr<Body>> Bodies()
{
  using Size = std::array<int, 3>;
  std::vector<std::unique_ptr<Body>> bodies;
  for (const Vec3& turn : { Vec3(0, 0, 0), Vec3(15, 0, 0), Vec3(15, 25, 0), Vec3(20, 20, 20) })
  {
    bodies.push_back(std::make_unique<Body>(Size{ 9, 8, 8 }, Everywhere, turn));
  }
  bodies.push_back(std::make_unique<Body>(Size{ 9, 9, 7 }, Angle, Vec3(0, 0, 0)));
  bodies.push_back(std::make_unique<Body>(Size{ 9, 9, 7 }, Angle, Vec3(0, 0, 12)));
  return bodies;
}

/// Displaces all points.
void Disturb(Body& body, double reach)
{
  std::mt19937 random(11);
  for (Vec3& p : body.Mesh.Points)
  {
    for (double& x : p)
    {
      x += reach * (2.0 * random() / 4294967295.0 - 1.0);
    }
  }
  body.Start();
}

/// The quad that is farthest from all features.
Index RemoteQuad(const Body& body)
{
  const std::vector<int> rings = body.RingsFrom(body.Targets->Vertices());
  std::pair<int, Index> best;
  for (std::size_t q = 0; q < body.Stars.Quads.size(); ++q)
  {
    const Quad& ids = body.Stars.Quads[q];
    const int ring = std::min({ rings[ids[0]], rings[ids[1]], rings[ids[2]], rings[ids[3]] });
    best = std::max(best, { ring, static_cast<Index>(q) });
  }
  return best.second;
}

/// Turns a quad round the middles of two of its sides, degrees.
void Turn(Body& body, Index quad, double angle)
{
  const Quad& ids = body.Stars.Quads[quad];
  std::vector<Vec3>& p = body.Mesh.Points;
  const Vec3 center = 0.25 * (p[ids[0]] + p[ids[1]] + p[ids[2]] + p[ids[3]]);
  const Mat3 rotation = Rotation(angle, p[ids[1]] + p[ids[2]] - 2 * center);
  for (Index v : ids)
  {
    p[v] = rotation * (p[v] - center) + center;
  }
}
}

TEST(BoundarySpreading, VerticesAtFeaturesAreWhereTheyBelong)
{
  for (const std::unique_ptr<Body>& made : Bodies())
  {
    Body& body = *made;
    for (double reach : { 0.0, 0.2 })
    {
      Disturb(body, reach);
      SpreadAtFeatures(body.Mesh, body.Stars, *body.Targets);
      body.ExpectOnFeatures();
      body.ExpectUnfolded();
      const std::vector<int> rings = body.RingsFrom(body.Targets->Vertices());
      int away = 0;
      for (Index v = 0; v < static_cast<Index>(rings.size()); ++v)
      {
        if (rings[v] >= 0 && rings[v] <= 2)
        {
          for (Index q : body.Stars.QuadsOfVertex[v])
          {
            const TriangleSearch& patch = body.Targets->PatchOfQuad(q).Search();
            EXPECT_LT(patch.Closest(body.Mesh.Points[v]).Distance, 1e-12) << "ring " << rings[v];
          }
        }
        else if (rings[v] < 0 || rings[v] > 3)
        {
          EXPECT_EQ(body.Mesh.Points[v], body.Before[v]) << "ring " << rings[v];
          away += rings[v] > 3;
        }
      }
      EXPECT_GT(away, 0);
    }
  }
}

TEST(BoundarySpreading, LoopsGoRound)
{
  FeatureShape cylinder = CylinderWithFeatures(6);
  const FeatureGeometry geometry(cylinder.Surface, cylinder.Graph, 1.0);
  const HexStars stars(cylinder.Mesh);
  std::vector<Vec3>& points = cylinder.Mesh.Points;
  for (Vec3& p : points)
  {
    p = Eigen::AngleAxisd(0.05 * p.x(), Vec3::UnitZ()) * p; // crowds on one side
  }
  const FeatureTargets targets(geometry, cylinder.Features, stars, points);
  SpreadAtFeatures(cylinder.Mesh, stars, targets);
  for (std::size_t c = 0; c < 2; ++c)
  {
    const std::vector<Index>& path = cylinder.Features.CurvePaths[c];
    const EnforcedCurve& curve = geometry.Curves()[c];
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      const CurvePoint to = curve.Closest(points[path[i]]);
      EXPECT_LT(to.Distance, 1e-12);
      const double ahead = to.Arc - curve.Closest(points[path[i - 1]]).Arc + curve.Length();
      EXPECT_NEAR(std::fmod(ahead, curve.Length()), curve.Length() / (path.size() - 1), 0.2);
    }
  }
  for (Index q = 0; q < static_cast<Index>(stars.Quads.size()); ++q)
  {
    EXPECT_FALSE(IsFolded(cylinder.Mesh, stars, targets, q));
  }
}

TEST(BoundarySpreading, TheSameBitsEveryTime)
{
  const auto first = Bodies(), second = Bodies();
  for (std::size_t i = 0; i < first.size(); ++i)
  {
    for (Body* body : { first[i].get(), second[i].get() })
    {
      SpreadAtFeatures(body->Mesh, body->Stars, *body->Targets);
      EXPECT_NE(body->Mesh.Points, body->Before);
    }
    EXPECT_EQ(first[i]->Mesh.Points, second[i]->Mesh.Points);
  }
}

TEST(BoundarySpreading, FoldedWhenTurnedOver)
{
  Body body({ 8, 8, 8 }, Everywhere, Vec3::Zero());
  ASSERT_TRUE(body.Folded().empty());
  const Index quad = RemoteQuad(body);
  for (double angle : { 0.0, 45.0, 90.0, 120.0, 180.0, 240.0, 270.0 })
  {
    body.Mesh.Points = body.Before;
    Turn(body, quad, angle);
    EXPECT_EQ(IsFolded(body.Mesh, body.Stars, *body.Targets, quad), angle > 100 && angle < 260)
      << angle << " degrees"; // quads across a fillet stand steeply
  }
}

TEST(BoundarySpreading, UnfoldingCuresWhatIsTurnedOver)
{
  for (const std::unique_ptr<Body>& made : Bodies())
  {
    Body& body = *made;
    SpreadAtFeatures(body.Mesh, body.Stars, *body.Targets);
    body.Start();
    EXPECT_EQ(UnfoldBoundary(body.Mesh, body.Stars, *body.Targets), 0);
    EXPECT_EQ(body.Mesh.Points, body.Before);

    // One far from all features, and one at a corner.
    const Index remote = RemoteQuad(body);
    const Index atCorner = body.Stars.QuadsOfVertex[body.Features.CornerVertices[0]][0];
    Turn(body, remote, 180);
    Turn(body, atCorner, 180);
    body.Start();
    const std::vector<Index> folded = body.Folded();
    EXPECT_TRUE(std::count(folded.begin(), folded.end(), remote));
    EXPECT_TRUE(std::count(folded.begin(), folded.end(), atCorner));
    EXPECT_EQ(UnfoldBoundary(body.Mesh, body.Stars, *body.Targets),
      static_cast<Index>(folded.size()));
    body.ExpectUnfolded();
    body.ExpectOnFeatures();
    std::vector<Index> start;
    for (Index q : folded)
    {
      start.insert(start.end(), body.Stars.Quads[q].begin(), body.Stars.Quads[q].end());
    }
    const std::vector<int> rings = body.RingsFrom(start);
    for (Index v = 0; v < static_cast<Index>(rings.size()); ++v)
    {
      if (rings[v] < 0 || rings[v] > 2)
      {
        EXPECT_EQ(body.Mesh.Points[v], body.Before[v]);
      }
    }
    EXPECT_EQ(UnfoldBoundary(body.Mesh, body.Stars, *body.Targets), 0);
  }
}

TEST(BoundarySpreading, UntanglingLeavesNothingInvertedOrFolded)
{
  for (const std::unique_ptr<Body>& made : Bodies())
  {
    Body& body = *made;
    const SurfaceGeometry surface(body.Surface);
    for (const bool turned : { false, true })
    {
      body.Mesh.Points = body.Before;
      body.Start();
      if (turned)
      {
        Turn(body, RemoteQuad(body), 180);
      }
      UntangleOptions options;
      options.Features = body.Targets.get();
      UntangleReport report;
      Monitor monitor;
      const std::size_t inverted = InvertedHexes(body.Mesh).size();
      ExpectOk(UntangleHexes(body.Mesh, body.Stars, &surface, options, report, monitor));
      EXPECT_EQ(report.InvertedBefore, static_cast<Index>(inverted));
      EXPECT_GT(report.Sweeps, 0) << "spreading inverts hexes";
      EXPECT_EQ(report.InvertedAfter, 0);
      EXPECT_EQ(report.Folded, 0);
      EXPECT_TRUE(InvertedHexes(body.Mesh).empty());
      body.ExpectUnfolded();
      for (Index v : body.Targets->Vertices())
      {
        const Vec3& p = body.Mesh.Points[v];
        EXPECT_LT((body.Targets->Project(v, p) - p).norm(), 1.0) << "farther than a hex is long";
      }
    }
  }
}

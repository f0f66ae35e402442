// SPDX-License-Identifier: BSD-3-Clause
#include "TriangleSearch.h"

#include "Parallel.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace featurehex
{
namespace
{
constexpr std::size_t TrianglesPerTask = 4096;

/// One Embree device for the process. "threads=1": hierarchies are built by the calling thread, so
/// they don't depend on the machine and don't fight with vtkSMPTools.
RTCDevice Device()
{
  struct Holder
  {
    RTCDevice Handle = rtcNewDevice("threads=1,set_affinity=0");
    ~Holder() { rtcReleaseDevice(this->Handle); }
  };
  static const Holder holder;
  return holder.Handle;
}

/// Barycentric coordinates of the closest point of the triangle a b c to p.
Vec3 ClosestBarycentric(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
  const Vec3 ab = b - a;
  const Vec3 ac = c - a;
  const Vec3 ap = p - a;
  const double d1 = ab.dot(ap);
  const double d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0)
  {
    return Vec3(1, 0, 0);
  }
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp);
  const double d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3)
  {
    return Vec3(0, 1, 0);
  }
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0)
  {
    const double t = d1 > d3 ? d1 / (d1 - d3) : 0.0;
    return Vec3(1 - t, t, 0);
  }
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp);
  const double d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6)
  {
    return Vec3(0, 0, 1);
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0)
  {
    const double t = d2 > d6 ? d2 / (d2 - d6) : 0.0;
    return Vec3(1 - t, 0, t);
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
  {
    const double sum = (d4 - d3) + (d5 - d6);
    const double t = sum > 0 ? (d4 - d3) / sum : 0.0;
    return Vec3(0, 1 - t, t);
  }
  const double sum = va + vb + vc;
  return sum > 0 ? Vec3(1 - vb / sum - vc / sum, vb / sum, vc / sum) : Vec3(1, 0, 0);
}
}

TrianglePoint ClosestPointOnTriangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
  TrianglePoint result;
  result.Barycentric = ClosestBarycentric(p, a, b, c);
  result.Point =
    result.Barycentric[0] * a + result.Barycentric[1] * b + result.Barycentric[2] * c;
  result.Distance = (p - result.Point).norm();
  return result;
}

struct TriangleSearch::Scene
{
  struct Corners
  {
    Vec3 A, B, C;
  };

  /// In Embree's coordinates, rounded outwards.
  struct FloatBox
  {
    std::array<float, 3> Lower, Upper;
  };

  RTCScene Handle = nullptr;
  std::vector<Corners> Triangles;
  std::vector<FloatBox> Boxes; ///< of the triangles, until the hierarchy is built
  Vec3 Center = Vec3::Zero();
  double Scale = 1.0;

  struct Query
  {
    const Scene* Self;
    Vec3 Position;
    TrianglePoint Best;
    float SlackFactor;
    float Slack;
  };

  ~Scene()
  {
    if (this->Handle)
    {
      rtcReleaseScene(this->Handle);
    }
  }

  static void Bounds(const RTCBoundsFunctionArguments* args)
  {
    const Scene& scene = *static_cast<const Scene*>(args->geometryUserPtr);
    const FloatBox& box = scene.Boxes[args->primID];
    std::copy(box.Lower.begin(), box.Lower.end(), &args->bounds_o->lower_x);
    std::copy(box.Upper.begin(), box.Upper.end(), &args->bounds_o->upper_x);
  }

  FloatBox BoxOf(const Corners& t) const
  {
    const Vec3 low = (t.A.cwiseMin(t.B).cwiseMin(t.C) - this->Center) * this->Scale;
    const Vec3 high = (t.A.cwiseMax(t.B).cwiseMax(t.C) - this->Center) * this->Scale;
    const float inf = std::numeric_limits<float>::infinity();
    FloatBox box;
    for (int k = 0; k < 3; ++k)
    {
      box.Lower[k] = std::nextafter(static_cast<float>(low[k]), -inf);
      box.Upper[k] = std::nextafter(static_cast<float>(high[k]), inf);
    }
    return box;
  }

  float Radius(const Query& query, double distance) const
  {
    return static_cast<float>(std::min(distance * this->Scale, 1e30)) * query.SlackFactor +
      query.Slack;
  }

  static bool Visit(RTCPointQueryFunctionArguments* args)
  {
    Query& query = *static_cast<Query*>(args->userPtr);
    const Corners& t = query.Self->Triangles[args->primID];
    const Index id = static_cast<Index>(args->primID);
    const TrianglePoint found = ClosestPointOnTriangle(query.Position, t.A, t.B, t.C);
    const bool tie = found.Distance == query.Best.Distance && id < query.Best.Triangle;
    if (found.Distance < query.Best.Distance || tie)
    {
      query.Best = found;
      query.Best.Triangle = id;
      const float radius = query.Self->Radius(query, found.Distance);
      if (radius < args->query->radius)
      {
        args->query->radius = radius;
        return true;
      }
    }
    return false;
  }
};

TriangleSearch::TriangleSearch() = default;
TriangleSearch::~TriangleSearch() = default;
TriangleSearch::TriangleSearch(TriangleSearch&&) noexcept = default;
TriangleSearch& TriangleSearch::operator=(TriangleSearch&&) noexcept = default;

TriangleSearch::TriangleSearch(
  std::vector<Vec3> points, std::vector<Triangle> triangles, SearchBuild build)
  : MeshPoints(std::move(points))
  , MeshTriangles(std::move(triangles))
  , Hierarchy(std::make_unique<Scene>())
{
  Scene& scene = *this->Hierarchy;
  scene.Triangles.resize(this->MeshTriangles.size());
  this->Normals.resize(this->MeshTriangles.size());
  ParallelFor(this->MeshTriangles.size(), TrianglesPerTask, [&](std::size_t i) {
    const Triangle& t = this->MeshTriangles[i];
    const Vec3& a = this->MeshPoints[t[0]];
    const Vec3& b = this->MeshPoints[t[1]];
    const Vec3& c = this->MeshPoints[t[2]];
    scene.Triangles[i] = { a, b, c };
    const Vec3 normal = (b - a).cross(c - a);
    const double length = normal.norm();
    this->Normals[i] = length > 0 ? Vec3(normal / length) : Vec3(Vec3::Zero());
  });
  Box box;
  for (const Scene::Corners& t : scene.Triangles)
  {
    box.Extend(t.A);
    box.Extend(t.B);
    box.Extend(t.C);
  }
  scene.Center = box.Empty() ? Vec3(Vec3::Zero()) : box.Center();
  const double half = box.Empty() ? 0.0 : 0.5 * box.Size().maxCoeff();
  scene.Scale = half > 0 ? 1.0 / half : 1.0;

  scene.Boxes.resize(scene.Triangles.size());
  ParallelFor(scene.Boxes.size(), TrianglesPerTask,
    [&](std::size_t i) { scene.Boxes[i] = scene.BoxOf(scene.Triangles[i]); });

  const RTCBuildQuality quality =
    build == SearchBuild::Quick ? RTC_BUILD_QUALITY_LOW : RTC_BUILD_QUALITY_MEDIUM;
  RTCGeometry geometry = rtcNewGeometry(Device(), RTC_GEOMETRY_TYPE_USER);
  rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(scene.Triangles.size()));
  rtcSetGeometryUserData(geometry, &scene);
  rtcSetGeometryBoundsFunction(geometry, &Scene::Bounds, nullptr);
  rtcSetGeometryPointQueryFunction(geometry, &Scene::Visit);
  rtcSetGeometryBuildQuality(geometry, quality);
  rtcCommitGeometry(geometry);
  scene.Handle = rtcNewScene(Device());
  rtcSetSceneBuildQuality(scene.Handle, quality);
  rtcAttachGeometry(scene.Handle, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(scene.Handle);
  scene.Boxes = std::vector<Scene::FloatBox>();
}

TrianglePoint TriangleSearch::ClosestOn(const Vec3& p, Index triangle) const
{
  const Scene::Corners& t = this->Hierarchy->Triangles[triangle];
  TrianglePoint result = ClosestPointOnTriangle(p, t.A, t.B, t.C);
  result.Triangle = triangle;
  return result;
}

TrianglePoint TriangleSearch::Closest(const Vec3& p, Index hint, double radius) const
{
  if (!this->Hierarchy || this->Hierarchy->Triangles.empty())
  {
    return {};
  }
  const Scene& scene = *this->Hierarchy;
  const Vec3 q = (p - scene.Center) * scene.Scale;
  Scene::Query query;
  query.Self = &scene;
  query.Position = p;
  query.Best.Distance = radius;
  // Rounding of the query point and of Embree's own box distances, with a wide safety factor.
  query.SlackFactor = 1.0f + 1e-6f;
  query.Slack = 1e-6f * static_cast<float>(1.0 + q.cwiseAbs().maxCoeff());
  if (hint >= 0)
  {
    const TrianglePoint start = this->ClosestOn(p, hint);
    if (start.Distance <= radius)
    {
      query.Best = start;
    }
  }
  RTCPointQuery embreeQuery;
  embreeQuery.x = static_cast<float>(q.x());
  embreeQuery.y = static_cast<float>(q.y());
  embreeQuery.z = static_cast<float>(q.z());
  embreeQuery.time = 0.0f;
  embreeQuery.radius = scene.Radius(query, query.Best.Distance);
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(scene.Handle, &embreeQuery, &context, nullptr, &query);
  if (query.Best.Triangle < 0)
  {
    query.Best.Distance = 1e300;
  }
  return query.Best;
}
}

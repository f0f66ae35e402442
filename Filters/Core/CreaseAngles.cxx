// SPDX-License-Identifier: BSD-3-Clause
#include "CreaseAngles.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
constexpr double Pi = 3.14159265358979323846;
}

CreaseAngles::CreaseAngles(const FeatureGeometry& geometry)
  : Geometry(geometry)
{
  const SurfaceMesh& mesh = geometry.Surface();
  const SurfaceFeatures& features = geometry.Features();
  for (const FeatureCurve& curve : features.Curves)
  {
    for (Index v : curve.Points)
    {
      this->Normals[{ v, curve.LeftPatch }] = Vec3::Zero();
      this->Normals[{ v, curve.RightPatch }] = Vec3::Zero();
    }
  }
  for (std::size_t t = 0; t < mesh.Triangles.size(); ++t)
  {
    const Triangle& triangle = mesh.Triangles[t];
    const Vec3 area = (mesh.Points[triangle[1]] - mesh.Points[triangle[0]])
                        .cross(mesh.Points[triangle[2]] - mesh.Points[triangle[0]]);
    for (Index v : triangle)
    {
      if (const auto found = this->Normals.find({ v, features.PatchOfTriangle[t] });
          found != this->Normals.end())
      {
        found->second += area;
      }
    }
  }
}

double CreaseAngles::InteriorAngle(const FeatureCurve& curve, Index a, Index b) const
{
  const auto normal = [&](int patch) {
    return Vec3(this->Normals.at({ a, patch }) + this->Normals.at({ b, patch })).stableNormalized();
  };
  const Vec3 left = normal(curve.LeftPatch);
  const Vec3 right = normal(curve.RightPatch);
  const std::vector<Vec3>& points = this->Geometry.Surface().Points;
  const Vec3 edge = (points[b] - points[a]).stableNormalized();
  return Pi - std::atan2(left.cross(right).dot(edge), left.dot(right));
}

std::vector<CreaseAngles::Piece> CreaseAngles::Pieces(Index index) const
{
  const FeatureCurve& curve = this->Geometry.Features().Curves[index];
  const std::vector<Vec3>& points = this->Geometry.Surface().Points;
  std::vector<Piece> pieces;
  for (std::size_t i = 1; i < curve.Points.size(); ++i)
  {
    const Index a = curve.Points[i - 1];
    const Index b = curve.Points[i];
    pieces.push_back({ this->InteriorAngle(curve, a, b), (points[b] - points[a]).norm() });
  }
  std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
    return a.Angle < b.Angle || (a.Angle == b.Angle && a.Length < b.Length);
  });
  return pieces;
}

int RightAnglesIn(double angle)
{
  return std::max(1, static_cast<int>(std::lround(angle / (Pi / 2))));
}
} // namespace featurehex

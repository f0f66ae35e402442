// SPDX-License-Identifier: BSD-3-Clause
#include "EnforcedFeatures.h"

#include "PolylineDistance.h"

namespace featurehex
{
std::set<FeatureName> FeaturesAt(
  const HexMesh& mesh, const std::vector<Index>& hexes, const FeatureLabels& labels)
{
  std::set<FeatureName> features;
  for (Index h : hexes)
  {
    for (Index v : mesh.Hexes[h])
    {
      if (labels.Kind[v] >= FeatureKind::Curve)
      {
        features.insert({ labels.Kind[v], labels.Id[v] });
      }
    }
  }
  return features;
}

namespace
{
std::vector<Vec3> PointsOf(const HexMesh& mesh, const std::vector<Index>& path)
{
  std::vector<Vec3> points;
  for (Index v : path)
  {
    points.push_back(mesh.Points[v]);
  }
  return points;
}

/// Points of one polyline, and between them, that are far from another.
void AddFarPoints(
  const std::vector<Vec3>& from, const Polyline& to, double distance, std::vector<Vec3>& places)
{
  for (std::size_t i = 1; i < from.size(); ++i)
  {
    for (double t : { 0.0, 0.25, 0.5, 0.75 })
    {
      const Vec3 p = from[i - 1] + t * (from[i] - from[i - 1]);
      if (to.Closest(p).Distance > distance)
      {
        places.push_back(p);
      }
    }
  }
}
}

std::vector<Vec3> MissedFeaturePlaces(const HexMesh& mesh, const std::vector<Quad>& quads,
  const HexFeatures& features, const FeatureGeometry& geometry,
  const FeatureValidationReport& report, double distance)
{
  std::vector<Vec3> places;
  for (std::size_t c = 0; c < report.Corners.size(); ++c)
  {
    if (report.Corners[c].Outcome == FeatureOutcome::OffPosition)
    {
      places.push_back(geometry.CornerPoint(static_cast<Index>(c)));
    }
  }
  for (std::size_t c = 0; c < report.Curves.size(); ++c)
  {
    if (report.Curves[c].Outcome == FeatureOutcome::OffPosition)
    {
      const Polyline curve(geometry.Curves()[c].Points);
      for (const Vec3& p : PointsOf(mesh, features.CurvePaths[c]))
      {
        if (curve.Closest(p).Distance > 0.5 * report.Curves[c].VertexDeviation)
        {
          places.push_back(p);
        }
      }
    }
    else if (report.Curves[c].Outcome == FeatureOutcome::BeyondTolerance)
    {
      const std::vector<Vec3> chain = PointsOf(mesh, features.CurvePaths[c]);
      const std::vector<Vec3>& curve = geometry.Curves()[c].Points;
      AddFarPoints(chain, Polyline(curve), distance, places);
      AddFarPoints(curve, Polyline(chain), distance, places);
    }
  }
  for (std::size_t q = 0; q < quads.size(); ++q)
  {
    const int patch = features.PatchOfQuad[q];
    if (patch < 0 || report.Patches[patch].Outcome != FeatureOutcome::BeyondTolerance)
    {
      continue;
    }
    const TriangleSearch& search = geometry.Patch(patch).Search();
    Vec3 center = Vec3::Zero();
    for (int k = 0; k < 4; ++k)
    {
      const Vec3& a = mesh.Points[quads[q][k]];
      const Vec3& b = mesh.Points[quads[q][(k + 1) & 3]];
      center += 0.25 * a;
      for (const Vec3& p : { a, Vec3(0.5 * (a + b)) })
      {
        if (search.Closest(p).Distance > distance)
        {
          places.push_back(p);
        }
      }
    }
    if (search.Closest(center).Distance > distance)
    {
      places.push_back(center);
    }
  }
  return places;
}

void EnforcedFeatures::Build(
  const SurfaceMesh& surface, const SurfaceFeatures& features, double trim)
{
  this->Surface = &surface;
  this->Graph = &features;
  this->Trim = trim;
  this->Current = std::make_unique<FeatureGeometry>(surface, features, trim, this->GivenUp);
}

bool EnforcedFeatures::GiveUp(const std::set<FeatureName>& failed, int patience)
{
  const std::size_t before = this->GivenUp.Corners.size() + this->GivenUp.Curves.size();
  for (const FeatureName& feature : failed)
  {
    if (++this->Failures[feature] < patience)
    {
      continue;
    }
    const auto [kind, id] = feature;
    if (kind == FeatureKind::Corner)
    {
      this->GivenUp.Corners.insert(id);
    }
    for (Index c = 0; c < static_cast<Index>(this->Graph->Curves.size()); ++c)
    {
      const FeatureCurve& curve = this->Graph->Curves[c];
      if ((kind == FeatureKind::Curve && id == c) ||
        (kind == FeatureKind::Surface && (curve.LeftPatch == id || curve.RightPatch == id)))
      {
        this->GivenUp.Curves.insert(c);
      }
    }
  }
  if (this->GivenUp.Corners.size() + this->GivenUp.Curves.size() == before)
  {
    return false;
  }
  this->Build(*this->Surface, *this->Graph, this->Trim);
  return true;
}

bool EnforcedFeatures::GiveUpLoose(const std::set<FeatureName>& features)
{
  std::set<FeatureName> loose;
  const auto add = [&](Index c) {
    const EnforcedCurve& curve = this->Current->Curves()[c];
    if (this->Current->PatchOf(curve.LeftPatch) == this->Current->PatchOf(curve.RightPatch))
    {
      loose.insert({ FeatureKind::Curve, c });
    }
  };
  for (const auto& [kind, id] : features)
  {
    if (kind == FeatureKind::Curve)
    {
      add(id);
    }
    for (std::size_t i = 0;
         kind == FeatureKind::Corner && i < this->Current->Fans()[id].Spokes.size(); ++i)
    {
      add(this->Current->Fans()[id].Spokes[i].Curve);
    }
  }
  return this->GiveUp(loose, 1);
}
} // namespace featurehex

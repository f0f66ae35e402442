// SPDX-License-Identifier: BSD-3-Clause
#include "PatchValidation.h"

#include "DisjointSets.h"
#include "Parallel.h"
#include "TriangleSearch.h"

#include <algorithm>
#include <tuple>

namespace featurehex
{
namespace
{
template <typename Face>
std::vector<FaceEdge> EdgesOf(const std::vector<Face>& faces)
{
  std::vector<FaceEdge> edges;
  edges.reserve(faces.size() * std::tuple_size<Face>::value);
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    for (std::size_t k = 0; k < faces[f].size(); ++k)
    {
      const Index a = faces[f][k], b = faces[f][(k + 1) % faces[f].size()];
      edges.push_back({ std::min(a, b), std::max(a, b), static_cast<Index>(f), a < b });
    }
  }
  std::sort(edges.begin(), edges.end(), [](const FaceEdge& a, const FaceEdge& b) {
    return std::tie(a.Low, a.High, a.Face) < std::tie(b.Low, b.High, b.Face);
  });
  return edges;
}

/// Vertices - edges + faces, a vertex once for each fan of faces that are joined through edges.
template <typename Face>
Index EulerCharacteristic(const std::vector<Face>& faces)
{
  constexpr Index corners = std::tuple_size<Face>::value;
  const std::vector<FaceEdge> edges = EdgesOf(faces);
  DisjointSets fans(corners * faces.size());
  const auto slot = [&](Index face, Index vertex)
  {
    return corners * face +
           static_cast<Index>(
             std::find(faces[face].begin(), faces[face].end(), vertex) - faces[face].begin());
  };
  Index numberOfEdges = 0;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    if (i > 0 && edges[i].Joins(edges[i - 1]))
    {
      for (Index v : { edges[i].Low, edges[i].High })
      {
        fans.Join(slot(edges[i - 1].Face, v), slot(edges[i].Face, v));
      }
    }
    else
    {
      ++numberOfEdges;
    }
  }
  Index vertices = 0;
  for (Index i = 0; i < corners * static_cast<Index>(faces.size()); ++i)
  {
    vertices += fans.Find(i) == i;
  }
  return vertices - numberOfEdges + static_cast<Index>(faces.size());
}

/// The triangles with only the points they use.
TriangleSearch SearchIn(const std::vector<Vec3>& points, std::vector<Triangle> triangles)
{
  std::vector<Index> used;
  for (const Triangle& t : triangles)
  {
    used.insert(used.end(), t.begin(), t.end());
  }
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  for (Triangle& t : triangles)
  {
    for (Index& v : t)
    {
      v = static_cast<Index>(std::lower_bound(used.begin(), used.end(), v) - used.begin());
    }
  }
  std::vector<Vec3> own;
  for (Index v : used)
  {
    own.push_back(points[v]);
  }
  return TriangleSearch(std::move(own), std::move(triangles));
}

std::string Name(const char* kind, Index id)
{
  return std::string(kind) + " " + std::to_string(id);
}

class PatchJudge
{
public:
  PatchJudge(const HexMesh& mesh, const HexBoundary& boundary, const SurfaceMesh& surface,
    const FeatureCorrespondence& features)
    : Mesh(mesh)
    , Boundary(boundary)
    , Surface(surface)
    , Graph(*features.OfSurface)
    , Labels(features.OfMesh->PatchOfQuad)
    , Findings(features.OfSurface->NumberOfPatches)
    , QuadsOfPatch(features.OfSurface->NumberOfPatches)
    , TrianglesOfPatch(features.OfSurface->NumberOfPatches)
    , Merged(features.OfSurface->NumberOfPatches)
  {
  }

  std::vector<FeatureFinding> Judge(
    const std::vector<ChainEdge>& chains, const std::vector<Index>& absent, double tolerance);

private:
  void MergePatches();
  void SortFaces();
  void CheckEdges(const std::vector<ChainEdge>& chains);
  void CheckPieces(DisjointSets& pieces);
  void CheckShape(int patch, double tolerance);
  void Blame(int patch, FeatureOutcome outcome, const std::string& reason);
  int PatchOf(Index quad) const;

  const HexMesh& Mesh;
  const HexBoundary& Boundary;
  const SurfaceMesh& Surface;
  const SurfaceFeatures& Graph;
  const std::vector<int>& Labels;
  std::vector<FeatureFinding> Findings;
  std::vector<std::vector<Quad>> QuadsOfPatch;
  std::vector<std::vector<Triangle>> TrianglesOfPatch;
  std::vector<int> Merged; ///< the lowest patch of those that nothing parts
};

/// The first finding counts, except that those with a lower value are more basic.
void PatchJudge::Blame(int patch, FeatureOutcome outcome, const std::string& reason)
{
  if (patch < 0)
  {
    return;
  }
  FeatureFinding& finding = this->Findings[patch];
  if (finding.Captured() || outcome < finding.Outcome)
  {
    finding.Outcome = outcome;
    finding.Reason = reason;
  }
}

int PatchJudge::PatchOf(Index quad) const
{
  const int label = quad < static_cast<Index>(this->Labels.size()) ? this->Labels[quad] : -1;
  return label >= 0 && label < this->Graph.NumberOfPatches ? this->Merged[label] : -1;
}

void PatchJudge::MergePatches()
{
  DisjointSets sets(this->Merged.size());
  for (const FeatureCurve& curve : this->Graph.Curves)
  {
    for (Index corner : { curve.FirstCorner, curve.LastCorner })
    {
      if (corner >= 0 && !this->Graph.Corners[corner].Valid())
      {
        sets.Join(curve.LeftPatch, curve.RightPatch);
      }
    }
  }
  for (std::size_t p = 0; p < this->Merged.size(); ++p)
  {
    this->Merged[p] = sets.Find(static_cast<Index>(p));
  }
}

void PatchJudge::SortFaces()
{
  for (std::size_t q = 0; q < this->Boundary.Quads.size(); ++q)
  {
    if (const int patch = this->PatchOf(static_cast<Index>(q)); patch >= 0)
    {
      this->QuadsOfPatch[patch].push_back(this->Boundary.Quads[q]);
    }
  }
  for (std::size_t t = 0; t < this->Surface.Triangles.size(); ++t)
  {
    this->TrianglesOfPatch[this->Merged[this->Graph.PatchOfTriangle[t]]].push_back(
      this->Surface.Triangles[t]);
  }
}

/// Every chain has its two patches on the right sides, and nothing else parts patches.
void PatchJudge::CheckEdges(const std::vector<ChainEdge>& chains)
{
  DisjointSets pieces(this->Boundary.Quads.size());
  const std::vector<FaceEdge> edges = EdgesOf(this->Boundary.Quads);
  for (std::size_t i = 0; i + 1 < edges.size(); ++i)
  {
    const FaceEdge& one = edges[i];
    const FaceEdge& other = edges[i + 1];
    if (!one.Joins(other))
    {
      continue;
    }
    const int upward = this->PatchOf(one.Upward ? one.Face : other.Face);
    const int downward = this->PatchOf(one.Upward ? other.Face : one.Face);
    const auto chain = std::lower_bound(chains.begin(), chains.end(), one,
      [](const ChainEdge& a, const FaceEdge& b)
      { return std::tie(a.Low, a.High) < std::tie(b.Low, b.High); });
    if (chain == chains.end() || chain->Low != one.Low || chain->High != one.High)
    {
      if (upward == downward)
      {
        pieces.Join(one.Face, other.Face);
        continue;
      }
      const std::string reason = "parted from " + Name("patch", downward) + " by no curve";
      this->Blame(upward, FeatureOutcome::WrongBoundary, reason);
      this->Blame(downward, FeatureOutcome::WrongBoundary,
        "parted from " + Name("patch", upward) + " by no curve");
      continue;
    }
    const FeatureCurve& curve = this->Graph.Curves[chain->Curve];
    const int left = this->Merged[curve.LeftPatch], right = this->Merged[curve.RightPatch];
    if ((chain->Upward ? upward : downward) != left || (chain->Upward ? downward : upward) != right)
    {
      for (int patch : { left, right, upward, downward })
      {
        this->Blame(patch, FeatureOutcome::WrongBoundary,
          "not on its side of " + Name("curve", chain->Curve));
      }
    }
  }
  this->CheckPieces(pieces);
}

void PatchJudge::CheckPieces(DisjointSets& pieces)
{
  std::vector<Index> count(this->Merged.size(), 0);
  for (Index q = 0; q < static_cast<Index>(this->Boundary.Quads.size()); ++q)
  {
    if (const int patch = this->PatchOf(q); patch >= 0)
    {
      count[patch] += pieces.Find(q) == q;
    }
  }
  for (std::size_t p = 0; p < count.size(); ++p)
  {
    if (count[p] == 0)
    {
      this->Blame(static_cast<int>(p), FeatureOutcome::NotMapped, "no boundary quad stands for it");
    }
    else if (count[p] > 1)
    {
      this->Blame(static_cast<int>(p), FeatureOutcome::InPieces,
        "its quads are " + std::to_string(count[p]) + " pieces");
    }
  }
}

/// Euler characteristic, distance.
void PatchJudge::CheckShape(int patch, double tolerance)
{
  const std::vector<Quad>& quads = this->QuadsOfPatch[patch];
  const Index found = EulerCharacteristic(quads);
  const Index wanted = EulerCharacteristic(this->TrianglesOfPatch[patch]);
  if (found != wanted)
  {
    this->Blame(patch, FeatureOutcome::WrongTopology,
      "Euler characteristic " + std::to_string(found) + " instead of " + std::to_string(wanted));
  }
  const TriangleSearch search =
    SearchIn(this->Surface.Points, this->TrianglesOfPatch[patch]);
  double deviation = 0.0;
  for (const Quad& quad : quads)
  {
    Vec3 center = Vec3::Zero();
    for (int k = 0; k < 4; ++k)
    {
      const Vec3& p = this->Mesh.Points[quad[k]];
      const Vec3 middle = 0.5 * (p + this->Mesh.Points[quad[(k + 1) % 4]]);
      center += 0.25 * p;
      deviation =
        std::max({ deviation, search.Closest(p).Distance, search.Closest(middle).Distance });
    }
    deviation = std::max(deviation, search.Closest(center).Distance);
  }
  this->Findings[patch].Deviation = deviation;
  if (deviation > tolerance && this->Findings[patch].Captured())
  {
    this->Blame(patch, FeatureOutcome::BeyondTolerance, "its quads leave the tolerance");
  }
}

std::vector<FeatureFinding> PatchJudge::Judge(
  const std::vector<ChainEdge>& chains, const std::vector<Index>& absent, double tolerance)
{
  this->MergePatches();
  this->SortFaces();
  this->CheckEdges(chains);
  for (Index c : absent)
  {
    const FeatureCurve& curve = this->Graph.Curves[c];
    for (int patch : { curve.LeftPatch, curve.RightPatch })
    {
      this->Blame(this->Merged[patch], FeatureOutcome::WrongBoundary,
        Name("curve", c) + " isn't in the mesh");
    }
  }
  ParallelFor(this->Findings.size(), 1, [&](std::size_t p) {
    if (!this->QuadsOfPatch[p].empty())
    {
      this->CheckShape(static_cast<int>(p), tolerance);
    }
  });

  std::vector<Index> members(this->Merged.size(), 0);
  for (int patch : this->Merged)
  {
    ++members[patch];
  }
  std::vector<bool> placed(this->Merged.size(), false);
  for (std::size_t t = 0; t < this->Surface.Triangles.size(); ++t)
  {
    const int patch = this->Graph.PatchOfTriangle[t];
    if (!placed[patch])
    {
      const Triangle& v = this->Surface.Triangles[t];
      this->Findings[patch].Where =
        (this->Surface.Points[v[0]] + this->Surface.Points[v[1]] + this->Surface.Points[v[2]]) /
        3.0;
      placed[patch] = true;
    }
  }
  for (std::size_t p = 0; p < this->Findings.size(); ++p)
  {
    if (members[this->Merged[p]] > 1)
    {
      FeatureFinding& finding = this->Findings[p];
      finding.Outcome = FeatureOutcome::NotEnforced;
      finding.Reason = "one with others round a corner that is not enforced";
      finding.Deviation = this->Findings[this->Merged[p]].Deviation;
    }
  }
  return std::move(this->Findings);
}
}

std::vector<FaceEdge> SortedEdges(const std::vector<Quad>& quads)
{
  return EdgesOf(quads);
}

std::vector<FeatureFinding> ValidatePatches(const HexMesh& mesh, const HexBoundary& boundary,
  const SurfaceMesh& surface, const FeatureCorrespondence& features,
  const std::vector<ChainEdge>& chains, const std::vector<Index>& absent, double tolerance)
{
  return PatchJudge(mesh, boundary, surface, features).Judge(chains, absent, tolerance);
}
}

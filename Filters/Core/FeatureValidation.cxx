// SPDX-License-Identifier: BSD-3-Clause
#include "FeatureValidation.h"

#include "MessageText.h"
#include "Parallel.h"
#include "PatchValidation.h"
#include "PolylineDistance.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace featurehex
{
namespace
{
std::string Percent(double value)
{
  return NumberText(100.0 * value, 3) + " %";
}

const char* FlawText(CornerFlaw flaw)
{
  return flaw == CornerFlaw::ManyCurves ? "more than six curves meet"
                                        : "two curves meet at less than 30 degrees";
}

/// A chain as it was found, in the direction of its curve where that could be told.
struct Chain
{
  std::vector<Index> Vertices; ///< empty: none, or with ids that don't exist
  FeatureFinding Finding;

  /// The first finding stays.
  void Blame(FeatureOutcome outcome, const std::string& reason)
  {
    if (this->Finding.Captured())
    {
      this->Finding.Outcome = outcome;
      this->Finding.Reason = reason;
    }
  }
};

class CurveJudge
{
public:
  CurveJudge(const HexMesh& mesh, const HexBoundary& boundary, const SurfaceMesh& surface,
    const FeatureCorrespondence& features, double diagonal, double tolerance)
    : Mesh(mesh)
    , Surface(surface)
    , Graph(*features.OfSurface)
    , Image(*features.OfMesh)
    , Diagonal(diagonal)
    , Tolerance(tolerance)
    , Edges(SortedEdges(boundary.Quads))
    , OnBoundary(mesh.Points.size(), 0)
    , CornersAt(mesh.Points.size(), 0)
    , Uses(mesh.Points.size(), 0)
    , Chains(features.OfSurface->Curves.size())
  {
    for (const Quad& quad : boundary.Quads)
    {
      for (Index v : quad)
      {
        this->OnBoundary[v] = 1;
      }
    }
  }

  std::vector<FeatureFinding> JudgeCorners();
  std::vector<FeatureFinding> JudgeCurves();
  std::vector<ChainEdge> ChainEdges() const;
  std::vector<Index> AbsentCurves() const;

private:
  bool Exists(Index v) const { return v >= 0 && v < static_cast<Index>(this->Mesh.Points.size()); }
  Index CornerVertex(Index corner) const
  {
    return corner >= 0 && corner < static_cast<Index>(this->Image.CornerVertices.size())
      ? this->Image.CornerVertices[corner]
      : -1;
  }
  bool Enforced(Index corner) const { return corner < 0 || this->Graph.Corners[corner].Valid(); }
  Index FlawedEnd(const FeatureCurve& curve) const
  {
    return !this->Enforced(curve.FirstCorner) ? curve.FirstCorner
      : !this->Enforced(curve.LastCorner)     ? curve.LastCorner
                                              : -1;
  }
  bool IsBoundaryEdge(Index a, Index b) const;
  bool IsLoop(const FeatureCurve& curve) const { return curve.FirstCorner < 0; }
  void CollectChains();
  void CountUses();
  void CheckPath(const FeatureCurve& curve, Chain& chain) const;
  void CheckEnds(const FeatureCurve& curve, Chain& chain) const;
  void CheckShape(const FeatureCurve& curve, Chain& chain) const;
  void MeasureBothWays(const FeatureCurve& curve, const Polyline& line, double from, double to,
    Chain& chain) const;

  const HexMesh& Mesh;
  const SurfaceMesh& Surface;
  const SurfaceFeatures& Graph;
  const HexFeatures& Image;
  double Diagonal, Tolerance; ///< model units
  std::vector<FaceEdge> Edges;
  std::vector<char> OnBoundary;
  std::vector<Index> CornersAt; ///< corners that have this vertex
  std::vector<Index> Uses;      ///< chains that pass through the vertex
  std::vector<Chain> Chains;
};

std::vector<FeatureFinding> CurveJudge::JudgeCorners()
{
  std::vector<FeatureFinding> findings(this->Graph.Corners.size());
  for (std::size_t c = 0; c < findings.size(); ++c)
  {
    if (const Index v = this->CornerVertex(static_cast<Index>(c)); this->Exists(v))
    {
      ++this->CornersAt[v];
    }
  }
  for (std::size_t c = 0; c < findings.size(); ++c)
  {
    const FeatureCorner& corner = this->Graph.Corners[c];
    const Index v = this->CornerVertex(static_cast<Index>(c));
    FeatureFinding& finding = findings[c];
    finding.Where = this->Surface.Points[corner.Point];
    if (!corner.Valid())
    {
      finding.Outcome = FeatureOutcome::NotEnforced;
      finding.Reason = FlawText(corner.Flaw);
      continue;
    }
    if (!this->Exists(v) || !this->OnBoundary[v] || this->CornersAt[v] > 1)
    {
      finding.Outcome = FeatureOutcome::NotMapped;
      finding.Reason = v < 0         ? "no vertex stands for it"
        : !this->Exists(v)           ? "its vertex doesn't exist"
        : this->CornersAt[v] > 1     ? "its vertex stands for other corners, too"
                                     : "its vertex isn't on the boundary";
      continue;
    }
    finding.Deviation = (this->Mesh.Points[v] - finding.Where).norm();
    if (finding.Deviation > CornerAccuracy * this->Diagonal)
    {
      finding.Outcome = FeatureOutcome::OffPosition;
      finding.Reason = "its vertex is " + Percent(finding.Deviation / this->Diagonal) +
        " of the diagonal away";
    }
  }
  return findings;
}

bool CurveJudge::IsBoundaryEdge(Index a, Index b) const
{
  FaceEdge wanted;
  wanted.Low = std::min(a, b);
  wanted.High = std::max(a, b);
  const auto found =
    std::lower_bound(this->Edges.begin(), this->Edges.end(), wanted, Before);
  return found != this->Edges.end() && found->Joins(wanted);
}

void CurveJudge::CollectChains()
{
  for (std::size_t c = 0; c < this->Chains.size(); ++c)
  {
    Chain& chain = this->Chains[c];
    if (c < this->Image.CurvePaths.size())
    {
      chain.Vertices = this->Image.CurvePaths[c];
    }
    if (chain.Vertices.size() < 2)
    {
      chain.Vertices.clear();
      chain.Blame(FeatureOutcome::NotMapped, "no chain of edges stands for it");
    }
    else if (!std::all_of(chain.Vertices.begin(), chain.Vertices.end(),
               [&](Index v) { return this->Exists(v); }))
    {
      chain.Vertices.clear();
      chain.Blame(FeatureOutcome::BrokenPath, "vertices of its chain don't exist");
    }
  }
}

void CurveJudge::CountUses()
{
  for (const Chain& chain : this->Chains)
  {
    // Of a loop the first vertex is the last one again.
    const bool closed =
      !chain.Vertices.empty() && chain.Vertices.front() == chain.Vertices.back();
    for (std::size_t i = closed ? 1 : 0; i < chain.Vertices.size(); ++i)
    {
      const bool end = i == 0 || i + 1 == chain.Vertices.size();
      if (!end || this->CornersAt[chain.Vertices[i]] == 0)
      {
        ++this->Uses[chain.Vertices[i]];
      }
    }
  }
}

void CurveJudge::CheckPath(const FeatureCurve& curve, Chain& chain) const
{
  const std::vector<Index>& path = chain.Vertices;
  for (std::size_t i = 1; i < path.size(); ++i)
  {
    if (!this->IsBoundaryEdge(path[i - 1], path[i]))
    {
      chain.Blame(FeatureOutcome::BrokenPath,
        "no boundary edge from vertex " + std::to_string(path[i - 1]) + " to " +
          std::to_string(path[i]));
    }
    const bool inner = i + 1 < path.size();
    if (inner && this->CornersAt[path[i]] > 0)
    {
      chain.Blame(FeatureOutcome::BrokenPath,
        "its chain passes through the corner vertex " + std::to_string(path[i]));
    }
    if (this->Uses[path[i]] > 1)
    {
      chain.Blame(FeatureOutcome::BrokenPath,
        "vertex " + std::to_string(path[i]) + " is passed more than once");
    }
  }
  if (this->IsLoop(curve) && path.front() != path.back())
  {
    chain.Blame(FeatureOutcome::BrokenPath, "its chain isn't closed");
  }
  if (path.front() == path.back() && path.size() < 4)
  {
    chain.Blame(FeatureOutcome::BrokenPath, "its loop has less than three edges");
  }
}

void CurveJudge::CheckEnds(const FeatureCurve& curve, Chain& chain) const
{
  const auto check = [&](Index corner, Index vertex) {
    if (corner >= 0 && this->Enforced(corner) && this->CornerVertex(corner) != vertex)
    {
      chain.Blame(FeatureOutcome::WrongEnd,
        "ends at vertex " + std::to_string(vertex) + ", not at that of corner " +
          std::to_string(corner));
    }
  };
  check(curve.FirstCorner, chain.Vertices.front());
  check(curve.LastCorner, chain.Vertices.back());
}

/// +1: the arcs run once along the curve, -1: against it, 0: neither. @a period: length of a closed
/// curve, 0: open. Steps back by less than @a slack don't count.
int DirectionOf(const std::vector<double>& arcs, double period, double slack)
{
  bool forward = true, backward = true;
  double ahead = 0.0, back = 0.0;
  for (std::size_t i = 1; i < arcs.size(); ++i)
  {
    const double step = arcs[i] - arcs[i - 1];
    forward = forward && step >= -slack;
    backward = backward && step <= slack;
    const auto around = [&](double s) {
      const double turned = s - std::floor(s / period) * period;
      return turned > period - slack ? turned - period : turned;
    };
    ahead += period > 0.0 ? around(step) : 0.0;
    back += period > 0.0 ? around(-step) : 0.0;
  }
  if (period > 0.0)
  {
    forward = std::abs(ahead - period) < 0.5 * period;
    backward = std::abs(back - period) < 0.5 * period;
  }
  return forward ? 1 : backward ? -1 : 0;
}

void CurveJudge::CheckShape(const FeatureCurve& curve, Chain& chain) const
{
  std::vector<Vec3> points;
  for (Index v : curve.Points)
  {
    points.push_back(this->Surface.Points[v]);
  }
  const Polyline line(std::move(points));
  std::vector<double> arcs;
  double worst = 0.0;
  for (Index v : chain.Vertices)
  {
    const PolylinePoint closest = line.Closest(this->Mesh.Points[v]);
    arcs.push_back(closest.Arc);
    worst = std::max(worst, closest.Distance);
  }
  chain.Finding.VertexDeviation = worst;
  if (worst > CurveAccuracy * this->Diagonal)
  {
    chain.Blame(FeatureOutcome::OffPosition,
      "a vertex of its chain is " + Percent(worst / this->Diagonal) + " of the diagonal away");
  }
  const bool cut = this->FlawedEnd(curve) >= 0;
  const bool closed = curve.Closed() && !cut;
  // Vertices that are off the curve make their arcs uncertain by as much.
  const double slack = CurveAccuracy * this->Diagonal + 2.0 * worst;
  int direction = DirectionOf(arcs, closed ? line.Length() : 0.0, slack);
  if (direction < 0 && (this->IsLoop(curve) || cut || closed))
  {
    std::reverse(chain.Vertices.begin(), chain.Vertices.end());
    direction = 1;
  }
  if (direction != 1)
  {
    chain.Blame(FeatureOutcome::BrokenPath, "its chain runs back along the curve");
  }
  this->MeasureBothWays(curve, line, *std::min_element(arcs.begin(), arcs.end()),
    *std::max_element(arcs.begin(), arcs.end()), chain);
}

void CurveJudge::MeasureBothWays(const FeatureCurve& curve, const Polyline& line, double from,
  double to, Chain& chain) const
{
  std::vector<Vec3> points;
  for (Index v : chain.Vertices)
  {
    points.push_back(this->Mesh.Points[v]);
  }
  const Polyline path(std::move(points));
  const double accuracy = std::min(0.01 * this->Tolerance, CurveAccuracy * this->Diagonal);
  const Index flawed = this->FlawedEnd(curve);
  const LengthBounds there = LargestDistance(path, line, accuracy);
  const LengthBounds back =
    LargestDistance(flawed >= 0 ? line.Between(from, to) : line, path, accuracy);
  chain.Finding.Deviation = std::max(there.Upper, back.Upper);
  if (chain.Finding.Deviation > this->Tolerance)
  {
    chain.Blame(FeatureOutcome::BeyondTolerance,
      "chain and curve are " + Percent(chain.Finding.Deviation / this->Diagonal) +
        " of the diagonal apart");
  }
  if (flawed >= 0)
  {
    chain.Finding.Reason = "; followed over " +
      Percent(line.Length() > 0.0 ? (to - from) / line.Length() : 0.0) + " of its length" +
      (chain.Finding.Captured() ? "" : ", but " + chain.Finding.Reason);
  }
}

std::vector<FeatureFinding> CurveJudge::JudgeCurves()
{
  this->CollectChains();
  this->CountUses();
  ParallelFor(this->Chains.size(), 1, [&](std::size_t c) {
    const FeatureCurve& curve = this->Graph.Curves[c];
    Chain& chain = this->Chains[c];
    const std::vector<Index>& points = curve.Points;
    chain.Finding.Where = 0.5 *
      (this->Surface.Points[points[(points.size() - 1) / 2]] +
        this->Surface.Points[points[points.size() / 2]]);
    if (!chain.Vertices.empty())
    {
      this->CheckEnds(curve, chain);
      this->CheckPath(curve, chain);
      this->CheckShape(curve, chain);
    }
    if (const Index flawed = this->FlawedEnd(curve); flawed >= 0)
    {
      chain.Finding.Outcome = FeatureOutcome::NotEnforced;
      chain.Finding.Reason = "ends at corner " + std::to_string(flawed) + ", where " +
        FlawText(this->Graph.Corners[flawed].Flaw) +
        (chain.Vertices.empty() ? "; not in the mesh" : chain.Finding.Reason);
    }
  });
  std::vector<FeatureFinding> findings;
  for (const Chain& chain : this->Chains)
  {
    findings.push_back(chain.Finding);
  }
  return findings;
}

std::vector<ChainEdge> CurveJudge::ChainEdges() const
{
  std::vector<ChainEdge> edges;
  for (std::size_t c = 0; c < this->Chains.size(); ++c)
  {
    const std::vector<Index>& path = this->Chains[c].Vertices;
    for (std::size_t i = 1; i < path.size(); ++i)
    {
      const Index a = path[i - 1], b = path[i];
      edges.push_back({ std::min(a, b), std::max(a, b), static_cast<Index>(c), a < b });
    }
  }
  std::sort(edges.begin(), edges.end(), [](const ChainEdge& a, const ChainEdge& b) {
    return std::tie(a.Low, a.High, a.Curve) < std::tie(b.Low, b.High, b.Curve);
  });
  return edges;
}

std::vector<Index> CurveJudge::AbsentCurves() const
{
  std::vector<Index> absent;
  for (std::size_t c = 0; c < this->Chains.size(); ++c)
  {
    if (this->Chains[c].Vertices.empty() && this->Chains[c].Finding.Enforced())
    {
      absent.push_back(static_cast<Index>(c));
    }
  }
  return absent;
}

/// An edge in two chains belongs to neither.
void BlameSharedEdges(const std::vector<ChainEdge>& edges, std::vector<FeatureFinding>& curves)
{
  for (std::size_t i = 1; i < edges.size(); ++i)
  {
    if (edges[i].Low != edges[i - 1].Low || edges[i].High != edges[i - 1].High)
    {
      continue;
    }
    for (const ChainEdge& edge : { edges[i - 1], edges[i] })
    {
      FeatureFinding& finding = curves[edge.Curve];
      if (finding.Captured())
      {
        finding.Outcome = FeatureOutcome::BrokenPath;
        finding.Reason = "an edge of its chain is in another chain, too";
      }
    }
  }
}

std::string Missed(const std::vector<FeatureFinding>& findings, const char* kind, const char* kinds)
{
  const FeatureTotals totals = FeatureValidationReport::Sum(findings);
  const Index missed = totals.Enforced - totals.Captured;
  if (missed == 0)
  {
    return "";
  }
  const auto first = std::find_if(findings.begin(), findings.end(),
    [](const FeatureFinding& f) { return f.Enforced() && !f.Captured(); });
  return std::to_string(missed) + " of " + std::to_string(totals.Enforced) + " " +
    (totals.Enforced == 1 ? kind : kinds) + " missed (" + kind + " " +
    std::to_string(first - findings.begin()) + " at " + PlaceText(first->Where) + ": " +
    first->Reason + ")";
}
}

const char* FeatureOutcomeName(FeatureOutcome outcome)
{
  constexpr const char* names[] = { "Captured", "NotEnforced", "NotMapped", "OffPosition",
    "BrokenPath", "WrongEnd", "BeyondTolerance", "InPieces", "WrongBoundary", "WrongTopology" };
  return names[static_cast<int>(outcome)];
}

FeatureTotals FeatureValidationReport::Sum(const std::vector<FeatureFinding>& findings)
{
  FeatureTotals totals;
  totals.Found = static_cast<Index>(findings.size());
  for (const FeatureFinding& finding : findings)
  {
    if (finding.Enforced())
    {
      ++totals.Enforced;
      totals.Captured += finding.Captured();
      totals.Deviation = std::max(totals.Deviation, finding.Deviation);
      totals.VertexDeviation = std::max(totals.VertexDeviation, finding.VertexDeviation);
    }
  }
  return totals;
}

bool FeatureValidationReport::AllCaptured() const
{
  const auto good = [](const FeatureFinding& f) { return f.Captured() || !f.Enforced(); };
  return std::all_of(this->Corners.begin(), this->Corners.end(), good) &&
    std::all_of(this->Curves.begin(), this->Curves.end(), good) &&
    std::all_of(this->Patches.begin(), this->Patches.end(), good);
}

std::string FeatureValidationReport::Complaint() const
{
  std::string text;
  for (const std::string& part : { Missed(this->Corners, "corner", "corners"),
         Missed(this->Curves, "curve", "curves"), Missed(this->Patches, "patch", "patches") })
  {
    text += (text.empty() || part.empty() ? "" : "; ") + part;
  }
  return text;
}

FeatureValidationReport ValidateFeatures(const HexMesh& mesh, const HexBoundary& boundary,
  const SurfaceMesh& surface, const FeatureCorrespondence& features, double tolerance)
{
  FeatureValidationReport report;
  report.Diagonal = BoundingBox(surface).Diagonal();
  CurveJudge judge(
    mesh, boundary, surface, features, report.Diagonal, tolerance * report.Diagonal);
  report.Corners = judge.JudgeCorners();
  report.Curves = judge.JudgeCurves();
  const std::vector<ChainEdge> edges = judge.ChainEdges();
  BlameSharedEdges(edges, report.Curves);
  report.Patches = ValidatePatches(mesh, boundary, surface, features, edges, judge.AbsentCurves(),
    tolerance * report.Diagonal);
  return report;
}
}

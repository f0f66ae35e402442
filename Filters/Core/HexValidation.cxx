// SPDX-License-Identifier: BSD-3-Clause

#include "HexValidation.h"

#include "HexCertificate.h"
#include "MessageText.h"

#include <algorithm>
#include <cmath>

namespace featurehex
{
namespace
{
/// Defects by hex while they are collected.
using Defects = std::vector<std::uint32_t>;

void MarkIf(std::uint32_t& defects, bool condition, HexDefect defect)
{
  defects |= condition ? static_cast<std::uint32_t>(defect) : 0u;
}

bool HexIsFinite(const HexMesh& mesh, const Hex& hex)
{
  return std::all_of(
    hex.begin(), hex.end(), [&](Index v) { return mesh.Points[v].allFinite(); });
}

/// False when an id does not exist: then nothing else can be asked.
bool CheckIds(const HexMesh& mesh, Defects& defects)
{
  const auto count = static_cast<Index>(mesh.Points.size());
  bool good = true;
  for (std::size_t h = 0; h < mesh.Hexes.size(); ++h)
  {
    for (Index v : mesh.Hexes[h])
    {
      if (v < 0 || v >= count)
      {
        defects[h] |= IdOutOfRange;
        good = false;
      }
    }
  }
  return good;
}

void MeasureElements(const HexMesh& mesh, HexValidationReport& r, Defects& defects)
{
  for (const Vec3& p : mesh.Points)
  {
    r.NonFinitePoints += !p.allFinite();
  }
  r.ScaledJacobians = ScaledJacobians(mesh);
  r.Quality = SummarizeQuality(r.ScaledJacobians);
  const std::vector<HexCertificate> certificates = CertifyHexes(mesh);
  r.MinimumJacobianRatio = certificates.empty() ? 0.0 : 1.0;
  for (std::size_t h = 0; h < certificates.size(); ++h)
  {
    const HexCertificate& c = certificates[h];
    r.CertifiedValid += c.State == Validity::Valid;
    r.CertifiedInvalid += c.State == Validity::Invalid;
    r.CertifiedUndecided += c.State == Validity::Undecided;
    r.MinimumJacobianRatio = std::min(r.MinimumJacobianRatio, c.Ratio());
    r.Volume += c.Volume;
    MarkIf(defects[h], !(r.ScaledJacobians[h] > 0.0), NonPositiveCorner);
    MarkIf(defects[h], c.State != Validity::Valid, NotCertified);
    MarkIf(defects[h], !HexIsFinite(mesh, mesh.Hexes[h]), NonFinitePoint);
  }
}

void MeasureTopology(const HexMesh& mesh, HexValidationReport& r, Defects& defects)
{
  r.Topology = AnalyzeHexMesh(mesh);
  const auto mark = [&](const std::vector<Index>& hexes, HexDefect defect) {
    for (Index h : hexes)
    {
      defects[h] |= defect;
    }
  };
  mark(r.Topology.DegenerateHexIds, RepeatedId);
  mark(r.Topology.DuplicateHexIds, DuplicateHex);
  mark(r.Topology.Defects.Overused, OverusedFaceHex);
  mark(r.Topology.Defects.Twisted, TwistedFaceHex);
  mark(r.Topology.Defects.Misoriented, MisorientedFaceHex);

  const SurfaceTopology& surface = r.Topology.Surface;
  const HexBoundary& boundary = r.Topology.Boundary;
  for (std::size_t q = 0; q < boundary.Quads.size(); ++q)
  {
    for (int k = 0; k < 4; ++k)
    {
      const Index a = boundary.Quads[q][k], b = boundary.Quads[q][(k + 1) % 4];
      const std::array<Index, 2> edge{ std::min(a, b), std::max(a, b) };
      if (std::binary_search(surface.BadVertices.begin(), surface.BadVertices.end(), a) ||
        std::binary_search(surface.BadEdges.begin(), surface.BadEdges.end(), edge))
      {
        defects[boundary.Owners[q]] |= NonManifoldBoundary;
      }
    }
  }
}

void MeasureIntersections(
  const HexMesh& mesh, HexValidationReport& r, Defects& defects, Monitor& monitor)
{
  const HexBoundary& boundary = r.Topology.Boundary;
  const BoundaryIntersections found =
    FindBoundaryIntersections(mesh.Points, boundary.Quads, monitor);
  r.IntersectionsChecked = true;
  r.SelfIntersections = found.Pairs;
  r.SuspectQuads = found.SuspectQuads;
  for (Index q : found.Quads)
  {
    defects[boundary.Owners[q]] |= SelfIntersecting;
  }
}

/// Hexes of the quads that are too far away, and of those nearest to surface points that are.
void MarkFarHexes(const HexMesh& mesh, const HexValidationReport& r, Defects& defects)
{
  const HexBoundary& boundary = r.Topology.Boundary;
  const double tolerance = r.Tolerance * r.Diagonal;
  // Where points beyond the tolerance are known, the bounds of other quads may be loose.
  const bool known = r.Distance.Lower() > tolerance;
  const std::vector<double>& deviation =
    known ? r.Distance.DeviationFound : r.Distance.Deviation;
  for (std::size_t q = 0; q < boundary.Quads.size(); ++q)
  {
    if (deviation[q] > tolerance)
    {
      defects[boundary.Owners[q]] |= BeyondTolerance;
    }
  }
  if (r.Distance.SurfaceToMesh.Witnesses.empty() || r.NonFinitePoints > 0)
  {
    return;
  }
  std::vector<Triangle> triangles;
  for (const Quad& q : boundary.Quads)
  {
    triangles.push_back({ q[0], q[1], q[2] });
    triangles.push_back({ q[0], q[2], q[3] });
  }
  const TriangleSearch search(mesh.Points, std::move(triangles), SearchBuild::Quick);
  for (const DistanceWitness& w : r.Distance.SurfaceToMesh.Witnesses)
  {
    const Index triangle = search.Closest(w.Point).Triangle;
    if (triangle >= 0)
    {
      defects[boundary.Owners[triangle / 2]] |= BeyondTolerance;
    }
  }
}

bool CheckSurfaceIds(const SurfaceMesh& surface)
{
  const auto count = static_cast<Index>(surface.Points.size());
  for (const Triangle& t : surface.Triangles)
  {
    for (Index v : t)
    {
      if (v < 0 || v >= count || !surface.Points[v].allFinite())
      {
        return false;
      }
    }
  }
  return !surface.Triangles.empty();
}

/// Which promises are broken, in words.
std::string Complaints(const HexValidationReport& r)
{
  std::string text;
  const auto blame = [&](bool good, const std::string& what) {
    if (!good)
    {
      text += (text.empty() ? "" : "; ") + what;
    }
  };
  const HexTopology& t = r.Topology;
  const auto count = [](Index n, const char* what) { return std::to_string(n) + " " + what; };
  blame(t.Hexes > 0, "no hexes");
  blame(t.Hexes == 0 || t.Conforming(),
    "not conforming (" + count(t.OverusedFaces, "overused, ") +
      count(t.TwistedFaces, "twisted, ") + count(t.MisorientedFaces, "misoriented faces, ") +
      count(t.DuplicateHexes, "duplicate, ") + count(t.DegenerateHexes, "degenerate hexes)"));
  blame(t.OrphanPoints == 0, count(t.OrphanPoints, "unused points"));
  blame(t.DuplicatePoints == 0, count(t.DuplicatePoints, "duplicate points"));
  blame(r.NonFinitePoints == 0, count(r.NonFinitePoints, "points are not finite"));
  blame(r.PositiveCorners(),
    count(r.Quality.NonPositive, "hexes with a corner that is not positive"));
  blame(r.Certified(),
    count(r.CertifiedInvalid + r.CertifiedUndecided,
      "hexes without a certified positive Jacobian"));
  blame(r.Manifold(),
    "boundary is not a closed manifold (" + count(t.Surface.NonManifoldEdges, "edges, ") +
      count(t.Surface.NonManifoldVertices, "vertices)"));
  blame(!r.IntersectionsChecked || r.FreeOfIntersections(),
    count(r.SelfIntersections, "self-intersections of the boundary"));
  if (r.HasSurface)
  {
    blame(r.TopologyMatches(),
      "components, genus or cavities differ from the surface (" +
        count(t.Surface.Components, "components instead of ") +
        std::to_string(r.Input.Components) + ", Euler characteristic " +
        std::to_string(t.Surface.EulerCharacteristic) + " instead of " +
        std::to_string(r.Input.EulerCharacteristic) + ")");
    blame(r.WithinTolerance(),
      "boundary up to " + NumberText(100.0 * r.Distance.Lower() / r.Diagonal) +
        " % of the diagonal from the surface, tolerance " + NumberText(100.0 * r.Tolerance) +
        " %");
    blame(r.VolumeFits(),
      "volume " + NumberText(r.Volume) + " instead of " +
        NumberText(std::abs(r.Input.Volume)));
  }
  return text;
}

/// Places of the first offending hexes.
std::vector<Vec3> Places(const HexMesh& mesh, const HexValidationReport& r)
{
  constexpr std::size_t most = 20;
  std::vector<Vec3> places;
  for (std::size_t i = 0; i < r.Offending.size() && places.size() < most; ++i)
  {
    if (!(r.Offending[i].Defects & (IdOutOfRange | NonFinitePoint)))
    {
      Vec3 sum = Vec3::Zero();
      for (Index v : mesh.Hexes[r.Offending[i].Hex])
      {
        sum += mesh.Points[v];
      }
      places.push_back(sum / 8.0);
    }
  }
  return places;
}

void CollectOffending(const Defects& defects, HexValidationReport& r)
{
  for (std::size_t h = 0; h < defects.size(); ++h)
  {
    if (defects[h])
    {
      r.Offending.push_back({ static_cast<Index>(h), defects[h] });
    }
  }
}
}

const char* HexDefectName(HexDefect defect)
{
  switch (defect)
  {
    case NonFinitePoint:
      return "NonFinitePoint";
    case IdOutOfRange:
      return "IdOutOfRange";
    case RepeatedId:
      return "RepeatedId";
    case DuplicateHex:
      return "DuplicateHex";
    case NonPositiveCorner:
      return "NonPositiveCorner";
    case NotCertified:
      return "NotCertified";
    case OverusedFaceHex:
      return "OverusedFace";
    case TwistedFaceHex:
      return "TwistedFace";
    case MisorientedFaceHex:
      return "MisorientedFace";
    case NonManifoldBoundary:
      return "NonManifoldBoundary";
    case SelfIntersecting:
      return "SelfIntersecting";
    case BeyondTolerance:
      return "BeyondTolerance";
  }
  return "Unknown";
}

namespace
{
void AddFeatureFigures(
  const FeatureValidationReport& features, std::vector<std::pair<std::string, double>>& figures)
{
  const double unit = features.Diagonal > 0.0 ? 1.0 / features.Diagonal : 0.0;
  figures.emplace_back("FeaturesCaptured", features.AllCaptured());
  const auto add = [&](const std::string& one, const std::string& many, const FeatureTotals& t) {
    figures.emplace_back(many + "Found", t.Found);
    figures.emplace_back(many + "Enforced", t.Enforced);
    figures.emplace_back(many + "Captured", t.Captured);
    figures.emplace_back(one + "DeviationMaximum", t.Deviation * unit);
  };
  add("Corner", "Corners", features.CornerTotals());
  add("Curve", "Curves", features.CurveTotals());
  figures.emplace_back(
    "CurveVertexDeviationMaximum", features.CurveTotals().VertexDeviation * unit);
  add("Patch", "Patches", features.PatchTotals());
}
}

bool HexValidationReport::PureConforming() const
{
  return this->Topology.Conforming() && this->Topology.OrphanPoints == 0 &&
    this->Topology.DuplicatePoints == 0;
}

bool HexValidationReport::PositiveCorners() const
{
  return !this->ScaledJacobians.empty() && this->Quality.NonPositive == 0;
}

bool HexValidationReport::Certified() const
{
  return this->Topology.Hexes > 0 && this->NonFinitePoints == 0 &&
    this->CertifiedValid == this->Topology.Hexes;
}

bool HexValidationReport::TopologyMatches() const
{
  return SameTopology(this->Topology.Surface, this->Input);
}

bool HexValidationReport::WithinTolerance() const
{
  return this->Distance.Upper() <= this->Tolerance * this->Diagonal;
}

bool HexValidationReport::VolumeFits() const
{
  const double expected = std::abs(this->Input.Volume);
  const double allowed =
    2.0 * this->Distance.Upper() * (this->Input.Area + this->Topology.Surface.Area) +
    1e-9 * expected;
  return std::abs(this->Volume - expected) <= allowed;
}

bool HexValidationReport::Valid() const
{
  const bool alone = this->PureConforming() && this->PositiveCorners() && this->Certified() &&
    this->Manifold() && this->FreeOfIntersections();
  return alone &&
    (!this->HasSurface ||
      (this->TopologyMatches() && this->WithinTolerance() && this->VolumeFits()));
}

std::vector<std::pair<std::string, double>> HexValidationReport::Figures() const
{
  const HexTopology& t = this->Topology;
  const SurfaceTopology& s = t.Surface;
  std::vector<std::pair<std::string, double>> f = {
    { "Valid", this->Valid() },
    { "PureConforming", this->PureConforming() },
    { "PositiveCorners", this->PositiveCorners() },
    { "CertifiedPositive", this->Certified() },
    { "Manifold", this->Manifold() },
    { "FreeOfSelfIntersections", this->FreeOfIntersections() },
    { "NumberOfHexes", t.Hexes },
    { "NumberOfPoints", t.Points },
    { "NumberOfBoundaryQuads", s.Faces },
    { "NumberOfOffendingHexes", static_cast<double>(this->Offending.size()) },
    { "MinimumScaledJacobian", this->Quality.Minimum },
    { "MeanScaledJacobian", this->Quality.Mean },
    { "StandardDeviationScaledJacobian", this->Quality.StandardDeviation },
    { "NonPositiveHexes", this->Quality.NonPositive },
    { "CertifiedValidHexes", this->CertifiedValid },
    { "CertifiedInvalidHexes", this->CertifiedInvalid },
    { "UndecidedHexes", this->CertifiedUndecided },
    { "MinimumJacobianRatio", this->MinimumJacobianRatio },
    { "Volume", this->Volume },
    { "BoundaryVolume", s.Volume },
    { "BoundaryArea", s.Area },
    { "NonFinitePoints", this->NonFinitePoints },
    { "OrphanPoints", t.OrphanPoints },
    { "DuplicatePoints", t.DuplicatePoints },
    { "DuplicateHexes", t.DuplicateHexes },
    { "DegenerateHexes", t.DegenerateHexes },
    { "OverusedFaces", t.OverusedFaces },
    { "TwistedFaces", t.TwistedFaces },
    { "MisorientedFaces", t.MisorientedFaces },
    { "OpenEdges", s.OpenEdges },
    { "NonManifoldEdges", s.NonManifoldEdges },
    { "NonManifoldVertices", s.NonManifoldVertices },
    { "Bodies", t.Bodies },
    { "BoundaryComponents", s.Components },
    { "Cavities", s.Cavities },
    { "EulerCharacteristic", s.EulerCharacteristic },
    { "Edges", t.Edges },
    { "SingularInteriorEdges", t.SingularInteriorEdges },
    { "SingularBoundaryEdges", t.SingularBoundaryEdges },
    { "SelfIntersections", this->SelfIntersections },
    { "SuspectQuads", this->SuspectQuads },
  };
  const double bin = 1.0 / QualityStatistics::Bins;
  for (int i = 0; i < QualityStatistics::Bins; ++i)
  {
    // The lower end of the bin in percent: ScaledJacobian00, 05, ... 95.
    const int percent = static_cast<int>(std::lround(100.0 * bin * i));
    const std::string digits = (percent < 10 ? "0" : "") + std::to_string(percent);
    f.emplace_back("HexesWithScaledJacobianFrom" + digits, this->Quality.Histogram[i]);
  }
  if (!this->HasSurface)
  {
    return f;
  }
  const DistanceBounds& d = this->Distance;
  const double unit = this->Diagonal > 0.0 ? 1.0 / this->Diagonal : 0.0;
  const std::vector<std::pair<std::string, double>> compared = {
    { "TopologyMatches", this->TopologyMatches() },
    { "WithinTolerance", this->WithinTolerance() },
    { "VolumeFits", this->VolumeFits() },
    { "Tolerance", this->Tolerance },
    { "Diagonal", this->Diagonal },
    { "HausdorffLower", d.Lower() * unit },
    { "HausdorffUpper", d.Upper() * unit },
    { "HausdorffConverged", d.Converged() },
    { "MeanDistance", d.Mean() * unit },
    { "MeshToSurfaceLower", d.MeshToSurface.Lower * unit },
    { "MeshToSurfaceUpper", d.MeshToSurface.Upper * unit },
    { "MeshToSurfaceMean", d.MeshToSurface.Mean * unit },
    { "SurfaceToMeshLower", d.SurfaceToMesh.Lower * unit },
    { "SurfaceToMeshUpper", d.SurfaceToMesh.Upper * unit },
    { "SurfaceToMeshMean", d.SurfaceToMesh.Mean * unit },
    { "SurfaceComponents", this->Input.Components },
    { "SurfaceCavities", this->Input.Cavities },
    { "SurfaceEulerCharacteristic", this->Input.EulerCharacteristic },
    { "SurfaceVolume", this->Input.Volume },
    { "SurfaceArea", this->Input.Area },
  };
  f.insert(f.end(), compared.begin(), compared.end());
  if (this->HasFeatures)
  {
    AddFeatureFigures(this->Features, f);
  }
  return f;
}

HexValidationReport ValidateHexMesh(const HexMesh& mesh, const SurfaceMesh* surface,
  const HexValidationOptions& options, Monitor& monitor)
{
  HexValidationReport r;
  r.Tolerance = options.Tolerance;
  r.Topology.Hexes = static_cast<Index>(mesh.Hexes.size());
  r.Topology.Points = static_cast<Index>(mesh.Points.size());
  r.HasSurface = surface != nullptr;
  Defects defects(mesh.Hexes.size(), 0);
  monitor.BeginPhase("checking elements", 0.0, 0.1);
  if (!CheckIds(mesh, defects))
  {
    CollectOffending(defects, r);
    r.ScaledJacobians = ScaledJacobians(mesh);
    r.Quality = SummarizeQuality(r.ScaledJacobians);
    r.Result = Status(StatusCode::IndexOutOfRange,
      std::to_string(r.Offending.size()) + " hexes refer to points that do not exist (" +
        std::to_string(mesh.Points.size()) + " points).");
    return r;
  }
  if (surface && !CheckSurfaceIds(*surface))
  {
    r.Result = Status(StatusCode::InvalidOption,
      "The surface to compare with is empty, or has points that are not finite or do not exist.");
    return r;
  }
  MeasureElements(mesh, r, defects);
  monitor.BeginPhase("checking topology", 0.1, 0.3);
  MeasureTopology(mesh, r, defects);
  if (r.NonFinitePoints == 0)
  {
    monitor.BeginPhase("checking self-intersections", 0.3, 0.5);
    MeasureIntersections(mesh, r, defects, monitor);
  }
  if (surface)
  {
    r.Input = AnalyzeSurface(surface->Points, surface->Triangles);
    const CertifiedDistance distance(*surface);
    r.Diagonal = distance.Diagonal();
    monitor.BeginPhase("measuring distances", 0.5, 1.0);
    r.Distance = distance.Measure(
      mesh.Points, r.Topology.Boundary.Quads, r.Tolerance * r.Diagonal, monitor);
    MarkFarHexes(mesh, r, defects);
    if (options.Features.OfSurface && options.Features.OfMesh && r.NonFinitePoints == 0)
    {
      r.HasFeatures = true;
      r.Features = ValidateFeatures(
        mesh, r.Topology.Boundary, *surface, options.Features, options.Tolerance);
    }
  }
  CollectOffending(defects, r);
  if (monitor.Stopped())
  {
    r.Result = monitor.StopStatus();
  }
  else if (!r.Valid())
  {
    r.Result = Status(StatusCode::Validation,
      "The mesh is not valid: " + Complaints(r) + ".", Places(mesh, r));
  }
  return r;
}
}

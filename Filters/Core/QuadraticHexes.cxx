// SPDX-License-Identifier: BSD-3-Clause
#include "QuadraticHexes.h"

#include "HexCertificate.h"
#include "Parallel.h"
#include "PolylineDistance.h"
#include "QuadraticCertificate.h"
#include "TriangleSearch.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace featurehex
{
namespace
{
/// After so many halvings a node goes back wholly.
constexpr int MaximumHalvings = 3;
/// A curved hex shall keep at least this part of the ratio that its linear one has.
constexpr double KeptRatio = 0.2;

using Key = std::array<Index, 4>; ///< sorted corners; of an edge the first two are -1

Key EdgeKey(Index a, Index b)
{
  return { -1, -1, std::min(a, b), std::max(a, b) };
}

Key FaceKey(Quad quad)
{
  std::sort(quad.begin(), quad.end());
  return quad;
}

/// A node that was added, and where it wants to be.
struct AddedNode
{
  Vec3 Middle = Vec3::Zero();
  Vec3 Move = Vec3::Zero(); ///< to its target
  int Halvings = 0;         ///< MaximumHalvings: stays
  FeatureKind Kind = FeatureKind::Interior;
  Index Id = -1;

  Vec3 Position() const
  {
    return this->Halvings >= MaximumHalvings
             ? this->Middle
             : this->Middle + std::ldexp(1.0, -this->Halvings) * this->Move;
  }
};

/// The node in the middle from those of faces, edges and corners (transfinite interpolation); for
/// the faces of a 20-node hex the same as FillSerendipity().
void BlendMiddle(HexGrid27& grid)
{
  const auto& places = GridPlaces();
  Vec3 middle = Vec3::Zero();
  for (int i = 0; i < 26; ++i)
  {
    middle += (i < 8 ? 0.125 : i < 20 ? -0.25 : 0.5) * grid[places[i]];
  }
  grid[13] = middle;
}

class Builder
{
public:
  Builder(const HexMesh& mesh, const QuadraticTargets& targets, const QuadraticOptions& options)
    : Mesh(mesh)
    , Targets(targets)
    , Options(options)
    , FirstAdded(static_cast<Index>(mesh.Points.size()))
  {
  }

  Status Run(Monitor& monitor, QuadraticMesh& result)
  {
    monitor.BeginPhase("adding nodes", 0.0, 0.2);
    Status status = this->CheckInput();
    if (!status.Ok() || !monitor.Update(0.5))
    {
      return status.Ok() ? monitor.StopStatus() : status;
    }
    this->AddNodes();
    this->LabelBoundary();
    monitor.BeginPhase("placing nodes on the surface", 0.2, 0.6);
    if (!this->Place(monitor))
    {
      return monitor.StopStatus();
    }
    monitor.BeginPhase("proving hexes", 0.6, 1.0);
    if (!this->KeepValid(monitor))
    {
      return monitor.StopStatus();
    }
    this->Write(result);
    return {};
  }

private:
  Status CheckInput()
  {
    if (this->Options.NodesPerHex != 20 && this->Options.NodesPerHex != 27)
    {
      return Status(StatusCode::InvalidOption, "Quadratic hexes have 20 or 27 nodes, not " +
                                                 std::to_string(this->Options.NodesPerHex) + ".");
    }
    const std::vector<HexCertificate> certificates = CertifyHexes(this->Mesh);
    for (std::size_t h = 0; h < certificates.size(); ++h)
    {
      if (certificates[h].State != Validity::Valid)
      {
        return Status(StatusCode::InvalidMesh,
          "Hex " + std::to_string(h) +
            " isn't proven valid, so a quadratic one can't be either. Hex Validation shows what is "
            "wrong with the mesh.");
      }
      this->Wanted.push_back(KeptRatio * std::max(0.0, certificates[h].Ratio()));
    }
    return {};
  }

  Index Node(const Key& key, const Vec3& middle)
  {
    const auto [at, fresh] = this->NodeOf.emplace(key, static_cast<Index>(this->Added.size()));
    if (fresh)
    {
      this->Added.push_back({});
      this->Added.back().Middle = middle;
    }
    return at->second;
  }

  /// Mid-face nodes of the inside and those in the middle of hexes are not placed, they follow.
  void AddNodes()
  {
    for (const Hex& hex : this->Mesh.Hexes)
    {
      for (const auto& edge : HexEdges)
      {
        const Index a = hex[edge[0]], b = hex[edge[1]];
        this->HexEdgeNodes.push_back(
          this->Node(EdgeKey(a, b), 0.5 * (this->Mesh.Points[a] + this->Mesh.Points[b])));
      }
    }
    if (this->Options.NodesPerHex == 20)
    {
      return;
    }
    for (const Hex& hex : this->Mesh.Hexes)
    {
      for (const auto& face : HexFaces)
      {
        const Quad quad = { hex[face[0]], hex[face[1]], hex[face[2]], hex[face[3]] };
        Vec3 sum = Vec3::Zero();
        for (Index v : FaceKey(quad)) // the same order from both sides
        {
          sum += this->Mesh.Points[v];
        }
        this->HexFaceNodes.push_back(this->Node(FaceKey(quad), 0.25 * sum));
      }
    }
  }

  void LabelBoundary()
  {
    const HexStars stars(this->Mesh);
    const HexFeatures* features = this->Targets.MeshFeatures;
    const bool known = features && features->PatchOfQuad.size() == stars.Quads.size();
    for (std::size_t q = 0; q < stars.Quads.size(); ++q)
    {
      const Quad& quad = stars.Quads[q];
      const Index patch = known ? features->PatchOfQuad[q] : -1;
      for (int k = 0; k < 4; ++k)
      {
        AddedNode& node = this->Added[this->NodeOf.at(EdgeKey(quad[k], quad[(k + 1) % 4]))];
        node.Id = node.Kind == FeatureKind::Interior || node.Id == patch ? patch : -1;
        node.Kind = FeatureKind::Surface;
      }
      const auto face = this->NodeOf.find(FaceKey(quad));
      if (face != this->NodeOf.end())
      {
        this->Added[face->second].Kind = FeatureKind::Surface;
        this->Added[face->second].Id = patch;
        this->Quads[face->second] = quad;
      }
    }
    for (std::size_t c = 0; features && c < features->CurvePaths.size(); ++c)
    {
      const std::vector<Index>& path = features->CurvePaths[c];
      for (std::size_t i = 0; i + 1 < path.size(); ++i)
      {
        const auto at = this->NodeOf.find(EdgeKey(path[i], path[i + 1]));
        if (at != this->NodeOf.end())
        {
          this->Added[at->second].Kind = FeatureKind::Curve;
          this->Added[at->second].Id = static_cast<Index>(c);
        }
      }
    }
    this->Measure();
  }

  void Measure()
  {
    const std::vector<Vec3>& p = this->Mesh.Points;
    this->Lengths.assign(this->Added.size(), 0.0);
    for (const auto& [key, index] : this->NodeOf)
    {
      if (key[0] < 0)
      {
        this->Lengths[index] = (p[key[2]] - p[key[3]]).norm();
      }
    }
    for (const auto& [index, quad] : this->Quads)
    {
      this->Lengths[index] =
        std::min((p[quad[0]] - p[quad[2]]).norm(), (p[quad[1]] - p[quad[3]]).norm());
    }
  }

  /// The point a node shall be at, for the middle it has.
  Vec3 Target(
    const AddedNode& node, const TriangleSearch& search, const std::vector<Polyline>& curves) const
  {
    if (node.Kind == FeatureKind::Curve)
    {
      const auto c = static_cast<std::size_t>(node.Id);
      return c < curves.size() ? curves[c].Closest(node.Middle).Point : node.Middle;
    }
    const TrianglePoint closest = search.Closest(node.Middle);
    // Beside a sharp edge the closest triangle can belong to the patch beyond it.
    const SurfaceFeatures* graph = this->Targets.SurfaceGraph;
    const bool other = graph && node.Id >= 0 && closest.Triangle >= 0 &&
                       graph->PatchOfTriangle[closest.Triangle] != node.Id;
    return closest.Triangle < 0 || other ? node.Middle : closest.Point;
  }

  bool Place(Monitor& monitor)
  {
    if (!this->Targets.Surface)
    {
      return true;
    }
    const SurfaceMesh& surface = *this->Targets.Surface;
    const TriangleSearch search(surface.Points, surface.Triangles);
    std::vector<Polyline> curves;
    if (const SurfaceFeatures* graph = this->Targets.SurfaceGraph)
    {
      for (const FeatureCurve& curve : graph->Curves)
      {
        std::vector<Vec3> chain;
        for (Index v : curve.Points)
        {
          chain.push_back(surface.Points[v]);
        }
        curves.emplace_back(std::move(chain));
      }
    }
    this->TooFar.assign(this->Added.size(), 0);
    return ParallelFor(this->Added.size(), 64, &monitor,
      [&](std::size_t i)
      {
        AddedNode& node = this->Added[i];
        if (node.Kind == FeatureKind::Interior)
        {
          return;
        }
        const Vec3 move = this->Target(node, search, curves) - node.Middle;
        this->TooFar[i] = move.norm() > this->Options.LargestMove * this->Lengths[i];
        node.Move = this->TooFar[i] ? Vec3::Zero() : move;
      });
  }

  HexGrid27 Grid(std::size_t hex) const
  {
    const auto& places = GridPlaces();
    HexGrid27 grid;
    for (int c = 0; c < 8; ++c)
    {
      grid[places[c]] = this->Mesh.Points[this->Mesh.Hexes[hex][c]];
    }
    for (int e = 0; e < 12; ++e)
    {
      grid[places[8 + e]] = this->Added[this->HexEdgeNodes[12 * hex + e]].Position();
    }
    FillSerendipity(grid);
    for (int f = 0; f < 6 && this->Options.NodesPerHex == 27; ++f)
    {
      const AddedNode& node = this->Added[this->HexFaceNodes[6 * hex + f]];
      if (Moves(node))
      {
        grid[places[20 + f]] = node.Position();
      }
    }
    if (this->Options.NodesPerHex == 27)
    {
      BlendMiddle(grid);
    }
    return grid;
  }

  /// Boundary nodes that aren't in the middle.
  static bool Moves(const AddedNode& node)
  {
    return node.Halvings < MaximumHalvings && node.Move != Vec3::Zero();
  }

  template <typename Visit>
  void VisitNodes(std::size_t hex, const Visit& visit)
  {
    for (int e = 0; e < 12; ++e)
    {
      visit(this->Added[this->HexEdgeNodes[12 * hex + e]]);
    }
    for (int f = 0; f < 6 && this->Options.NodesPerHex == 27; ++f)
    {
      visit(this->Added[this->HexFaceNodes[6 * hex + f]]);
    }
  }

  /// Until every curved hex is proven and as good as wanted: those that aren't take their nodes
  /// back by half. Ends, because each round halves something, and nothing more than MaximumHalvings
  /// times.
  bool KeepValid(Monitor& monitor)
  {
    const std::size_t count = this->Mesh.Hexes.size();
    std::vector<char> curved(count);
    std::vector<double> ratios(count);
    for (int round = 0;; ++round)
    {
      for (std::size_t h = 0; h < count; ++h)
      {
        curved[h] = 0;
        this->VisitNodes(h, [&](const AddedNode& node) { curved[h] |= Moves(node); });
      }
      const bool going = ParallelFor(count, 64, &monitor,
        [&](std::size_t h) { ratios[h] = curved[h] ? QuadraticHexRatio(this->Grid(h)) : 1.0; });
      if (!going || !monitor.Update(1.0 - std::ldexp(0.5, -round)))
      {
        return false;
      }
      std::vector<AddedNode> next = this->Added;
      bool changed = false;
      for (std::size_t h = 0; h < count; ++h)
      {
        this->VisitNodes(h,
          [&](const AddedNode& node)
          {
            if ((ratios[h] <= 0.0 || ratios[h] < this->Wanted[h]) && Moves(node))
            {
              next[static_cast<std::size_t>(&node - this->Added.data())].Halvings =
                node.Halvings + 1;
              changed = true;
            }
          });
      }
      if (!changed)
      {
        this->SmallestRatio = *std::min_element(ratios.begin(), ratios.end());
        return true;
      }
      this->Added = std::move(next);
    }
  }

  void Write(QuadraticMesh& result)
  {
    result.NodesPerHex = this->Options.NodesPerHex;
    result.Points = this->Mesh.Points;
    for (std::size_t i = 0; i < this->Added.size(); ++i)
    {
      const AddedNode& node = this->Added[i];
      result.Points.push_back(node.Position());
      result.Added.Kind.push_back(node.Kind);
      result.Added.Id.push_back(node.Id);
      if (node.Kind != FeatureKind::Interior)
      {
        const bool far = !this->TooFar.empty() && this->TooFar[i];
        ++result.Report.BoundaryNodes;
        result.Report.TooFar += far;
        result.Report.Shortened += node.Halvings > 0;
        result.Report.OnSurface += this->Targets.Surface && !far && node.Halvings == 0;
      }
    }
    result.Report.SmallestRatio = this->SmallestRatio;
    for (std::size_t h = 0; h < this->Mesh.Hexes.size(); ++h)
    {
      this->WriteHex(h, result);
    }
  }

  void WriteHex(std::size_t h, QuadraticMesh& result)
  {
    const Hex& hex = this->Mesh.Hexes[h];
    result.HexNodes.insert(result.HexNodes.end(), hex.begin(), hex.end());
    for (int e = 0; e < 12; ++e)
    {
      result.HexNodes.push_back(this->FirstAdded + this->HexEdgeNodes[12 * h + e]);
    }
    if (this->Options.NodesPerHex == 20)
    {
      return;
    }
    const HexGrid27 grid = this->Grid(h);
    for (int f = 0; f < 6; ++f)
    {
      const Index node = this->HexFaceNodes[6 * h + f];
      result.HexNodes.push_back(this->FirstAdded + node);
      // From both sides the same but for rounding; the last hex decides.
      result.Points[this->FirstAdded + node] = grid[GridPlaces()[20 + f]];
    }
    result.HexNodes.push_back(static_cast<Index>(result.Points.size()));
    result.Points.push_back(grid[13]);
    result.Added.Kind.push_back(FeatureKind::Interior);
    result.Added.Id.push_back(-1);
  }

  const HexMesh& Mesh;
  const QuadraticTargets& Targets;
  const QuadraticOptions& Options;
  const Index FirstAdded;
  std::map<Key, Index> NodeOf; ///< position in Added
  std::vector<AddedNode> Added;
  std::vector<double> Lengths; ///< of the edge or quad of each added node
  std::vector<char> TooFar;
  std::vector<double> Wanted;      ///< ratio of each hex
  std::map<Index, Quad> Quads;     ///< boundary quads of mid-face nodes
  std::vector<Index> HexEdgeNodes; ///< 12 a hex, positions in Added
  std::vector<Index> HexFaceNodes; ///< 6 a hex; empty with 20 nodes
  double SmallestRatio = 1.0;
};
} // namespace

Status MakeQuadratic(const HexMesh& mesh, const QuadraticTargets& targets,
  const QuadraticOptions& options, Monitor& monitor, QuadraticMesh& result)
{
  result = {};
  return Builder(mesh, targets, options).Run(monitor, result);
}
} // namespace featurehex

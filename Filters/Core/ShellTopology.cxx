// SPDX-License-Identifier: BSD-3-Clause
#include "ShellTopology.h"

#include "DisjointSets.h"
#include "Parallel.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <numeric>

namespace featurehex
{
namespace
{
/// Points of a mesh shell that vote for the surface shell it belongs to.
constexpr std::size_t MaximumVotes = 500;

/// Six times the signed volume between a face and @a apex; quads as four triangles round their
/// middle, which is what a bilinear patch encloses.
double SixVolumes(const std::vector<Vec3>& points, const Triangle& t, const Vec3& apex)
{
  return (points[t[0]] - apex).dot((points[t[1]] - apex).cross(points[t[2]] - apex));
}

double SixVolumes(const std::vector<Vec3>& points, const Quad& q, const Vec3& apex)
{
  const Vec3 middle =
    0.25 * (points[q[0]] + points[q[1]] + points[q[2]] + points[q[3]]) - apex;
  double sum = 0.0;
  for (int k = 0; k < 4; ++k)
  {
    sum += middle.dot((points[q[k]] - apex).cross(points[q[(k + 1) & 3]] - apex));
  }
  return sum;
}

template <typename Face>
Shells FindShellsOf(const std::vector<Vec3>& points, const std::vector<Face>& faces)
{
  Shells shells;
  DisjointSets sets(points.size());
  std::vector<std::uint64_t> edges;
  edges.reserve(faces.size() * 2);
  for (const Face& face : faces)
  {
    for (std::size_t k = 0; k < face.size(); ++k)
    {
      const Index a = face[k];
      const Index b = face[(k + 1) % face.size()];
      sets.Join(face[0], a);
      const std::uint64_t low = static_cast<std::uint32_t>(std::min(a, b));
      edges.push_back(low << 32 | static_cast<std::uint32_t>(std::max(a, b)));
    }
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());

  std::vector<Index> shellOfRoot(points.size(), -1);
  shells.OfFace.reserve(faces.size());
  std::vector<char> used(points.size(), 0);
  std::vector<Index> apexes;
  for (const Face& face : faces)
  {
    Index& shell = shellOfRoot[sets.Find(face[0])];
    if (shell < 0)
    {
      shell = static_cast<Index>(shells.List.size());
      shells.List.emplace_back();
      apexes.push_back(face[0]);
    }
    shells.OfFace.push_back(shell);
    ShellTopology& topology = shells.List[shell];
    // The shell's own first point as apex: the sign must be right far from the origin too.
    topology.Volume += SixVolumes(points, face, points[apexes[shell]]) / 6.0;
    topology.Center += points[face[0]];
    ++topology.Faces;
    ++topology.EulerCharacteristic;
    for (Index v : face)
    {
      topology.EulerCharacteristic += used[v] ? 0 : 1;
      used[v] = 1;
    }
  }
  for (std::uint64_t edge : edges)
  {
    --shells.List[shellOfRoot[sets.Find(static_cast<Index>(edge >> 32))]].EulerCharacteristic;
  }
  for (ShellTopology& topology : shells.List)
  {
    topology.Center /= topology.Faces;
  }
  return shells;
}

std::string Describe(std::size_t shell, const ShellTopology& topology)
{
  // Rounding errors of the mean are no coordinates.
  const double smallest = 1e-9 * std::cbrt(std::abs(topology.Volume));
  double c[3];
  for (int k = 0; k < 3; ++k)
  {
    c[k] = std::abs(topology.Center[k]) < smallest ? 0.0 : topology.Center[k];
  }
  char text[160];
  std::snprintf(text, sizeof(text), "%s %zu (round %.4g %.4g %.4g)",
    topology.Cavity() ? "Cavity" : "Shell", shell + 1, c[0], c[1], c[2]);
  return text;
}
}

Shells FindShells(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles)
{
  return FindShellsOf(points, triangles);
}

Shells FindShells(const std::vector<Vec3>& points, const std::vector<Quad>& quads)
{
  return FindShellsOf(points, quads);
}

ShellComparison CompareShells(const Shells& surface, const TriangleSearch& search,
  const Shells& mesh, const std::vector<Vec3>& meshPoints, const std::vector<Quad>& meshQuads)
{
  std::vector<std::size_t> voters;
  std::vector<Index> seen(mesh.List.size(), 0);
  for (std::size_t q = 0; q < meshQuads.size(); ++q)
  {
    const Index shell = mesh.OfFace[q];
    const std::size_t stride = 1 + mesh.List[shell].Faces / MaximumVotes;
    if (seen[shell]++ % stride == 0)
    {
      voters.push_back(q);
    }
  }
  std::vector<Index> closest(voters.size());
  ParallelFor(voters.size(), 64, [&](std::size_t i) {
    const Quad& q = meshQuads[voters[i]];
    const Vec3 middle =
      0.25 * (meshPoints[q[0]] + meshPoints[q[1]] + meshPoints[q[2]] + meshPoints[q[3]]);
    closest[i] = surface.OfFace[search.Closest(middle).Triangle];
  });

  ShellComparison result;
  std::vector<std::vector<Index>> votes(
    mesh.List.size(), std::vector<Index>(surface.List.size(), 0));
  for (std::size_t i = 0; i < voters.size(); ++i)
  {
    ++votes[mesh.OfFace[voters[i]]][closest[i]];
  }
  std::vector<std::vector<Index>> candidates(surface.List.size());
  for (std::size_t m = 0; m < mesh.List.size(); ++m)
  {
    for (std::size_t s = 0; s < surface.List.size(); ++s)
    {
      if (surface.List[s].Cavity() != mesh.List[m].Cavity())
      {
        votes[m][s] -= static_cast<Index>(MaximumVotes) * 2 + 2;
      }
    }
    const Index best = static_cast<Index>(
      std::max_element(votes[m].begin(), votes[m].end()) - votes[m].begin());
    result.Matched.push_back(best);
    candidates[best].push_back(static_cast<Index>(m));
  }
  for (std::size_t s = 0; s < surface.List.size(); ++s)
  {
    const ShellTopology& wanted = surface.List[s];
    ShellVerdict verdict = ShellVerdict::Same;
    std::string text;
    if (candidates[s].empty())
    {
      verdict = ShellVerdict::Missing;
      text = " has no hexes of its own.";
    }
    else if (candidates[s].size() > 1)
    {
      verdict = ShellVerdict::Split;
      text = " became " + std::to_string(candidates[s].size()) + " shells.";
    }
    else if (mesh.List[candidates[s][0]].EulerCharacteristic != wanted.EulerCharacteristic)
    {
      verdict = ShellVerdict::Genus;
      text = " has genus " + std::to_string(mesh.List[candidates[s][0]].Genus()) +
        " instead of " + std::to_string(wanted.Genus()) + ".";
    }
    else if (mesh.List[candidates[s][0]].Cavity() != wanted.Cavity())
    {
      verdict = ShellVerdict::Split;
      text = wanted.Cavity() ? " became solid." : " became a cavity.";
    }
    result.Verdicts.push_back(verdict);
    if (verdict != ShellVerdict::Same)
    {
      result.Report += (result.Report.empty() ? "" : " ") + Describe(s, wanted) + text;
    }
  }
  return result;
}
}

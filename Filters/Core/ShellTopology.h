// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Components of closed surfaces one by one: Euler characteristic, solid or cavity, which one is
/// which.

#ifndef featurehex_ShellTopology_h
#define featurehex_ShellTopology_h

#include "TriangleSearch.h"
#include "Types.h"

#include <string>
#include <vector>

namespace featurehex
{
/// One closed component (shell) of a surface.
struct ShellTopology
{
  int EulerCharacteristic = 0;
  double Volume = 0.0; ///< signed; negative: the shell bounds a cavity
  Index Faces = 0;
  Vec3 Center = Vec3::Zero(); ///< mean of its faces' first points, to name the place

  int Genus() const { return (2 - this->EulerCharacteristic) / 2; }
  bool Cavity() const { return this->Volume < 0; }
};

/// Shells in the order of their first face. Faces are connected through vertices.
struct Shells
{
  std::vector<ShellTopology> List;
  std::vector<Index> OfFace; ///< shell of each face
};

Shells FindShells(const std::vector<Vec3>& points, const std::vector<Triangle>& triangles);
Shells FindShells(const std::vector<Vec3>& points, const std::vector<Quad>& quads);

/// What is wrong with the mesh's shells for one shell of the surface.
enum class ShellVerdict
{
  Same,    ///< exactly one, with the same Euler characteristic
  Missing, ///< none
  Split,   ///< more than one
  Genus    ///< one, with another Euler characteristic
};

/// How the shells of a mesh match those of the surface.
struct ShellComparison
{
  std::vector<Index> Matched;         ///< per mesh shell the surface shell that it is nearest to
  std::vector<ShellVerdict> Verdicts; ///< per surface shell
  std::string Report;                 ///< one sentence for each shell that differs

  bool Same() const { return this->Report.empty(); }
};

/// Match each mesh shell to a surface shell (that of the closest triangles of most of its points,
/// among those that are solid or cavity like it) and compare one by one.
ShellComparison CompareShells(const Shells& surface, const TriangleSearch& search,
  const Shells& mesh, const std::vector<Vec3>& meshPoints, const std::vector<Quad>& meshQuads);
}

#endif

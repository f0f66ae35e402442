// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Medit .mesh files (ASCII): hexahedra, boundary quads, feature edges and corners with references.

#ifndef featurehex_MeditFile_h
#define featurehex_MeditFile_h

#include "Status.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace featurehex
{
/// A Medit mesh; all ids 0-based (in the file they start at 1).
///
/// References are integer labels: of a hex its body, of a quad its patch, of an edge its curve.
/// A references vector is as long as its elements, or empty: all 0 when written.
struct MeditMesh
{
  std::vector<Vec3> Points;
  std::vector<std::int32_t> PointReferences;
  std::vector<Hex> Hexes;
  std::vector<std::int32_t> HexReferences;
  std::vector<Quad> Quads;
  std::vector<std::int32_t> QuadReferences;
  std::vector<std::array<Index, 2>> Edges;
  std::vector<std::int32_t> EdgeReferences;
  std::vector<Index> Corners; ///< ids of points
  std::vector<Index> Ridges;  ///< ids of edges that are sharp
};

/// Reads @a path. Required elements, normals, tangents and triangles are skipped; tetrahedra,
/// prisms and pyramids are an error, because leaving them out would tear the mesh. Coordinates may
/// be NaN or infinite. Numbers are read independent of the locale, counts are compared with the
/// file size before anything is allocated. Hexes may have repeated ids.
/// @return UnreadableFile, EmptySurface (no points), InvalidMesh (other volume elements),
/// IndexOutOfRange, each with the line. @a mesh is empty then.
Status ReadMedit(const std::string& path, MeditMesh& mesh);

/// The same for the content of a file; @a name is used in messages.
Status ParseMedit(std::string_view bytes, const std::string& name, MeditMesh& mesh);

/// Writes @a mesh, version 2 (double precision); every coordinate reads back with the same bits.
/// The file appears when it is complete.
/// @return UnwritableFile, IndexOutOfRange (the mesh is wrong), NonFinite.
Status WriteMedit(const std::string& path, const MeditMesh& mesh);
} // namespace featurehex

#endif

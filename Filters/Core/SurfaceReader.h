// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Reads triangle surfaces from OBJ, STL, PLY and OFF files that may be broken or hostile.

#ifndef featurehex_SurfaceReader_h
#define featurehex_SurfaceReader_h

#include "Status.h"

#include <string>
#include <string_view>

namespace featurehex
{
/// What a surface file is written in.
enum class SurfaceFormat
{
  Unknown,
  Obj, ///< Wavefront: v and f lines; negative indices; everything else is skipped
  Stl, ///< ASCII or binary
  Ply, ///< ASCII, binary little and big endian; polygons and triangle strips
  Off  ///< ASCII; COFF, NOFF, STOFF: colours, normals and texture coordinates are skipped
};

/// By the extension of @a path, else by the first bytes.
SurfaceFormat DetectSurfaceFormat(const std::string& path, std::string_view bytes);

/// Reads @a path into @a surface: points in file order and model units, polygons as triangle fans
/// around their first point.
///
/// Guaranteed of the result: at least one triangle, every id in range. Not checked here: the rest
/// of what CheckSurface() looks at. NaN and infinite coordinates (too large numbers too) are
/// passed on, and STL triangles come with three points each of their own. Faces with repeated
/// points are kept. Numbers are read independent of the locale. Nothing is allocated that the
/// file has no bytes for: memory is at most some 10 times the file size.
/// @return UnreadableFile (missing, truncated, not of its format), EmptySurface (no points or no
/// faces), IndexOutOfRange; the message has the line, face or byte. @a surface is empty then.
Status ReadSurface(const std::string& path, SurfaceMesh& surface);

/// The same for the content of a file; @a name is used in messages.
Status ParseSurface(
  std::string_view bytes, SurfaceFormat format, const std::string& name, SurfaceMesh& surface);
} // namespace featurehex

#endif

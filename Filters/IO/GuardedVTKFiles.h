// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// VTK's own files, safely: one Status instead of a stream of errors, no exceptions, and data that
/// is checked before anyone uses it. Private to this module.

#ifndef featurehex_GuardedVTKFiles_h
#define featurehex_GuardedVTKFiles_h

#include "Status.h"

#include <exception>
#include <new>
#include <string>

class vtkPolyData;
class vtkUnstructuredGrid;

namespace featurehex
{
/// Runs @a work, which returns a Status; a file name that is not set and an exception become one
/// too.
template <typename Work>
Status Guarded(const char* fileName, const Work& work)
{
  if (!fileName || !*fileName)
  {
    return Status(StatusCode::InvalidOption, "FileName is not set.");
  }
  try
  {
    return work();
  }
  catch (const std::bad_alloc&)
  {
    return Status(StatusCode::UnreadableFile,
      "Out of memory. The file is damaged, or too large for this machine.");
  }
  catch (const std::exception& error)
  {
    return Status(StatusCode::UnreadableFile, std::string("Unexpected failure: ") + error.what());
  }
}

/// For vtkAlgorithm::SetErrorCode(): a code of vtkErrorCode where one fits, else
/// vtkErrorCode::UserError + StatusCode.
unsigned long ErrorCodeOf(const Status& status);

/// Reads .vtp, or legacy .vtk for any other extension, into @a output.
/// Guaranteed of the result: every id of every cell in range, arrays as long as their points and
/// cells.
/// @return UnreadableFile, IndexOutOfRange. @a output is empty then.
Status ReadVTKFile(const std::string& path, vtkPolyData* output);

/// Reads .vtu, or legacy .vtk for any other extension. Beyond the above: only linear cells, each
/// with its number of points.
/// @return UnreadableFile, IndexOutOfRange, InvalidMesh. @a output is empty then.
Status ReadVTKFile(const std::string& path, vtkUnstructuredGrid* output);

/// Writes .vtu, or legacy .vtk for any other extension. The file appears when it is complete.
/// Data is inline base64 and compressed (.vtu: the ParaView of Debian 12 can't read appended
/// data), or legacy version 4.2, binary (.vtk: what most other programs can read).
/// @return UnwritableFile.
Status WriteVTKFile(const std::string& path, vtkUnstructuredGrid* input);
} // namespace featurehex

#endif

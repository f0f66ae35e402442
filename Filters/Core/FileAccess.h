// SPDX-License-Identifier: BSD-3-Clause
/// @file
/// Whole files in, whole files out: reading that can't hang or overrun, writing that never leaves
/// half a file behind.

#ifndef featurehex_FileAccess_h
#define featurehex_FileAccess_h

#include "Status.h"

#include <string>
#include <string_view>

namespace featurehex
{
/// Largest file that is read, bytes. 2^31 points of the tersest text format don't fit in less than
/// this, so a larger file can't be indexed anyway.
constexpr unsigned long long MaximumFileSize = 1ull << 34;

/// Content of a regular file (devices and pipes, which may never end, are refused).
/// @return UnreadableFile: missing, a folder, a device, no permission, over MaximumFileSize.
Status ReadFileBytes(const std::string& path, std::string& bytes);

/// Up to the first 1024 bytes of a regular file; false: there is no such file. To see what it is.
bool ReadFileHead(const std::string& path, std::string& bytes);

/// Extension in lower case with its dot, ".stl"; empty without one.
std::string FileExtension(const std::string& path);

/// Name without the folder, for messages.
std::string FileBaseName(const std::string& path);

/// A file that appears under its name only when it is complete.
///
/// Open() makes an empty temporary file next to the target, the caller fills it, Commit() renames
/// it. Without Commit() the destructor removes it and the target stays what it was. A target that
/// is a symbolic link keeps being one; its permissions are kept; a device is refused, because the
/// rename would replace it.
class PendingFile
{
public:
  PendingFile() = default;
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// @return UnwritableFile: no such folder, no permission, or the target is no regular file.
  Status Open(const std::string& path);

  /// Where to write. Same folder as the target.
  const std::string& Name() const { return this->Temporary; }

  /// Replaces the target.
  Status Commit();

private:
  std::string Target;
  std::string Temporary;
};

/// Writes a whole file through PendingFile.
Status WriteFileBytes(const std::string& path, std::string_view bytes);
} // namespace featurehex

#endif

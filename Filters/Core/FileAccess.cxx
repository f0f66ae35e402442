// SPDX-License-Identifier: BSD-3-Clause
#include "FileAccess.h"

#include <atomic>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

namespace fs = std::filesystem;

namespace featurehex
{
namespace
{
struct CloseFile
{
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using FilePointer = std::unique_ptr<std::FILE, CloseFile>;

Status Unreadable(const std::string& path, const std::string& why)
{
  return Status(StatusCode::UnreadableFile, "Can't read \"" + path + "\": " + why);
}

Status Unwritable(const std::string& path, const std::string& why)
{
  return Status(StatusCode::UnwritableFile, "Can't write \"" + path + "\": " + why);
}

std::string SystemMessage()
{
  return std::string(std::strerror(errno)) + ".";
}

/// Differs between processes and calls; PendingFile::Open refuses an existing name anyway.
std::string UniqueSuffix()
{
  static std::atomic<unsigned> counter{ 0 };
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  return ".part-" + std::to_string(now) + "-" + std::to_string(counter++);
}
} // namespace

Status ReadFileBytes(const std::string& path, std::string& bytes)
{
  bytes.clear();
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status))
  {
    return Unreadable(path, "there is no such file.");
  }
  if (!fs::is_regular_file(status))
  {
    return Unreadable(path, "it is a folder, a device or a pipe, not a file.");
  }
  const std::uintmax_t size = fs::file_size(path, error);
  if (error)
  {
    return Unreadable(path, error.message() + ".");
  }
  if (size > MaximumFileSize)
  {
    return Unreadable(path, "it has " + std::to_string(size) + " bytes, the limit is " +
                              std::to_string(MaximumFileSize) + ". Decimate the surface first.");
  }
  FilePointer file(std::fopen(path.c_str(), "rb"));
  if (!file)
  {
    return Unreadable(path, SystemMessage());
  }
  bytes.resize(static_cast<std::size_t>(size));
  const std::size_t count = std::fread(bytes.data(), 1, bytes.size(), file.get());
  if (count < bytes.size() && std::ferror(file.get()))
  {
    bytes.clear();
    return Unreadable(path, SystemMessage());
  }
  bytes.resize(count);
  return {};
}

bool ReadFileHead(const std::string& path, std::string& bytes)
{
  bytes.clear();
  std::error_code error;
  if (!fs::is_regular_file(path, error))
  {
    return false;
  }
  FilePointer file(std::fopen(path.c_str(), "rb"));
  if (file)
  {
    bytes.resize(1024);
    bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file.get()));
  }
  return file != nullptr;
}

std::string FileExtension(const std::string& path)
{
  std::string extension = fs::path(path).extension().string();
  for (char& c : extension)
  {
    // Not std::tolower: that one depends on the locale.
    c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return extension;
}

std::string FileBaseName(const std::string& path)
{
  return fs::path(path).filename().string();
}

PendingFile::~PendingFile()
{
  if (!this->Temporary.empty())
  {
    std::error_code error;
    fs::remove(this->Temporary, error);
  }
}

Status PendingFile::Open(const std::string& path)
{
  if (path.empty())
  {
    return Status(StatusCode::UnwritableFile, "No file name is given to write to.");
  }
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    return Unwritable(path, "it is a folder, a device or a pipe, not a file.");
  }
  // The target of a symbolic link is replaced, not the link.
  fs::path target = fs::weakly_canonical(path, error);
  this->Target = error ? path : target.string();
  const std::string temporary = this->Target + UniqueSuffix();
  FilePointer file(std::fopen(temporary.c_str(), "wbx"));
  if (!file)
  {
    return Unwritable(path, SystemMessage() + " Check that the folder exists and can be written.");
  }
  this->Temporary = temporary;
  if (fs::exists(status))
  {
    fs::permissions(temporary, status.permissions(), error);
  }
  return {};
}

Status PendingFile::Commit()
{
  std::error_code error;
  fs::rename(this->Temporary, this->Target, error);
  if (error)
  {
    return Unwritable(this->Target, error.message() + ".");
  }
  this->Temporary.clear();
  return {};
}

Status WriteFileBytes(const std::string& path, std::string_view bytes)
{
  PendingFile pending;
  Status status = pending.Open(path);
  if (!status.Ok())
  {
    return status;
  }
  FilePointer file(std::fopen(pending.Name().c_str(), "wb"));
  if (!file || std::fwrite(bytes.data(), 1, bytes.size(), file.get()) != bytes.size() ||
      std::fflush(file.get()) != 0)
  {
    return Unwritable(path, SystemMessage());
  }
  if (std::fclose(file.release()) != 0)
  {
    return Unwritable(path, SystemMessage());
  }
  return pending.Commit();
}
} // namespace featurehex

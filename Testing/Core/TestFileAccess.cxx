// SPDX-License-Identifier: BSD-3-Clause
#include "FileAccess.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace featurehex;
namespace fs = std::filesystem;

TEST(FileAccess, APendingFileAppearsOnlyWhenCommitted)
{
  const fs::path folder = fs::temp_directory_path() / "featurehex-file-access";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const std::string name = (folder / "out.txt").string();
  {
    PendingFile pending;
    ASSERT_TRUE(pending.Open(name).Ok());
    std::ofstream(pending.Name()) << "half";
  }
  EXPECT_TRUE(fs::is_empty(folder));

  ASSERT_TRUE(WriteFileBytes(name, "whole").Ok());
  fs::create_symlink("out.txt", folder / "link");
  fs::permissions(name, fs::perms::owner_read | fs::perms::owner_write);
  ASSERT_TRUE(WriteFileBytes((folder / "link").string(), "other").Ok());
  std::string bytes;
  ASSERT_TRUE(ReadFileBytes(name, bytes).Ok());
  EXPECT_EQ(bytes, "other");
  EXPECT_TRUE(fs::is_symlink(folder / "link"));
  EXPECT_EQ(fs::status(name).permissions(), fs::perms::owner_read | fs::perms::owner_write);

  EXPECT_EQ(WriteFileBytes(folder.string(), "x").Code, StatusCode::UnwritableFile);
  EXPECT_EQ(WriteFileBytes("/dev/null", "x").Code, StatusCode::UnwritableFile);
  EXPECT_EQ(WriteFileBytes((folder / "none" / "x").string(), "x").Code, StatusCode::UnwritableFile);
  EXPECT_EQ(WriteFileBytes("", "x").Code, StatusCode::UnwritableFile);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);
  fs::remove_all(folder);
}

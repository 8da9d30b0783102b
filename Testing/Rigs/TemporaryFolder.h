// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Provides a folder for a test program's files, which is removed when the program ends. */
#ifndef TemporaryFolder_h
#define TemporaryFolder_h

#include "Rigs/Portable.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

/// Returns the path of a file in a temporary folder whose name contains "VolumeHaptics".
inline std::string TemporaryPath(const std::string& name)
{
  struct Folder
  {
    Folder()
      : Owner(GetProcessNumber())
    {
      const std::filesystem::path all = testing::TempDir();
      this->Path = MakeNewFolder(all / "VolumeHaptics").generic_string() + "/";
    }
    ~Folder()
    {
      // Only the process that created the folder removes it, not a forked child.
      if (GetProcessNumber() == this->Owner)
      {
        std::error_code ignored;
        std::filesystem::remove_all(this->Path, ignored);
      }
    }
    std::string Path;
    const long Owner;
  };
  static const Folder folder;
  return folder.Path + name;
}

#endif

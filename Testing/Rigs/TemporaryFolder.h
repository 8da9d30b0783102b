// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Files of a test program, in a folder of its own that is removed at its end. */
#ifndef TemporaryFolder_h
#define TemporaryFolder_h

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>

#include <unistd.h>

/// The path of a file in the folder, which ends with a slash and has "VolumeHaptics" in its name.
inline std::string TemporaryPath(const std::string& name)
{
  struct Folder
  {
    Folder()
      : Path(testing::TempDir())
      , Owner(getpid())
    {
      std::string name = (std::filesystem::path(this->Path) / "VolumeHapticsXXXXXX").string();
      if (!mkdtemp(name.data()))
      {
        throw std::runtime_error("no folder can be made in " + this->Path);
      }
      this->Path = name + "/";
    }
    ~Folder()
    {
      // A forked child leaves the folder to its parent.
      if (getpid() == this->Owner)
      {
        std::error_code ignored;
        std::filesystem::remove_all(this->Path, ignored);
      }
    }
    std::string Path;
    const pid_t Owner;
  };
  static const Folder folder;
  return folder.Path + name;
}

#endif

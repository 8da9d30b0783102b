// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A file of devices for one test. Create it before an emulator and destroy it afterwards: the
 * emulator's threads read the environment in each call that umockdev intercepts, which must not
 * happen while a variable is set.
 */
#ifndef DevicesFile_h
#define DevicesFile_h

#include "Rigs/TemporaryFolder.h"

#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include <unistd.h>

namespace emulated
{
class DevicesFile
{
public:
  DevicesFile()
  {
    this->Clear();
    setenv("VOLUMEHAPTICS_DEVICES", this->Path.c_str(), 1);
  }
  ~DevicesFile()
  {
    setenv("VOLUMEHAPTICS_DEVICES", this->Others.c_str(), 1);
    this->Clear();
  }
  DevicesFile(const DevicesFile&) = delete;
  DevicesFile& operator=(const DevicesFile&) = delete;

  /** Forgets the devices that other emulators have confirmed since the last call. */
  void Clear() const noexcept
  {
    std::error_code ignored;
    std::filesystem::remove(this->Path, ignored);
  }

  const std::string Path = TemporaryPath("devices-" + std::to_string(getpid()) + ".txt");

private:
  // EmulatedMain.cxx sets this variable
  const std::string Others = std::getenv("VOLUMEHAPTICS_DEVICES");
};
} // namespace emulated

#endif

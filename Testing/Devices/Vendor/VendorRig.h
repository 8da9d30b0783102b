// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Plug-ins in a folder that no other user can write, which is the search path.
 */
#ifndef VendorRig_h
#define VendorRig_h

#include "Devices/Emulated/DeviceBench.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

namespace vendortest
{
using namespace emulated;
namespace fs = std::filesystem;

/**
 * In the system's folder for temporary files, which is sticky: the folders above the build tree may
 * be open to others.
 */
class PluginFolder
{
public:
  PluginFolder()
  {
    std::string name = (fs::temp_directory_path() / "VolumeHapticsVendorXXXXXX").string();
    if (!mkdtemp(name.data()))
    {
      throw std::runtime_error("no folder can be made for plug-ins");
    }
    this->Path = fs::canonical(name);
    setenv("VOLUMEHAPTICS_VENDOR_PATH", this->Path.c_str(), 1);
  }
  ~PluginFolder()
  {
    unsetenv("VOLUMEHAPTICS_VENDOR_PATH");
    std::error_code ignored;
    fs::permissions(this->Path, fs::perms::owner_all, ignored);
    fs::remove_all(this->Path, ignored);
  }
  /** Copies a plug-in of the build tree, writable by its owner only. */
  fs::path Add(const std::string& plugin, const std::string& name = "") const
  {
    const fs::path file =
      this->Path / ("libvolumehaptics-" + (name.empty() ? plugin : name) + ".so");
    fs::copy_file(std::string(VOLUME_HAPTICS_PLUGINS) + "/libvolumehaptics-" + plugin + ".so", file,
      fs::copy_options::overwrite_existing);
    fs::permissions(file, fs::perms::owner_all);
    return file;
  }
  fs::path Path;
};

inline std::string TextOfMissing()
{
  for (const DeviceObstacle& obstacle : ListMissingKinds())
  {
    if (obstacle.Kind == "vendor")
    {
      return obstacle.Text;
    }
  }
  return {};
}

inline std::vector<DeviceListing> ListVendors()
{
  std::vector<DeviceListing> all;
  for (const DeviceListing& listing : ListDevices())
  {
    if (listing.Id.compare(0, 7, "vendor:") == 0)
    {
      all.push_back(listing);
    }
  }
  return all;
}

} // namespace vendortest

#endif

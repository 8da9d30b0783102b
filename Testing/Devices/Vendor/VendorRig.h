// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Finds the plug-ins' entries in the list of devices. */
#ifndef VendorRig_h
#define VendorRig_h

#include "Devices/Emulated/DeviceBench.h"
#include "Rigs/PluginFolder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace vendortest
{
using namespace emulated;
namespace fs = std::filesystem;
using devicetest::PluginFolder;

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

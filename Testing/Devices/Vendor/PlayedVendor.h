// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A plug-in with a device that a test controls. The test accesses the device in the loaded plug-in
 * through the function GetPlayedVendor.
 */
#ifndef PlayedVendor_h
#define PlayedVendor_h

#include "Devices/Vendor/VendorPlugin.h"

#include <array>
#include <mutex>
#include <string>
#include <vector>

struct PlayedVendor
{
  std::mutex Mutex;
  int Count = 2;
  std::string Error = "is as the test wants it.";
  std::string Name = "Played stylus";
  std::string Serial = "SN 1=2";
  VolumeHapticsVendorLimits Limits{ 4.0, 0.1, 800.0, 5.0, 0.0, 0.0, 0.05, 7, 0.0, 0.0 };
  VolumeHapticsVendorPose Pose{};
  /// whether Describe returns no serial number for a closed device
  bool TellsSerialOnlyOpen = false;
  int OpenFails = 0;
  int ReadResult = VOLUME_HAPTICS_VENDOR_NEWS;
  int WriteResult = VOLUME_HAPTICS_VENDOR_DONE;
  int HomeResult = VOLUME_HAPTICS_VENDOR_DONE;
  int ReadTime = 0; ///< duration (ms) of the next read
  int Homes = 0;
  int Asked = 0; ///< number of calls of Count and Describe
  std::array<double, 3> Force{};
  std::array<double, 3> Torque{};
  /// names of the calls, without reads and repeated writes of the same force
  std::vector<std::string> Calls;
};

#endif

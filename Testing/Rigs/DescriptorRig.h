// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Provides shared code for the tests of HID descriptors.
 */
#ifndef DescriptorRig_h
#define DescriptorRig_h

#include "Devices/Transport/Hid/HidReportDescriptor.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace hardwaretest
{
using namespace VolumeHaptics;

using Bytes = std::vector<std::uint8_t>;

inline HidReportDescriptor Parsed(const Bytes& bytes)
{
  HidReportDescriptor descriptor;
  std::string error;
  EXPECT_TRUE(descriptor.Parse(bytes.data(), bytes.size(), error)) << error;
  return descriptor;
}

/** Returns the error that a bad descriptor causes. */
inline std::string ErrorOf(const Bytes& bytes)
{
  HidReportDescriptor descriptor;
  std::string error;
  EXPECT_FALSE(descriptor.Parse(bytes.data(), bytes.size(), error));
  EXPECT_TRUE(descriptor.GetFields().empty());
  return error;
}

inline Bytes operator+(Bytes a, const Bytes& b)
{
  a.insert(a.end(), b.begin(), b.end());
  return a;
}
} // namespace hardwaretest

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Simulates the servo's, the owner's and the device's side of an exchange in one thread. */
#ifndef ExchangeRig_h
#define ExchangeRig_h

#include "Devices/Common/HardwareExchange.h"

#include <gtest/gtest.h>

namespace hardwaretest
{
using namespace VolumeHaptics;

class ExchangeTest : public testing::Test
{
protected:
  ExchangeTest()
  {
    Asleep = 0;
    this->Exchange.Begin();
  }
  DeviceState Take()
  {
    this->Sample.Fresh = false;
    return this->Exchange.Receive(this->Sample);
  }

  /// ns, simulated time that the computer has been asleep so far
  static inline std::int64_t Asleep = 0;
  HardwareExchange Exchange{ [] { return Asleep; } };
  DeviceSample Sample;
};
} // namespace hardwaretest

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A virtual device on a ramp, led by the test.
 */
#ifndef DeviceRig_h
#define DeviceRig_h

#include "../Api/ApiRig.h"

#include <vtkHapticDevice.h>
#include <vtkMatrix4x4.h>

#include <chrono>
#include <cmath>
#include <thread>

namespace devicetest
{
using namespace apitest;

/// Polls until something holds; false after a generous time.
template <typename F>
bool Eventually(F&& holds)
{
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while (!holds())
  {
    if (std::chrono::steady_clock::now() > end)
    {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::microseconds(500));
  }
  return true;
}

inline double Length(const double v[3])
{
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

class DeviceTest : public testing::Test
{
protected:
  DeviceTest()
  {
    this->Filter->SetInputData(0, this->Image);
    this->Device->SetVolumeHaptics(this->Filter);
  }

  /// The servo runs, with the tip where the ramp begins to be felt.
  void Begin(const char* id = "virtual")
  {
    ASSERT_TRUE(this->Device->Open(id));
    if (std::string(id) == "virtual")
    {
      this->Device->SetVirtualTip(7.0, 7.0, 5.0);
    }
    ASSERT_TRUE(this->Device->Start());
    ASSERT_TRUE(this->WaitTicks(2));
  }
  bool WaitTicks(vtkIdType ticks)
  {
    this->Device->UpdateState();
    const vtkIdType end = this->Device->GetTick() + ticks;
    return this->Wait([&] { return this->Device->GetTick() >= end; });
  }
  template <typename F>
  bool Wait(F&& holds)
  {
    return Eventually(
      [&]
      {
        this->Device->UpdateState();
        return holds();
      });
  }
  /// Force flows. Where a busy machine held the loop up, it began anew from where the hand is: once more from outside.
  bool WaitForce()
  {
    for (int attempt = 0; attempt < 5; ++attempt)
    {
      for (int i = 0; i < 300; ++i)
      {
        this->Device->UpdateState();
        if (Length(this->Device->GetForce()) > 0.2)
        {
          return true;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
      }
      if (this->Device->GetDeviceId() == "virtual")
      {
        const double* const tip = this->Device->GetTipPosition();
        const double inside[3] = { tip[0], tip[1], tip[2] };
        this->Lead(7.0, 7.0, 5.0);
        this->Device->SetVirtualTip(inside);
      }
    }
    return false;
  }
  /// Leads the tip and waits until it is there.
  bool Lead(double x, double y, double z)
  {
    this->Device->SetVirtualTip(x, y, z);
    return this->Wait(
      [&]
      {
        const double* tip = this->Device->GetTipPosition();
        const double way[3] = { tip[0] - x, tip[1] - y, tip[2] - z };
        return Length(way) < 1e-6;
      });
  }
  std::string File(const char* name) { return testing::TempDir() + "VolumeHaptics" + name; }
  void ExpectError(const char* words)
  {
    ASSERT_EQ(this->Log.Errors.size(), 1U);
    EXPECT_NE(this->Log.Errors[0].find(words), std::string::npos) << this->Log.Errors[0];
    this->Log.Errors.clear();
  }

  vtkSmartPointer<vtkImageData> Image = MakeRamp();
  vtkNew<vtkVolumeHapticsFilter> Filter;
  vtkNew<vtkHapticDevice> Device;
  MessageLog Log{ this->Device };
  MessageLog FilterLog{ this->Filter };
};
} // namespace devicetest

#endif

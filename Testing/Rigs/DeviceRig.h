// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A virtual device on a ramp, led by the test.
 */
#ifndef DeviceRig_h
#define DeviceRig_h

#include "ApiRig.h"
#include "Eventually.h"
#include "LoopPauses.h"
#include "TemporaryFolder.h"

#include <vtkMatrix4x4.h>

#include <cmath>

namespace devicetest
{
using namespace apitest;

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

  /// The servo runs, with the tip at the beginning of the ramp's force.
  void Begin(const char* id = "virtual")
  {
    this->Way.clear();
    ASSERT_TRUE(this->Device->Open(id));
    if (std::string(id) == "virtual")
    {
      this->Device->SetVirtualTip(7.0, 7.0, 5.0);
    }
    ASSERT_TRUE(this->Device->Start());
    ASSERT_TRUE(this->WaitTicks(2));
  }
  /// The servo runs, armed, with a light tip that a far goal makes faster than a hand may be.
  void BeginFast()
  {
    ASSERT_TRUE(this->Device->Open("virtual"));
    this->Device->SetVirtualDynamics(0.01, 4.0, 2000.0, 0.0, 0);
    this->Device->SetVirtualTip(7.0, 7.0, 5.0);
    ASSERT_TRUE(this->Device->Start());
    this->Device->Arm();
    ASSERT_TRUE(this->WaitTicks(5));
  }
  bool WaitTicks(vtkIdType ticks)
  {
    this->Look();
    const vtkIdType end = this->Device->GetTick() + ticks;
    return this->Wait([&] { return this->Device->GetTick() >= end; });
  }
  /// Polls the device until something holds in a state that no pause of the loop came before.
  template <typename F>
  bool Wait(F&& holds)
  {
    return Eventually(
      [&]
      {
        this->Look();
        if (this->Pauses.WasHeldUp())
        {
          this->GoAgain();
        }
        return !this->Pauses.WasHeldUp() && holds();
      });
  }
  bool WaitForce()
  {
    return this->Wait([this] { return Length(this->Device->GetForce()) > 0.2; });
  }
  /// Leads the tip and waits until it is there.
  bool Lead(double x, double y, double z)
  {
    if (this->Way.empty())
    {
      const double* const start = this->Device->GetTipPosition();
      this->Way.push_back({ start[0], start[1], start[2] });
    }
    this->Way.push_back({ x, y, z });
    this->Device->SetVirtualTip(x, y, z);
    return this->Wait([this] { return this->IsAt(this->Way.back()); });
  }
  /// The servo runs, armed, and the tip presses the ramp with 1.5 N.
  void BeginPressed()
  {
    this->Begin();
    this->Device->Arm();
    ASSERT_TRUE(this->Lead(7.0, 7.0, 8.0));
    ASSERT_TRUE(this->Wait([this] { return Length(this->Device->GetForce()) > 1.4; }));
  }
  std::string File(const char* name) { return TemporaryPath(name); }
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

private:
  void Look()
  {
    this->Device->UpdateState();
    this->Pauses.Look(this->Device);
  }
  bool IsAt(const Point& place)
  {
    const double* const tip = this->Device->GetTipPosition();
    const double way[3] = { tip[0] - place[0], tip[1] - place[1], tip[2] - place[2] };
    return Length(way) < 1e-6;
  }
  /// The way that Lead went, from its start on.
  void GoAgain()
  {
    this->Pauses.Forget();
    for (const Point& place : this->Way)
    {
      this->Device->SetVirtualTip(place.data());
      const bool isThere = Eventually(
        [&]
        {
          this->Look();
          return this->Pauses.WasHeldUp() || this->IsAt(place);
        });
      if (!isThere || this->Pauses.WasHeldUp())
      {
        return;
      }
    }
  }

  LoopPauses Pauses;
  std::vector<Point> Way;
};
} // namespace devicetest

#endif

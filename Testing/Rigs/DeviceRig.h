// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Runs a virtual device, whose tip the test moves, on a ramp. */
#ifndef DeviceRig_h
#define DeviceRig_h

#include "ApiRig.h"
#include "Eventually.h"
#include "LoopPauses.h"
#include "TemporaryFolder.h"

#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>

namespace devicetest
{
using namespace apitest;

inline double Length(const double v[3])
{
  return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

/// Returns whether the full force is active: no ramp, hold or gap is in progress.
inline bool IsFullyArmed(vtkHapticDevice* device)
{
  return device->GetStatus() == vtkHapticDevice::ACTIVE &&
    device->GetStatusText().find("100 % of the force passes") != std::string::npos;
}
inline bool IsRising(vtkHapticDevice* device)
{
  return device->GetStatusText().find("(it rises)") != std::string::npos;
}

class DeviceTest : public testing::Test
{
protected:
  DeviceTest()
  {
    this->Filter->SetInputData(0, this->Image);
    this->Device->SetVolumeHaptics(this->Filter);
  }

  /// Starts the servo, with the tip where the ramp's force begins.
  void Begin(const char* id = "virtual")
  {
    this->BeginWayHere();
    ASSERT_TRUE(this->Device->Open(id));
    if (std::string(id) == "virtual")
    {
      this->Device->GetVirtualHand()->SetPosition(7.0, 7.0, 5.0);
    }
    ASSERT_TRUE(this->Device->Start());
    ASSERT_TRUE(this->WaitTicks(2));
  }
  /// Starts and arms the servo. A distant target accelerates the light tip beyond the speed limit.
  void BeginFast()
  {
    ASSERT_TRUE(this->Device->Open("virtual"));
    this->Device->GetVirtualHand()->SetDynamics(0.01, 4.0, 2000.0, 0.0, 0);
    this->Device->GetVirtualHand()->SetPosition(7.0, 7.0, 5.0);
    ASSERT_TRUE(this->Device->Start());
    this->Device->Arm();
    ASSERT_TRUE(this->WaitTicks(5));
  }
  bool WaitTicks(vtkIdType ticks)
  {
    this->Look();
    const vtkIdType end = this->Device->GetState()->GetTick() + ticks;
    return this->Wait([&] { return this->Device->GetState()->GetTick() >= end; });
  }
  /// Polls the device until `holds` returns true for a state, and no pause of the loop has preceded
  /// this state.
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
    return this->Wait([this] { return Length(this->Device->GetState()->GetForce()) > 0.2; });
  }
  /// Moves the tip to a position, and waits for its arrival. Returns false if the tip does not
  /// arrive.
  bool Lead(double x, double y, double z)
  {
    if (this->Way.empty())
    {
      const double* const start = this->Device->GetState()->GetTipPosition();
      this->Way.push_back({ start[0], start[1], start[2] });
    }
    this->Way.push_back({ x, y, z });
    this->Device->GetVirtualHand()->SetPosition(x, y, z);
    return this->Wait([this] { return this->IsAt(this->Way.back()); });
  }
  /// Discards the recorded path, so that a repetition by Lead() begins at the present position.
  void BeginWayHere() { this->Way.clear(); }
  /// Waits until the force gate's ramp has ended. A wall pressed during the ramp would stay soft
  /// until the tip leaves it.
  bool WaitFullyArmed()
  {
    return this->Wait([this] { return IsFullyArmed(this->Device); });
  }
  bool ArmFully()
  {
    this->Device->Arm();
    return this->WaitFullyArmed();
  }
  /// Moves the tip into the ramp slowly enough that the slew limit does not act.
  bool LeadInto(double z)
  {
    bool isThere = true;
    for (double way = this->Device->GetState()->GetTipPosition()[2]; isThere && way < z;)
    {
      way = std::min(way + 0.5, z);
      isThere = this->Lead(7.0, 7.0, way);
    }
    return isThere;
  }
  /// Starts and arms the servo, and presses into the ramp with 1.5 N.
  void BeginPressed()
  {
    this->Begin();
    ASSERT_TRUE(this->ArmFully());
    ASSERT_TRUE(this->LeadInto(8.0));
    ASSERT_TRUE(this->WaitPressed());
  }
  bool WaitPressed()
  {
    return this->Wait([this] { return Length(this->Device->GetState()->GetForce()) > 1.4; });
  }
  /// Leaves the ramp, and presses into it again with 1.5 N.
  bool PressAgain()
  {
    return this->Lead(7.0, 7.0, 5.0) && this->WaitFullyArmed() && this->LeadInto(8.0) &&
      this->WaitPressed();
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
    const double* const tip = this->Device->GetState()->GetTipPosition();
    const double way[3] = { tip[0] - place[0], tip[1] - place[1], tip[2] - place[2] };
    return Length(way) < 1e-6;
  }
  /// Repeats the path of Lead() from its start. Begins each time after the ramp of the force has
  /// ended.
  void GoAgain()
  {
    this->Pauses.Forget();
    for (const Point& place : this->Way)
    {
      this->Device->GetVirtualHand()->SetPosition(place.data());
      const bool isThere = Eventually(
        [&]
        {
          this->Look();
          return this->Pauses.WasHeldUp() || (this->IsAt(place) && !IsRising(this->Device));
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

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Provides an emulated WoodenHaptics, a floor, and a hand that is moved into the floor. */
#ifndef WoodenRig_h
#define WoodenRig_h

#include "DeviceBench.h"
#include "Emulators/EmulatedHid.h"
#include "Emulators/WoodenModel.h"

#include <gtest/gtest.h>

namespace emulated
{
inline constexpr double Height = -0.01; ///< m, height of the floor
/// Maps the device's axes (right, up, towards the hand) to the arm's y, z and x.
inline const Matrix3 ToTheArm = Matrix3::FromColumns({ 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 0 });

class Wooden : public testing::Test
{
protected:
  /// Calibrates and arms the device, and moves the hand's goal 10 mm deep into the middle of the
  /// floor.
  void Feel()
  {
    ASSERT_TRUE(this->Bench.WaitForText("rest pose")) << this->Bench.Text();
    EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Homing);
    this->Bench.Start(this->Ground.Model);
    this->Bench.Device->Home();
    ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
    ASSERT_TRUE(this->Bench.WaitForTicks(20));
    this->Bench->Arm();
    EXPECT_TRUE(this->Bench.Press(
      [&]
      {
        this->Model.SetGoal({ 0.0, 0.0, Height + 0.005 });
        Eventually([&] { return std::abs(this->Model.GetTip()[2] - Height - 0.005) < 0.001; });
      },
      [&] {
        this->Model.SetGoal({ 0.0, 0.0, Height - 0.01 });
      },
      [&] { return this->IsHeld(); }))
      << this->Model.GetForce()[2];
  }
  /// Returns whether the floor's force balances a hand whose goal is 10 mm inside.
  bool IsHeld()
  {
    const double force = FloorStiffness * BalancedDepth(0.01);
    return IsNear(this->Model.GetForce(), { 0.0, 0.0, force }, 0.05);
  }

  WoodenModel Model;
  EmulatedHid Hid{ this->Model };
  Floor Ground{ Height, ToTheArm };
  DeviceBench Bench;
};

} // namespace emulated

#endif

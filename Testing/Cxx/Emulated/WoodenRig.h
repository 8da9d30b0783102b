// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * An emulated WoodenHaptics, a floor that it feels, and a hand that is led into it.
 */
#ifndef WoodenRig_h
#define WoodenRig_h

#include "HidRig.h"
#include "WoodenModel.h"

#include <gtest/gtest.h>

namespace emulated
{
inline constexpr double Height = -0.01; ///< m, of the floor

class Wooden : public testing::Test
{
protected:
  /// Calibrates, arms, and leads the hand to the floor's middle, 10 mm inside.
  void Feel()
  {
    ASSERT_TRUE(this->Bench.WaitForText("rest pose")) << this->Bench.Text();
    EXPECT_EQ(this->Bench.Device->GetCondition().Stage, DeviceStage::Homing);
    this->Bench.Start(this->Ground.Model);
    this->Bench.Device->Home();
    ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
    ASSERT_TRUE(this->Bench.WaitForTicks(20));
    this->Bench->Arm();
    this->Model.SetGoal({ 0.0, 0.0, Height + 0.005 });
    ASSERT_TRUE(Eventually([&] { return this->Model.GetTip()[2] < Height + 0.006; }));
    this->Model.SetGoal({ 0.0, 0.0, Height - 0.01 });
    EXPECT_TRUE(this->Settles(1.0)) << this->Model.GetForce()[2];
  }
  /// The floor holds against a hand that is led 10 mm inside.
  bool Settles(double part)
  {
    const double force = part * FloorStiffness * BalancedDepth(0.01);
    return Eventually([&] { return IsNear(this->Model.GetForce(), { 0.0, 0.0, force }, 0.05); });
  }

  WoodenModel Model;
  EmulatedHid Hid{ this->Model };
  Floor Ground{ Height };
  HidBench Bench;
};

} // namespace emulated

#endif

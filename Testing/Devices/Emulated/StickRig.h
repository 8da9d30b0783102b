// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Provides an emulated wheel, a wall to the right of its centre, and a hand that is moved into the
 * wall.
 */
#ifndef StickRig_h
#define StickRig_h

#include "DeviceBench.h"
#include "Emulators/EmulatedHid.h"
#include "Emulators/ModelClock.h"
#include "Emulators/OpenFfboardModel.h"

#include <gtest/gtest.h>

namespace emulated
{
inline constexpr double Wall = 0.01; ///< m: position of the wall, to the right of the centre
/// Rotation from the device's axes to the wall's: the wall faces the device's left.
inline const Matrix3 ToTheLeft = Matrix3::FromColumns({ 0, 0, -1 }, { 0, 1, 0 }, { 1, 0, 0 });

class Pid : public testing::Test
{
protected:
  // Set the full scale of the second axis to 0 N, because it has no motor.
  Pid() { this->Options.NewtonsPerFullScale = { FfbHandle::FullScale, 0.0 }; }

  void Feel()
  {
    ASSERT_TRUE(this->Bench.WaitFor(DeviceStage::Ready)) << this->Bench.Text();
    this->Bench.Start(this->Ground.Model);
    ASSERT_TRUE(this->Bench.WaitForTicks(20));
    this->Bench->Arm();
    const double force = -FloorStiffness * BalancedDepth(0.01);
    EXPECT_TRUE(this->Bench.Press(
      [&]
      {
        this->Model.SetGoal(Wall - 0.005, 0.0);
        Eventually([&] { return this->Model.GetTip()[0] < Wall - 0.004; });
      },
      [&] { this->Model.SetGoal(Wall + 0.01, 0.0); },
      [&] {
        return IsNear(this->Model.GetForce(), { force, 0.0, 0.0 }, 0.05);
      }))
      << this->Model.GetForce()[0];
  }

  OpenFfboardModel Model;
  EmulatedHid Hid{ this->Model };
  ModelClock Clock{ [this] { this->Model.Step(); } };
  Floor Ground{ -Wall, ToTheLeft };
  DeviceOptions Options;
  DeviceBench Bench;
};

} // namespace emulated

#endif

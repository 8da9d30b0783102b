// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Expects that faults cut the force, and that the force stays zero until the user arms again.
 */

#include "SafetyRig.h"

using namespace servotest;

namespace
{
const Vector3 Force{ 0.0, 0.0, 1.5 };

class SafetyFaults : public SafetyTest
{
};
} // namespace

TEST_F(SafetyFaults, NoForceBeforeArming)
{
  EXPECT_EQ(this->Stage.Gate.GetState(), GateState::Disarmed);
  EXPECT_TRUE(IsZero(this->Repeat(Force, 1000)));
}

TEST_F(SafetyFaults, ForcesThatAreNotFinite)
{
  for (const double bad : { NaN, Infinity, -Infinity })
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      this->Activate(Force);
      Vector3 broken = Force;
      (axis == 0 ? broken.X : axis == 1 ? broken.Y : broken.Z) = bad;
      this->Apply(broken);
      this->ExpectLatched(GateReason::NotFinite, Force);
    }
  }
}

TEST_F(SafetyFaults, TipsThatAreNotFinite)
{
  for (const double bad : { NaN, Infinity })
  {
    this->Activate(Force);
    this->Input.Tip = { 0.0, bad, 0.0 };
    this->Apply(Force);
    this->Input.Tip = {};
    this->ExpectLatched(GateReason::NotFinite, Force);
  }
}

TEST_F(SafetyFaults, OverSpeed)
{
  this->Activate(Force);
  // The speed limit is between 2.4 m/s and 2.6 m/s.
  for (int i = 0; i < 50; ++i)
  {
    this->Input.Tip.X += 0.0024;
    this->Apply(Force);
  }
  this->Input.Tip.X += 0.0026;
  this->Apply(Force);
  this->ExpectLatched(GateReason::OverSpeed, Force);
}

TEST_F(SafetyFaults, OverSpeedGoesByTheTimeThatPassed)
{
  this->Activate(Force);
  // If 10 ms have passed since the last sample, the tip may move ten times as far as in a tick of 1
  // ms.
  this->Input.Elapsed = 0.01;
  this->Input.Tip.X += 0.024;
  this->Apply(Force);
  EXPECT_EQ(this->Stage.Gate.GetFault(), GateReason::None);
  this->Input.Tip.X += 0.026;
  this->Apply(Force);
  EXPECT_EQ(this->Stage.Gate.GetFault(), GateReason::OverSpeed);
}

TEST_F(SafetyFaults, OverSpeedIsNotMadeUpByALateWakeUp)
{
  this->Activate(Force);
  // The device moves at a constant 2 m/s by its own clock. The loop reads it alternately late and
  // on time.
  for (int i = 0; i < 20; ++i)
  {
    this->Input.Elapsed = i % 2 == 0 ? 0.0019 : 0.0001;
    this->Input.Tip.X += 0.002;
    this->Apply(Force);
    ASSERT_EQ(this->Stage.Gate.GetFault(), GateReason::None) << "in tick " << i;
  }
}

TEST_F(SafetyFaults, NoSpeedIsTooMuchWithoutALimit)
{
  this->Limits.MaximumSpeed = 0.0;
  this->Activate(Force);
  this->Input.Tip.X += 1.0;
  this->Apply(Force);
  EXPECT_EQ(this->Stage.Gate.GetFault(), GateReason::None);
}

TEST_F(SafetyFaults, ALostDevice)
{
  this->Activate(Force);
  this->Input.Lost = true;
  this->Apply(Force);
  this->ExpectLatched(GateReason::DeviceLost, Force);
}

TEST_F(SafetyFaults, AreNotRaisedWhileDisarmed)
{
  this->Apply({ NaN, 0.0, 0.0 });
  this->Input.Lost = true;
  this->Apply(Force);
  this->Input.Lost = false;
  this->Input.Tip.X = 100.0;
  this->Apply(Force);
  EXPECT_EQ(this->Stage.Gate.GetFault(), GateReason::None);
  EXPECT_TRUE(IsZero(this->Output));
}

TEST_F(SafetyFaults, DisarmingCutsAtOnce)
{
  this->Activate(Force);
  this->Stage.Gate.Disarm();
  EXPECT_TRUE(IsZero(this->Apply(Force)));
  EXPECT_EQ(this->Stage.Gate.GetState(), GateState::Disarmed);
}

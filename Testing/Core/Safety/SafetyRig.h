// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Runs a safety stage and checks each tick: the force must be finite and at most the maximum, and
 * must grow at most by the slew limit.
 */
#ifndef SafetyRig_h
#define SafetyRig_h

#include "Rigs/GatedStage.h"
#include "Rigs/Growth.h"

#include <gtest/gtest.h>

#include <limits>

namespace servotest
{
using namespace VolumeHaptics;

inline constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
inline constexpr double Infinity = std::numeric_limits<double>::infinity();

inline bool IsZero(const Vector3& v)
{
  return v.X == 0.0 && v.Y == 0.0 && v.Z == 0.0;
}

class SafetyTest : public testing::Test
{
protected:
  SafetyTest()
  {
    this->Limits.MaximumForce = 4.0;
    this->Limits.MaximumForceRate = 500.0;
    this->Limits.MaximumSpeed = 2.5;
    this->Input.Elapsed = this->Input.Period;
    this->Input.Fresh = true;
  }

  /// Runs one tick with a wanted force (N), and checks the result against the limits. Returns the
  /// force that is sent.
  Vector3 Apply(const Vector3& force)
  {
    this->Input.Force = force;
    const Vector3 before = this->Output;
    this->Output = this->Stage.Apply(this->Input, this->Limits);
    const double step = this->Limits.MaximumForceRate * this->Input.Period;
    EXPECT_TRUE(IsFinite(this->Output));
    EXPECT_LE(Norm(this->Output), this->Limits.MaximumForce * (1.0 + 1e-12));
    EXPECT_LE(GrowthOf(before, this->Output), step * (1.0 + 1e-9));
    return this->Output;
  }

  Vector3 Repeat(const Vector3& force, int ticks)
  {
    for (int i = 0; i < ticks; ++i)
    {
      this->Apply(force);
    }
    return this->Output;
  }

  /// Arms the stage, and applies a force (N) until the ramp has ended.
  void Activate(const Vector3& force)
  {
    this->Stage.Arm();
    this->Repeat(force, 600);
    ASSERT_LT(Norm(this->Output - force), 1e-12);
  }

  /// Expects that the force is cut at once, and that the fault stays until the stage is armed
  /// again.
  void ExpectLatched(GateReason fault, const Vector3& force)
  {
    EXPECT_TRUE(IsZero(this->Output));
    EXPECT_EQ(this->Stage.Gate.GetFault(), fault);
    this->Input.Lost = false;
    for (int i = 0; i < 2000; ++i)
    {
      ASSERT_TRUE(IsZero(this->Apply(force)));
    }
    EXPECT_EQ(this->Stage.Gate.GetFault(), fault);
    this->Stage.Arm();
    EXPECT_EQ(this->Stage.Gate.GetFault(), GateReason::None);
    EXPECT_TRUE(IsZero(this->Apply(force))) << "the ramp begins at zero";
    this->Repeat(force, 600);
    EXPECT_LT(Norm(this->Output - force), 1e-12);
  }

  rigs::GatedStage Stage;
  SafetyLimits Limits;
  SafetyInput Input;
  Vector3 Output;
};
} // namespace servotest

#endif

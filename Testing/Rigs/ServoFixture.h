// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Runs a servo session on a ramp, for each method. */
#ifndef ServoFixture_h
#define ServoFixture_h

#include "CoreScene.h"

#include <gtest/gtest.h>

namespace coretest
{
inline constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

inline bool IsSame(const Vector3& a, const Vector3& b)
{
  return a.X == b.X && a.Y == b.Y && a.Z == b.Z;
}

class ServoTick : public testing::TestWithParam<HapticMethod>
{
protected:
  ServoTick()
  {
    this->Description.Settings.Method = this->GetParam();
    this->Description.Settings.ForceFieldGain = 0.02;
    this->Description.Settings.IsoValue = 1200.0;
    this->Description.Settings.ForceFieldDamping = 3.0;
    this->Description.Material.Friction = ConstantPolyline(0.3);
    this->Description.Material.Viscosity = ConstantPolyline(0.2);
  }

  TickRecord Step(const HapticModel& model, ServoState& state, const Vector3& tip)
  {
    TickRecord record;
    Tick(model, state, tip, record);
    return record;
  }

  TestVolume Volume = MakeRamp();
  HapticModelDescription Description = Describe(this->Volume);
};
} // namespace coretest

#endif

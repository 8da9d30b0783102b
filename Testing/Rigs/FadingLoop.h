// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Records a servo loop on a ramp, and checks in each tick that the force does not jump. */
#ifndef FadingLoop_h
#define FadingLoop_h

#include "PlayedDevice.h"

#include <algorithm>

namespace servotest
{
class FadingLoop : public testing::Test
{
protected:
  /// @param rate tick rate (Hz) of the loops that Take() reads
  explicit FadingLoop(double rate)
    : TickRate(rate)
  {
  }
  /// Reads the next tick. Expects the force to change at most as fast as the limits and the fade
  /// allow.
  void Take(RunningLoop& loop)
  {
    const double most =
      std::max(this->Limits.MaximumForceRate, this->Limits.MaximumForce / ForceGate::FadeTime);
    ServoSnapshot next;
    ASSERT_TRUE(Eventually([&] { return loop->Drain(next); }));
    const double step = Norm(next.Command - this->Last.Command);
    EXPECT_TRUE(!this->HasLast || step <= most / this->TickRate * (1.0 + 1e-9))
      << step << " N in tick " << next.Tick;
    this->Last = next;
    this->HasLast = true;
  }

  const double TickRate;
  TestVolume Volume = MakeRamp();
  PlayedDevice Device;
  SafetyLimits Limits = QuickLimits();
  ServoSnapshot Last;
  bool HasLast = false; ///< whether the next tick is compared with Last
};
} // namespace servotest

#endif

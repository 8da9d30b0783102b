// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A recorded servo loop on a ramp, whose ticks are taken one by one: no force leaps.
 */
#ifndef FadingLoop_h
#define FadingLoop_h

#include "PlayedDevice.h"

#include <algorithm>

namespace servotest
{
class FadingLoop : public testing::Test
{
protected:
  /// Ticks per second of the loops that Take looks at.
  explicit FadingLoop(double rate)
    : TickRate(rate)
  {
  }
  /// Takes the next tick; its force changes no faster than the limits and the fade let it.
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

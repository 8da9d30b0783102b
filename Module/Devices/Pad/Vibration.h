// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts a force to the speeds of the two motors of a gamepad.
 *
 * A pad can't exert a force, so its vibration renders changes of the force: the faster a force F
 * (N) changes, the stronger the vibration; a constant force causes none. Two low-pass filters
 * smooth F, a fast one (A) and a slow one (B):
 *
 *   dA/dt = (F - A) / FastTime      dB/dt = (F - B) / SlowTime
 *
 * Changes that the fast filter removes, above 1 / (2 pi FastTime) = 8 Hz, drive the weak motor,
 * which turns fast. Changes that only the fast filter passes, down to 1 Hz, drive the strong motor,
 * which turns slowly:
 *
 *   weak   w = min(1, |F - A| / FullChange)
 *   strong s = min(1, |A - B| / FullChange)
 *
 * The levels follow w and s, but rise at most at RiseRate and fall at most at FallRate, so that
 * even a short touch lasts long enough for a motor to respond. Both are fractions of a motor's full
 * speed, from 0 to 1.
 *
 * A force that steps from 0 to f at the time 0 thus causes
 *
 *   w = f exp(-t / FastTime) / FullChange
 *   s = f (exp(-t / SlowTime) - exp(-t / FastTime)) / FullChange
 *
 * With f = 1 N the weak motor reaches 0.70 after 7 ms, and the strong one 0.64 after 46 ms. For a
 * force that grows at r (N/s), the levels approach w = r FastTime / FullChange and s = r (SlowTime
 * - FastTime) / FullChange.
 */
#ifndef Vibration_h
#define Vibration_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{

/** The speed of each motor as a fraction of its full speed, 0 to 1. */
struct VibrationLevels
{
  double Strong = 0.0; ///< level of the motor that turns slowly
  double Weak = 0.0;   ///< level of the motor that turns fast
};

class Vibration
{
public:
  static constexpr double FastTime = 0.02; ///< time constant (s) of the fast low-pass of the force
  static constexpr double SlowTime = 0.15; ///< time constant (s) of the slow low-pass of the force
  /// change of the force (N) at which a motor turns at full speed
  static constexpr double FullChange = 1.0;
  static constexpr double RiseRate = 100.0; ///< 1/s
  static constexpr double FallRate = 10.0;  ///< 1/s
  /** Level below which the motors of pads do not turn; lower levels are sent as zero. */
  static constexpr double Least = 0.04;

  ///@{
  /**
   * ReplayTime: time (s) after the last report at which a device stops vibrating, if it does so by
   * itself. RenewTime: time (s) after which an unchanged level is sent again.
   */
  static constexpr double ReplayTime = 0.15;
  static constexpr double RenewTime = 0.05;
  /** Time (s) between changes; the end of vibration is sent at once. */
  static constexpr double SendPeriod = 0.01;
  ///@}

  /**
   * Advances the levels by a time (s) with a constant force (N). A force that is not finite or
   * exceeds 1e6 N ends the vibration.
   */
  VibrationLevels Advance(const Vector3& force, double elapsed) noexcept;
  /** Resets the filters to the state without a force. */
  void Silence() noexcept;

  /** Converts a level to an integer from 0 to `steps`. Levels below Least become 0. */
  static int Quantize(double level, int steps) noexcept;
  /**
   * Returns whether to send the levels. `age` (s) is the time since levels were last sent. The end
   * of vibration is sent at once, and other changes at most once every SendPeriod. Constant levels
   * are renewed.
   */
  static bool IsDue(bool isSame, bool isSilent, double age) noexcept
  {
    return isSame ? !isSilent && age >= RenewTime : isSilent || age >= SendPeriod;
  }

private:
  Vector3 Fast;
  Vector3 Slow;
  VibrationLevels Levels;
};

} // namespace VolumeHaptics

#endif

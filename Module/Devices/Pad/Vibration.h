// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From a force to the speeds of the two motors of a gamepad.
 *
 * A pad can't push: it tells how the force changes. A force F (N) that stays is not felt; one that
 * changes is, the faster the more. Two low-pass filters follow F, a fast one (A) and a slow one
 * (B):
 *
 *   dA/dt = (F - A) / FastTime      dB/dt = (F - B) / SlowTime
 *
 * Changes that the fast one does not follow, above 1 / (2 pi FastTime) = 8 Hz, are for the weak
 * motor, which turns fast. Those that only the fast one follows, down to 1 Hz, are for the strong
 * motor, which turns slowly:
 *
 *   weak   w = min(1, |F - A| / FullChange)
 *   strong s = min(1, |A - B| / FullChange)
 *
 * The levels follow w and s, and rise by at most RiseRate and fall by at most FallRate, so that a
 * short touch is long enough for a motor. Both are the share of a motor's full speed, from 0 to 1.
 *
 * A force that steps from 0 to f at the time 0 thus asks for
 *
 *   w = f exp(-t / FastTime) / FullChange
 *   s = f (exp(-t / SlowTime) - exp(-t / FastTime)) / FullChange
 *
 * With f = 1 N the weak motor reaches 0.70 after 7 ms, and the strong one 0.64 after 46 ms. A force
 * that grows by r (N/s) ends at w = r FastTime / FullChange and s = r (SlowTime - FastTime) /
 * FullChange.
 */
#ifndef Vibration_h
#define Vibration_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{

/** The share of the full speed of each motor, 0 to 1. */
struct VibrationLevels
{
  double Strong = 0.0; ///< of the slow motor
  double Weak = 0.0;   ///< of the fast motor
};

class Vibration
{
public:
  static constexpr double FastTime = 0.02;  ///< s
  static constexpr double SlowTime = 0.15;  ///< s
  static constexpr double FullChange = 1.0; ///< N, the change that is felt with the full speed
  static constexpr double RiseRate = 100.0; ///< 1/s
  static constexpr double FallRate = 10.0;  ///< 1/s
  /** Below this share motors of pads do not turn: they get nothing. */
  static constexpr double Least = 0.04;

  ///@{
  /** s, for devices on which what was sent ends by itself after ReplayTime. */
  static constexpr double ReplayTime = 0.15;
  static constexpr double RenewTime = 0.05;
  static constexpr double SendPeriod = 0.01; ///< between changes; silence does not wait
  ///@}

  /**
   * The force (N) has been the same for a time (s). One that is not finite, or beyond 1e6 N, is
   * silence.
   */
  VibrationLevels Advance(const Vector3& force, double elapsed) noexcept;
  /** As if there had never been a force. */
  void Silence() noexcept;

  /** A level as a number of 0 to `steps`; 0 below Least. */
  static int Quantize(double level, int steps) noexcept;
  /**
   * Whether to send levels, `age` (s) after the last ones. Silence and others are sent as they come
   * and at most every SendPeriod; levels that stay are renewed.
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

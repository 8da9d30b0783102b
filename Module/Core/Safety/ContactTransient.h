// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A short pulse of force when the tip touches a surface, so that the surface feels hard.
 *
 * A tap on a real surface stops the hand within milliseconds and rings; a sampled spring does
 * neither. Both effects can be produced by a force pulse at touch-down that is played without
 * feedback (Hwang, Williams and Niemeyer, "Toward event-based haptics: rendering contact using
 * open-loop force pulses", 2004; Fiene and Kuchenbecker, "Shaping event-based haptic transients via
 * an improved understanding of real contact dynamics", 2007; only the abstracts of both were read).
 * Let v be the speed of the approach along the push n of the surface, t the time since touch-down,
 * and f a frequency of the material. The pulse along n is a decaying sine, the form that Okamura,
 * Hage, Cutkosky and Dennerlein fitted to taps ("Improving reality-based models for vibration
 * feedback", 2000),
 *
 *   P(t) = a exp(-f t) sin(2 pi f t).                                                          (1)
 *
 * The height a makes the impulse of the first half wave equal to gain m v, with m = TouchMass. With
 * a gain of 1, the pulse alone stops an arm of this mass. A tick of duration T sends the mean of P
 * over T, so that sampling does not change the impulse. The pulse never pulls into the wall: wall
 * and pulse together never push inward.
 *
 * The harder the material, the higher f. Most tissues of the presets have the same stiffness k, so
 * f also depends on the surface strength T_N, as in the explorer's sound (ContactSound.h):
 *
 *   f = 120 Hz (k / 400 N/m)^(1/4) (T_N / 1 N)^(1/2),   T_N <= 12 N,   50 Hz <= f <= 300 Hz.    (2)
 *
 * Energy
 * ------
 *
 * The pulse takes energy from a tip that still moves inward. An account sums up this work,
 *
 *   dA = -p.dx.
 *
 * Only an upper bound of the delay is known, so several pulses may have acted during dx. Of these,
 * p is the one that gives the hand the most energy. Let tau be the time until the next measurement,
 * including the delay. In this time, a tip with the mass LightMass moves along p by at most s +
 * c |p|, with c = tau^2 / (2 LightMass). The pulse is limited to
 *
 *   |p| (s + c |p|) <= A.                                                                      (3)
 *
 * The distance s includes the effect of the wall's own push. A debt of the account remains for the
 * next contact, unless nothing is touched for RestTime. A pulse therefore never gives more than it
 * took, and with an empty account it only brakes. A force that the slew limit still holds back
 * after a pulse counts as a part of p.
 */
#ifndef ContactTransient_h
#define ContactTransient_h

#include "Core/Math/Vector3.h"

#include <array>
#include <cstddef>

namespace VolumeHaptics
{

struct TransientInput
{
  Vector3 Wall;           ///< force (N)
  double Frequency = 0.0; ///< f (Hz) if a surface holds the tip, else 0
  double Gain = 0.0;      ///< gain of (1)
  double Share = 1.0;     ///< fraction of the pulse that is sent, 0 to 1
  double Most = 0.0;      ///< largest force (N)
  double Least = 0.0;     ///< least value (N) to which a pulse may reduce the force of the wall
  double Period = 1e-3;   ///< duration T of a tick (s)
  bool MovesTip = true;   ///< whether (3) must hold
};

class ContactTransient
{
public:
  static constexpr double TouchMass = 0.1;  ///< m in kg: arm and fingers
  static constexpr double LightMass = 0.05; ///< mass (kg) of a light tip
  static constexpr double FreeTime = 0.02;  ///< time (s) without a surface until the next pulse
  static constexpr double RestTime = 0.5;   ///< time (s) without a surface that cancels a debt
  static constexpr double StepSize = 7e-5;  ///< a length (m) above a step of an encoder

  /** Returns f (Hz) by (2) for k (N/m) and T_N (N), or 0 for a material without strength. */
  static double ComputeFrequency(double stiffness, double strength) noexcept;

  /** Clears all data. Afterwards, tip and force are unknown. */
  void Reset() noexcept { *this = ContactTransient{}; }

  /**
   * Processes a measurement of the tip (m). `time` (s) is the time since the last measurement,
   * `late` (s) the delay until a force reaches the device, and `period` (s) the duration of a tick.
   */
  void Observe(const Vector3& tip, double time, double late, double period) noexcept;

  /** Records that the tip has rested for another `time` (s) without a measurement. */
  void Rest(double time) noexcept;

  /** Returns the force (N) of wall and pulse. Must be called in every tick. */
  Vector3 Apply(const TransientInput& input) noexcept;

  /**
   * Records the pulse's part (N) of the force sent until the next tick. Must be called in every
   * tick.
   */
  void RecordSent(const Vector3& pulse) noexcept;

  /** Returns the account A (J). */
  double GetAccount() const noexcept { return this->Account; }

private:
  struct Measurement
  {
    double Time = 0.0; ///< time in s
    Vector3 Tip;
  };
  static constexpr std::size_t Kept = 64;
  void Begin(const TransientInput& input) noexcept;
  double ComputePulse(double period) const noexcept;
  double Limit(double pulse, double wall, const Vector3& out, double period) const noexcept;

  std::array<Measurement, Kept> Measurements{}; ///< a ring buffer
  std::size_t Count = 0;
  std::array<Vector3, Kept> Pulses{}; ///< a ring buffer of the pulses sent (N)
  std::size_t Sent = 0;
  std::size_t SentSince = 0; ///< number of pulses sent since the last measurement
  double Time = 0.0;         ///< time of the last measurement (s)
  Vector3 Tip;
  Vector3 Velocity;      ///< velocity of the tip (m/s)
  double Rested = 0.0;   ///< time (s) of Rest() since the last measurement
  double Between = 1e-3; ///< time between the last two measurements (s)
  double Late = 0.0;     ///< delay until a force reaches the device (s)
  bool HasTip = false;
  double Free = 0.0;      ///< time without a surface (s)
  double Frequency = 0.0; ///< f (Hz)
  double Height = 0.0;    ///< a (N); 0 without a pulse
  double Played = 0.0;    ///< t (s)
  double Account = 0.0;   ///< A (J)
};

} // namespace VolumeHaptics

#endif

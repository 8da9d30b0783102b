// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Renders walls that are stiffer than the loop can render stably by itself.
 *
 * A sampled spring is stable up to a stiffness of k = 2 b / T, where b is the friction of the
 * device and T the round trip (LoopTiming.h). A wall with K > k feels as stiff as K if an offset O
 * is added to the force of the soft spring k without feedback. This follows the idea of the
 * successive force augmentation of Singh, Janetzko, Jafari, Weber, Lee and Ryu ("Enhancing the
 * rate-hardness of haptic interaction: successive force augmentation approach", 2019; only the
 * abstract was read, so the rules below are not theirs). Let d be the depth, x the measured tip, n
 * the direction in which the wall pushes, and v the speed of the tip along n:
 *
 *   F = k d + O,   O = (K - k) d - B v,   0 <= O,   F <= M.                                    (1)
 *
 * Damping
 * -------
 *
 * The offset makes the loop swing, and B takes the energy of the swing. As in PortDamper.h, B is
 * limited to B <= m / (2 tau), m = LightMass, where tau is the delay of v. The speed is the slope
 * of the longest line that is within StepSize of all measured positions (the adaptive window of
 * Janabi-Sharifi, Hayward and Chen, "Discrete-time adaptive windowing for velocity estimation",
 * 2000), so that the steps of an encoder at rest do not count as speed.
 *
 * Account
 * -------
 *
 * The account A is the energy that the hand has put into the port since the contact began, minus
 * the energy that it got back, with the friction b of the device on the hand's side:
 *
 *   dA = -F.dx + b v^2 dt.
 *
 * Only an upper bound of the delay is known. If the tip moves noticeably, F is therefore the one of
 * all forces that may have acted during dx that gives the hand the most energy. If it does not, dx
 * consists of steps of the encoder: F is the mean of the forces before and after the step, and b
 * v^2 dt is left out. In a contact, A is at most the largest energy of the ideal spring K. If a
 * force F acted until the next measurement, a light stylus would move outward by at most s + c F.
 * The force is therefore limited to
 *
 *   O (s + c F) <= A + Tolerance - k d^2 / 2,   O = F - k d >= 0,                              (2)
 *
 * The wall thus gives at most Tolerance more than it got, apart from the energy of the spring k,
 * and with an empty account it is as soft as k. If the slew limit has held back k d, only (2)
 * limits the force for the rest of the contact. A debt remains until nothing was felt for RestTime.
 * If the spring has slack s (PassiveSpring.h), d is the depth minus s.
 *
 * Limits
 * ------
 *
 * The steps q of an encoder let any wall swing within a step unless the dry friction of the device
 * is at least K q / 2 (Abbott and Okamura, "Effects of position quantization and sampling rate on
 * virtual-wall passivity", 2005). A device with coarse encoders and no dry friction buzzes;
 * EnergyObserver.h detects larger swings.
 */
#ifndef ForceAugmentation_h
#define ForceAugmentation_h

#include "Core/Math/Vector3.h"

#include <array>
#include <cstddef>

namespace VolumeHaptics
{

struct AugmentationInput
{
  Vector3 Wall;                ///< force of the wall (N), K d n in (1), or less if it was clamped
  double Pull = 0.0;           ///< K d (N)
  double Stiffness = 0.0;      ///< stiffness K of the wall (N/m)
  double Feedback = 0.0;       ///< stiffness k that the loop renders stably by itself (N/m)
  double Most = 0.0;           ///< largest force M (N)
  double MaximumDamping = 0.0; ///< largest B (N s/m); 0 for no limit
  double DampingShare = 1.0;   ///< fraction of B that is used, 0 to 1
  double Period = 1e-3;        ///< period of the ticks (s)
};

class ForceAugmentation
{
public:
  static constexpr double LightMass = 0.05; ///< m (kg)
  static constexpr double StepSize = 7e-5;  ///< m, more than a step of an encoder
  static constexpr double Tolerance = 1e-3; ///< energy (J) below the bounds of PortObserver.h
  static constexpr double RestTime = 0.5;   ///< time (s) after which a debt is cancelled

  /** Clears all data. Afterwards, force and tip are unknown. */
  void Reset() noexcept { *this = ForceAugmentation{}; }

  /**
   * Processes a measurement of the tip (m). `time` (s) is the time since the last measurement,
   * `late` (s) the delay until a force reaches the device, and `damping` the friction b (N s/m) of
   * the device.
   */
  void Observe(const Vector3& tip, double time, double late, double damping) noexcept;

  /**
   * Records that another `time` (s) has passed without a new measurement. The tip counts as at
   * rest, so the velocity is limited to StepSize divided by the time at rest.
   */
  void Rest(double time) noexcept;

  /** Returns the force (N) of the wall by (1) and (2). Must be called in every tick. */
  Vector3 Apply(const AugmentationInput& input) noexcept;

  /**
   * Records the force (N) that is sent until the next tick, and the work (J) of a wall that moves,
   * which may reach the hand. Must be called in every tick.
   */
  void RecordSent(const Vector3& force, double period, double wallWork) noexcept;

  /** Returns the account A (J). */
  double GetAccount() const noexcept { return this->Account; }

private:
  struct Measurement
  {
    double Time = 0.0; ///< time in s
    Vector3 Tip;
  };
  static constexpr std::size_t Kept = 16;
  static constexpr std::size_t KeptForces = 64;
  const Measurement& Back(std::size_t n) const noexcept
  {
    return this->Measurements[(this->Count - n) % Kept];
  }
  void Keep() noexcept;
  Vector3 EstimateVelocity() const noexcept;
  double ComputeGiven(const Vector3& force, double period) const noexcept;
  double ComputeMost(
    double speed, const AugmentationInput& input, double base, double kept) const noexcept;

  std::array<Measurement, Kept> Measurements{}; ///< a ring buffer, at least KeepTime apart
  std::size_t Count = 0;
  std::array<Vector3, KeptForces> Forces{}; ///< a ring buffer of the forces sent (N)
  std::size_t Sent = 0;
  std::size_t SentSince = 0; ///< number of forces sent since the last measurement
  double Time = 0.0;         ///< time of the last measurement (s)
  Vector3 Tip;
  Vector3 Motion;        ///< last motion (m), until RecordSent has accounted for it
  Vector3 Velocity;      ///< velocity of the tip (m/s)
  double Rested = 0.0;   ///< time (s) of Rest() since the last measurement
  double Between = 1e-3; ///< time between the last two measurements (s)
  double Late = 0.0;     ///< delay until a force reaches the device (s)
  double Damping = 0.0;  ///< friction of the device (N s/m)
  bool HasTip = false;
  bool HasMotion = false;
  bool IsHeldBack = false; ///< whether M has held back the spring k in this contact
  double Account = 0.0;    ///< A in J
  double Largest = 0.0;    ///< largest energy of the ideal spring in this contact (J)
  double Free = 0.0;       ///< time since the wall last pushed (s)
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Tests whether a device pushes the hand along the commanded force, or against it.
 *
 * A device with a reversed motor turns every spring into one that drives the hand away, and no
 * computed value shows this. Before a device is trusted, it therefore gives the hand a few small
 * pushes along each of its axes, and the motion must follow them.
 *
 *   check.Begin(axes, most);
 *   every tick:  force = check.Step(tip, isFresh, elapsed);  until  check.GetVerdict() is one
 *
 * A trial
 * -------
 *
 * 1. Rest. The check waits until the tip moves slowly, and so steadily that a line through its last
 *    positions predicts the next ones. The line shows where the hand would be without a push
 *    (DriftLine.h).
 * 2. Push. A force along one axis rises to a level and stays there for a moment. It ends as soon as
 *    the tip is StopDistance away from the line. If the distance at its end is clear of the hand's
 *    own motion, it is a vote: *with* the force, or *against* it.
 * 3. Return. The force of the push is applied with the opposite sign and backwards in time, until
 *    the tip turns back. A free mass is then at rest again, whichever sign the device has, so that
 *    motion does not build up.
 *
 * A passive hand that begins at rest first moves with the force, whether it is a mass, a damper or
 * a spring, so the vote shows the sign of the device. A constant force (gravity, or a spring that
 * is already bent) can't produce a vote, because the distance is measured from the line.
 *
 * The verdict
 * -----------
 *
 * Trials alternate between the axes. On each axis, the directions follow + - - + - + + - ...,
 * unlike any steady drift or swing of a hand. The level begins low, for a hand that yields at once.
 * It rises with each trial of this axis without a clear vote, up to a tenth of the device's force.
 * An axis is right (or wrong) as soon as each direction has at least two votes for it, and all its
 * votes exceed three times the opposite votes by four. The first wrong axis ends the check.
 */
#ifndef SignCheck_h
#define SignCheck_h

#include "Core/Safety/DriftLine.h"

#include <cstdint>

namespace VolumeHaptics
{

enum class SignResult : std::uint8_t
{
  Pending,   ///< not begun, or in progress
  Confirmed, ///< the tip moves with the force along all axes
  Wrong,     ///< the tip moves against the force along an axis
  NoMotion,  ///< the tip does not move along an axis, because it is held too firmly or is at a stop
  Restless   ///< the tip moves by itself, or sometimes with and sometimes against the force
};

struct SignVerdict
{
  SignResult Result = SignResult::Pending;
  int Axis = 0; ///< axis of Wrong, NoMotion or Restless, 0 to 2
};

class SignCheck
{
public:
  /** Distance (m) at which a push ends. */
  static constexpr double StopDistance = 0.8e-3;
  /** Largest push, as a fraction of the device's force (MostShare) and in newtons (MostForce). */
  static constexpr double MostShare = 0.1;
  static constexpr double MostForce = 4.0;

  /**
   * Restarts the check. Bit i of `axes` is set if the device can exert a force along axis i.
   * `force` (N) is the device's largest force.
   */
  void Begin(unsigned axes, double force) noexcept;
  /**
   * Returns the force (N) to send in this tick, or zero if there is a verdict. `tip` (m) is the
   * position of the tip; isFresh is true if it was measured in this tick. `elapsed` (s) is the time
   * since the last tick.
   */
  Vector3 Step(const Vector3& tip, bool isFresh, double elapsed) noexcept;
  /**
   * Discards the present trial, because the force was held back for another reason, or because the
   * tip jumped.
   */
  void Interrupt() noexcept;

  const SignVerdict& GetVerdict() const noexcept { return this->Verdict; }
  /** Returns the axis of the present trial. */
  int GetAxis() const noexcept { return this->Axis; }

private:
  enum class Phase : std::uint8_t
  {
    Rest,
    Push,
    Return
  };
  struct Votes
  {
    int With[2] = {};
    int Against[2] = {}; ///< votes against the force, by direction of the push
    int Unclear = 0;     ///< number of trials at the highest level without a clear vote
    int Trials = 0;
    int Level = 0;
    bool IsDone = false;
  };

  double GetDirection() const noexcept;
  double GetForce(double time) const noexcept;
  void BeginRest() noexcept;
  void Rest() noexcept;
  void Push(double distance) noexcept;
  void Return(double distance) noexcept;
  void Count(double distance) noexcept;
  void Judge() noexcept;
  void Finish(SignResult result) noexcept;

  SignVerdict Verdict;
  unsigned Axes = 0;
  double Most = 0.0; ///< largest force of a push (N)
  Votes Tally[3];
  int Axis = 0;
  Phase Now = Phase::Rest;
  double Time = 0.0;           ///< time since Begin (s)
  double Start = 0.0;          ///< time at which the phase began (s)
  double Duration = 0.0;       ///< duration of the push (s)
  double Clear = 0.0;          ///< distance (m) below which a trial is no vote
  double Farthest = 0.0;       ///< farthest signed distance (m) in the trial
  bool MustPushHarder = false; ///< whether the next push along this axis must be stronger
  DriftLine Drift;
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Searches the zero of a Novint Falcon's encoders: a state machine without a transport or a clock.
 *
 * The encoders count from an arbitrary position until the hand has moved the grip through its
 * range. Before that, the grip's position in the range is not known, so the hand is asked to go to
 * both ends. Afterwards the grip must be far out before forces may begin, because otherwise a grip
 * that was left inside would begin in the middle of a volume.
 *
 * The motors get zero all the time. Not verified on hardware; sources disagree on the colours.
 */
#ifndef FalconHoming_h
#define FalconHoming_h

#include "Devices/Falcon/FalconProtocol.h"

namespace VolumeHaptics
{

enum class FalconHomingState : std::uint8_t
{
  OutAndIn, ///< the hand must pull the grip fully out, then push it fully in
  Out,      ///< the encoders are homed; the hand must pull the grip out
  Ready,
  TimedOut, ///< the hand took too long; this state lasts until Restart()
  Lost      ///< the encoders have lost their zero after homing; this state lasts until Restart()
};

/** Returns the instruction for the user in a state. */
const char* FalconHomingText(FalconHomingState state) noexcept;

/** Distance (m) of the grip from the base above which the grip is ready. */
constexpr double FalconReadyHeight = 0.170;

class FalconHoming
{
public:
  /** `timeLimit` (s) limits the time in each of the two states that wait for the hand. */
  explicit FalconHoming(double timeLimit) noexcept
    : TimeLimit(timeLimit)
  {
  }

  /** Begins again. Necessary after a time-out, and whenever the device was disconnected. */
  void Restart() noexcept;

  /**
   * Advances by a tick. `elapsed` (s) is the time since the last tick; if it is negative or not a
   * number, it counts as too long. `report` is the report that came in this tick, or nullptr.
   */
  void Update(double elapsed, const FalconReport* report) noexcept;

  FalconHomingState GetState() const noexcept { return this->State; }
  /** Returns which encoders are not homed: one bit for each. */
  std::uint8_t GetMissing() const noexcept { return this->Missing; }
  /**
   * Returns the packet to send. It has zero for the motors, the homing bit, and a colour that shows
   * the progress.
   */
  FalconOrder GetOrder() const noexcept;

private:
  void Enter(FalconHomingState state) noexcept;

  double TimeLimit;
  double Waited = 0.0;
  std::uint8_t Missing = FalconAllHomed;
  FalconHomingState State = FalconHomingState::OutAndIn;
};

} // namespace VolumeHaptics

#endif

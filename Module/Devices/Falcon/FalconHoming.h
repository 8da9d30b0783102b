// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the zero of a Novint Falcon's encoders: a state machine without a transport or a clock.
 *
 * The encoders count from an arbitrary position until the user has moved the grip through its whole
 * range. Until then the grip's position is unknown, so the user is asked to move it to both ends.
 * Forces may begin only when the grip is far out, because a grip farther in could begin in the
 * middle of a volume.
 *
 * The motor commands are always zero. Not verified on hardware; sources disagree on the colours.
 */
#ifndef FalconHoming_h
#define FalconHoming_h

#include "Devices/Falcon/FalconProtocol.h"

namespace VolumeHaptics
{

enum class FalconHomingState : std::uint8_t
{
  OutAndIn, ///< the user must pull the grip fully out, then push it fully in
  Out,      ///< the encoders are homed; the user must pull the grip out
  Ready,
  TimedOut, ///< the user took too long; this state lasts until Restart()
  Lost      ///< the encoders have lost their zero after homing; this state lasts until Restart()
};

/** Returns the instruction for the user in a state. */
const char* FalconHomingText(FalconHomingState state) noexcept;

/** Distance (m) of the grip from the base above which the grip is ready. */
constexpr double FalconReadyHeight = 0.170;

class FalconHoming
{
public:
  /** @param timeLimit longest time (s) in each of the two states that wait for the user */
  explicit FalconHoming(double timeLimit) noexcept
    : TimeLimit(timeLimit)
  {
  }

  /** Starts again. Necessary after a time-out, and whenever the device was disconnected. */
  void Restart() noexcept;

  /**
   * Advances by a tick. `elapsed` (s) is the time since the last tick; a negative value or NaN
   * counts as a time-out. `report` is the report received in this tick, or nullptr.
   */
  void Update(double elapsed, const FalconReport* report) noexcept;

  FalconHomingState GetState() const noexcept { return this->State; }
  /** Returns the encoders that are not homed yet, one bit for each. */
  std::uint8_t GetMissing() const noexcept { return this->Missing; }
  /**
   * Returns the packet to send: zero for the motors, the homing bit, and a colour that shows the
   * progress.
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

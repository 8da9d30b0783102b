// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The search for the Novint Falcon's zero, as a state machine without a transport or a clock.
 *
 * The encoders count from an arbitrary position until the hand has moved the grip through its
 * range. Before that, its position within the range is unknown, so the hand is asked for both ends
 * at once. Afterwards the grip has to be far out before forces may begin: otherwise a grip that was
 * left inside would start in the middle of a volume.
 *
 * The motors get zero throughout. Not verified on hardware; sources disagree on the colours.
 */
#ifndef FalconHoming_h
#define FalconHoming_h

#include "Devices/Falcon/FalconProtocol.h"

namespace VolumeHaptics
{

enum class FalconHomingState : std::uint8_t
{
  OutAndIn, ///< the hand must pull the grip fully out, then push it fully in
  Out,      ///< homed; the hand must pull the grip out
  Ready,
  TimedOut, ///< the hand took too long; the state lasts until Restart
  Lost      ///< the encoders lost their zero after homing; the state lasts until Restart
};

/** Returns the instruction for the user in a state. */
const char* FalconHomingText(FalconHomingState state) noexcept;

/** The distance (m) from the base beyond which the grip is ready. */
constexpr double FalconReadyHeight = 0.170;

class FalconHoming
{
public:
  /** `timeLimit` (s) limits each of the two states that wait for the hand. */
  explicit FalconHoming(double timeLimit) noexcept
    : TimeLimit(timeLimit)
  {
  }

  /** Begins again. Necessary after a time-out, and always after the device was disconnected. */
  void Restart() noexcept;

  /**
   * Advances by a tick: the time (s) since the last tick, and the report that came in this tick, or
   * nullptr. A time that is negative or not a number counts as too long.
   */
  void Update(double elapsed, const FalconReport* report) noexcept;

  FalconHomingState GetState() const noexcept { return this->State; }
  /** Returns the encoders that are not homed, a bit for each. */
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

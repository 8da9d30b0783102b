// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How the Novint Falcon finds its zero, as a state machine without a transport and without a clock.
 *
 * The encoders count from wherever they were when the device was switched on, until the hand has
 * moved the grip through its range. Where it is within the range can't be told before, so both ends
 * are asked for at once. Afterwards the grip has to be out near the hand before forces may begin: a
 * grip that was left inside would otherwise start in the middle of a volume.
 *
 * The motors get zero all the while. Not verified on hardware; the colours are disputed.
 */
#ifndef FalconHoming_h
#define FalconHoming_h

#include "Devices/Falcon/FalconProtocol.h"

namespace VolumeHaptics
{

enum class FalconHomingState : std::uint8_t
{
  OutAndIn, ///< the hand is asked to pull the grip fully out, then to push it fully in
  Out,      ///< homed; the hand is asked to pull the grip out
  Ready,
  TimedOut, ///< until Restart
  Lost      ///< the encoders lost their zero after all were homed; until Restart
};

/** The request to the hand, in words, for a status. */
const char* FalconHomingText(FalconHomingState state) noexcept;

/** How far out (m) the grip has to be to become ready. */
constexpr double FalconReadyHeight = 0.170;

class FalconHoming
{
public:
  /** How long (s) each of the two states may take that wait for the hand. */
  explicit FalconHoming(double timeLimit) noexcept
    : TimeLimit(timeLimit)
  {
  }

  /** Begins again: after a time-out, and always after the device was gone. */
  void Restart() noexcept;

  /**
   * A tick: the time since the last one (s), and the report that came in it or nullptr. A time that
   * is negative or no number counts as too long.
   */
  void Update(double elapsed, const FalconReport* report) noexcept;

  FalconHomingState GetState() const noexcept { return this->State; }
  /** The encoders that are not homed, a bit each. */
  std::uint8_t GetMissing() const noexcept { return this->Missing; }
  /** The packet to send: no command to the motors; homing, and a colour that says how far it is. */
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

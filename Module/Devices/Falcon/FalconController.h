// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a session with a Novint Falcon decides, without a transport: what the next packet says, and
 * when the device can't be trusted any more.
 *
 * The device's space is right-handed, in metres, seen by the hand: x to the right, y up, z out of
 * the device towards the hand. Its origin is in the middle of the workspace, which is (0, 0, 0.125)
 * in the frame of FalconKinematics.h; forces are the same in both. Which way the axes point on a
 * real device is not verified.
 */
#ifndef FalconController_h
#define FalconController_h

#include "Devices/Common/HardwareExchange.h"
#include "Devices/Falcon/FalconHoming.h"

namespace VolumeHaptics
{

/** The device's limits: 8 N, 3000 N/m, 20 N s/m, a ball of 0.04 m radius, 2.5 m/s. */
DeviceLimits FalconLimits() noexcept;

/** The middle of the workspace, in the frame of FalconKinematics.h (m). */
constexpr Vector3 FalconMiddle = { 0.0, 0.0, 0.125 };

/**
 * DeviceSample::Buttons of FalconReport::Buttons: bit 0 the centre, bit 1 plus, 2 minus, 3 forward.
 */
std::uint32_t FalconButtonsOf(std::uint8_t buttons) noexcept;

/** DeviceBackend::SetLights as colours of a packet: bit 0 is green, bit 1 blue, bit 2 red. */
constexpr std::uint8_t FalconColours(int lights) noexcept
{
  return static_cast<std::uint8_t>((lights & 7) << 1);
}

class FalconController
{
public:
  /** How far (m) the grip may be from the last report, however long that was ago. */
  static constexpr double LongestStep = 0.02;
  /** How many packets in a row may stay without an answer. */
  static constexpr int MostMissed = 10;

  /** Begins with homing, each of whose steps may take that long (s). */
  FalconController(HardwareExchange& exchange, double homingTime) noexcept;

  /** A report, the latest one, and the time (s) since the last call of this or of Miss. */
  void Take(const FalconReport& report, double elapsed) noexcept;
  /** A packet was not answered in time; why, as far as it is known, or nullptr. */
  void Miss(double elapsed, const char* why) noexcept;

  /** Zero commands until Restart, whatever comes; with what is wrong and the cure. */
  void Lose(const char* text) noexcept;
  /** The same, where the exchange has been told why. */
  void Stop() noexcept { this->IsStopped = true; }
  bool IsLost() const noexcept { return this->IsStopped; }

  /** After HardwareExchange::TakeHomeRequest. */
  void Restart() noexcept;

  /**
   * The packet to send now. Motors get the servo's force while the device is ready, else zero.
   * Colours are those of homing, then green, blue while there is force, red when lost; or those of
   * SetLights, except while homing, when they guide the hand.
   */
  FalconOrder GetOrder() noexcept;

private:
  void FollowHoming(const FalconReport& report) noexcept;
  bool IsPossible(const Vector3& position, double elapsed) const noexcept;
  void TellState() noexcept;

  HardwareExchange& Exchange;
  FalconHoming Homing;
  FalconHomingState Told = FalconHomingState::Ready; ///< the condition says so
  FalconPose Pose;
  double SincePose = 0.0; ///< s
  int Missed = 0;         ///< in a row
  bool IsStopped = false;
};

} // namespace VolumeHaptics

#endif

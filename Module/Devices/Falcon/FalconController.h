// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The decisions of a session with a Novint Falcon, without a transport: the contents of the next
 * packet, and whether the device can still be trusted.
 *
 * The device's space is right-handed, in metres, seen by the hand: x to the right, y up, z out of
 * the device towards the hand. Its origin is the middle of the workspace, which is (0, 0, 0.125) in
 * the frame of FalconKinematics.h; forces are the same in both. The directions of the axes are not
 * verified on a real device.
 */
#ifndef FalconController_h
#define FalconController_h

#include "Devices/Common/HardwareExchange.h"
#include "Devices/Falcon/FalconHoming.h"

namespace VolumeHaptics
{

/** Returns the device's limits: 8 N, 3000 N/m, 20 N s/m, a ball of 0.04 m radius, 2.5 m/s. */
DeviceLimits FalconLimits() noexcept;

/** The middle of the workspace, in the frame of FalconKinematics.h (m). */
constexpr Vector3 FalconMiddle = { 0.0, 0.0, 0.125 };

/**
 * Converts FalconReport::Buttons to DeviceSample::Buttons: bit 0 is the centre, 1 plus, 2 minus, 3
 * forward.
 */
std::uint32_t FalconButtonsOf(std::uint8_t buttons) noexcept;

/**
 * Converts the bits of DeviceBackend::SetLights to the colours of a packet: bit 0 is green, bit 1
 * blue, bit 2 red.
 */
constexpr std::uint8_t FalconColours(int lights) noexcept
{
  return static_cast<std::uint8_t>((lights & 7) << 1);
}

class FalconController
{
public:
  /** The largest distance (m) of the grip from the last report, however old that is. */
  static constexpr double LongestStep = 0.02;
  /** The largest number of packets in a row without an answer. */
  static constexpr int MostMissed = 10;

  /** Begins with homing; `homingTime` (s) limits each of its steps. */
  FalconController(HardwareExchange& exchange, double homingTime) noexcept;

  /**
   * Processes the latest report; `elapsed` (s) is the time since the last call of this function or
   * of Miss.
   */
  void Receive(const FalconReport& report, double elapsed) noexcept;
  /** Records that a packet was not answered in time. `why` may be nullptr. */
  void Miss(double elapsed, const char* why) noexcept;

  /** Makes all commands zero until Restart. `text` gives the fault and the cure. */
  void Lose(const char* text) noexcept;
  /** Does the same as Lose, if the exchange already has the reason. */
  void Stop() noexcept { this->IsStopped = true; }
  bool IsLost() const noexcept { return this->IsStopped; }

  /** Begins again with homing. Call it after HardwareExchange::DrainHomeRequest. */
  void Restart() noexcept;

  /**
   * Returns the packet to send now. Motors get the servo's force while the device is ready, else
   * zero. While homing, the colours show the progress of homing; then green, blue while there is
   * force, red after a loss. SetLights replaces them except while homing, when they guide the hand.
   */
  FalconOrder GetOrder() noexcept;

private:
  void UpdateHoming(const FalconReport& report) noexcept;
  bool IsPossible(const Vector3& position, double elapsed) const noexcept;
  void ReportState() noexcept;

  HardwareExchange& Exchange;
  FalconHoming Homing;
  FalconHomingState Told = FalconHomingState::Ready; ///< the homing state that the condition shows
  FalconPose Pose;
  double SincePose = 0.0; ///< s, the time since Pose was reached
  int Missed = 0;         ///< number of packets in a row without an answer
  bool IsStopped = false;
};

} // namespace VolumeHaptics

#endif

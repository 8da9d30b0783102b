// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Controls a session with a Novint Falcon, without a transport: decides the contents of the next
 * packet, and whether the device can still be trusted.
 *
 * The device's space is right-handed, in metres, as seen by the hand: x points to the right, y up,
 * and z out of the device towards the hand. Its origin is the middle of the workspace, which is (0,
 * 0, 0.125) in the frame of FalconKinematics.h. Forces are the same in both frames. The directions
 * of the axes have not been verified on a real device.
 */
#ifndef FalconController_h
#define FalconController_h

#include "Devices/Common/HardwareExchange.h"
#include "Devices/Falcon/FalconHoming.h"

namespace VolumeHaptics
{

/**
 * Returns the device's limits: 8 N, 3000 N/m, 20 N s/m, a ball with a radius of 0.04 m, and 2.5
 * m/s.
 */
DeviceLimits FalconLimits() noexcept;

/** The middle of the workspace, in the frame of FalconKinematics.h (m). */
constexpr Vector3 FalconMiddle = { 0.0, 0.0, 0.125 };

/**
 * Converts FalconReport::Buttons to DeviceSample::Buttons. Bit 0 is the centre button, bit 1 plus,
 * bit 2 minus, bit 3 forward.
 */
std::uint32_t FalconButtonsOf(std::uint8_t buttons) noexcept;

/**
 * Converts the bits of DeviceBackend::SetLights to the colours of a packet. Bit 0 is green, bit 1
 * blue, bit 2 red.
 */
constexpr std::uint8_t FalconColours(int lights) noexcept
{
  return static_cast<std::uint8_t>((lights & 7) << 1);
}

class FalconController
{
public:
  /**
   * Largest plausible distance (m) of the grip from the last report, however old that report is.
   */
  static constexpr double LongestStep = 0.02;
  /** Largest number of consecutive packets without an answer. */
  static constexpr int MostMissed = 10;

  /** Starts with homing. `homingTime` (s) limits each of its steps. */
  FalconController(HardwareExchange& exchange, double homingTime) noexcept;

  /**
   * Processes the latest report. `elapsed` (s) is the time since the last call of Receive() or
   * Miss().
   */
  void Receive(const FalconReport& report, double elapsed) noexcept;
  /** Records that a packet was not answered in time. `why` is the reason, or nullptr. */
  void Miss(double elapsed, const char* why) noexcept;

  /** Makes all commands zero until Restart(). `text` contains the fault and the cure. */
  void Lose(const char* text) noexcept;
  /** Like Lose(), if the exchange already contains the reason. */
  void Stop() noexcept { this->IsStopped = true; }
  bool IsLost() const noexcept { return this->IsStopped; }

  /** Starts again with homing. Must be called after HardwareExchange::DrainHomeRequest(). */
  void Restart() noexcept;

  /**
   * Returns the packet to send now. While the device is ready, the motors receive the servo's
   * force, otherwise zero. The colours show the progress of homing; after homing they are green,
   * blue while there is force, and red after a loss. SetLights() replaces the colours, except
   * during homing, when they guide the hand.
   */
  FalconOrder GetOrder() noexcept;

private:
  void UpdateHoming(const FalconReport& report) noexcept;
  bool IsPossible(const Vector3& position, double elapsed) const noexcept;
  void ReportState() noexcept;

  HardwareExchange& Exchange;
  FalconHoming Homing;
  /// homing state that was last reported in the condition
  FalconHomingState Told = FalconHomingState::Ready;
  FalconPose Pose;
  double SincePose = 0.0; ///< time since the measurement of Pose (s)
  int Missed = 0;         ///< number of consecutive packets without an answer
  bool IsStopped = false;
};

} // namespace VolumeHaptics

#endif

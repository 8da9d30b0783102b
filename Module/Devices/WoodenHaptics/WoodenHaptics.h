// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * WoodenHaptics, an open-hardware device: packets, kinematics and currents, without a transport.
 * Polhem uses the same packets, but has another linkage, other encoders and another rest pose.
 *
 * It has three joints: A rotates about the vertical (z), B leans the upper arm forward from
 * upright, and C lifts the forearm from hanging straight down, independently of B. The default
 * geometry is the published v2015, which was not verified on a device. All functions are safe in
 * the servo loop: they neither allocate nor throw.
 */
#ifndef WoodenHaptics_h
#define WoodenHaptics_h

#include "Core/Math/Vector3.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace VolumeHaptics
{

struct WoodenHapticsGeometry
{
  /// Joint angle divided by motor angle, which equals motor torque divided by joint torque: the
  /// diameter of the capstan divided by that of the body.
  std::array<double, 3> Transmission{ 10.0 / 160.0, 10.0 / 120.0, 10.0 / 120.0 };
  /// 1 if counts grow with the joint's angle, otherwise -1. A positive current turns the motor
  /// towards larger counts.
  std::array<double, 3> Signs{ 1.0, 1.0, 1.0 };
  double CountsPerTurn = 2000.0;     ///< encoder counts per revolution of a motor
  double TorqueConstant = 0.0259;    ///< in N m/A
  double Base = 0.080;               ///< Ln, height of the shoulder (m)
  double UpperArm = 0.205;           ///< Lb in m
  double Forearm = 0.245;            ///< Lc in m
  Vector3 Origin{ 0.22, 0.0, 0.08 }; ///< origin of the tip's coordinates, from the foot (m)
  std::array<std::int16_t, 3> RestCounts{ 0, 0, 6000 }; ///< counts in the calibration pose
  double MaximumCurrent = 3.0;                          ///< largest current of each motor (A)
};

class WoodenHaptics
{
public:
  /** Number of bytes: seven little-endian int16. */
  static constexpr std::size_t PacketSize = 14;
  /** A packet, preceded by the report id 0. */
  using Packet = std::array<std::uint8_t, PacketSize + 1>;
  using Currents = std::array<std::int16_t, 3>; ///< in mA

  /** A report from the device. */
  struct Input
  {
    std::array<std::int16_t, 6> Counts{}; ///< counts of the encoders a to f
    /// Whether the calibration button was pressed since the device last received its rest pose. A
    /// device that was never calibrated does not report this.
    bool WantsCalibration = false;
  };

  explicit WoodenHaptics(const WoodenHapticsGeometry& geometry = {}) noexcept
    : Geometry(geometry)
  {
  }
  const WoodenHapticsGeometry& GetGeometry() const noexcept { return this->Geometry; }

  ///@{
  /**
   * Decodes bytes. Returns nullptr, or the reason why the packet is not valid, as a static text;
   * the input is then unchanged.
   */
  static const char* Decode(const std::uint8_t* bytes, std::size_t size, Input& input) noexcept;
  static Packet EncodeCurrents(const Currents& milliamperes) noexcept;
  /** Encodes the packet that sets the encoder counts of a device in its rest pose. */
  Packet EncodeCalibration() const noexcept;
  ///@}

  ///@{
  /**
   * Compute the joint angles A, B, C (rad), the tip (m), and the derivatives of the tip with
   * respect to the angles (m/rad; one column for each angle).
   */
  std::array<double, 3> ComputeAngles(const std::array<std::int16_t, 6>& counts) const noexcept;
  Vector3 ComputeTip(const std::array<double, 3>& angles) const noexcept;
  Matrix3 ComputeJacobian(const std::array<double, 3>& angles) const noexcept;
  ///@}

  /**
   * Computes the motors' currents for a force on the hand (N): i = (J^T f) transmission / kt. If a
   * current would exceed the maximum, all currents are scaled by the same factor, so that the force
   * keeps its direction. They are zero if the force is not finite.
   */
  Currents ComputeCurrents(
    const std::array<double, 3>& angles, const Vector3& force) const noexcept;

private:
  WoodenHapticsGeometry Geometry;
};

} // namespace VolumeHaptics

#endif

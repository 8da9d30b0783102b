// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * WoodenHaptics, open hardware: packets, kinematics and currents, without a transport. Polhem has
 * the same packets, but another linkage, other encoders and another rest pose.
 *
 * Three joints: A turns about the vertical (z), B leans the upper arm forward from upright, C lifts
 * the forearm from hanging straight down, independently of B. The default geometry is the published
 * v2015; it was not verified on a device. All functions are suitable for the servo loop: noexcept,
 * no allocation.
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
  /// Joint radians per motor radian, and so motor torque per joint torque: the capstan's diameter
  /// over the body's.
  std::array<double, 3> Transmission{ 10.0 / 160.0, 10.0 / 120.0, 10.0 / 120.0 };
  /// +1 if counts grow with the joint's angle, -1 if they fall. A positive current turns the motor
  /// towards growing counts.
  std::array<double, 3> Signs{ 1.0, 1.0, 1.0 };
  double CountsPerTurn = 2000.0;     ///< encoder counts per turn of a motor
  double TorqueConstant = 0.0259;    ///< N m/A
  double Base = 0.080;               ///< m, Ln: height of the shoulder
  double UpperArm = 0.205;           ///< m, Lb
  double Forearm = 0.245;            ///< m, Lc
  Vector3 Origin{ 0.22, 0.0, 0.08 }; ///< m, from the foot to the origin of the tip's position
  std::array<std::int16_t, 3> RestCounts{ 0, 0, 6000 }; ///< counts in the pose for calibration
  double MaximumCurrent = 3.0;                          ///< A, for each motor
};

class WoodenHaptics
{
public:
  static constexpr std::size_t PacketSize = 14;            ///< bytes: seven int16, little-endian
  using Packet = std::array<std::uint8_t, PacketSize + 1>; ///< with the report id 0 in front
  using Currents = std::array<std::int16_t, 3>;            ///< mA

  /** The device's report. */
  struct Input
  {
    std::array<std::int16_t, 6> Counts{}; ///< encoders a to f
    /// The calibration button was pressed since the device last got its rest pose. A device without
    /// a zero does not report that.
    bool WantsCalibration = false;
  };

  explicit WoodenHaptics(const WoodenHapticsGeometry& geometry = {}) noexcept
    : Geometry(geometry)
  {
  }
  const WoodenHapticsGeometry& GetGeometry() const noexcept { return this->Geometry; }

  ///@{
  /**
   * Decodes bytes. Returns nullptr, or the reason for refusing the packet, as a text that lasts;
   * the input is then unchanged.
   */
  static const char* Decode(const std::uint8_t* bytes, std::size_t size, Input& input) noexcept;
  static Packet EncodeCurrents(const Currents& milliamperes) noexcept;
  /** Encodes the packet that tells a device in the rest pose its encoders' counts there. */
  Packet EncodeCalibration() const noexcept;
  ///@}

  ///@{
  /**
   * Compute joint angles A, B, C (rad), the tip (m), and the derivative of the tip by the angles
   * (m/rad; columns).
   */
  std::array<double, 3> ComputeAngles(const std::array<std::int16_t, 6>& counts) const noexcept;
  Vector3 ComputeTip(const std::array<double, 3>& angles) const noexcept;
  Matrix3 ComputeJacobian(const std::array<double, 3>& angles) const noexcept;
  ///@}

  /**
   * Computes the motors' currents for a force on the hand (N): i = (J^T f) transmission / kt. If a
   * motor would exceed the maximum, all currents are scaled down together, so that the force keeps
   * its direction. They are zero if the force is not finite.
   */
  Currents ComputeCurrents(
    const std::array<double, 3>& angles, const Vector3& force) const noexcept;

private:
  WoodenHapticsGeometry Geometry;
};

} // namespace VolumeHaptics

#endif

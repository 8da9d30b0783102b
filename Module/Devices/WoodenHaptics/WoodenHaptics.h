// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * WoodenHaptics, open hardware: packets, kinematics and currents, without a transport. Polhem has
 * the same packets, but another linkage, other encoders and another rest pose.
 *
 * Three joints: A turns about the vertical (z), B leans the upper arm forward from upright, C lifts
 * the forearm from hanging straight down. The forearm's angle is its own, whatever B does. The
 * default geometry is the one published as v2015; nothing was verified on a device. All of this is
 * fit for the servo loop: noexcept, no allocation.
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
  /// Joint radians for a radian of the motor, which are also the motor's torque for a joint's: the
  /// capstan's size over the body's.
  std::array<double, 3> Transmission{ 10.0 / 160.0, 10.0 / 120.0, 10.0 / 120.0 };
  /// Whether counts grow with the joint's angle (+1) or against it (-1); a positive current turns
  /// the motor towards growing counts.
  std::array<double, 3> Signs{ 1.0, 1.0, 1.0 };
  double CountsPerTurn = 2000.0;     ///< of a motor
  double TorqueConstant = 0.0259;    ///< N m/A
  double Base = 0.080;               ///< m, Ln: height of the shoulder
  double UpperArm = 0.205;           ///< m, Lb
  double Forearm = 0.245;            ///< m, Lc
  Vector3 Origin{ 0.22, 0.0, 0.08 }; ///< m, from the foot to where the tip counts from
  std::array<std::int16_t, 3> RestCounts{ 0, 0, 6000 }; ///< in the pose for calibrating
  double MaximumCurrent = 3.0;                          ///< A, for each motor
};

class WoodenHaptics
{
public:
  static constexpr std::size_t PacketSize = 14;            ///< bytes: seven int16, little-endian
  using Packet = std::array<std::uint8_t, PacketSize + 1>; ///< the report id 0 in front
  using Currents = std::array<std::int16_t, 3>;            ///< mA

  /** The device's report. */
  struct Input
  {
    std::array<std::int16_t, 6> Counts{}; ///< encoders a to f
    /// Its calibration button was pressed since it was told its rest pose last. A device without a
    /// zero does not say so.
    bool WantsCalibration = false;
  };

  explicit WoodenHaptics(const WoodenHapticsGeometry& geometry = {}) noexcept
    : Geometry(geometry)
  {
  }
  const WoodenHapticsGeometry& GetGeometry() const noexcept { return this->Geometry; }

  ///@{
  /** Bytes. Why a packet is refused, as a text that lasts, and input as it was; else nullptr. */
  static const char* Decode(const std::uint8_t* bytes, std::size_t size, Input& input) noexcept;
  static Packet EncodeCurrents(const Currents& milliamperes) noexcept;
  /** Tells the device, which is in its rest pose, what its encoders have to read there. */
  Packet EncodeCalibration() const noexcept;
  ///@}

  ///@{
  /** Joint angles A, B, C (rad), the tip (m), and its change with the angles (m/rad; columns). */
  std::array<double, 3> ComputeAngles(const std::array<std::int16_t, 6>& counts) const noexcept;
  Vector3 ComputeTip(const std::array<double, 3>& angles) const noexcept;
  Matrix3 ComputeJacobian(const std::array<double, 3>& angles) const noexcept;
  ///@}

  /**
   * The motors' currents for a force on the hand (N): i = (J^T f) transmission / kt. Where a motor
   * would get more than the maximum, all are scaled down together, so that the force keeps its
   * direction. Zeros for what is not finite.
   */
  Currents ComputeCurrents(
    const std::array<double, 3>& angles, const Vector3& force) const noexcept;

private:
  WoodenHapticsGeometry Geometry;
};

} // namespace VolumeHaptics

#endif

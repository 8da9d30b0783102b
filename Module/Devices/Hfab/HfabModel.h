// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Models the arms of hfab controllers: computes the tip from encoder counts, and the motors'
 * currents from a force.
 *
 * Lengths, gears, counts, torque constants, poses and signs are from hfabapi's tables
 * (forsslund/hfabapi, commit cf00e97, which has the signs and the home position of WoodenHaptics as
 * of 4224b75). Along the arm's axes, x points towards the hand, y to the right, and z up.
 *
 * WoodenHaptics and PHANToM are serial arms: A rotates about the vertical, B leans the upper arm
 * forward from upright, and C lifts the forearm from hanging straight down.
 *
 * Polhem has a five-bar linkage in the plane that A rotates. Let u(q) = (cos q, sin q). The cranks
 * about (-L0/2, 0) and (L0/2, 0) end in a = (-L0/2, 0) + L2 u(C) and b = (L0/2, 0) + L1 u(B). A rod
 * of length L3 joins a to c = b - L4 u(l), and the tip is b + L5 u(l). The angle l solves the
 * triangle a, b, c in which the direction from b to c is clockwise of that from b to a. Its
 * derivatives follow from |c - a| = L3.
 *
 * The handle of Polhem and PHANToM has encoders D, E and F. hfabapi's published functions disagree
 * about the handle of a PHANToM: computeRotation() of hfab_kinematics.cpp rotates it with the
 * forearm, and by D about x, but is never called. getRot() of hfab_api.cpp is called, and rotates
 * the handle by D about z, but omits the forearm, whose angle is written only by Polhem's
 * functions. Here the handle rotates with the forearm, as the tip does, and then as in getRot():
 * the gimbal swings right, then up, then turns about its own axis, like the gimbal angles of the
 * vendor's own library.
 *
 * hfabapi's current that compensates the arm's weight is omitted, because every force must pass the
 * gate and the safety stage. hfabapi's g is 0 for PHANToM and WoodenHaptics anyway, and their
 * formula uses the angle C where the forearm's weight acts on B, although this weight acts at B's
 * end.
 *
 * No function allocates or throws.
 */
#ifndef HfabModel_h
#define HfabModel_h

#include "Core/Math/Quaternion.h"
#include "Core/Safety/DeviceBackend.h"

#include <array>

namespace VolumeHaptics
{

struct HfabGeometry
{
  const char* Name;
  bool IsLinkage;
  std::array<double, 3> Capstan;        ///< diameters at the motors (m)
  std::array<double, 3> Body;           ///< diameters at the joints (m)
  std::array<double, 3> Lengths;        ///< lengths of a serial arm in m: base, upper arm, forearm
  Vector3 Origin;                       ///< origin of the tip's position (m)
  std::array<double, 3> TorqueConstant; ///< in N m/A
  double CountsPerTurn;                 ///< encoder counts per revolution of a motor
  std::array<double, 3> Signs;          ///< +1 if counts grow with the joint's angle
  std::array<int, 6> Home;              ///< counts in the calibration pose
  /// mA for each motor: the lowest setting of the controller's amplifiers
  double MaximumCurrent;
  double GimbalCounts; ///< encoder counts per revolution of the handle; 0 if it has no encoders
  DeviceLimits Limits;
};

class HfabModel
{
public:
  using Angles = std::array<double, 3>; ///< the angles A, B and C (rad)
  using Counts = std::array<int, 6>;    ///< encoder counts after calibration

  /**
   * Returns the geometry of an arm, or null for an unknown model. The models are 1 Polhem, 2
   * PHANToM, 3 WoodenHaptics.
   */
  static const HfabGeometry* Find(int model) noexcept;

  static Angles ComputeAngles(const HfabGeometry& geometry, const Counts& counts) noexcept;
  /** Computes the tip (m). Returns false if the linkage can't reach these angles. */
  static bool ComputeTip(const HfabGeometry& geometry, const Angles& angles, Vector3& tip) noexcept;
  /**
   * Computes the derivatives of the tip with respect to the angles (m/rad; one column for each
   * angle). Returns false if the linkage can't reach these angles, or if a derivative does not
   * exist.
   */
  static bool ComputeJacobian(
    const HfabGeometry& geometry, const Angles& angles, Matrix3& jacobian) noexcept;
  /**
   * Returns the handle's orientation along the axes of all devices (DeviceBackend.h). Must only be
   * called if the handle has encoders.
   */
  static Quaternion ComputeOrientation(const HfabGeometry& geometry, const Counts& counts) noexcept;

  /**
   * Computes the motors' currents (mA) for a force on the hand (N): i = (J^T f) sign capstan /
   * (body kt). If a current would exceed the maximum, all currents are scaled by the same factor.
   * They are zero if the force is not finite or if the linkage can't reach these angles.
   */
  static std::array<int, 3> ComputeCurrents(
    const HfabGeometry& geometry, const Angles& angles, const Vector3& force) noexcept;

  ///@{
  /** Convert between the arm's axes and the axes of all devices: right, up, towards the hand. */
  static Vector3 ToDevice(const Vector3& arm) noexcept { return { arm.Y, arm.Z, arm.X }; }
  static Vector3 ToArm(const Vector3& device) noexcept { return { device.Z, device.X, device.Y }; }
  ///@}
};

} // namespace VolumeHaptics

#endif

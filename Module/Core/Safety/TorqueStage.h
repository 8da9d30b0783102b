// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The only way from a computed torque to a device.
 *
 * The torque passes the gate of the force (ForceGate.h), after SafetyStage.h has updated the gate:
 * where no force may flow, no torque flows from that tick on, and the gate's share applies to both.
 * A torque that is not finite is a fault, which SafetyStage reports. Then, in this order:
 * 1. The norm is clamped to the smaller of the device's and the user's maximum.
 * 2. The gate's share is taken, and the growth is limited. A torque may fall at once. GrowthLimit.h
 *    keeps the account, of torques and turns in place of forces and ways: the work that a turning
 *    hand was spared on the way in is not given to it on the way out.
 *
 * While samples are missing there is no torque: the force retreats by itself, and the torque is
 * gone at once.
 */
#ifndef TorqueStage_h
#define TorqueStage_h

#include "Core/Math/Quaternion.h"
#include "Core/Math/Vector3.h"
#include "Core/Safety/ForceGate.h"
#include "Core/Safety/GrowthLimit.h"

namespace VolumeHaptics
{

struct SafetyLimits;

/** The input of the stage in a tick. */
struct TorqueInput
{
  Vector3 Torque;          ///< N m, as computed
  double Stiffness = 0.0;  ///< N m/rad, of the torque's spring; 0 if there is none
  Quaternion Orientation;  ///< orientation of the stylus, a unit quaternion
  bool IsMeasured = false; ///< whether the orientation was measured for this tick
  double Period = 1e-3;    ///< s, for the limit of growth
};

class TorqueStage
{
public:
  /** Returns the torque to send (N m). */
  Vector3 Apply(
    const TorqueInput& input, const SafetyLimits& limits, const ForceGate& gate) noexcept;

private:
  void UpdateTurn(const Quaternion& orientation) noexcept;

  GrowthLimit Growth;
  Vector3 Turned;  ///< rad, the sum of all small turns
  Quaternion Last; ///< the last orientation
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The only way from a computed torque to a device.
 *
 * The torque passes the same gate as the force (ForceGate.h), after SafetyStage.h has updated the
 * gate. In a tick in which no force may flow, no torque flows either, and the gate's share applies
 * to both. A torque that is not finite is a fault, which SafetyStage reports. Then, in this order:
 * 1. The norm is clamped to the smaller one of the device's and the user's maximum.
 * 2. The torque is multiplied by the gate's share, and its growth is limited. It may fall at once.
 *    GrowthLimit.h keeps the account, with torques and angles instead of forces and lengths: work
 *    that a turning hand did not have to do on the way in is not given to it on the way out.
 *
 * If samples are missing, the force retreats, but the torque ends at once.
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
  Vector3 Torque;          ///< computed torque (N m)
  double Stiffness = 0.0;  ///< stiffness of the torque's spring (N m/rad); 0 without a spring
  Quaternion Orientation;  ///< orientation of the stylus, a unit quaternion
  bool IsMeasured = false; ///< whether the orientation was measured for this tick
  double Period = 1e-3;    ///< period in s, for the limit of growth
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
  Vector3 Turned;  ///< sum of all small rotations (rad)
  Quaternion Last; ///< the last measured orientation
};

} // namespace VolumeHaptics

#endif

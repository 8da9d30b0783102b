// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * All computed torques pass this stage on their way to a device.
 *
 * The torque passes the same gate as the force (ForceGate.h), after SafetyStage.h has updated the
 * gate. If no force may flow in a tick, no torque flows either, and the gate's share applies to
 * both. A torque that is not finite is a fault, which SafetyStage reports. The torque passes these
 * steps, in this order:
 * 1. The norm is clamped to the smaller of the device's and the user's maximum.
 * 2. The torque is multiplied by the gate's share, and its growth is limited. It may fall at once.
 *    GrowthLimit.h keeps the account, with torques and angles instead of forces and lengths: work
 *    that a turning hand did not have to do on the way in is not given to it on the way out.
 *
 * If samples are missing, the torque ends at once, while the force falls gradually.
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

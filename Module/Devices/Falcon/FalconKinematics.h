// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The Novint Falcon's kinematics: encoder counts <-> grip position, force -> motor commands.
 *
 * A delta robot has three legs, each with an arm that a motor turns, and a parallelogram from the
 * arm's end to the grip. A leg closes if g(p, theta) = 0: the distance of the parallelogram's ends
 * minus its length. Everything here follows from g. Positions are in metres in the device's frame,
 * in which z points from the base to the hand. Angles are in radians; they grow as the grip is
 * pulled out.
 *
 * Pure functions for the servo loop: no allocation, bounded iterations. Not verified on hardware.
 */
#ifndef FalconKinematics_h
#define FalconKinematics_h

#include "Core/Math/Vector3.h"

#include <array>
#include <cstdint>

namespace VolumeHaptics
{

/** Encoder counts or motor commands, one for each leg, as they are sent. */
using FalconCounts = std::array<std::int16_t, 3>;

/** The largest command; more would be risky for a motor, and much more turns the sign. */
constexpr int FalconLargestCommand = 4096;

enum class FalconReach : std::uint8_t
{
  Reached,
  OutOfReach,  ///< no position closes all legs of the assembled device
  NotConverged ///< FalconMostSteps did not suffice
};

constexpr int FalconMostSteps = 20; ///< the most steps of Newton's iteration; within the workspace
                                    ///< it takes 4 to 8

/** The position of the grip; meaningless unless Reach is Reached, but always finite. */
struct FalconPose
{
  Vector3 Position; ///< m
  Matrix3 Jacobian; ///< dp/dtheta, m/rad: one column for each leg
  int Steps = 0;    ///< steps of Newton's iteration
  FalconReach Reach = FalconReach::NotConverged;
};

/** Converts homed encoder counts to angles (rad): 35 degrees + 0.0364347 degrees per count. */
Vector3 FalconAnglesOf(const FalconCounts& counts) noexcept;

/**
 * Finds the position for three leg angles, and dp/dtheta there, by Newton's iteration on g from (0,
 * 0, 0.11). A position is reached only if the assembled device can take it: the arms bent as they
 * are built, no leg turned over, and no singularity passed on the way. Angles that are not finite
 * are out of reach.
 */
FalconPose FalconForward(const Vector3& angles) noexcept;

/**
 * Computes the angles of a position, in closed form. If the position is out of reach, returns false
 * and leaves the angles unchanged.
 */
bool FalconInverse(const Vector3& position, Vector3& angles) noexcept;

/**
 * Computes dp/dtheta (m/rad) of closed legs, by implicit differentiation of g. In a singularity or
 * out of reach, returns false and leaves the matrix unchanged.
 */
bool FalconJacobian(const Vector3& position, const Vector3& angles, Matrix3& jacobian) noexcept;

/**
 * Computes the commands for a force (N) before the cap: -1e4 per N m of the torques (dp/dtheta)^T
 * F.
 */
Vector3 FalconTorqueCommands(const Matrix3& jacobian, const Vector3& force) noexcept;

/**
 * Computes the commands to send. All three are scaled down together to FalconLargestCommand, so
 * that the force keeps its direction. All commands are zero if one is not finite.
 */
FalconCounts FalconCommandsOf(const Matrix3& jacobian, const Vector3& force) noexcept;

} // namespace VolumeHaptics

#endif

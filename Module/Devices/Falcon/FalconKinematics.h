// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The Novint Falcon's kinematics: encoder counts <-> grip position, force -> motor commands.
 *
 * A delta robot: three legs, each an arm turned by a motor and a parallelogram from the arm's end
 * to the grip. A leg closes where g(p, theta) = 0, the distance of the parallelogram's ends less
 * its length; everything here follows from g. Positions are in metres in the device's frame: z
 * points from the base to the hand. Angles are in radians; they grow as the grip is pulled out.
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

/** Encoder counts or motor commands, one a leg, as they are sent. */
using FalconCounts = std::array<std::int16_t, 3>;

/** The largest command of a motor; more would be risky for the motors, much more turns the sign. */
constexpr int FalconLargestCommand = 4096;

enum class FalconReach : std::uint8_t
{
  Reached,
  OutOfReach,  ///< no position closes all legs as the device is assembled
  NotConverged ///< FalconMostSteps were not enough
};

constexpr int FalconMostSteps = 20; ///< of Newton's iteration; within the workspace it takes 4 to 8

/** Where the grip is; without meaning unless Reach says Reached, but always finite. */
struct FalconPose
{
  Vector3 Position; ///< m
  Matrix3 Jacobian; ///< dp/dtheta, m/rad: a column a leg
  int Steps = 0;    ///< that Newton's iteration took
  FalconReach Reach = FalconReach::NotConverged;
};

/** The angles (rad) that homed encoders stand for: 35 degrees + 0.0364347 degrees a count. */
Vector3 FalconAnglesOf(const FalconCounts& counts) noexcept;

/**
 * The position that three leg angles lead to, by Newton's iteration on g from (0, 0, 0.11), and
 * dp/dtheta there. Only what the assembled device can reach counts as reached: the arms bent as
 * they are built, no leg turned over, no singularity passed on the way. Angles that are not finite
 * are out of reach.
 */
FalconPose FalconForward(const Vector3& angles) noexcept;

/** The angles of a position, in closed form; false, with the angles as they were, out of reach. */
bool FalconInverse(const Vector3& position, Vector3& angles) noexcept;

/**
 * dp/dtheta (m/rad) where the legs close, by implicit differentiation of g; false, with the matrix
 * as it was, in a singularity and out of reach.
 */
bool FalconJacobian(const Vector3& position, const Vector3& angles, Matrix3& jacobian) noexcept;

/**
 * The commands for a force (N) before they are capped: -1e4 a N m, of the torques (dp/dtheta)^T F.
 */
Vector3 FalconTorqueCommands(const Matrix3& jacobian, const Vector3& force) noexcept;

/**
 * The commands to send. All three are scaled down together to FalconLargestCommand, so that the
 * force keeps its direction; all are zero where one is not finite.
 */
FalconCounts FalconCommandsOf(const Matrix3& jacobian, const Vector3& force) noexcept;

} // namespace VolumeHaptics

#endif

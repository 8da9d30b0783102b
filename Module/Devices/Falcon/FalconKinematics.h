// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The Novint Falcon's kinematics: converts encoder counts to the grip's position and back, and a
 * force to motor commands.
 *
 * A delta robot has three legs. Each has an arm that a motor rotates, and a parallelogram from the
 * arm's end to the grip. A leg is closed if g(p, theta) = 0, where g compares the distance between
 * the parallelogram's ends with its length. All functions follow from g. Positions are in metres in
 * the device's frame, in which z points from the base to the hand. Angles are in radians, and grow
 * as the grip is pulled out.
 *
 * The functions are pure and safe in the servo loop: they allocate no memory, and limit the number
 * of iterations. Not verified on hardware.
 */
#ifndef FalconKinematics_h
#define FalconKinematics_h

#include "Core/Math/Vector3.h"

#include <array>
#include <cstdint>

namespace VolumeHaptics
{

/** Encoder counts or motor commands as transmitted, one for each leg. */
using FalconCounts = std::array<std::int16_t, 3>;

/**
 * Largest command. Larger commands could damage a motor, and much larger ones would overflow to the
 * opposite sign.
 */
constexpr int FalconLargestCommand = 4096;

enum class FalconReach : std::uint8_t
{
  Reached,
  OutOfReach,  ///< no configuration of the assembled device closes all legs at these angles
  NotConverged ///< FalconMostSteps steps did not suffice
};

/** Largest number of steps of Newton's iteration, which needs 4 to 8 within the workspace. */
constexpr int FalconMostSteps = 20;

/** The position of the grip. It is always finite, but valid only if Reach is Reached. */
struct FalconPose
{
  Vector3 Position; ///< position p of the tip (m)
  Matrix3 Jacobian; ///< dp/dtheta in m/rad, with one column for each leg
  int Steps = 0;    ///< number of steps of Newton's iteration
  FalconReach Reach = FalconReach::NotConverged;
};

/**
 * Converts the counts of homed encoders to angles (rad). An angle is 35 degrees + 0.0364347 degrees
 * per count.
 */
Vector3 FalconAnglesOf(const FalconCounts& counts) noexcept;

/**
 * Computes the position for the angles of the three legs, and dp/dtheta there, by Newton's
 * iteration on g from (0, 0, 0.11). A position counts as reached only if the assembled device can
 * be there: the arms are bent as built, no leg has flipped over, and no singularity was passed on
 * the way. Angles that are not finite are out of reach.
 */
FalconPose FalconForward(const Vector3& angles) noexcept;

/**
 * Computes the angles for a position in closed form. If the position is out of reach, returns false
 * and leaves the angles unchanged.
 */
bool FalconInverse(const Vector3& position, Vector3& angles) noexcept;

/**
 * Computes dp/dtheta (m/rad) of closed legs by implicit differentiation of g. In a singularity or
 * out of reach, returns false and leaves the matrix unchanged.
 */
bool FalconJacobian(const Vector3& position, const Vector3& angles, Matrix3& jacobian) noexcept;

/** Computes the unlimited commands for a force (N): -1e4 per N m of the torques (dp/dtheta)^T F. */
Vector3 FalconTorqueCommands(const Matrix3& jacobian, const Vector3& force) noexcept;

/**
 * Computes the commands to send. All three are scaled by the same factor to at most
 * FalconLargestCommand, so that the force keeps its direction. If any is not finite, all are zero.
 */
FalconCounts FalconCommandsOf(const Matrix3& jacobian, const Vector3& force) noexcept;

} // namespace VolumeHaptics

#endif

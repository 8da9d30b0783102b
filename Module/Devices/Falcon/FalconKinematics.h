// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The Novint Falcon's kinematics: converts encoder counts to the grip's position and back, and a
 * force to motor commands.
 *
 * A delta robot has three legs. Each has an arm that a motor rotates, and a parallelogram from the
 * arm's end to the grip. A leg is closed if g(p, theta) = 0, where g is the distance between the
 * parallelogram's ends minus its length. All functions follow from g. Positions are in metres in
 * the device's frame, in which z points from the base to the hand. Angles are in radians, and grow
 * as the grip is pulled out.
 *
 * These are pure functions for the servo loop: no allocation, and a limited number of iterations.
 * Not verified on hardware.
 */
#ifndef FalconKinematics_h
#define FalconKinematics_h

#include "Core/Math/Vector3.h"

#include <array>
#include <cstdint>

namespace VolumeHaptics
{

/** Encoder counts or motor commands as they are sent, one for each leg. */
using FalconCounts = std::array<std::int16_t, 3>;

/**
 * Largest command. A larger one would be risky for a motor, and a much larger one would change its
 * sign.
 */
constexpr int FalconLargestCommand = 4096;

enum class FalconReach : std::uint8_t
{
  Reached,
  OutOfReach,  ///< no position of the assembled device closes all its legs
  NotConverged ///< FalconMostSteps steps did not suffice
};

/** Limit of the steps of Newton's iteration; in the workspace it takes 4 to 8. */
constexpr int FalconMostSteps = 20;

/** The position of the grip. It is always finite, but only valid if Reach is Reached. */
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
 * iteration on g from (0, 0, 0.11). A position is reached only if the device as it is assembled can
 * have it: the arms are bent as built, no leg has turned over, and no singularity is passed on the
 * way. Angles that are not finite are out of reach.
 */
FalconPose FalconForward(const Vector3& angles) noexcept;

/**
 * Computes the angles for a position in closed form. Returns false and leaves the angles unchanged
 * if the position is out of reach.
 */
bool FalconInverse(const Vector3& position, Vector3& angles) noexcept;

/**
 * Computes dp/dtheta (m/rad) of closed legs by implicit differentiation of g. Returns false and
 * leaves the matrix unchanged in a singularity or out of reach.
 */
bool FalconJacobian(const Vector3& position, const Vector3& angles, Matrix3& jacobian) noexcept;

/**
 * Computes the commands for a force (N) before they are limited: -1e4 per N m of the torques
 * (dp/dtheta)^T F.
 */
Vector3 FalconTorqueCommands(const Matrix3& jacobian, const Vector3& force) noexcept;

/**
 * Computes the commands to send. All three are reduced by the same factor to at most
 * FalconLargestCommand, so that the force keeps its direction. All are zero if one is not finite.
 */
FalconCounts FalconCommandsOf(const Matrix3& jacobian, const Vector3& force) noexcept;

} // namespace VolumeHaptics

#endif

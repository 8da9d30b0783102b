// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Falcon/FalconKinematics.h"

#include "Core/Safety/SafetyStage.h"

#include <cmath>

namespace VolumeHaptics
{

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Degree = Pi / 180.0;
constexpr double AngleAtZero = 35.0 * Degree;
constexpr double AnglePerCount = 0.0364347 * Degree;
constexpr double CommandPerTorque = -1e4; // command units per N m

// Lengths in m, with the names used in the literature on delta robots.
constexpr double A = 0.060;
constexpr double B = 0.1025;
constexpr double C = 0.01443;
constexpr double DPlusE = 0.01125 + 0.01125;
constexpr double F = -0.025;
constexpr double R = 0.040;
constexpr double S = -0.02309;

constexpr Vector3 Start = { 0.0, 0.0, 0.11 };
constexpr double Converged = 1e-12; // length (m) of the step below which the iteration ends
// Smallest accepted determinant of the legs' unit normals. Near zero, one encoder count could move
// the grip by any distance.
constexpr double Singular = 0.02;
// Limit (m^2/rad) of the derivative of g / 2 with respect to the angle, above which a leg counts as
// stretched. At zero, a stretched leg no longer moves the grip; the limit is a fraction of an
// encoder count away.
constexpr double Stretched = -1e-6;

struct Azimuth
{
  double Cos;
  double Sin;
};
// The azimuths are 105, -15 and -135 degrees.
constexpr Azimuth Azimuths[3] = { { -0.25881904510252076, 0.96592582628906829 },
  { 0.96592582628906829, -0.25881904510252076 }, { -0.70710678118654752, -0.70710678118654752 } };

/**
 * A position in a leg's frame, and the length of the parallelogram in projection along the arm's
 * axis.
 */
struct Leg
{
  double U;
  double V;
  double W;
  double Length;
  double Slope; ///< -dLength/dV
};

bool SeeFromLeg(const Azimuth& azimuth, const Vector3& p, Leg& leg) noexcept
{
  leg.U = azimuth.Cos * p.X + azimuth.Sin * p.Y - R;
  leg.V = -azimuth.Sin * p.X + azimuth.Cos * p.Y - S;
  leg.W = p.Z;
  const double aside = leg.V + F;
  const double square = B * B - aside * aside;
  if (!(square > 0.0))
  {
    return false;
  }
  const double along = std::sqrt(square);
  leg.Length = DPlusE + along;
  leg.Slope = aside / along;
  return true;
}

/** Half of g, with its derivatives with respect to position and angle. */
struct Closure
{
  double Value;
  Vector3 ByPosition;
  double ByAngle;
};

bool Close(const Azimuth& azimuth, const Vector3& p, double angle, Closure& closure) noexcept
{
  Leg leg;
  if (!SeeFromLeg(azimuth, p, leg))
  {
    return false;
  }
  const double cosine = std::cos(angle);
  const double sine = std::sin(angle);
  const double across = leg.U + C - A * cosine;
  const double up = leg.W - A * sine;
  const double aside = leg.Length * leg.Slope;
  closure.Value = 0.5 * (across * across + up * up - leg.Length * leg.Length);
  closure.ByPosition = { azimuth.Cos * across - azimuth.Sin * aside,
    azimuth.Sin * across + azimuth.Cos * aside, up };
  closure.ByAngle = A * (across * sine - up * cosine);
  return true;
}

struct Closures
{
  Matrix3 ByPosition;
  Vector3 Values;
  Vector3 ByAngle;
};

bool Close(const Vector3& p, const Vector3& angles, Closures& all) noexcept
{
  Closure legs[3];
  const double angle[3] = { angles.X, angles.Y, angles.Z };
  for (int i = 0; i < 3; ++i)
  {
    if (!Close(Azimuths[i], p, angle[i], legs[i]))
    {
      return false;
    }
    all.ByPosition.Row[i] = legs[i].ByPosition;
  }
  all.Values = { legs[0].Value, legs[1].Value, legs[2].Value };
  all.ByAngle = { legs[0].ByAngle, legs[1].ByAngle, legs[2].ByAngle };
  return true;
}

/**
 * Returns whether the grip is on the side of the singularities on which the device was assembled.
 */
bool IsRegular(const Matrix3& byPosition) noexcept
{
  const double volume = Norm(byPosition.Row[0]) * Norm(byPosition.Row[1]) * Norm(byPosition.Row[2]);
  // The legs are arranged clockwise.
  return -Determinant(byPosition) > Singular * volume;
}

/**
 * Returns whether the arms are bent outwards, as they were built. The sign of the square root in
 * the inverse corresponds to this.
 */
bool IsBentAsBuilt(const Vector3& byAngle) noexcept
{
  return byAngle.X < Stretched && byAngle.Y < Stretched && byAngle.Z < Stretched;
}

Matrix3 JacobianOf(const Closures& all) noexcept
{
  const Matrix3 columns = Transpose(Inverse(all.ByPosition));
  return Matrix3::FromColumns(-all.ByAngle.X * columns.Row[0], -all.ByAngle.Y * columns.Row[1],
    -all.ByAngle.Z * columns.Row[2]);
}

bool IsWithinATurn(const Vector3& angles) noexcept
{
  return std::fabs(angles.X) < Pi && std::fabs(angles.Y) < Pi && std::fabs(angles.Z) < Pi;
}
} // namespace

Vector3 FalconAnglesOf(const FalconCounts& counts) noexcept
{
  return { AngleAtZero + AnglePerCount * counts[0], AngleAtZero + AnglePerCount * counts[1],
    AngleAtZero + AnglePerCount * counts[2] };
}

FalconPose FalconForward(const Vector3& angles) noexcept
{
  FalconPose pose;
  pose.Position = Start;
  pose.Reach = FalconReach::OutOfReach;
  if (!IsWithinATurn(angles))
  {
    return pose;
  }
  Closures all;
  for (pose.Steps = 1; pose.Steps <= FalconMostSteps; ++pose.Steps)
  {
    if (!Close(pose.Position, angles, all) || !IsRegular(all.ByPosition))
    {
      return pose;
    }
    const Vector3 step = Inverse(all.ByPosition) * all.Values;
    pose.Position = pose.Position - step;
    if (Norm(step) < Converged)
    {
      const bool reached = Close(pose.Position, angles, all) && IsRegular(all.ByPosition) &&
        IsBentAsBuilt(all.ByAngle);
      if (reached)
      {
        pose.Jacobian = JacobianOf(all);
        pose.Reach = FalconReach::Reached;
      }
      return pose;
    }
  }
  pose.Reach = FalconReach::NotConverged;
  return pose;
}

bool FalconInverse(const Vector3& position, Vector3& angles) noexcept
{
  double found[3];
  for (int i = 0; i < 3; ++i)
  {
    Leg leg;
    if (!SeeFromLeg(Azimuths[i], position, leg))
    {
      return false;
    }
    // Solve l2 t^2 + l1 t + l0 = 0 for t, the tangent of half the angle.
    const double rest = leg.W * leg.W - leg.Length * leg.Length;
    const double inner = leg.U + C - A;
    const double outer = leg.U + C + A;
    const double l0 = inner * inner + rest;
    const double l1 = -4.0 * A * leg.W;
    const double l2 = outer * outer + rest;
    const double square = l1 * l1 - 4.0 * l0 * l2;
    if (!(square >= 0.0))
    {
      return false;
    }
    // Use atan2 of numerator and denominator, which avoids a division by zero if l2 is zero.
    const double over = -l1 - std::sqrt(square);
    found[i] = 2.0 * std::atan2(std::copysign(1.0, l2) * over, 2.0 * std::fabs(l2));
  }
  angles = { found[0], found[1], found[2] };
  return true;
}

bool FalconJacobian(const Vector3& position, const Vector3& angles, Matrix3& jacobian) noexcept
{
  Closures all;
  if (!Close(position, angles, all) || !IsRegular(all.ByPosition))
  {
    return false;
  }
  jacobian = JacobianOf(all);
  return true;
}

Vector3 FalconTorqueCommands(const Matrix3& jacobian, const Vector3& force) noexcept
{
  return CommandPerTorque * (Transpose(jacobian) * force);
}

FalconCounts FalconCommandsOf(const Matrix3& jacobian, const Vector3& force) noexcept
{
  const Vector3 wanted = FalconTorqueCommands(jacobian, force);
  double commands[3] = { wanted.X, wanted.Y, wanted.Z };
  SaturateTogether(commands, 3, FalconLargestCommand);
  return { static_cast<std::int16_t>(std::lround(commands[0])),
    static_cast<std::int16_t>(std::lround(commands[1])),
    static_cast<std::int16_t>(std::lround(commands[2])) };
}

} // namespace VolumeHaptics

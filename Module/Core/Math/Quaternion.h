// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Unit quaternions for orientations, as value types.
 *
 * The order of the numbers is w, x, y, z, as in vtkQuaternion. A rotation by an angle a about the
 * unit axis n is { cos(a/2), sin(a/2) n }. q and -q are the same orientation. No function
 * allocates, throws or uses trigonometric functions, so that the servo tick can call all of them.
 */
#ifndef Quaternion_h
#define Quaternion_h

#include "Core/Math/Vector3.h"

#include <limits>

namespace VolumeHaptics
{

/** An orientation, or four numbers that MakeUnit() has not checked yet. */
struct Quaternion
{
  double W = 1.0;
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;
};

constexpr double SquaredNorm(const Quaternion& q) noexcept
{
  return q.W * q.W + q.X * q.X + q.Y * q.Y + q.Z * q.Z;
}
constexpr Quaternion operator*(double s, const Quaternion& q) noexcept
{
  return { s * q.W, s * q.X, s * q.Y, s * q.Z };
}
/** Returns the rotation by b followed by the rotation by a, both about fixed axes. */
constexpr Quaternion operator*(const Quaternion& a, const Quaternion& b) noexcept
{
  return { a.W * b.W - a.X * b.X - a.Y * b.Y - a.Z * b.Z,
    a.W * b.X + a.X * b.W + a.Y * b.Z - a.Z * b.Y, a.W * b.Y - a.X * b.Z + a.Y * b.W + a.Z * b.X,
    a.W * b.Z + a.X * b.Y - a.Y * b.X + a.Z * b.W };
}
/** Returns the inverse rotation of a unit quaternion. */
constexpr Quaternion Conjugate(const Quaternion& q) noexcept
{
  return { q.W, -q.X, -q.Y, -q.Z };
}

/**
 * Largest difference of the norm from 1 that MakeUnit() accepts. It is large because sensors send
 * few digits.
 */
constexpr double UnitTolerance = 0.01;

/**
 * Divides a quaternion by its norm. Returns false and changes nothing if it is no orientation, that
 * is, if a number is not finite or the norm differs from 1 by more than the tolerance. A norm of 1
 * apart from rounding leaves the quaternion unchanged, so that a second call changes nothing.
 */
inline bool MakeUnit(Quaternion& q) noexcept
{
  constexpr double rounding = 16.0 * std::numeric_limits<double>::epsilon();
  const double square = SquaredNorm(q);
  const double norm = std::sqrt(square);
  // The comparison is false for NaN and infinity, too.
  if (!(std::abs(norm - 1.0) <= UnitTolerance))
  {
    return false;
  }
  if (std::abs(square - 1.0) > rounding)
  {
    q = (1.0 / norm) * q;
  }
  return true;
}

/** Returns the rotation matrix of a unit quaternion. */
constexpr Matrix3 ToMatrix(const Quaternion& q) noexcept
{
  const double x = 2.0 * q.X;
  const double y = 2.0 * q.Y;
  const double z = 2.0 * q.Z;
  return { { { 1.0 - y * q.Y - z * q.Z, x * q.Y - z * q.W, x * q.Z + y * q.W },
    { x * q.Y + z * q.W, 1.0 - x * q.X - z * q.Z, y * q.Z - x * q.W },
    { x * q.Z - y * q.W, y * q.Z + x * q.W, 1.0 - x * q.X - y * q.Y } } };
}

/** Returns the unit quaternion of a rotation matrix. Its largest component is positive. */
inline Quaternion ToQuaternion(const Matrix3& m) noexcept
{
  // Take the largest component from the diagonal and divide the others by it, so that all are
  // accurate.
  const double xx = m.Row[0].X;
  const double yy = m.Row[1].Y;
  const double zz = m.Row[2].Z;
  const Vector3 odd{ m.Row[2].Y - m.Row[1].Z, m.Row[0].Z - m.Row[2].X, m.Row[1].X - m.Row[0].Y };
  const Vector3 even{ m.Row[2].Y + m.Row[1].Z, m.Row[0].Z + m.Row[2].X, m.Row[1].X + m.Row[0].Y };
  const double squares[4] = { 1.0 + xx + yy + zz, 1.0 + xx - yy - zz, 1.0 - xx + yy - zz,
    1.0 - xx - yy + zz };
  Quaternion q;
  if (squares[0] >= 1.0)
  {
    q = { squares[0], odd.X, odd.Y, odd.Z };
  }
  else if (xx >= yy && xx >= zz)
  {
    q = { odd.X, squares[1], even.Z, even.Y };
  }
  else if (yy >= zz)
  {
    q = { odd.Y, even.Z, squares[2], even.X };
  }
  else
  {
    q = { odd.Z, even.Y, even.X, squares[3] };
  }
  return (1.0 / std::sqrt(SquaredNorm(q))) * q;
}

/** Value for "no orientation" in arrays and files. */
inline constexpr Quaternion NoOrientation{ 0.0, 0.0, 0.0, 0.0 };
/**
 * Returns an orientation for arrays and files: `q` rotated by a matrix, for example by the rotation
 * from the device's axes to the world's. Returns NoOrientation if `isValid` is false.
 */
inline Quaternion TurnedBy(const Matrix3& rotation, const Quaternion& q, bool isValid) noexcept
{
  return isValid ? ToQuaternion(rotation) * q : NoOrientation;
}

/** Returns whether the numbers are exactly equal. q and -q are not. */
constexpr bool IsIdentical(const Quaternion& a, const Quaternion& b) noexcept
{
  return a.W == b.W && a.X == b.X && a.Y == b.Y && a.Z == b.Z;
}

} // namespace VolumeHaptics

#endif

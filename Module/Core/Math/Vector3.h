// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Three-vectors, 3x3 matrices and affine maps in double precision, as value types.
 *
 * No function allocates or throws, and most are constexpr, so that the servo tick can call all of
 * them. Matrices are row-major.
 */
#ifndef Vector3_h
#define Vector3_h

#include <cmath>

namespace VolumeHaptics
{

struct Vector3
{
  double X = 0.0;
  double Y = 0.0;
  double Z = 0.0;

  constexpr Vector3& operator+=(const Vector3& b) noexcept
  {
    this->X += b.X;
    this->Y += b.Y;
    this->Z += b.Z;
    return *this;
  }
};

constexpr Vector3 operator+(const Vector3& a, const Vector3& b) noexcept
{
  return { a.X + b.X, a.Y + b.Y, a.Z + b.Z };
}
constexpr Vector3 operator-(const Vector3& a, const Vector3& b) noexcept
{
  return { a.X - b.X, a.Y - b.Y, a.Z - b.Z };
}
constexpr Vector3 operator-(const Vector3& a) noexcept
{
  return { -a.X, -a.Y, -a.Z };
}
constexpr Vector3 operator*(double s, const Vector3& a) noexcept
{
  return { s * a.X, s * a.Y, s * a.Z };
}
constexpr Vector3 operator*(const Vector3& a, double s) noexcept
{
  return s * a;
}
constexpr double Dot(const Vector3& a, const Vector3& b) noexcept
{
  return a.X * b.X + a.Y * b.Y + a.Z * b.Z;
}
constexpr Vector3 Cross(const Vector3& a, const Vector3& b) noexcept
{
  return { a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X };
}
inline double Norm(const Vector3& a) noexcept
{
  return std::sqrt(Dot(a, a));
}
/** Shortens a vector whose norm exceeds `most`. Returns zero if `most` is NaN or not positive. */
inline Vector3 ClampNorm(const Vector3& v, double most) noexcept
{
  if (!(most > 0.0))
  {
    return {};
  }
  const double norm = Norm(v);
  return norm > most ? (most / norm) * v : v;
}
///@{
/** Return the smaller (Least) or the larger (Most) of each pair of components. */
inline Vector3 Least(const Vector3& a, const Vector3& b) noexcept
{
  return { std::fmin(a.X, b.X), std::fmin(a.Y, b.Y), std::fmin(a.Z, b.Z) };
}
inline Vector3 Most(const Vector3& a, const Vector3& b) noexcept
{
  return { std::fmax(a.X, b.X), std::fmax(a.Y, b.Y), std::fmax(a.Z, b.Z) };
}
///@}
/** Returns whether the magnitudes of all components are below a limit, which is false for NaN. */
inline bool IsNear(const Vector3& a, double most) noexcept
{
  return std::abs(a.X) < most && std::abs(a.Y) < most && std::abs(a.Z) < most;
}
/** Returns a unit vector perpendicular to `unit`. */
inline Vector3 UnitAcross(const Vector3& unit) noexcept
{
  const Vector3 axis = std::abs(unit.X) < 0.6 ? Vector3{ 1.0, 0.0, 0.0 } : Vector3{ 0.0, 1.0, 0.0 };
  const Vector3 across = Cross(unit, axis);
  return (1.0 / Norm(across)) * across;
}
inline bool IsFinite(const Vector3& a) noexcept
{
  return std::isfinite(a.X) && std::isfinite(a.Y) && std::isfinite(a.Z);
}

struct Matrix3
{
  Vector3 Row[3] = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };

  static constexpr Matrix3 FromColumns(
    const Vector3& a, const Vector3& b, const Vector3& c) noexcept
  {
    return { { { a.X, b.X, c.X }, { a.Y, b.Y, c.Y }, { a.Z, b.Z, c.Z } } };
  }
};

constexpr Vector3 operator*(const Matrix3& m, const Vector3& v) noexcept
{
  return { Dot(m.Row[0], v), Dot(m.Row[1], v), Dot(m.Row[2], v) };
}
constexpr Matrix3 Transpose(const Matrix3& m) noexcept
{
  return Matrix3::FromColumns(m.Row[0], m.Row[1], m.Row[2]);
}
constexpr Matrix3 operator*(const Matrix3& a, const Matrix3& b) noexcept
{
  const Matrix3 columns = Transpose(b);
  return Matrix3::FromColumns(a * columns.Row[0], a * columns.Row[1], a * columns.Row[2]);
}
constexpr Matrix3 operator*(double s, const Matrix3& m) noexcept
{
  return { { s * m.Row[0], s * m.Row[1], s * m.Row[2] } };
}
constexpr double Determinant(const Matrix3& m) noexcept
{
  return Dot(m.Row[0], Cross(m.Row[1], m.Row[2]));
}
/** The determinant must not be zero. */
constexpr Matrix3 Inverse(const Matrix3& m) noexcept
{
  const double s = 1.0 / Determinant(m);
  return Matrix3::FromColumns(
    s * Cross(m.Row[1], m.Row[2]), s * Cross(m.Row[2], m.Row[0]), s * Cross(m.Row[0], m.Row[1]));
}

/**
 * Returns the length of a matrix's longest column. For a map from indices, this is the length of
 * the longest index step.
 */
inline double LargestColumn(const Matrix3& m) noexcept
{
  const Matrix3 columns = Transpose(m);
  return std::fmax(Norm(columns.Row[0]), std::fmax(Norm(columns.Row[1]), Norm(columns.Row[2])));
}

/** The affine map x -> Linear x + Offset. */
struct Affine3
{
  Matrix3 Linear;
  Vector3 Offset;

  constexpr Vector3 operator()(const Vector3& x) const noexcept
  {
    return this->Linear * x + this->Offset;
  }
};

constexpr Affine3 Compose(const Affine3& outer, const Affine3& inner) noexcept
{
  return { outer.Linear * inner.Linear, outer(inner.Offset) };
}
constexpr Affine3 Inverse(const Affine3& a) noexcept
{
  const Matrix3 inverse = Inverse(a.Linear);
  return { inverse, -(inverse * a.Offset) };
}

/**
 * Returns the rotation in a map that consists of a rotation, a translation and a uniform positive
 * scale.
 */
inline Matrix3 RotationOf(const Affine3& map) noexcept
{
  return (1.0 / std::cbrt(Determinant(map.Linear))) * map.Linear;
}

///@{
constexpr bool IsIdentical(const Vector3& a, const Vector3& b) noexcept
{
  return a.X == b.X && a.Y == b.Y && a.Z == b.Z;
}
constexpr bool IsIdentical(const Affine3& a, const Affine3& b) noexcept
{
  return IsIdentical(a.Linear.Row[0], b.Linear.Row[0]) &&
    IsIdentical(a.Linear.Row[1], b.Linear.Row[1]) &&
    IsIdentical(a.Linear.Row[2], b.Linear.Row[2]) && IsIdentical(a.Offset, b.Offset);
}
///@}

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Three-vectors of the reference. They are deliberately simple, and share no code with the module.
 */
#ifndef Vec3_h
#define Vec3_h

#include <cmath>

namespace reference
{
struct Vec3
{
  double c[3] = { 0.0, 0.0, 0.0 };

  double& operator[](int i) { return this->c[i]; }
  double operator[](int i) const { return this->c[i]; }
};

inline Vec3 operator+(const Vec3& a, const Vec3& b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2] } };
}

inline Vec3 operator-(const Vec3& a, const Vec3& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2] } };
}

inline Vec3 operator*(double s, const Vec3& a)
{
  return { { s * a[0], s * a[1], s * a[2] } };
}

inline double Dot(const Vec3& a, const Vec3& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

inline Vec3 Cross(const Vec3& a, const Vec3& b)
{
  return { { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] } };
}

inline double Norm(const Vec3& a)
{
  return std::sqrt(Dot(a, a));
}

inline bool IsFinite(const Vec3& a)
{
  return std::isfinite(a[0]) && std::isfinite(a[1]) && std::isfinite(a[2]);
}

/// Matrix of three columns, such as an image's direction times its spacing.
struct Mat3
{
  Vec3 column[3] = { { { 1.0, 0.0, 0.0 } }, { { 0.0, 1.0, 0.0 } }, { { 0.0, 0.0, 1.0 } } };
};

inline Vec3 operator*(const Mat3& m, const Vec3& a)
{
  return a[0] * m.column[0] + a[1] * m.column[1] + a[2] * m.column[2];
}

/// Returns the transpose of the inverse, by Cramer's rule: its columns are the rows of the inverse.
inline Mat3 InverseTransposed(const Mat3& m)
{
  const double det = Dot(m.column[0], Cross(m.column[1], m.column[2]));
  return { { (1.0 / det) * Cross(m.column[1], m.column[2]),
    (1.0 / det) * Cross(m.column[2], m.column[0]),
    (1.0 / det) * Cross(m.column[0], m.column[1]) } };
}

/// m^T a
inline Vec3 TransposedTimes(const Mat3& m, const Vec3& a)
{
  return { { Dot(m.column[0], a), Dot(m.column[1], a), Dot(m.column[2], a) } };
}
} // namespace reference

#endif

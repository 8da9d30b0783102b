// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Symmetric matrices and quadrics as value types.
 */
#ifndef Quadric_h
#define Quadric_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{

/** A symmetric matrix. */
struct Symmetric3
{
  Vector3 Diagonal; ///< XX, YY, ZZ
  Vector3 Mixed;    ///< YZ, XZ, XY

  constexpr Vector3 operator*(const Vector3& v) const noexcept
  {
    return { this->Diagonal.X * v.X + this->Mixed.Z * v.Y + this->Mixed.Y * v.Z,
      this->Mixed.Z * v.X + this->Diagonal.Y * v.Y + this->Mixed.X * v.Z,
      this->Mixed.Y * v.X + this->Mixed.X * v.Y + this->Diagonal.Z * v.Z };
  }
};

/**
 * A quadric, given by the depth of a point x in the structure: Gradient.u + u.Curvature u / 2,
 * where u = x - Centre. The depth is positive inside the structure.
 */
struct Quadric
{
  Vector3 Centre;
  Vector3 Gradient;
  Symmetric3 Curvature;

  double Depth(const Vector3& x) const noexcept
  {
    const Vector3 u = x - this->Centre;
    return Dot(u, this->Gradient + 0.5 * (this->Curvature * u));
  }
  Vector3 Slope(const Vector3& x) const noexcept
  {
    return this->Gradient + this->Curvature * (x - this->Centre);
  }
};

} // namespace VolumeHaptics

#endif

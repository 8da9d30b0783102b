// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A plane or a quadric that stands in for the isosurface near the proxy: what the slow loop of
 * HapticMethod::LocalSurface finds.
 *
 * The nearest crossing of V = HapticSettings::IsoValue is looked for along 26 directions,
 * LocalReach voxels far, and along the way that the tip takes; from there its foot is followed
 * along the gradient. With the foot c, the unit normal N (into the structure) and, for a quadric,
 * the change S of N across c, how deep x lies is
 *
 *   depth(x) = N.u + u.S u / 2,   u = x - c,   S N = 0.
 *
 * A surface holds from outside only: a hand that is in the structure, with no surface near that it
 * has not come through, finds none. N is that of the gradient kernel, turned to where V rises, or
 * falls.
 *
 * Everything is in world units, so that surfaces stay where they are when the device is placed
 * anew.
 */
#ifndef LocalSurface_h
#define LocalSurface_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{
class HapticModel;

/** How far around the hand a surface is looked for (voxels along each axis). */
constexpr int LocalReach = 4;
/** How far ahead of the hand, at most (voxels). */
constexpr int LocalReachAhead = 64;

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

/** depth(x) = Gradient.u + u.Curvature u / 2, u = x - Centre; more than 0 in the structure. */
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

struct LocalSurface
{
  bool IsThere = false; ///< whether there is any
  Quadric Shape;
};

/** Where to look. */
struct LocalQuestion
{
  Vector3 Where;  ///< the proxy
  Vector3 Ahead;  ///< how far the tip may have gone when the answer is replaced
  Vector3 Normal; ///< into the structure, of the surface that is known there; 0 where there is none
};

/**
 * Takes 10 to 20 microseconds with kernels of 2 voxels, and 200 with 8. The same question gets the
 * same answer, wherever the device is placed.
 */
LocalSurface FitLocalSurface(const HapticModel& model, const LocalQuestion& question) noexcept;

} // namespace VolumeHaptics

#endif

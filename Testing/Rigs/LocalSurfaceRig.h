// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Helpers for tests of the method LOCAL_SURFACE: models of volumes with a known surface. */
#ifndef LocalSurfaceRig_h
#define LocalSurfaceRig_h

#include "ServoFixture.h"

namespace coretest
{
inline constexpr double BallRadius = 14.0; // voxels, or mm

inline HapticModelDescription DescribeLocal(
  const TestVolume& volume, double iso, LocalSurfaceShape shape = LocalSurfaceShape::Plane)
{
  HapticModelDescription description = Describe(volume);
  description.Settings.Method = HapticMethod::LocalSurface;
  description.Settings.IsoValue = iso;
  description.Settings.LocalShape = shape;
  return description;
}

/// Returns a volume with the value 100 on a sphere around (20, 20, 20). Towards the middle, the
/// values increase by 10 per voxel for a ball (sign 1), and decrease for a cavity (-1).
inline TestVolume MakeLocalBall(double sign)
{
  TestVolume volume(ScalarType::Float64, { 41, 41, 41 });
  volume.Fill<double>(
    [sign](std::int64_t i, std::int64_t j, std::int64_t k)
    {
      const Vector3 x{ double(i) - 20.0, double(j) - 20.0, double(k) - 20.0 };
      return 100.0 + sign * 10.0 * (BallRadius - Norm(x));
    });
  return volume;
}
} // namespace coretest

#endif

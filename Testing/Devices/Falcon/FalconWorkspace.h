// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Samples positions in a Falcon's workspace, and computes the encoder counts at a position.
 */
#ifndef FalconWorkspace_h
#define FalconWorkspace_h

#include "Devices/Falcon/FalconKinematics.h"

#include <vector>

namespace hardwaretest
{
using namespace VolumeHaptics;

/**
 * Samples a cylinder with a radius of 0.06 m, from 0.075 to 0.15 m along z, which contains the
 * haptic workspace (radius 0.04 m).
 */
inline std::vector<Vector3> SampleWorkspace(double step = 0.005)
{
  constexpr double radius = 0.06;
  std::vector<Vector3> positions;
  for (double z = 0.075; z < 0.1501; z += step)
  {
    for (double y = -radius; y <= radius; y += step)
    {
      for (double x = -radius; x <= radius; x += step)
      {
        if (std::hypot(x, y) <= radius)
        {
          positions.push_back({ x, y, z });
        }
      }
    }
  }
  return positions;
}

/**
 * Returns the encoder counts at a position, for emulated reports. The count 0 means an arm at 35
 * degrees; a count is 0.0364347 degrees.
 */
inline FalconCounts CountsAt(const Vector3& position)
{
  Vector3 angles;
  FalconInverse(position, angles);
  const auto count = [](double angle)
  {
    const double degrees = angle * 180.0 / 3.14159265358979323846;
    return static_cast<std::int16_t>(std::lround((degrees - 35.0) / 0.0364347));
  };
  return { count(angles.X), count(angles.Y), count(angles.Z) };
}
} // namespace hardwaretest

#endif

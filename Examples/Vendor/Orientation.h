// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Converts the rotation matrices of vendors' libraries to unit quaternions.
#ifndef VolumeHapticsVendorOrientation_h
#define VolumeHapticsVendorOrientation_h

#include <algorithm>
#include <cmath>

// Converts a rotation matrix to a quaternion with w first. For rotations below a half turn, the
// matrix's antisymmetric part gives the signs of x, y and z.
inline void ToQuaternion(const double m[3][3], double q[4])
{
  const auto half = [](double square) { return 0.5 * std::sqrt(std::max(0.0, square)); };
  q[0] = half(1.0 + m[0][0] + m[1][1] + m[2][2]);
  q[1] = half(1.0 + m[0][0] - m[1][1] - m[2][2]);
  q[2] = half(1.0 - m[0][0] + m[1][1] - m[2][2]);
  q[3] = half(1.0 - m[0][0] - m[1][1] + m[2][2]);
  // Copy the signs from the row of the largest component, because a half turn has no antisymmetric
  // part.
  const int largest = static_cast<int>(std::max_element(q, q + 4) - q);
  const double part[4][4] = {
    { 1.0, m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1] },
    { m[2][1] - m[1][2], 1.0, m[0][1] + m[1][0], m[0][2] + m[2][0] },
    { m[0][2] - m[2][0], m[0][1] + m[1][0], 1.0, m[1][2] + m[2][1] },
    { m[1][0] - m[0][1], m[0][2] + m[2][0], m[1][2] + m[2][1], 1.0 },
  };
  for (int i = 0; i < 4; ++i)
  {
    q[i] = std::copysign(q[i], part[largest][i]);
  }
}

#endif

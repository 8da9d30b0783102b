// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Four doubles as a plain struct, for any compiler and processor; included by Double4.h only.
 */
#ifndef Double4Portable_h
#define Double4Portable_h

#include "Core/Math/KernelInline.h"

namespace VolumeHaptics
{
namespace
{

struct Double4
{
  double Lane[4];

  double operator[](int i) const { return this->Lane[i]; }
  double& operator[](int i) { return this->Lane[i]; }
};
VOLUME_HAPTICS_INLINE Double4 operator*(double s, const Double4& a)
{
  return { { s * a[0], s * a[1], s * a[2], s * a[3] } };
}
VOLUME_HAPTICS_INLINE Double4 operator*(const Double4& a, const Double4& b)
{
  return { { a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3] } };
}
VOLUME_HAPTICS_INLINE Double4 operator+(const Double4& a, const Double4& b)
{
  return { { a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3] } };
}
VOLUME_HAPTICS_INLINE Double4 operator-(const Double4& a, const Double4& b)
{
  return { { a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3] } };
}

/** Four samples of any type. */
template <typename T>
VOLUME_HAPTICS_INLINE Double4 LoadDouble4(const T* from)
{
  return { { static_cast<double>(from[0]), static_cast<double>(from[1]),
    static_cast<double>(from[2]), static_cast<double>(from[3]) } };
}

} // namespace
} // namespace VolumeHaptics

#endif

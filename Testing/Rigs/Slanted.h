// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Makes a rotation about a direction that is not along an axis. */
#ifndef Slanted_h
#define Slanted_h

#include "Core/Math/Vector3.h"

namespace coretest
{
using namespace VolumeHaptics;

/// Returns a rotation about an oblique axis.
inline Matrix3 Slanted()
{
  const double c = 0.36;
  const double s = std::sqrt(1.0 - c * c);
  const Matrix3 aboutX{ { { 1, 0, 0 }, { 0, c, -s }, { 0, s, c } } };
  const Matrix3 aboutZ{ { { s, -c, 0 }, { c, s, 0 }, { 0, 0, 1 } } };
  return aboutZ * aboutX;
}
} // namespace coretest

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Computes the growth of a force, which the slew limit bounds: the force's magnitude minus the
 * component of the previous force along its direction.
 */
#ifndef Growth_h
#define Growth_h

#include "Core/Math/Vector3.h"

#include <algorithm>

namespace servotest
{
inline double GrowthOf(const VolumeHaptics::Vector3& before, const VolumeHaptics::Vector3& after)
{
  const double norm = Norm(after);
  return norm > 0.0 ? norm - std::max(0.0, Dot(before, after) / norm) : 0.0;
}
} // namespace servotest

#endif

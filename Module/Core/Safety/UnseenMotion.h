// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detects motion of a tip that was not seen: the observers of energy begin anew after such a
 * motion.
 */
#ifndef UnseenMotion_h
#define UnseenMotion_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{

/**
 * Returns whether the force's work along a motion (m) that took a time (s) is unknown: the tip was
 * not measured for more than 30 ms, or was faster than a hand, 5 m/s.
 */
inline bool IsUnseenMotion(const Vector3& motion, double time) noexcept
{
  return time > 0.03 || Norm(motion) > 5.0 * time;
}

} // namespace VolumeHaptics

#endif

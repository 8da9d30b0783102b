// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Recognizes motion of the tip that was not observed. After such a motion, the energy
 * observers start again.
 */
#ifndef UnseenMotion_h
#define UnseenMotion_h

#include "Core/Math/Vector3.h"

namespace VolumeHaptics
{

/**
 * Returns whether the force's work along a motion is unknown: the tip was not measured for more
 * than 30 ms, or it moved faster than a hand can (5 m/s). `motion` is in m, `time` in s.
 */
inline bool IsUnseenMotion(const Vector3& motion, double time) noexcept
{
  return time > 0.03 || Norm(motion) > 5.0 * time;
}

} // namespace VolumeHaptics

#endif

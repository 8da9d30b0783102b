// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Limits of stiffness and damping, that is, of how fast a force may change with position and speed.
 */
#ifndef ForceCaps_h
#define ForceCaps_h

#include <algorithm>

namespace VolumeHaptics
{

/**
 * Largest stiffness and damping that a device can render stably at its tick rate, whatever the
 * material and the settings. 0 means no cap.
 */
struct ForceCaps
{
  double Stiffness = 0.0; ///< N/m
  double Damping = 0.0;   ///< N s/m
  /**
   * Stiffness (N/m) that the loop can render by itself, if Stiffness is larger
   * (ForceAugmentation.h). Otherwise 0.
   */
  double Feedback = 0.0;

  bool operator==(const ForceCaps& other) const noexcept
  {
    return this->Stiffness == other.Stiffness && this->Damping == other.Damping &&
      this->Feedback == other.Feedback;
  }
};

/** Returns the smaller of two caps. 0 means no cap. */
inline double TighterCap(double a, double b) noexcept
{
  return a > 0.0 && b > 0.0 ? std::min(a, b) : std::max(a, b);
}

inline ForceCaps TighterCaps(const ForceCaps& a, const ForceCaps& b) noexcept
{
  return { TighterCap(a.Stiffness, b.Stiffness), TighterCap(a.Damping, b.Damping),
    TighterCap(a.Feedback, b.Feedback) };
}

} // namespace VolumeHaptics

#endif

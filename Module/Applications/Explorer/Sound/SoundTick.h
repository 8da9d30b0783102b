// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_SoundTick_h
#define Explore_SoundTick_h

#include <cstdint>

namespace Explore
{
/// Contact of the proxy. The values equal those of the array Contact in traces and states.
enum class SurfaceContact : std::uint8_t
{
  Free = 0,
  Sticking = 1,
  Sliding = 2,
  Penetrating = 3
};

/// The data of a servo tick that sound depends on.
struct SoundTick
{
  double Time = 0.0;          // s
  double NormalForce = 0.0;   // N, on the hand
  double FrictionForce = 0.0; // N, on the hand
  double Speed = 0.0;         // speed of the proxy (m/s)
  double Stiffness = 0.0;     // k of the surface's material, N/m
  double Strength = 0.0;      // T_N of the surface's material, N
  SurfaceContact Contact = SurfaceContact::Free;
};
} // namespace Explore

#endif

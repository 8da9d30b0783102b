// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How a free needle enters tissue.
 *
 * The needle has to come from a place where nothing resists. It punctures a surface when the spring
 * pushes with the whole strength and the lag then falls. A surface that never gives way is
 * punctured when the needle is two kernel lengths deep in it.
 */
#ifndef NeedleEntry_h
#define NeedleEntry_h

#include "Core/Model/HapticModel.h"
#include "Core/State/ServoState.h"

namespace VolumeHaptics
{

/** The state at the beginning of a tick of the free law. */
struct FreeTick
{
  explicit FreeTick(const ServoState& state) noexcept
    : Proxy(state.Proxy)
    , Tip(state.PreviousTip)
    , Stiffness(state.Stiffness)
    , SurfaceStrength(state.SurfaceStrength)
  {
  }

  Vector3 Proxy;
  Vector3 Tip;
  double Stiffness;
  double SurfaceStrength;
};

/**
 * Inserts the needle and repeats the tick from `before`, if the tick has broken through a surface
 * or has come into tissue that resists. Call it after a tick of the method with a free needle.
 */
void EnterNeedle(
  const HapticModel& model, ServoState& state, const FreeTick& before, TickRecord& record) noexcept;

} // namespace VolumeHaptics

#endif

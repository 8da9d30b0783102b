// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Decides when a free needle enters tissue.
 *
 * The needle must come from a place where nothing resists. It punctures a surface when the spring
 * pushes with the surface's whole strength and the lag then falls. If a surface never gives way,
 * the needle punctures it when it has been pushed in by two kernel lengths.
 */
#ifndef NeedleEntry_h
#define NeedleEntry_h

#include "Core/Model/HapticModel.h"
#include "Core/State/ServoState.h"

namespace VolumeHaptics
{

/** State of the free needle at the beginning of a tick. */
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
 * If the tick has broken through a surface or has come into tissue that resists, inserts the needle
 * and repeats the tick from `before`. Must be called after a tick of the method with a free needle.
 */
void EnterNeedle(
  const HapticModel& model, ServoState& state, const FreeTick& before, TickRecord& record) noexcept;

} // namespace VolumeHaptics

#endif

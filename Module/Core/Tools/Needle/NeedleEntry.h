// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * How a free needle gets into tissue.
 *
 * It has to come from a place where nothing resists. A surface is punctured by the spring that
 * pushes with all that holds; then the lag falls. A surface that goes on holding, such as one
 * without an end, is punctured two kernel lengths deep.
 */
#ifndef NeedleEntry_h
#define NeedleEntry_h

#include "Core/Model/HapticModel.h"
#include "Core/State/ServoState.h"

namespace VolumeHaptics
{

/** What a tick of the free law began with. */
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
 * After a tick of the method with a free needle: inserts it, and does the tick again from `before`,
 * if the tick has broken through a surface or has come into tissue that resists.
 */
void EnterNeedle(
  const HapticModel& model, ServoState& state, const FreeTick& before, TickRecord& record) noexcept;

} // namespace VolumeHaptics

#endif

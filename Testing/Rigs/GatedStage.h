// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** A safety stage with its own force gate. */
#ifndef GatedStage_h
#define GatedStage_h

#include "Core/Safety/SafetyStage.h"

namespace rigs
{
class GatedStage
{
public:
  /// Arms the gate again, even while a force is active.
  void Arm()
  {
    this->Gate.Arm(false);
    this->Reset();
  }
  void Reset() { this->Stage.Reset(); }
  VolumeHaptics::Vector3 Apply(
    const VolumeHaptics::SafetyInput& input, const VolumeHaptics::SafetyLimits& limits)
  {
    return this->Stage.Apply(input, limits, this->Gate);
  }
  bool IsStale() const { return this->Stage.IsStale(); }
  bool IsSoft() const { return this->Stage.IsSoft(); }

  VolumeHaptics::ForceGate Gate;

private:
  VolumeHaptics::SafetyStage Stage;
};
} // namespace rigs

#endif

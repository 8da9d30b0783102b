// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A needle, baked for the servo tick: see NeedleTool.h.
 */
#ifndef BakedNeedle_h
#define BakedNeedle_h

#include "Core/Math/PiecewiseTable.h"
#include "Core/Model/BakedTool.h"

namespace VolumeHaptics
{

/** A needle's friction and cutting force by the scalar, used where no label sets them. */
struct NeedleDescription
{
  Polyline ShaftFriction = ConstantPolyline(0.0); ///< tau, N per metre of the shaft
  Polyline CuttingForce = ConstantPolyline(0.0);  ///< R, N
  bool HasCuttingForce = false;                   ///< if false, R is the material's viscosity
  double LateralStrength = 1.0;                   ///< s_l, N
};

class BakedNeedle final : public BakedTool
{
public:
  explicit BakedNeedle(NeedleDescription description);

  /** Returns the array ForbiddenTouches. */
  static const ToolColumns& Columns();

  bool IsSame(const BakedTool& other) const override;
  bool Step(const ToolTick& tick) const noexcept override;
  bool Carry(const HapticModel& from, const HapticModel& to, ServoState& state,
    ToolMemory* memory) const noexcept override;
  void AppendTables(std::vector<MemoryRange>& tables) const override;
  const ToolColumns& GetColumns() const override { return Columns(); }

  const NeedleDescription Description;
  const PiecewiseTable<2> Forces; ///< channels tau, R
};

} // namespace VolumeHaptics

#endif

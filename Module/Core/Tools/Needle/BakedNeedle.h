// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A needle, baked for the servo tick (NeedleTool.h).
 */
#ifndef BakedNeedle_h
#define BakedNeedle_h

#include "Core/Math/PiecewiseTable.h"
#include "Core/Model/BakedTool.h"

namespace VolumeHaptics
{

/**
 * The friction and cutting force of a needle as functions of the scalar, for tissue whose label
 * does not set them.
 */
struct NeedleDescription
{
  Polyline ShaftFriction = ConstantPolyline(0.0); ///< tau (N per metre of the shaft)
  Polyline CuttingForce = ConstantPolyline(0.0);  ///< R (N)
  /** Whether CuttingForce is used. If not, R is the material's viscosity. */
  bool HasCuttingForce = false;
  double LateralStrength = 1.0; ///< s_l (N)
};

class BakedNeedle final : public BakedTool
{
public:
  explicit BakedNeedle(NeedleDescription description);

  /** Returns the trace's column ForbiddenTouches. */
  static const ToolColumns& Columns();

  bool IsSame(const BakedTool& other) const override;
  bool Step(const ToolTick& tick) const noexcept override;
  bool Carry(const HapticModel& from, const HapticModel& to, ServoState& state,
    ToolMemory* memory) const noexcept override;
  void AppendTables(std::vector<MemoryRange>& tables) const override;
  const ToolColumns& GetColumns() const override { return Columns(); }

  const NeedleDescription Description;
  const PiecewiseTable<2> Forces; ///< table of tau and R
};

} // namespace VolumeHaptics

#endif

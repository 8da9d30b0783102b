// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Solvers/Method.h"

#include "Core/Model/HapticModel.h"

#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr Vector3 Spare{ ResidencySpare, ResidencySpare, ResidencySpare };

} // namespace

Vector3 GetKernelReach(const HapticModel& model) noexcept
{
  const double radius = model.Baked->Kernel.Radius;
  return Vector3{ radius, radius, radius } + Spare;
}

Vector3 FindValueReach(const HapticModel& model, double aside, const Vector3& around) noexcept
{
  return Most(aside * model.VoxelsPerMeter + Spare, around);
}

double FindMaterialReach(const HapticModel& model) noexcept
{
  return model.Baked->FeelsLabels() ? std::fmax(model.KernelLength, model.LabelReach)
                                    : model.KernelLength;
}

} // namespace VolumeHaptics

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkHapticMeasurementRepresentation, one row each: see HapticSetting.h.
 */
#ifndef HapticMeasurementViewSettings_h
#define HapticMeasurementViewSettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkHapticMeasurementRepresentation.h"

namespace VolumeHaptics
{

using MeasurementViewSetting = HapticSetting<vtkHapticMeasurementRepresentation>;

namespace MeasurementViewSettingRows
{
using Owner = vtkHapticMeasurementRepresentation;

inline constexpr MeasurementViewSetting All[] = {
  HapticNumberMacro(Radius, 1e-9, VTK_DOUBLE_MAX, 1.0, "", NotBaked,
    "Radius of points, world units. Default 1; lines are in proportion."),
  HapticFlagMacro(
    LabelVisibility, true, NotBaked, "Whether names and values are shown. Default on."),
  HapticFlagMacro(HiddenVisibility, true, NotBaked,
    "Whether measurements behind a surface or inside the volume show through. Default on."),
};
} // namespace MeasurementViewSettingRows

inline constexpr const auto& MeasurementViewSettings = MeasurementViewSettingRows::All;

} // namespace VolumeHaptics

#endif

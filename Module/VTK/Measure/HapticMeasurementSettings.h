// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkHapticMeasurements, one row each: see HapticSetting.h.
 */
#ifndef HapticMeasurementSettings_h
#define HapticMeasurementSettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkHapticMeasurements.h"

namespace VolumeHaptics
{

using MeasurementSetting = HapticSetting<vtkHapticMeasurements>;

inline constexpr SettingChoice CoordinateSystemNames[] = { { "LPS", "Left, posterior, superior" },
  { "RAS", "Right, anterior, superior" } };

namespace MeasurementSettingRows
{
using Owner = vtkHapticMeasurements;

inline constexpr MeasurementSetting All[] = {
  HapticChoiceMacro(CoordinateSystem, Owner::LPS, NotBaked,
    "What the world's axes point to, for files of 3D Slicer: LPS (default), to the left, posterior "
    "and superior of a patient, or RAS, to the right, anterior and superior."),
  HapticNumberMacro(MetersPerWorldUnit, 1e-12, 1e12, 0.001, "", NotBaked,
    "Metres per world unit, 1e-12 to 1e12. Default 0.001."),
  HapticNumberMacro(PathSpacing, 0.0, VTK_DOUBLE_MAX, 0.0, "", NotBaked,
    "How far apart the samples of a path are that is followed in a scene (world units, 0 or more). "
    "Default 0: each tick is a sample."),
  HapticNumberMacro(BrushRadius, 0.0, VTK_DOUBLE_MAX, 0.0, "", NotBaked,
    "The radius of the brush with which areas are painted in a scene (world units, 0 or more). "
    "Default 0: four times the smallest spacing of the image."),
};
} // namespace MeasurementSettingRows

inline constexpr const auto& MeasurementSettings = MeasurementSettingRows::All;

} // namespace VolumeHaptics

#endif

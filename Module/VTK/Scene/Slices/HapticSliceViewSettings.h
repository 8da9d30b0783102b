// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkHapticSliceView, one row each: see HapticSetting.h.
 */
#ifndef HapticSliceViewSettings_h
#define HapticSliceViewSettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkHapticSliceView.h"

namespace VolumeHaptics
{

using SliceViewSetting = HapticSetting<vtkHapticSliceView>;

namespace SliceViewSettingRows
{
using Owner = vtkHapticSliceView;

inline constexpr SliceViewSetting All[] = {
  HapticFlagMacro(Visibility, true, NotBaked, "Whether the slices are shown. Default on."),
  HapticNumberMacro(Share, 0.1, 0.9, 0.3, "", NotBaked,
    "The column's share of the window's width, 0.1 to 0.9. Default 0.3."),
  HapticFlagMacro(
    AutoLayout, true, NotBaked, "Whether this places the renderers in the window. Default on."),
  HapticFlagMacro(Anatomical, false, NotBaked,
    "Whether the world's axes point to a patient's left, back and head, as in DICOM."),
  HapticNumberMacro(ColorWindow, 0.0, VTK_DOUBLE_MAX, 0.0, "", NotBaked,
    "The range of values from black to white, 0 or more. Default 0: nearly all values of the "
    "image, whatever the level."),
  HapticNumberMacro(ColorLevel, -VTK_DOUBLE_MAX, VTK_DOUBLE_MAX, 0.0, "", NotBaked,
    "The value in the middle of the range. Default 0."),
};
} // namespace SliceViewSettingRows

inline constexpr const auto& SliceViewSettings = SliceViewSettingRows::All;

} // namespace VolumeHaptics

#endif

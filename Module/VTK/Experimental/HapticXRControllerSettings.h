// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkHapticXRController, one row each: see HapticSetting.h.
 */
#ifndef HapticXRControllerSettings_h
#define HapticXRControllerSettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkHapticXRController.h"

namespace VolumeHaptics
{

using XRControllerSetting = HapticSetting<vtkHapticXRController>;

inline constexpr SettingChoice HandNames[] = { { "Left", "Left" }, { "Right", "Right" } };

namespace XRControllerSettingRows
{
using Owner = vtkHapticXRController;

inline constexpr XRControllerSetting All[] = {
  HapticChoiceMacro(Hand, Owner::RIGHT, NotBaked,
    "The hand whose controller leads the tip, Left or Right (default)."),
  HapticNumberMacro(Reach, 0.0, 1.0, 0.05, "m", NotBaked,
    "How far the tip is in front of the controller (m), 0 to 1. Default 0.05."),
};
} // namespace XRControllerSettingRows

inline constexpr const auto& XRControllerSettings = XRControllerSettingRows::All;

} // namespace VolumeHaptics

#endif

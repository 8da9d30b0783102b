// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkHapticHeadUpDisplay, one row each: see HapticSetting.h.
 */
#ifndef HapticDisplaySettings_h
#define HapticDisplaySettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkHapticHeadUpDisplay.h"

namespace VolumeHaptics
{

using DisplaySetting = HapticSetting<vtkHapticHeadUpDisplay>;

inline constexpr SettingChoice PlotCornerNames[] = { { "Automatic", "Automatic" },
  { "LowerLeft", "Lower left" }, { "LowerRight", "Lower right" } };

namespace DisplaySettingRows
{
using Owner = vtkHapticHeadUpDisplay;

inline constexpr DisplaySetting All[] = {
  HapticNumberMacro(TimeSpan, 0.5, 60.0, 5.0, "s", NotBaked,
    "How far back the plot goes (s), 0.5 to 60. Default 5."),
  HapticFlagMacro(PlotVisibility, true, NotBaked, "Whether the plot is shown. Default on."),
  HapticChoiceMacro(PlotCorner, Owner::AUTOMATIC_CORNER, NotBaked,
    "Where the plot is. Automatic (default): at the lower left, or beside or above what the 2D "
    "actors of the program take up there. LowerLeft and LowerRight, above the scale of forces: "
    "there, whatever else is."),
  HapticFlagMacro(TextVisibility, true, NotBaked, "Whether the text is shown. Default on."),
  HapticFlagMacro(DetailsVisibility, false, NotBaked,
    "Whether the text has a line with the value in the surface, the rate of the servo and the "
    "ticks it has missed. Default off."),
  HapticFlagMacro(HintVisibility, true, NotBaked, "Whether the hint is shown. Default on."),
  HapticFlagMacro(HelpVisibility, false, NotBaked, "Whether HelpText is shown. Default off."),
  HapticFlagMacro(
    MeasurementsVisibility, true, NotBaked, "Whether the measurements are listed. Default on."),
};
} // namespace DisplaySettingRows

inline constexpr const auto& DisplaySettings = DisplaySettingRows::All;

} // namespace VolumeHaptics

#endif

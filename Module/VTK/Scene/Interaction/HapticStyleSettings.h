// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkInteractorStyleHaptic, one row each: see HapticSetting.h.
 */
#ifndef HapticStyleSettings_h
#define HapticStyleSettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkInteractorStyleHaptic.h"

namespace VolumeHaptics
{

using StyleSetting = HapticSetting<vtkInteractorStyleHaptic>;

inline constexpr SettingChoice FeltVolumeNames[] = { { "Nearest", "Nearest" },
  { "Strongest", "Strongest" } };

namespace StyleSettingRows
{
using Owner = vtkInteractorStyleHaptic;

inline constexpr StyleSetting All[] = {
  HapticFlagMacro(AutoAdjustVolumeQuality, true, NotBaked,
    "Whether ray casters draw as finely as 20 frames per second allow while something moves, and "
    "input interrupts a frame at rest; while the device is armed, a frame at rest takes 0.5 s at "
    "most, and 0.1 s if it can't be interrupted. Default on."),
  HapticFlagMacro(AutoAdjustOffScreen, false, NotBaked,
    "Whether AutoAdjustVolumeQuality also adjusts a window off the screen, for applications that "
    "show its pictures elsewhere, such as in a browser. Default off."),
  HapticNumberMacro(DepthStep, 0.0, VTK_DOUBLE_MAX, 0.0, "", NotBaked,
    "The distance that a step of the wheel moves the tip (world units, 0 or more). Default 0: the "
    "smallest spacing of the image."),
  HapticNumberMacro(DisplayRate, 1.0, 240.0, 60.0, "Hz", NotBaked,
    "Updates per second, 1 to 240. Default 60. Takes effect with the next interactor."),
  HapticChoiceMacro(FeltVolume, Owner::NEAREST, NotBaked,
    "Which one of several volumes is felt: NEAREST (default), whose surface comes first along the "
    "line of sight, or STRONGEST, whose surface along that line pushes back with the largest "
    "force, if it is pressed by four of the smallest voxels; of equal ones the nearest."),
  HapticFlagMacro(TipFollowsSurface, true, NotBaked,
    "Whether the mouse moves the tip along the first surface under it, at the depth to which the "
    "wheel has brought it, so that a stroke goes on around a head. If not, or if there is no "
    "surface, or beyond an edge, the tip moves in the plane of the view. Default on."),
  HapticFlagMacro(WorkspaceFollowsCamera, true, NotBaked,
    "Whether the workspace of a real device follows the camera. Default on."),
  HapticNumberMacro(WorkspaceScale, 0.0, VTK_DOUBLE_MAX, 0.0, "", NotBaked,
    "World units per metre of a real device's workspace, 0 or more. Default 0: by the filter's "
    "MetersPerWorldUnit."),
};
} // namespace StyleSettingRows

inline constexpr const auto& StyleSettings = StyleSettingRows::All;

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkHapticFunctionEditor, one row each: see HapticSetting.h.
 */
#ifndef HapticEditorSettings_h
#define HapticEditorSettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkHapticFunctionEditor.h"

namespace VolumeHaptics
{

using EditorSetting = HapticSetting<vtkHapticFunctionEditor>;

inline constexpr SettingChoice DockEdgeNames[] = { { "Left", "Left" }, { "Right", "Right" },
  { "Bottom", "Bottom" }, { "Top", "Top" } };

namespace EditorSettingRows
{
using Owner = vtkHapticFunctionEditor;

inline constexpr EditorSetting All[] = {
  HapticFlagMacro(Docked, false, NotBaked,
    "Whether the editor is beside the scene, in a viewport of its own, instead of over it in its "
    "rectangle. Default off."),
  HapticChoiceMacro(DockEdge, Owner::BOTTOM_EDGE, NotBaked,
    "The edge of the window for an editor that is Docked: Left, Right, Bottom (default) or Top."),
  HapticNumberMacro(DockShare, 0.1, 0.9, 0.35, "", NotBaked,
    "The share of the window's width or height for an editor that is Docked, 0.1 to 0.9. Default "
    "0.35."),
};
} // namespace EditorSettingRows

inline constexpr const auto& EditorSettings = EditorSettingRows::All;

} // namespace VolumeHaptics

#endif

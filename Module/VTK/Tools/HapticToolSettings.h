// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkHapticTool and its kinds.
 */
#ifndef HapticToolSettings_h
#define HapticToolSettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkHapticBurr.h"
#include "vtkHapticNeedle.h"
#include "vtkHapticPointShell.h"
#include "vtkHapticShapedTool.h"
#include "vtkHapticTool.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <string>
#include <vector>

class vtkPiecewiseFunction;

namespace VolumeHaptics
{

using NeedleSetting = HapticSetting<vtkHapticNeedle>;

namespace NeedleSettingRows
{
using Owner = vtkHapticNeedle;

inline constexpr NeedleSetting All[] = {
  HapticNumberMacro(LateralStrength, 0.0, VTK_DOUBLE_MAX, 1.0, "N", NotBaked,
    "The force with which tissue holds the inserted needle across its axis (N), 0 or more."),
};
} // namespace NeedleSettingRows

inline constexpr const auto& NeedleSettings = NeedleSettingRows::All;

using ShapedToolSetting = HapticSetting<vtkHapticShapedTool>;

///@{
/** The ContactArea that a tool begins with (square world units). */
constexpr double ShellContactArea = 25.0;
constexpr double BurrContactArea = 0.1;
///@}

namespace ShapedToolSettingRows
{
using Owner = vtkHapticShapedTool;

inline constexpr SettingChoice SolidNames[] = { { "FromStrength", "from strength" },
  { "Above", "above" }, { "Below", "below" } };

/** The ContactArea has the default of a vtkHapticPointShell. */
inline constexpr ShapedToolSetting All[] = {
  HapticNumberMacro(ContactArea, 0.0, VTK_DOUBLE_MAX, ShellContactArea, "", NotBaked,
    "The area (square world units) on which the stiffness and the surface strength of the "
    "materials act, more than 0. A smaller one makes what is touched feel harder."),
  HapticNumberMacro(CouplingStiffness, 0.0, VTK_DOUBLE_MAX, 500.0, "N/m", NotBaked,
    "The stiffness of the spring between hand and tool (N/m), more than 0. Devices may cap it."),
  HapticChoiceMacro(Solid, 0.0, NotBaked,
    "Which values of the scalars are solid: From strength (default) finds the contact value at "
    "which the surface strength of vtkHapticProperty, where something is visible, passes half of "
    "its largest, if it does so once. Above and Below are beyond the ContactValue."),
  HapticNumberMacro(ContactValue, -LargestNumber, LargestNumber, 0.0, "", NotBaked,
    "The value of the scalars at the surface of what is solid, if Solid is Above or Below."),
};
} // namespace ShapedToolSettingRows

inline constexpr const auto& ShapedToolSettings = ShapedToolSettingRows::All;

using PointShellSetting = HapticSetting<vtkHapticPointShell>;

namespace PointShellSettingRows
{
using Owner = vtkHapticPointShell;

inline constexpr PointShellSetting All[] = {
  HapticIntegerMacro(NumberOfPoints, 0.0, 1000000.0, 2000.0, "", NotBaked,
    "The number of points on the surface. From 1 to 100000 can be felt; a few may be left out that "
    "would stand for nothing."),
  HapticNumberMacro(TurningStiffness, 0.0, VTK_DOUBLE_MAX, 0.5, "N m/rad", NotBaked,
    "The stiffness of the turning spring between hand and tool (N m/rad), more than 0."),
};
} // namespace PointShellSettingRows

inline constexpr const auto& PointShellSettings = PointShellSettingRows::All;

using BurrSetting = HapticSetting<vtkHapticBurr>;

namespace BurrSettingRows
{
using Owner = vtkHapticBurr;

inline constexpr BurrSetting All[] = {
  HapticNumberMacro(Radius, 0.0, VTK_DOUBLE_MAX, 2.0, "", NotBaked,
    "The radius of the head (world units), more than 0."),
  HapticNumberMacro(Speed, 0.0, VTK_DOUBLE_MAX, 60000.0, "1/min", NotBaked,
    "The speed of the rotation (1/min), 0 or more."),
  HapticNumberMacro(Friction, 0.0, VTK_DOUBLE_MAX, 0.3, "", NotBaked,
    "The friction between the head and the tissue, 0 or more, which sets the power of the "
    "rotation. It does not pull the hand aside."),
  HapticNumberMacro(Vibration, 0.0, 1.0, 0.0, "", NotBaked,
    "The share of the force that vibrates while it spins in tissue, 0 to 1."),
  HapticIntegerMacro(SpinButton, -1.0, 31.0, 0.0, "", NotBaked,
    "The button of the device that makes it spin while it is pressed, 0 to 31; -1: none."),
};
} // namespace BurrSettingRows

inline constexpr const auto& HapticBurrSettings = BurrSettingRows::All;

/** A function of a tool against the scalar value. Its values are 0 or more. */
struct ToolFunction
{
  const char* Name; ///< as in Get... and Set...
  const char* Unit;
  vtkPiecewiseFunction* (*Get)(vtkHapticTool*);
  double Default = 0.0; ///< without points
};

/** A kind of tool; its class is vtkHapticNAME. */
struct ToolKindRow
{
  const char* Name; ///< as in files
  const char* Text; ///< as the user sees it
  vtkSmartPointer<vtkHapticTool> (*Make)();
  std::vector<ToolFunction> Functions;
};

const std::vector<ToolKindRow>& GetToolKinds();
/** Whether a tool is of one of these kinds. An application's own class of tools is of none. */
bool HasToolKind(vtkHapticTool* tool);
/** The kind of a tool that has one. */
const ToolKindRow& FindToolKind(vtkHapticTool* tool);

/** A tool as the user sees it. */
std::string GetToolText(vtkHapticTool* tool);

/** Prints the settings and functions of a tool, for PrintSelf. */
void PrintTool(std::ostream& os, vtkIndent indent, vtkHapticTool* tool);

/**
 * Describes a tool to a model's description that has its settings and frames already. Null is a
 * point. False, with the reason and the cure in `error`, if it can't be felt.
 */
bool DescribeTool(vtkHapticTool* tool, HapticModelDescription& description, std::string& error);

} // namespace VolumeHaptics

#endif

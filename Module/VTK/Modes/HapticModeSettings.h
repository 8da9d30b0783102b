// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The settings of vtkHapticMode and its kinds.
 */
#ifndef HapticModeSettings_h
#define HapticModeSettings_h

#include "VTK/Base/HapticSetting.h"

#include "vtkHapticGuideMode.h"
#include "vtkHapticMode.h"
#include "vtkHapticRidgeMode.h"
#include "vtkHapticVectorFrontMode.h"

#include <vector>

class vtkPiecewiseFunction;

namespace VolumeHaptics
{

using ModeSetting = HapticSetting<vtkHapticMode>;
using ModeText = HapticTextSetting<vtkHapticMode>;
using FrontModeSetting = HapticSetting<vtkHapticVectorFrontMode>;
using RidgeModeSetting = HapticSetting<vtkHapticRidgeMode>;
using GuideModeSetting = HapticSetting<vtkHapticGuideMode>;

inline constexpr SettingChoice AxesNames[] = { { "World", "World" }, { "Image", "Image" } };
inline constexpr SettingChoice PolarityNames[] = { { "Bright", "Bright" }, { "Dark", "Dark" } };
inline constexpr SettingChoice SideNames[] = { { "Surface", "Surface" }, { "Outside", "Outside" },
  { "Inside", "Inside" } };

namespace ModeSettingRows
{
using Owner = vtkHapticMode;

inline constexpr ModeSetting All[] = {
  HapticFlagMacro(Active, true, NotBaked, "Whether the mode is felt. Default on."),
  HapticChoiceMacro(Axes, Owner::WORLD, NotBaked,
    "The axes along which the components of the array stand. World (default): those of the world, "
    "as ParaView takes them. Image: those of the image, turned by its direction matrix."),
};

inline constexpr ModeText Texts[] = {
  { "ArrayName", "",
    "The point array of the touched image that the mode is about: vectors of 3 components, or "
    "tensors of 6 (XX, YY, ZZ, XY, YZ, XZ) or 9.",
    [](Owner* owner) { return owner->GetArrayName(); },
    [](Owner* owner, const std::string& text) { owner->SetArrayName(text.c_str()); },
    [](const std::string&) { return std::string(); } },
};
} // namespace ModeSettingRows

namespace FrontModeSettingRows
{
using Owner = vtkHapticVectorFrontMode;

inline constexpr FrontModeSetting All[] = {
  HapticFlagMacro(TwoSided, false, NotBaked,
    "Whether the hand is held in both directions along the vectors, so that it snaps on a front."),
};
} // namespace FrontModeSettingRows

namespace RidgeModeSettingRows
{
using Owner = vtkHapticRidgeMode;

inline constexpr RidgeModeSetting All[] = {
  HapticChoiceMacro(Polarity, Owner::BRIGHT, NotBaked,
    "Whether vessels are Bright (default), brighter than what is around them, or Dark."),
  HapticNumberMacro(SnapDistance, 0.1, 16.0, 3.0, "voxels", NotBaked,
    "How far from the ridge the hand is drawn to it with all of the strength (voxels), 0.1 to 16."),
};
} // namespace RidgeModeSettingRows

namespace GuideModeSettingRows
{
using Owner = vtkHapticGuideMode;

inline constexpr GuideModeSetting All[] = {
  HapticChoiceMacro(Side, Owner::SURFACE, NotBaked,
    "Where a surface or a distance field holds the hand: on its Surface (default), or so that it "
    "stays Outside or Inside of it, and is free there."),
  HapticNumberMacro(Distance, -LargestNumber, LargestNumber, 0.0, "world units", NotBaked,
    "The distance from the surface, or in the distance field, at which the hand is held (world "
    "units)."),
};
} // namespace GuideModeSettingRows

inline constexpr const auto& ModeSettings = ModeSettingRows::All;
inline constexpr const auto& ModeTexts = ModeSettingRows::Texts;
inline constexpr const auto& FrontModeSettings = FrontModeSettingRows::All;
inline constexpr const auto& RidgeModeSettings = RidgeModeSettingRows::All;
inline constexpr const auto& GuideModeSettings = GuideModeSettingRows::All;

/** A strength function of a mode. */
struct ModeFunction
{
  const char* Name; ///< as in Get... and Set...
  double Default;   ///< N, of a function without points
  vtkPiecewiseFunction* (*Get)(vtkHapticMode*);
};

/** The array that a kind of mode is about. */
enum class ModeInput
{
  None,
  Vectors,
  Tensors
};

/** A kind of mode; its class is vtkHapticNAMEMode. */
struct ModeKindRow
{
  const char* Name; ///< as in files
  ModeInput Input;
  vtkSmartPointer<vtkHapticMode> (*Make)();
  std::vector<ModeFunction> Functions; ///< two at most
};

const std::vector<ModeKindRow>& GetModeKinds();
/** Whether a mode is of one of these kinds. An application's own class of modes is of none. */
bool HasModeKind(vtkHapticMode* mode);
/** The kind of a mode that has one. */
const ModeKindRow& FindModeKind(vtkHapticMode* mode);

/** A mode as the user sees it, such as "vector follow, velocity". */
std::string GetModeText(vtkHapticMode* mode);

/** Prints the settings that all kinds have, for PrintSelf. */
void PrintMode(std::ostream& os, vtkIndent indent, vtkHapticMode* mode);

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Modes/ModePresets.h"

#include "VTK/Base/HapticFiles.h"
#include "VTK/Modes/HapticModeKinds.h"
#include "VTK/Modes/ModeProposal.h"

#include "vtkHapticMode.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkStringArray.h"

namespace VolumeHaptics
{
namespace
{

struct ModePreset
{
  const char* Name;
  int Kind;
  /**
   * Ratio of the second strength to the strength that the image proposes. 0: no second strength.
   */
  double Fraction;
  bool TouchesSurfaces;
  void (*Adjust)(vtkHapticMode*); ///< sets further settings of the kind; null if the defaults are
                                  ///< used
};

constexpr ModePreset ModePresetRows[] = {
  { "Follow the flow", vtkHapticMode::VECTOR_FOLLOW, 0.0, false, nullptr },
  { "Drift with the flow", vtkHapticMode::VECTOR_FOLLOW, 0.25, false, nullptr },
  { "Feel wave fronts", vtkHapticMode::VECTOR_FRONT, 0.0, false,
    [](vtkHapticMode* mode) { mode->TwoSidedOn(); } },
  { "Find a vortex", vtkHapticMode::VORTEX, 0.25, false, nullptr },
  { "Feel where a flow stretches", vtkHapticMode::SHEAR, 0.0, false, nullptr },
  { "Slide along fibres", vtkHapticMode::TENSOR_FOLLOW, 0.0, false, nullptr },
  { "Slide along fibres and sheets", vtkHapticMode::TENSOR_FOLLOW, 0.5, false, nullptr },
  { "Follow a vessel", vtkHapticMode::RIDGE, 0.0, false, nullptr },
  { "Follow a dark vessel", vtkHapticMode::RIDGE, 0.0, false,
    [](vtkHapticMode* mode) { mode->SetPolarityToDark(); } },
  { "Follow the flow and touch surfaces", vtkHapticMode::VECTOR_FOLLOW, 0.0, true, nullptr },
};

vtkSmartPointer<vtkHapticMode> MakeMode(int kind)
{
  auto mode = vtkSmartPointer<vtkHapticMode>::New();
  mode->SetKind(kind);
  return mode;
}

bool SuitImage(
  const ModePreset& preset, vtkHapticMode* mode, vtkImageData* image, std::string& error)
{
  if (!mode->GetArrayText().empty() && !FindModeArray({ mode }, image))
  {
    const std::string array = mode->FindArrayName(image);
    if (array.empty())
    {
      error = "The image has no " + mode->GetArrayText() + " for the preset \"" + preset.Name +
        "\". Give it such an array, or take another preset: see GetModePresetNames().";
      return false;
    }
    mode->SetArrayName(array.c_str());
  }
  return ProposeStrength(mode, image, error);
}

/** Fills the second function with the strength, multiplied by the preset's Fraction. */
void FillSecond(const ModePreset& preset, vtkHapticMode* mode)
{
  vtkPiecewiseFunction* const strength = mode->GetStrength();
  vtkPiecewiseFunction* const second = mode->GetSecondStrength();
  for (int i = 0; i < strength->GetSize(); ++i)
  {
    double node[4];
    strength->GetNodeValue(i, node);
    second->AddPoint(node[0], preset.Fraction * node[1], node[2], node[3]);
  }
  if (strength->GetSize() == 0)
  {
    second->AddPoint(0.0, preset.Fraction * GetModeFunctions(mode).front().Default);
  }
}

} // namespace

HapticModes MakeModePreset(const char* name, vtkImageData* image, std::string& error)
{
  std::string known;
  for (const ModePreset& preset : ModePresetRows)
  {
    known += (known.empty() ? "\"" : ", \"") + std::string(preset.Name) + "\"";
    if (!name || std::string(name) != preset.Name)
    {
      continue;
    }
    HapticModes modes = { MakeMode(preset.Kind) };
    if (preset.Adjust)
    {
      preset.Adjust(modes.front());
    }
    if (image && !SuitImage(preset, modes.front(), image, error))
    {
      return {};
    }
    if (preset.Fraction > 0.0)
    {
      FillSecond(preset, modes.front());
    }
    if (preset.TouchesSurfaces)
    {
      modes.push_back(MakeMode(vtkHapticMode::SURFACE));
    }
    return modes;
  }
  error = "There is no preset of modes \"" + (name ? Printable(name) : std::string("(null)")) +
    "\". Use one of: " + known + ".";
  return {};
}

vtkSmartPointer<vtkStringArray> MakeModePresetNames()
{
  auto names = vtkSmartPointer<vtkStringArray>::New();
  for (const ModePreset& preset : ModePresetRows)
  {
    names->InsertNextValue(preset.Name);
  }
  return names;
}

} // namespace VolumeHaptics

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Modes/ModePresets.h"

#include "VTK/Base/HapticFiles.h"
#include "VTK/Modes/HapticModeKinds.h"
#include "VTK/Modes/ModeProposal.h"

#include "vtkDataArray.h"
#include "vtkHapticRidgeMode.h"
#include "vtkHapticShearMode.h"
#include "vtkHapticSurfaceMode.h"
#include "vtkHapticTensorFollowMode.h"
#include "vtkHapticVectorFollowMode.h"
#include "vtkHapticVectorFrontMode.h"
#include "vtkHapticVortexMode.h"
#include "vtkImageData.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkStringArray.h"

namespace VolumeHaptics
{
namespace
{

using ModePointer = vtkSmartPointer<vtkHapticMode>;

template <typename Mode>
ModePointer NewOfKind()
{
  return vtkSmartPointer<Mode>::New();
}

struct ModePreset
{
  const char* Name;
  ModePointer (*Make)();
  /**
   * Function that gets a fraction of the strength that the image proposes; null if there is none.
   */
  vtkPiecewiseFunction* (*Second)(vtkHapticMode*);
  double Share;
  bool TouchesSurfaces;
};

ModePointer NewTwoSidedFront()
{
  auto mode = vtkSmartPointer<vtkHapticVectorFrontMode>::New();
  mode->TwoSidedOn();
  return mode;
}

ModePointer NewDarkRidge()
{
  auto mode = vtkSmartPointer<vtkHapticRidgeMode>::New();
  mode->SetPolarityToDark();
  return mode;
}

const std::vector<ModePreset>& ModePresetRows()
{
  using F = vtkHapticVectorFollowMode;
  using V = vtkHapticVortexMode;
  using T = vtkHapticTensorFollowMode;
  // Never destroyed: see MethodChoices().
  static const auto* const rows = new std::vector<ModePreset>{
    { "Follow the flow", &NewOfKind<F>, nullptr, 0.0, false },
    { "Drift with the flow", &NewOfKind<F>,
      [](vtkHapticMode* m) { return F::SafeDownCast(m)->GetPush(); }, 0.25, false },
    { "Feel wave fronts", &NewTwoSidedFront, nullptr, 0.0, false },
    { "Find a vortex", &NewOfKind<V>,
      [](vtkHapticMode* m) { return V::SafeDownCast(m)->GetAxisStrength(); }, 0.25, false },
    { "Feel where a flow stretches", &NewOfKind<vtkHapticShearMode>, nullptr, 0.0, false },
    { "Slide along fibres", &NewOfKind<T>, nullptr, 0.0, false },
    { "Slide along fibres and sheets", &NewOfKind<T>,
      [](vtkHapticMode* m) { return T::SafeDownCast(m)->GetSheetStrength(); }, 0.5, false },
    { "Follow a vessel", &NewOfKind<vtkHapticRidgeMode>, nullptr, 0.0, false },
    { "Follow a dark vessel", &NewDarkRidge, nullptr, 0.0, false },
    { "Follow the flow and touch surfaces", &NewOfKind<F>, nullptr, 0.0, true },
  };
  return *rows;
}

/**
 * Returns the first array with the number of components that a kind of mode needs; null if there is
 * none.
 */
vtkDataArray* FindFirstArray(ModeInput input, vtkImageData* image)
{
  vtkPointData* const data = image->GetPointData();
  for (int i = 0; i < data->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* const array = data->GetArray(i);
    const int components = array ? array->GetNumberOfComponents() : 0;
    const bool fits =
      input == ModeInput::Vectors ? components == 3 : components == 6 || components == 9;
    if (fits && array->GetName())
    {
      return array;
    }
  }
  return nullptr;
}

bool SuitImage(
  const ModePreset& preset, vtkHapticMode* mode, vtkImageData* image, std::string& error)
{
  const ModeInput input = FindModeKind(mode).Input;
  if (input != ModeInput::None && !FindModeArray({ mode }, image))
  {
    vtkDataArray* const array = FindFirstArray(input, image);
    if (!array)
    {
      error = std::string("The image has no ") +
        (input == ModeInput::Vectors ? "vectors (a point array of 3 components)"
                                     : "tensors (a point array of 6 or 9 components)") +
        " for the preset \"" + preset.Name +
        "\". Give it such an array, or take another preset: see GetModePresetNames().";
      return false;
    }
    mode->SetArrayName(array->GetName());
  }
  return ProposeStrength(mode, image, error);
}

/** Fills the second function with a fraction of the strength. */
void FillSecond(const ModePreset& preset, vtkHapticMode* mode)
{
  vtkPiecewiseFunction* const strength = mode->GetStrength();
  vtkPiecewiseFunction* const second = preset.Second(mode);
  for (int i = 0; i < strength->GetSize(); ++i)
  {
    double node[4];
    strength->GetNodeValue(i, node);
    second->AddPoint(node[0], preset.Share * node[1], node[2], node[3]);
  }
  if (strength->GetSize() == 0)
  {
    second->AddPoint(0.0, preset.Share * FindModeKind(mode).Functions.front().Default);
  }
}

} // namespace

HapticModes MakeModePreset(const char* name, vtkImageData* image, std::string& error)
{
  std::string known;
  for (const ModePreset& preset : ModePresetRows())
  {
    known += (known.empty() ? "\"" : ", \"") + std::string(preset.Name) + "\"";
    if (!name || std::string(name) != preset.Name)
    {
      continue;
    }
    HapticModes modes = { preset.Make() };
    if (image && !SuitImage(preset, modes.front(), image, error))
    {
      return {};
    }
    if (preset.Second)
    {
      FillSecond(preset, modes.front());
    }
    if (preset.TouchesSurfaces)
    {
      modes.push_back(NewOfKind<vtkHapticSurfaceMode>());
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
  for (const ModePreset& preset : ModePresetRows())
  {
    names->InsertNextValue(preset.Name);
  }
  return names;
}

} // namespace VolumeHaptics

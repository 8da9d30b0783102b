// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Setup/HapticSetupModes.h"

#include "VTK/Base/PassSettings.h"
#include "VTK/Material/HapticSetupFunctions.h"
#include "VTK/Modes/HapticModeKinds.h"
#include "VTK/Modes/HapticModeSettings.h"

#include "vtkHapticGuideMode.h"
#include "vtkHapticMode.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace VolumeHaptics
{
namespace
{

using ModeRow = std::vector<vtkSmartPointer<vtkHapticMode>>;

/** Passes the kind of a mode by `get`; -1 if a file has none. */
int PassKind(SetupNode& node, const std::function<int()>& get)
{
  std::vector<const char*> names;
  for (const SettingChoice& kind : ModeSettingRows::KindNames)
  {
    names.push_back(kind.Name);
  }
  return node.Choice("Kind", names, get, [](int) {});
}

/** Whether a setting of vtkHapticMode is of a mode's kind. */
bool HasSetting(vtkHapticMode* mode, const std::string& name)
{
  const auto& own = GetModeKind(mode).Settings;
  return name == "Active" || name == "Axes" ||
    std::any_of(std::begin(own), std::end(own),
      [&name](const char* other) { return other && name == other; });
}

void PassMode(SetupNode& node, vtkHapticMode* mode)
{
  PassSettings(node, mode, ModeTexts);
  for (const ModeSetting& setting : ModeSettings)
  {
    if (HasSetting(mode, setting.Name))
    {
      PassSetting(node, mode, setting);
    }
  }
  if (auto* const guide = vtkHapticGuideMode::SafeDownCast(mode))
  {
    PassSettings(node, guide, GuideModeSettings);
  }
  const vtkSmartPointer<vtkHapticMode> kept = mode;
  for (const ModeFunction& function : GetModeFunctions(mode))
  {
    PassFunction(node.Child(function.Name), NotNegative(),
      [kept, strength = function.Function] { return strength; });
  }
}

void WriteModes(SetupNode& modes, vtkVolumeHapticsFilter* filter)
{
  for (int i = 0; i < filter->GetNumberOfModes(); ++i)
  {
    vtkHapticMode* const mode = filter->GetMode(i);
    SetupNode node = modes.Child(std::to_string(i));
    PassKind(node, [mode] { return mode->GetKind(); });
    PassMode(node, mode);
  }
}

} // namespace

void PassModes(SetupNode& haptics, vtkVolumeHapticsFilter* filter)
{
  if (haptics.IsWriting() ? filter->GetNumberOfModes() == 0 : !haptics.Has("Modes"))
  {
    return;
  }
  SetupNode modes = haptics.Child("Modes");
  if (haptics.IsWriting())
  {
    WriteModes(modes, filter);
    return;
  }
  const auto read = std::make_shared<ModeRow>();
  for (const std::string& key : modes.GetKeys())
  {
    modes.Require(key.c_str(), key == std::to_string(read->size()),
      "called by its number, from 0 on without gaps");
    SetupNode node = modes.Child(key);
    const int kind = PassKind(node, [] { return 0; });
    modes.Require(key.c_str(), kind >= 0, "an object with the Kind of a mode");
    if (kind < 0)
    {
      return;
    }
    if (kind == vtkHapticMode::GUIDE)
    {
      read->push_back(vtkSmartPointer<vtkHapticGuideMode>::New());
    }
    else
    {
      read->push_back(vtkSmartPointer<vtkHapticMode>::New());
      read->back()->SetKind(kind);
    }
    auto* const before =
      vtkHapticGuideMode::SafeDownCast(filter->GetMode(static_cast<int>(read->size()) - 1));
    auto* const guide = vtkHapticGuideMode::SafeDownCast(read->back());
    if (before && guide)
    {
      guide->SetPath(before->GetPath());
      guide->SetSurface(before->GetSurface());
      guide->SetDistanceField(before->GetDistanceField());
    }
    PassMode(node, read->back());
  }
  haptics.Then(
    [=]
    {
      filter->RemoveAllModes();
      for (vtkHapticMode* const mode : *read)
      {
        filter->AddMode(mode);
      }
    });
}

} // namespace VolumeHaptics

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
#include "vtkVolumeHapticsAlgorithm.h"

#include <memory>

namespace VolumeHaptics
{
namespace
{

using ModeRow = std::vector<vtkSmartPointer<vtkHapticMode>>;

std::vector<const char*> KindNames()
{
  std::vector<const char*> names;
  for (const ModeKindRow& kind : GetModeKinds())
  {
    names.push_back(kind.Name);
  }
  return names;
}

void PassMode(SetupNode& node, vtkHapticMode* mode)
{
  PassSettings(node, mode, ModeTexts);
  PassSettings(node, mode, ModeSettings);
  if (auto* const front = vtkHapticVectorFrontMode::SafeDownCast(mode))
  {
    PassSettings(node, front, FrontModeSettings);
  }
  if (auto* const ridge = vtkHapticRidgeMode::SafeDownCast(mode))
  {
    PassSettings(node, ridge, RidgeModeSettings);
  }
  if (auto* const guide = vtkHapticGuideMode::SafeDownCast(mode))
  {
    PassSettings(node, guide, GuideModeSettings);
  }
  const vtkSmartPointer<vtkHapticMode> kept = mode;
  for (const ModeFunction& function : FindModeKind(mode).Functions)
  {
    PassFunction(
      node.Child(function.Name), NotNegative(), [kept, get = function.Get] { return get(kept); });
  }
}

void WriteModes(SetupNode& modes, vtkVolumeHapticsAlgorithm* filter)
{
  for (int i = 0; i < filter->GetNumberOfModes(); ++i)
  {
    vtkHapticMode* const mode = filter->GetMode(i);
    SetupNode node = modes.Child(std::to_string(i));
    node.Choice(
      "Kind", KindNames(),
      [mode] { return static_cast<int>(&FindModeKind(mode) - GetModeKinds().data()); }, [](int) {});
    PassMode(node, mode);
  }
}

} // namespace

void PassModes(SetupNode& haptics, vtkVolumeHapticsAlgorithm* filter)
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
    const int kind = node.Choice(
      "Kind", KindNames(), [] { return 0; }, [](int) {});
    modes.Require(key.c_str(), kind >= 0, "an object with the Kind of a mode");
    if (kind < 0)
    {
      return;
    }
    read->push_back(GetModeKinds()[static_cast<std::size_t>(kind)].Make());
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

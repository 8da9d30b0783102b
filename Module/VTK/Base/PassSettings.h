// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Writes and reads lists of settings in a setup.
 */
#ifndef PassSettings_h
#define PassSettings_h

#include "VTK/Base/HapticSetting.h"
#include "VTK/Base/HapticSetupNode.h"

#include "vtkType.h"

#include <cstddef>
#include <vector>

namespace VolumeHaptics
{

/** Passes a setting of an owner, which must live until the changes are made. */
template <typename Owner>
void PassSetting(SetupNode& node, Owner* owner, const HapticSetting<Owner>& setting)
{
  const auto get = [owner, get = setting.Get] { return get(owner); };
  const auto set = [owner, set = setting.Set](double value) { set(owner, value); };
  switch (setting.Kind)
  {
    case SettingKind::Number:
      node.Number(setting.Name,
        { setting.Minimum,
          setting.Maximum < VTK_DOUBLE_MAX ? setting.Maximum : NotNegative().Maximum },
        get, set);
      break;
    case SettingKind::Integer:
      node.Integer(setting.Name, static_cast<int>(setting.Minimum),
        static_cast<int>(setting.Maximum), get, set);
      break;
    case SettingKind::Flag:
      node.Flag(setting.Name, get, set);
      break;
    case SettingKind::Choice:
      std::vector<const char*> names;
      for (int i = 0; i <= static_cast<int>(setting.Maximum); ++i)
      {
        names.push_back(setting.Choices[i].Name);
      }
      node.Choice(setting.Name, names, get, set);
      break;
  }
}

///@{
/** Passes one key for each setting of an owner, which must live until the changes are made. */
template <typename Owner, std::size_t Size>
void PassSettings(SetupNode& node, Owner* owner, const HapticSetting<Owner> (&settings)[Size])
{
  for (const HapticSetting<Owner>& setting : settings)
  {
    PassSetting(node, owner, setting);
  }
}

template <typename Owner, std::size_t Size>
void PassSettings(SetupNode& node, Owner* owner, const HapticTextSetting<Owner> (&settings)[Size])
{
  for (const HapticTextSetting<Owner>& setting : settings)
  {
    node.Text(
      setting.Name, [=] { return setting.Get(owner); },
      [=](const std::string& text) { setting.Set(owner, text); }, setting.Check);
  }
}
///@}

} // namespace VolumeHaptics

#endif

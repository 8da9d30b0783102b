// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Filter/HapticMethods.h"

#include "VTK/Filter/HapticFilterSettings.h"

#include <algorithm>

namespace VolumeHaptics
{

const std::vector<MethodChoice>& MethodChoices()
{
  using A = vtkVolumeHapticsAlgorithm;
  using FilterSettingRows::MethodNames;
  constexpr int any = MethodChoice::AnySolver;
  const std::string proxy = MethodNames[A::PROXY].Text + std::string(", ");
  // Never destroyed, because objects that are deleted while the process exits still read it.
  static const auto* const choices = new std::vector<MethodChoice>{
    { A::PROXY, A::PRECISE, "proxy", proxy + "PRECISE", false },
    { A::PROXY, A::PAPER, "paper", proxy + "PAPER", false },
    { A::FORCE_FIELD, any, "force-field", MethodNames[A::FORCE_FIELD].Text, false },
    { A::SURFACE_PROXY, any, "surface-proxy", MethodNames[A::SURFACE_PROXY].Text, true },
    { A::LOCAL_SURFACE, any, "local-surface", MethodNames[A::LOCAL_SURFACE].Text, false },
    { A::PRIMITIVES, any, "primitives", MethodNames[A::PRIMITIVES].Text, false },
  };
  return *choices;
}

std::size_t FindMethodChoice(int method, int solver)
{
  const auto& all = MethodChoices();
  const auto found = std::find_if(all.begin(), all.end(),
    [=](const MethodChoice& choice)
    {
      return choice.Method == method &&
        (choice.Solver == solver || choice.Solver == MethodChoice::AnySolver);
    });
  return found == all.end() ? 0 : static_cast<std::size_t>(found - all.begin());
}

} // namespace VolumeHaptics

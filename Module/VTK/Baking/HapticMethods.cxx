// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Baking/HapticMethods.h"

#include "vtkVolumeHapticsAlgorithm.h"

#include <algorithm>

namespace VolumeHaptics
{

const std::vector<MethodChoice>& MethodChoices()
{
  using A = vtkVolumeHapticsAlgorithm;
  constexpr int any = MethodChoice::AnySolver;
  // Never destroyed: objects that are deleted while the process exits still ask for it.
  static const auto* const choices = new std::vector<MethodChoice>{
    { A::PROXY, A::PRECISE, "Proxy", "proxy", "Proxy, PRECISE", false },
    { A::PROXY, A::PAPER, "Proxy", "paper", "Proxy, PAPER", false },
    { A::FORCE_FIELD, any, "ForceField", "force-field", "Force field", false },
    { A::SURFACE_PROXY, any, "SurfaceProxy", "surface-proxy", "Surface proxy", true },
    { A::LOCAL_SURFACE, any, "LocalSurface", "local-surface", "Local surface", false },
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

std::vector<const char*> MethodSettings()
{
  std::vector<const char*> names;
  for (const MethodChoice& choice : MethodChoices())
  {
    names.resize(std::max<std::size_t>(names.size(), choice.Method + 1), "");
    names[choice.Method] = choice.Setting;
  }
  return names;
}

} // namespace VolumeHaptics

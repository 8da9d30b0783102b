// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Filter/HapticMethods.h"

#include "VTK/Filter/HapticFilterSettings.h"

#include <algorithm>
#include <cctype>

namespace VolumeHaptics
{

namespace
{

using A = vtkVolumeHapticsFilter;

std::vector<MethodChoice> MakeChoices()
{
  std::vector<MethodChoice> choices;
  for (const SettingChoice& method : FilterSettingRows::MethodNames)
  {
    const std::string text = method.Text;
    if (choices.empty())
    {
      // PROXY is first in the list, and is the only method with several solvers.
      choices.push_back({ A::PROXY, A::PRECISE, "proxy", text + ", PRECISE", false });
      choices.push_back({ A::PROXY, A::PAPER, "paper", text + ", PAPER", false });
      continue;
    }
    std::string name;
    for (const char c : text)
    {
      name += c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    const int number = static_cast<int>(&method - FilterSettingRows::MethodNames);
    choices.push_back({ number, MethodChoice::AnySolver, name, text, number == A::SURFACE_PROXY });
  }
  return choices;
}

} // namespace

const std::vector<MethodChoice>& MethodChoices()
{
  // Never destroyed, because objects that are deleted at the exit of the process may still read it.
  static const auto* const choices = new std::vector<MethodChoice>(MakeChoices());
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

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Base/KeyMap.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

struct Action
{
  const char* Name;
  const char* Keys; ///< the first key stands for the action
};

constexpr Action Actions[] = {
  { "Touch", "t" },
  { "Arm", "a" },
  { "LetGo", "Escape End" },
  { "NextMethod", "m" },
  { "Compare", "C" },
  { "NextMode", "M" },
  { "Help", "question F1" },
  { "Text", "h" },
  { "Graph", "g" },
  { "Details", "d" },
  { "Slices", "s" },
  { "Point", "P" },
  { "Distance", "D" },
  { "Angle", "A" },
  { "Path", "L" },
  { "Area", "B" },
  { "Undo", "Z" },
  { "Redo", "Y" },
  { "RemoveLast", "Delete" },
  { "Measurements", "I" },
  { "FunctionEditor", "v" },
  { "NextFunction", "n" },
  { "Propose", "p" },
  { "DropProposal", "BackSpace" },
  { "DockEditor", "V" },
  { "ResetFunctions", "R" },
  { "Labels", "l" },
  { "Play", "space" },
  { "FrameBefore", "Left" },
  { "FrameAfter", "Right" },
  { "Slower", "comma" },
  { "Faster", "period" },
  { "AtTheEnd", "b" },
  { "RecenterWorkspace", "c" },
  { "Clutch", "k" },
  { "LargerWorkspace", "plus KP_Add" },
  { "SmallerWorkspace", "minus KP_Subtract" },
  { "Home", "Home" },
};

std::vector<std::string> Split(const std::string& keys)
{
  std::istringstream words(keys);
  return { std::istream_iterator<std::string>(words), std::istream_iterator<std::string>() };
}

bool HasKey(const std::string& keys, const std::string& key)
{
  const std::vector<std::string> all = Split(keys);
  return std::find(all.begin(), all.end(), key) != all.end();
}

/** The text that is printed on a key. */
std::string Label(const std::string& key)
{
  static const std::map<std::string, std::string> labels{ { "question", "?" }, { "plus", "+" },
    { "minus", "-" }, { "comma", "," }, { "period", "." }, { "greater", ">" }, { "less", "<" },
    { "BackSpace", "Backspace" } };
  const auto label = labels.find(key);
  return label == labels.end() ? key : label->second;
}

} // namespace

std::vector<std::string> KeyMap::ListActions()
{
  std::vector<std::string> names;
  for (const Action& action : Actions)
  {
    names.emplace_back(action.Name);
  }
  return names;
}

std::string KeyMap::FindName(const char* symbol, char code, bool hasShift)
{
  if (symbol && *symbol)
  {
    return symbol;
  }
  // ASCII codes and X11 names (keysymdef.h) of keys that are no letters or digits.
  static const std::map<char, const char*> names{ { '\b', "BackSpace" }, { '\t', "Tab" },
    { '\n', "Return" }, { '\r', "Return" }, { '\x1b', "Escape" }, { ' ', "space" },
    { '\x7f', "Delete" }, { '?', "question" }, { '+', "plus" }, { '-', "minus" }, { ',', "comma" },
    { '.', "period" }, { '<', "less" }, { '>', "greater" } };
  const auto name = names.find(code);
  if (name != names.end())
  {
    return name->second;
  }
  const bool isCapital = code >= 'A' && code <= 'Z';
  const char letter = isCapital && !hasShift ? static_cast<char>(code - 'A' + 'a') : code;
  return letter == '\0' ? std::string() : std::string(1, letter);
}

bool KeyMap::Set(const std::string& action, const std::string& keys, std::string& error)
{
  const std::vector<std::string> names = ListActions();
  if (std::find(names.begin(), names.end(), action) == names.end())
  {
    error = "There is no action \"" + action + "\". Cure: take one of these:";
    for (const std::string& name : names)
    {
      error += " " + name;
    }
    return false;
  }
  for (const std::string& key : Split(keys))
  {
    for (const std::string& other : names)
    {
      if (other != action && HasKey(this->Get(other), key))
      {
        error = "The key \"" + key + "\" is that of the action " + other +
          " already. Cure: SetKey(\"" + other + "\", \"\") before, or another key for it.";
        return false;
      }
    }
  }
  this->Changed[action] = keys;
  return true;
}

std::string KeyMap::Get(const std::string& action) const
{
  const auto changed = this->Changed.find(action);
  if (changed != this->Changed.end())
  {
    return changed->second;
  }
  const auto* const known = std::find_if(
    std::begin(Actions), std::end(Actions), [&](const Action& one) { return action == one.Name; });
  return known == std::end(Actions) ? "" : known->Keys;
}

std::string KeyMap::Find(const std::string& pressed) const
{
  for (const Action& action : Actions)
  {
    if (HasKey(this->Get(action.Name), pressed))
    {
      return Split(action.Keys).front();
    }
  }
  return {};
}

std::string KeyMap::Name(const std::string& defaultKey) const
{
  const std::string all = this->Describe({ defaultKey });
  return all.substr(0, all.find("  "));
}

std::string KeyMap::Describe(const std::vector<std::string>& defaultKeys) const
{
  std::string text;
  for (const std::string& wanted : defaultKeys)
  {
    for (const Action& action : Actions)
    {
      if (Split(action.Keys).front() != wanted)
      {
        continue;
      }
      for (const std::string& key : Split(this->Get(action.Name)))
      {
        // Twin keys elsewhere on a keyboard need no mention.
        if (key.rfind("KP_", 0) != 0 || this->Changed.count(action.Name) > 0)
        {
          text += (text.empty() ? "" : "  ") + Label(key);
        }
      }
    }
  }
  return text;
}

} // namespace VolumeHaptics

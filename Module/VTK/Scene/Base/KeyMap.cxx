// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Base/KeyMap.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <sstream>
#include <vector>

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

/** Returns the text that is printed on a key. */
std::string Label(const std::string& key)
{
  static const std::map<std::string, std::string> labels{ { "question", "?" }, { "plus", "+" },
    { "minus", "-" }, { "comma", "," }, { "period", "." }, { "greater", ">" }, { "less", "<" },
    { "BackSpace", "Backspace" } };
  const auto label = labels.find(key);
  return label == labels.end() ? key : label->second;
}

/** X11's names (keysymdef.h) of ASCII codes that are no letters or digits. */
const std::map<char, const char*>& CodeNames()
{
  static const std::map<char, const char*> names{ { '\b', "BackSpace" }, { '\t', "Tab" },
    { '\n', "Return" }, { '\r', "Return" }, { '\x1b', "Escape" }, { ' ', "space" },
    { '\x7f', "Delete" }, { '?', "question" }, { '+', "plus" }, { '-', "minus" }, { ',', "comma" },
    { '.', "period" }, { '<', "less" }, { '>', "greater" } };
  return names;
}

bool HasCode(const std::string& key)
{
  const auto& names = CodeNames();
  return key.size() == 1 ||
    std::any_of(names.begin(), names.end(), [&](const auto& one) { return key == one.second; });
}

/** A line of the list: its actions, by their default keys, and what they do. */
struct KeyLine
{
  std::vector<std::string> Keys;
  const char* Meaning;
};
struct MouseLine
{
  const char* Motion;
  const char* Meaning;
};

class KeyList
{
public:
  explicit KeyList(const KeyMap& keys)
    : Keys(keys)
  {
  }
  /** Sets a title, which is written only if a line follows. */
  void Begin(const char* title) { this->Title = title; }
  void Add(std::initializer_list<KeyLine> lines)
  {
    for (const KeyLine& line : lines)
    {
      const std::string keys = this->Keys.Describe(line.Keys);
      if (!keys.empty())
      {
        this->Add(keys, line.Meaning);
      }
    }
  }
  void AddMouse(std::initializer_list<MouseLine> lines)
  {
    for (const MouseLine& line : lines)
    {
      this->Add(line.Motion, line.Meaning);
    }
  }
  const std::string& GetText() const { return this->Text; }

private:
  void Add(const std::string& key, const char* meaning)
  {
    this->Text += this->Title.empty() ? "" : this->Title + "\n";
    this->Title.clear();
    this->Text += key + "\t" + meaning + "\n";
  }

  const KeyMap& Keys;
  std::string Title;
  std::string Text;
};

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
  if (hasShift && (code == '/' || code == '='))
  {
    return code == '/' ? "question" : "plus";
  }
  const auto name = CodeNames().find(code);
  if (name != CodeNames().end())
  {
    return name->second;
  }
  const bool isCapital = code >= 'A' && code <= 'Z';
  const char letter = isCapital && !hasShift ? static_cast<char>(code - 'A' + 'a') : code;
  return letter == '\0' ? std::string() : std::string(1, letter);
}

void KeyMap::RecordPress(const char* symbol, char code)
{
  const bool hasName = symbol && *symbol;
  if (hasName || code != '\0')
  {
    this->HasNames = hasName;
  }
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
        // Skip keys of the keypad, which repeat other keys, unless the application has set them.
        const bool isWanted = key.rfind("KP_", 0) != 0 || this->Changed.count(action.Name) > 0;
        if (isWanted && (this->HasNames || HasCode(key)))
        {
          text += (text.empty() ? "" : "  ") + Label(key);
        }
      }
    }
  }
  return text;
}

std::string ListKeys(const KeyedParts& parts, const KeyMap& keys)
{
  KeyList list(keys);
  list.Begin("Touch");
  list.Add({ { { "t" }, "touch what is under the pointer; let go" } });
  if (parts.HasMouse)
  {
    list.AddMouse({ { "mouse", "stroke" }, { "wheel", "press, and lift" },
      { "Ctrl + mouse", "press, and lift" }, { "Shift", "five times finer" },
      { "left button", "the button of the device" } });
  }
  if (parts.TurnsView)
  {
    list.AddMouse({ { "right button", "turn the view and keep touching" } });
  }
  if (parts.HasTool)
  {
    list.AddMouse(
      { { "Alt + mouse", "turn the tool" }, { "Alt + wheel", "turn it about the line of sight" } });
  }
  list.Add({ { { "a" }, "force on; off" }, { { "Escape" }, "let go, force off" },
    { { "m" }, "the next method" }, { { "C" }, "compare settings A and B" } });
  if (parts.HasModes)
  {
    list.Add({ { { "M" }, "the next mode alone; all modes" } });
  }
  list.Begin("Display");
  list.Add({ { { "question" }, "these keys" }, { { "h" }, "text" }, { { "g" }, "graph" },
    { { "d" }, "details" } });
  if (parts.HasSlices)
  {
    list.Begin("Slices");
    list.Add({ { { "s" }, "show; hide" } });
    list.AddMouse({ { "click", "go there and touch" }, { "wheel", "across them" },
      { "right drag", "window, level" } });
  }
  if (parts.HasMeasurements)
  {
    list.Begin("Measure where you touch");
    list.Add({ { { "P" }, "a point" }, { { "D" }, "a distance: both ends" },
      { { "A" }, "an angle: end, corner, end" }, { { "L" }, "a path: begin; end" },
      { { "B" }, "a painted area: begin; end" }, { { "Z", "Y" }, "undo; redo" },
      { { "Delete" }, "remove the last one" }, { { "I" }, "list" } });
  }
  list.Begin("Materials");
  if (parts.HasEditor)
  {
    list.Add({ { { "v" }, "function editor" }, { { "V" }, "beside the scene; over it" },
      { { "n" }, "the next function" }, { { "Z", "Y" }, "undo; redo, over the editor" },
      { { "R" }, "undo all edits" }, { { "p" }, "propose functions; take them" },
      { { "BackSpace" }, "drop the proposal" } });
  }
  if (parts.HasLabels)
  {
    list.Add({ { { "l" }, "materials of labels" } });
  }
  if (parts.HasTimeSteps)
  {
    list.Begin("Time");
    list.Add({ { { "space" }, "play; hold" }, { { "Left", "Right" }, "the frame before; after" },
      { { "comma", "period" }, "half the speed; twice" },
      { { "b" }, "at the end: hold, repeat, turn back" } });
  }
  if (parts.HasDevice)
  {
    list.Begin("Device");
    list.Add({ { { "c" }, "workspace back to the focal point" }, { { "k" }, "clutch, while held" },
      { { "plus", "minus" }, "larger, smaller workspace" },
      { { "Home" }, "find the zero of the encoders" } });
  }
  return list.GetText();
}

} // namespace VolumeHaptics

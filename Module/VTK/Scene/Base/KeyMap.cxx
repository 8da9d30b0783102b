// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Base/KeyMap.h"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <sstream>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/** Groups of actions in the list of keys and in menus. */
enum class KeyGroup
{
  Touch,
  Display,
  Slices,
  Measure,
  Materials,
  Time,
  Device
};

/** Titles of the groups, in the order of KeyGroup. */
constexpr const char* GroupTitles[] = { "Touch", "Display", "Slices", "Measure where you touch",
  "Materials", "Time", "Device" };

/**
 * An action of vtkInteractorStyleHaptic. The list of keys, menus, and programs' buttons are made
 * from a table of these.
 */
struct Action
{
  const char* Name;
  const char* Keys; ///< default keys; the first one identifies the action
  KeyGroup Group;
  bool KeyedParts::*Part; ///< part of the scene that it needs; null: none
  const char* Text;
};

constexpr Action Actions[] = {
  { "Touch", "t", KeyGroup::Touch, nullptr, "touch what is under the pointer; let go" },
  { "Arm", "a", KeyGroup::Touch, nullptr, "force on; off" },
  { "LetGo", "Escape End", KeyGroup::Touch, nullptr, "let go, force off" },
  { "NextMethod", "m", KeyGroup::Touch, nullptr, "the next method" },
  { "Compare", "y", KeyGroup::Touch, nullptr, "compare settings A and B" },
  { "NextMode", "j", KeyGroup::Touch, &KeyedParts::HasModes, "the next mode alone; all modes" },
  { "Help", "question F1", KeyGroup::Display, nullptr, "these keys" },
  { "Text", "h", KeyGroup::Display, nullptr, "text" },
  { "Graph", "g", KeyGroup::Display, nullptr, "graph" },
  { "Details", "d", KeyGroup::Display, nullptr, "details" },
  { "Slices", "s", KeyGroup::Slices, &KeyedParts::HasSlices, "show; hide" },
  { "Point", "1", KeyGroup::Measure, &KeyedParts::HasMeasurements, "a point" },
  { "Distance", "2", KeyGroup::Measure, &KeyedParts::HasMeasurements, "a distance: both ends" },
  { "Angle", "3", KeyGroup::Measure, &KeyedParts::HasMeasurements, "an angle: end, corner, end" },
  { "Path", "4", KeyGroup::Measure, &KeyedParts::HasMeasurements, "a path: begin; end" },
  { "Area", "5", KeyGroup::Measure, &KeyedParts::HasMeasurements, "a painted area: begin; end" },
  { "Undo", "Ctrl+z", KeyGroup::Measure, &KeyedParts::HasEdits,
    "undo (the key over the editor: an edit)" },
  { "Redo", "Ctrl+y", KeyGroup::Measure, &KeyedParts::HasEdits, "redo" },
  { "RemoveLast", "Delete", KeyGroup::Measure, &KeyedParts::HasMeasurements,
    "remove the last one" },
  { "Measurements", "i", KeyGroup::Measure, &KeyedParts::HasMeasurements, "list" },
  { "FunctionEditor", "v", KeyGroup::Materials, &KeyedParts::HasEditor, "function editor" },
  { "NextFunction", "n", KeyGroup::Materials, &KeyedParts::HasEditor, "the next function" },
  { "Propose", "p", KeyGroup::Materials, &KeyedParts::HasEditor, "propose functions; take them" },
  { "DropProposal", "BackSpace", KeyGroup::Materials, &KeyedParts::HasEditor, "drop the proposal" },
  { "DockEditor", "u", KeyGroup::Materials, &KeyedParts::HasEditor, "beside the scene; over it" },
  { "ResetFunctions", "Ctrl+BackSpace", KeyGroup::Materials, &KeyedParts::HasEditor,
    "undo all edits" },
  { "Labels", "l", KeyGroup::Materials, &KeyedParts::HasLabels, "materials of labels" },
  { "Play", "space", KeyGroup::Time, &KeyedParts::HasTimeSteps, "play; hold" },
  { "FrameBefore", "Left", KeyGroup::Time, &KeyedParts::HasTimeSteps, "the frame before" },
  { "FrameAfter", "Right", KeyGroup::Time, &KeyedParts::HasTimeSteps, "the frame after" },
  { "Slower", "comma", KeyGroup::Time, &KeyedParts::HasTimeSteps, "half the speed" },
  { "Faster", "period", KeyGroup::Time, &KeyedParts::HasTimeSteps, "twice the speed" },
  { "AtTheEnd", "b", KeyGroup::Time, &KeyedParts::HasTimeSteps,
    "at the end: hold, repeat, turn back" },
  { "RecenterWorkspace", "c", KeyGroup::Device, &KeyedParts::HasDevice,
    "workspace back to the focal point" },
  { "Clutch", "k", KeyGroup::Device, &KeyedParts::HasDevice, "clutch, while held" },
  { "LargerWorkspace", "plus KP_Add", KeyGroup::Device, &KeyedParts::HasDevice,
    "larger workspace" },
  { "SmallerWorkspace", "minus KP_Subtract", KeyGroup::Device, &KeyedParts::HasDevice,
    "smaller workspace" },
  { "Home", "Home", KeyGroup::Device, &KeyedParts::HasDevice, "find the zero of the encoders" },
};

/** Prefix of the name of a key that is pressed with Ctrl. */
constexpr const char* ControlPrefix = "Ctrl+";

bool HasControl(const std::string& key)
{
  return key.rfind(ControlPrefix, 0) == 0;
}

std::string RemoveControl(const std::string& key)
{
  return HasControl(key) ? key.substr(std::strlen(ControlPrefix)) : key;
}

std::string ToLower(const std::string& key)
{
  const bool isCapital = key.size() == 1 && key[0] >= 'A' && key[0] <= 'Z';
  return isCapital ? std::string(1, static_cast<char>(key[0] - 'A' + 'a')) : key;
}

const Action* FindAction(const std::string& name)
{
  const auto* const known = std::find_if(
    std::begin(Actions), std::end(Actions), [&](const Action& one) { return name == one.Name; });
  return known == std::end(Actions) ? nullptr : known;
}

bool HasPart(const KeyedParts& parts, const Action& action)
{
  return !action.Part || parts.*action.Part;
}

/** Splits a list of keys, and normalises letters after Ctrl as KeyMap::FindName() does. */
std::vector<std::string> Split(const std::string& keys)
{
  std::istringstream words(keys);
  std::vector<std::string> all;
  for (std::string key; words >> key;)
  {
    all.push_back(HasControl(key) ? ControlPrefix + ToLower(RemoveControl(key)) : key);
  }
  return all;
}

bool HasKey(const std::string& keys, const std::string& key)
{
  const std::vector<std::string> all = Split(keys);
  return std::find(all.begin(), all.end(), key) != all.end();
}

/** Returns the text printed on a key. */
std::string Label(const std::string& key)
{
  if (HasControl(key))
  {
    const std::string rest = RemoveControl(key);
    const bool isLetter = rest.size() == 1 && rest[0] >= 'a' && rest[0] <= 'z';
    return ControlPrefix +
      (isLetter ? std::string(1, static_cast<char>(rest[0] - 'a' + 'A')) : Label(rest));
  }
  static const std::map<std::string, std::string> labels{ { "question", "?" }, { "plus", "+" },
    { "minus", "-" }, { "comma", "," }, { "period", "." }, { "greater", ">" }, { "less", "<" },
    { "BackSpace", "Backspace" } };
  const auto label = labels.find(key);
  return label == labels.end() ? key : label->second;
}

/** X11's names (keysymdef.h) of ASCII codes other than letters and digits. */
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
  return RemoveControl(key).size() == 1 ||
    std::any_of(names.begin(), names.end(), [&](const auto& one) { return key == one.second; });
}

/** Returns the name of a key without "Ctrl+". See KeyMap::FindName. */
std::string FindPlainName(const char* symbol, char code, bool hasShift, bool hasControl)
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
  constexpr char lastControl = 26; // Ctrl+Z
  if (hasControl && code > '\0' && code <= lastControl)
  {
    return std::string(1, static_cast<char>(code - 1 + 'a'));
  }
  const std::string letter = code == '\0' ? std::string() : std::string(1, code);
  return hasShift ? letter : ToLower(letter);
}

class KeyList
{
public:
  explicit KeyList(const KeyMap& keys)
    : Keys(keys)
  {
  }
  /** Sets a title, which is written only if a line follows it. */
  void Begin(KeyGroup group) { this->Title = GroupTitles[static_cast<std::size_t>(group)]; }
  /** Adds the actions of a group that the scene has the parts for. */
  void AddActions(const KeyedParts& parts, KeyGroup group)
  {
    for (const Action& action : Actions)
    {
      const std::string keys = action.Group == group && HasPart(parts, action)
        ? this->Keys.Describe({ Split(action.Keys).front() })
        : std::string();
      if (!keys.empty())
      {
        this->Add(keys + "\t" + action.Text + "\n");
      }
    }
  }
  /** Adds lines that consist of a key or a mouse motion, a tab, and its meaning. */
  void Add(const std::string& lines)
  {
    this->Text += (this->Title.empty() ? "" : this->Title + "\n") + lines;
    this->Title.clear();
  }
  const std::string& GetText() const { return this->Text; }

private:
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

std::string KeyMap::FindName(const char* symbol, char code, bool hasShift, bool hasControl)
{
  const std::string name = FindPlainName(symbol, code, hasShift, hasControl);
  return hasControl && !name.empty() ? ControlPrefix + ToLower(name) : name;
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
    error = "There is no action \"" + action + "\". Cure: use one of these:";
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
        error = "The key \"" + key + "\" belongs to the action " + other +
          " already. Cure: call SetKey(\"" + other + "\", \"\") before, or choose another key.";
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
  const Action* const known = FindAction(action);
  return known ? known->Keys : "";
}

std::string KeyMap::Find(const std::string& pressed) const
{
  const std::string found = this->FindExactly(pressed);
  if (!found.empty())
  {
    return found;
  }
  // A capital without an action stands for its letter, for example with Caps Lock. A named key,
  // such as Escape, keeps its action with Ctrl, because Ctrl is also held to move the mouse in
  // depth.
  const std::string rest = RemoveControl(pressed);
  const bool isNamed = HasControl(pressed) && rest.size() > 1;
  return this->FindExactly(isNamed ? rest : ToLower(pressed));
}

std::string KeyMap::FindReleased(const std::string& released) const
{
  return this->Find(RemoveControl(released));
}

std::string KeyMap::FindExactly(const std::string& key) const
{
  for (const Action& action : Actions)
  {
    if (HasKey(this->Get(action.Name), key))
    {
      return Split(action.Keys).front();
    }
  }
  return {};
}

std::string KeyMap::FindDefaultKey(const std::string& action)
{
  const Action* const known = FindAction(action);
  return known ? Split(known->Keys).front() : std::string();
}

std::string KeyMap::GetText(const std::string& action, const KeyedParts& parts)
{
  const Action* const known = FindAction(action);
  return known && HasPart(parts, *known) ? known->Text : "";
}

std::string KeyMap::GetGroup(const std::string& action)
{
  const Action* const known = FindAction(action);
  return known ? GroupTitles[static_cast<std::size_t>(known->Group)] : "";
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
        // Skip keys of the keypad, which only duplicate other keys, unless the application has set
        // them.
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
  list.Begin(KeyGroup::Touch);
  if (parts.HasMouse)
  {
    list.Add("mouse\tstroke\nwheel\tpress, and lift\nCtrl + mouse\tpress, and lift\n"
             "Shift\tfive times finer\nleft button\t"
             "the button of the device\n");
  }
  if (parts.TurnsView)
  {
    list.Add("right button\tturn the view and keep touching\n");
  }
  if (parts.HasTool)
  {
    list.Add("Alt + mouse\tturn the tool\nAlt + wheel\tturn it about the line of sight\n");
  }
  list.AddActions(parts, KeyGroup::Touch);
  list.Begin(KeyGroup::Display);
  list.AddActions(parts, KeyGroup::Display);
  list.Begin(KeyGroup::Slices);
  list.AddActions(parts, KeyGroup::Slices);
  if (parts.HasSlices)
  {
    list.Add("click\tgo there and touch\nwheel\tacross them\nright drag\twindow, level\n");
  }
  for (const KeyGroup group :
    { KeyGroup::Measure, KeyGroup::Materials, KeyGroup::Time, KeyGroup::Device })
  {
    list.Begin(group);
    list.AddActions(parts, group);
  }
  return list.GetText();
}

} // namespace VolumeHaptics

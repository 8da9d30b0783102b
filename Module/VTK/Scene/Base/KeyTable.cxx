// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Base/KeyTable.h"

#include "VTK/Scene/Base/KeyMap.h"

#include <initializer_list>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/** A line of the list: actions by their default keys, or the mouse. */
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
  /** A title, written before the next line, if there is a next line. */
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
  if (parts.HasFrames)
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

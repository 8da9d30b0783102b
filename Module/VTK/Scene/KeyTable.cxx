// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/KeyTable.h"

#include <initializer_list>

namespace VolumeHaptics
{
namespace
{

struct KeyLine
{
  const char* Key;
  const char* Meaning;
};

std::string Join(std::initializer_list<KeyLine> lines)
{
  std::string text;
  for (const KeyLine& line : lines)
  {
    text += std::string(line.Key) + "\t" + line.Meaning + "\n";
  }
  return text;
}

} // namespace

std::string ListKeys(const KeyedParts& parts)
{
  std::string text = "Touch\n" + Join({ { "t", "touch what is under the pointer; let go" } });
  if (parts.HasMouse)
  {
    text += Join({ { "mouse", "stroke" }, { "wheel", "press, and lift" },
      { "Ctrl + mouse", "press, and lift" }, { "Shift", "five times finer" },
      { "left button", "the button of the device" },
      { "right button", "turn the view and keep touching" } });
  }
  text += Join(
    { { "a", "force on; off" }, { "Escape", "let go, force off" }, { "m", "the next method" } });
  if (parts.HasModes)
  {
    text += Join({ { "M", "the next mode alone; all modes" } });
  }
  text += "Display\n" +
    Join({ { "?  F1", "these keys" }, { "h", "text" }, { "g", "graph" }, { "d", "details" } });
  if (parts.HasSlices)
  {
    text += "Slices\n" +
      Join({ { "s", "show; hide" }, { "click", "go there and touch" }, { "wheel", "across them" },
        { "right drag", "window, level" } });
  }
  if (parts.HasEditor)
  {
    text += "Materials\n" +
      Join({ { "v", "function editor" }, { "n", "the next function" },
        { "p", "propose functions; take them" }, { "Backspace", "drop the proposal" } });
  }
  if (parts.HasLabels)
  {
    text += Join({ { "l", "materials of labels" } });
  }
  if (parts.HasFrames)
  {
    text += "Time\n" +
      Join({ { "space", "play; hold" }, { "Left  Right", "the frame before; after" },
        { ",  .", "half the speed; twice" }, { "b", "at the end: hold, repeat, turn back" } });
  }
  if (parts.HasDevice)
  {
    text += "Device\n" +
      Join({ { "c", "workspace back to the focal point" }, { "k", "clutch, while held" },
        { "+  -", "larger, smaller workspace" }, { "Home", "find the zero of the encoders" } });
  }
  return text;
}

} // namespace VolumeHaptics

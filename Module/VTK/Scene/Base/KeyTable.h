// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The keys of vtkInteractorStyleHaptic in groups, for people.
 */
#ifndef KeyTable_h
#define KeyTable_h

#include <string>

namespace VolumeHaptics
{

class KeyMap;

/** The parts of a scene that have keys of their own. */
struct KeyedParts
{
  bool HasMouse = true;   ///< the mouse leads the tip
  bool TurnsView = true;  ///< the mouse's right button, in the touch mode
  bool HasDevice = false; ///< has a real device
  bool HasTool = false;   ///< has a tool that the mouse can turn
  bool HasEditor = false;
  bool HasLabels = false; ///< the editor shows labels
  bool HasModes = false;
  bool HasFrames = false;
  bool HasSlices = false;
  bool HasMeasurements = false;
};

/**
 * The text of vtkHapticHeadUpDisplay::HelpText: titles, and lines of a key, a tab and its meaning.
 * Leaves out actions without a key.
 */
std::string ListKeys(const KeyedParts& parts, const KeyMap& keys);

} // namespace VolumeHaptics

#endif

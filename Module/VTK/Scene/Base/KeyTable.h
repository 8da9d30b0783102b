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
  bool HasMouse = true;   ///< leads the tip
  bool TurnsView = true;  ///< the mouse's right button, in the touch mode
  bool HasDevice = false; ///< a real one
  bool HasTool = false;   ///< that the mouse can turn
  bool HasEditor = false;
  bool HasLabels = false; ///< in the editor
  bool HasModes = false;
  bool HasFrames = false;
  bool HasSlices = false;
  bool HasMeasurements = false;
};

/**
 * As vtkHapticHeadUpDisplay::HelpText: titles, and lines of a key, a tab and its meaning. Actions
 * without a key are left out.
 */
std::string ListKeys(const KeyedParts& parts, const KeyMap& keys);

} // namespace VolumeHaptics

#endif

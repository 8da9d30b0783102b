// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The keys of the head-up display, see vtkInteractorStyleHaptic, and its hints for newcomers.
 */
#ifndef DisplayKeys_h
#define DisplayKeys_h

#include "VTK/Scene/Interaction/TouchedScene.h"

#include <string>

namespace VolumeHaptics
{

class KeyMap;
class ToolTurn;
class TouchMode;

class DisplayKeys
{
public:
  DisplayKeys(TouchedScene& scene, const TouchMode& touch, const ToolTurn& turn, const KeyMap& keys)
    : Scene(scene)
    , Touch(touch)
    , Turn(turn)
    , Keys(keys)
  {
  }

  /** False if the key is none of them, or without a display. */
  bool Press(const std::string& key);
  void HideKeys();
  /** The list of keys for the current scene. */
  std::string ListKeys() const;
  /** Shows what to do next, until something is touched. */
  void UpdateHint();

  std::string ApplicationKeys; ///< listed after the style's keys

private:
  std::string FindHint();
  /** A line about the key of an action, by its default key; empty if it has none. */
  std::string Tell(const char* before, const char* defaultKey, const char* after) const;

  TouchedScene& Scene;
  const TouchMode& Touch;
  const ToolTurn& Turn;
  const KeyMap& Keys;
  bool WasTouching = false; ///< state at the last call of UpdateHint
  bool HasTouched = false;  ///< something was touched since the touch mode, or arming, began
  std::string Shown;        ///< the last hint
};

} // namespace VolumeHaptics

#endif

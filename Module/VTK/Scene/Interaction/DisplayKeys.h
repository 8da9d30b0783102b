// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The keys of the head-up display, see vtkInteractorStyleHaptic, and what it tells a newcomer.
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

  /** False if it is none of them, or there is no display. */
  bool Press(const std::string& key);
  void HideKeys();
  /** The list of keys in the scene as it is now. */
  std::string ListKeys() const;
  /** Shows what to do next, until something was touched. */
  void UpdateHint();

  std::string ApplicationKeys; ///< listed after those of the style

private:
  std::string FindHint();
  /** A line about the key of an action, by its default key; empty if it has none. */
  std::string Tell(const char* before, const char* defaultKey, const char* after) const;

  TouchedScene& Scene;
  const TouchMode& Touch;
  const ToolTurn& Turn;
  const KeyMap& Keys;
  bool WasTouching = false; ///< at the last call of UpdateHint
  bool HasTouched = false;  ///< since the touch mode, or arming, began
  std::string Shown;        ///< the last hint
};

} // namespace VolumeHaptics

#endif

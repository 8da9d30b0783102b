// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Maps keys to the actions of vtkInteractorStyleHaptic, as an application has chosen.
 */
#ifndef KeyMap_h
#define KeyMap_h

#include "Core/Realtime/ServoClock.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/**
 * Maps the key that was pressed to the default key of its action, such as "t" for Touch. The parts
 * of an interaction know actions by these default keys.
 */
class KeyMap
{
public:
  /** Returns the names of all actions, in the order of the style's documentation. */
  static std::vector<std::string> ListActions();

  /**
   * Returns the name of the key of an event: its symbol, or if a toolkit gives none, X11's name for
   * its code. wx gives capital letters for keys without Shift.
   */
  static std::string FindName(const char* symbol, char code, bool hasShift);

  /**
   * Sets the keys of an action: X11's names, separated by spaces; an empty text disables the
   * action. False with an error, which names the cure, if there is no such action or another action
   * has one of the keys.
   */
  bool Set(const std::string& action, const std::string& keys, std::string& error);
  /** Returns the keys of an action; empty if it has none, or if the action does not exist. */
  std::string Get(const std::string& action) const;

  /** Returns the default key of the action that a key has now; empty if the key has no action. */
  std::string Find(const std::string& pressed) const;
  /** Returns the label of an action's first key for people, such as "?"; empty if it has none. */
  std::string Name(const std::string& defaultKey) const;
  /**
   * Returns the labels of all keys of the actions with these default keys, such as "?  F1"; empty
   * if none of them has a key.
   */
  std::string Describe(const std::vector<std::string>& defaultKeys) const;

private:
  std::map<std::string, std::string> Changed; ///< action -> keys
};

/**
 * Distinguishes presses that a window system repeats for a held key from presses of a hand.
 *
 * An X server sends the release and the next press of a held key at the same time, and VTK passes
 * both. No hand presses a key again so soon.
 */
class KeyRepeat
{
public:
  void RecordRelease(const std::string& key)
  {
    this->Released = key;
    this->ReleaseTime = ServoClock::Now();
  }
  bool IsRepeat(const std::string& key) const
  {
    constexpr double soon = 0.015; // s
    return key == this->Released && ServoClock::SecondsSince(this->ReleaseTime) < soon;
  }
  /** Whether an action repeats while its key, by default this one, is held. */
  static bool MayRepeat(const std::string& key)
  {
    for (const char* const step : { "plus", "minus", "comma", "period", "Left", "Right", "k" })
    {
      if (key == step)
      {
        return true;
      }
    }
    return false;
  }

private:
  std::string Released;
  std::int64_t ReleaseTime = 0; ///< ServoClock
};

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
  bool HasTimeSteps = false;
  bool HasSlices = false;
  bool HasMeasurements = false;
};

/**
 * Returns the text of vtkHapticHeadUpDisplay::HelpText: titles, and lines of a key, a tab and its
 * meaning. Leaves out actions without a key.
 */
std::string ListKeys(const KeyedParts& parts, const KeyMap& keys);

} // namespace VolumeHaptics

#endif

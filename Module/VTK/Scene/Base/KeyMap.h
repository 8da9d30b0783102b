// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Maps keys to the actions of vtkInteractorStyleHaptic, as an application has chosen.
 */
#ifndef KeyMap_h
#define KeyMap_h

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
  /** All actions, in the order of the style's documentation. */
  static std::vector<std::string> ListActions();

  /**
   * The name of the key of an event: its symbol, or if a toolkit gives none, X11's name for its
   * code. wx gives capital letters for keys without Shift.
   */
  static std::string FindName(const char* symbol, char code, bool hasShift);

  /**
   * Gives an action other keys: X11's names, with spaces between them; an empty text disables the
   * action. False with an error, which names the cure, if there is no such action or another action
   * has one of the keys.
   */
  bool Set(const std::string& action, const std::string& keys, std::string& error);
  /** The keys of an action; empty if it has none, or if the action does not exist. */
  std::string Get(const std::string& action) const;

  /** The default key of the action that a key has now; empty if the key has no action. */
  std::string Find(const std::string& pressed) const;
  /** The label of an action's first key for people, such as "?"; empty if it has none. */
  std::string Name(const std::string& defaultKey) const;
  /**
   * The labels of all keys of the actions with these default keys, such as "?  F1"; empty if none
   * of them has a key.
   */
  std::string Describe(const std::vector<std::string>& defaultKeys) const;

private:
  std::map<std::string, std::string> Changed; ///< action -> keys
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Maps keys to the actions of vtkInteractorStyleHaptic. An application can change the keys.
 */
#ifndef KeyMap_h
#define KeyMap_h

#include <map>
#include <string>
#include <vector>

namespace VolumeHaptics
{

/** Parts of a scene that have keys of their own. */
struct KeyedParts
{
  bool HasMouse = true;   ///< whether the mouse moves the tip
  bool TurnsView = true;  ///< whether the right mouse button turns the view in touch mode
  bool HasDevice = false; ///< whether a real device is open
  bool HasTool = false;   ///< whether the hand has a tool that the mouse can turn
  bool HasEditor = false;
  bool HasLabels = false; ///< whether the editor shows labels
  bool HasModes = false;
  bool HasTimeSteps = false;
  bool HasSlices = false;
  bool HasMeasurements = false;
  bool HasEdits = false; ///< whether measurements or edits can be undone
};

/**
 * Maps a pressed key to the default key of its action, such as "t" for Touch. The parts of an
 * interaction identify actions by these default keys.
 */
class KeyMap
{
public:
  /**
   * Returns the names of all actions, in the order of the documentation of
   * vtkInteractorStyleHaptic.
   */
  static std::vector<std::string> ListActions();

  /**
   * Returns the name of an event's key: its symbol, or X11's name for its code if the toolkit sends
   * no symbol. A letter without Shift is lower case, even though wx sends capitals. wx also sends
   * the code that a key has without Shift; `?` and `+` are then found as on a US keyboard. With
   * Ctrl, the name begins with "Ctrl+", and a letter is lower case: "Ctrl+z".
   */
  static std::string FindName(
    const char* symbol, char code, bool hasShift, bool hasControl = false);

  /**
   * Records whether the toolkit sends names of keys. If it sends only codes, as wx does, keys
   * without a code, such as End and F1, never arrive and are omitted from descriptions.
   */
  void RecordPress(const char* symbol, char code);

  /**
   * Sets the keys of an action as X11's names, separated by spaces; an empty text removes all keys.
   * After "Ctrl+", a capital stands for its letter. Returns false, with the cure in `error`, if
   * there is no such action or if another action has one of the keys.
   */
  bool Set(const std::string& action, const std::string& keys, std::string& error);
  /** Returns the keys of an action; empty if it has none or does not exist. */
  std::string Get(const std::string& action) const;

  /**
   * Returns the default key of the action that a key is assigned to; empty if it has no action. A
   * capital without an action of its own has the action of its letter. A named key, such as Escape,
   * keeps its action with Ctrl.
   */
  std::string Find(const std::string& pressed) const;
  /** Finds the action of a released key, which may have been pressed before Ctrl was. */
  std::string FindReleased(const std::string& released) const;
  /** Returns the default key of an action; empty if the action does not exist. */
  static std::string FindDefaultKey(const std::string& action);
  /** Returns the description of an action; empty if the scene lacks the part for it. */
  static std::string GetText(const std::string& action, const KeyedParts& parts);
  /** Returns the title of the group that an action belongs to, such as "Touch". */
  static std::string GetGroup(const std::string& action);
  /**
   * Returns the label of an action's first key as users see it, such as "?"; empty if it has none.
   */
  std::string Name(const std::string& defaultKey) const;
  /**
   * Returns the labels of all keys of the actions with these default keys, such as "?  F1"; empty
   * if no such key can arrive.
   */
  std::string Describe(const std::vector<std::string>& defaultKeys) const;

private:
  std::string FindExactly(const std::string& key) const;

  std::map<std::string, std::string> Changed; ///< action -> keys
  bool HasNames = true;                       ///< whether the toolkit sent a name with the last
                                              ///< pressed key
};

/**
 * Returns the text of vtkHapticHeadUpDisplay::HelpText: titles, and lines that consist of a key, a
 * tab and the key's meaning. Omits actions without a key.
 */
std::string ListKeys(const KeyedParts& parts, const KeyMap& keys);

} // namespace VolumeHaptics

#endif

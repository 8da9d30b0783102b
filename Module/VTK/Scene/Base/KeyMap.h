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

/** The parts of a scene that have keys of their own. */
struct KeyedParts
{
  bool HasMouse = true;   ///< the mouse leads the tip
  bool TurnsView = true;  ///< the right mouse button turns the view in touch mode
  bool HasDevice = false; ///< has a real device
  bool HasTool = false;   ///< has a tool that the mouse can turn
  bool HasEditor = false;
  bool HasLabels = false; ///< the editor shows labels
  bool HasModes = false;
  bool HasTimeSteps = false;
  bool HasSlices = false;
  bool HasMeasurements = false;
  bool HasEdits = false; ///< whether something can be undone: measurements or edits
};

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
   * Returns the name of an event's key: its symbol, or if the toolkit sends no symbol, X11's name
   * for its code. A letter without Shift is lower case, although wx sends capital letters. wx also
   * sends the code that a key has without Shift: `?` and `+` are found for a US keyboard. With
   * Ctrl, the name begins with "Ctrl+", and a letter is lower case: "Ctrl+z".
   */
  static std::string FindName(
    const char* symbol, char code, bool hasShift, bool hasControl = false);

  /**
   * Records whether the toolkit names keys. If it sends only codes, as wx does, keys without a
   * code, such as End and F1, never arrive, and are not described.
   */
  void RecordPress(const char* symbol, char code);

  /**
   * Sets the keys of an action: X11's names, separated by spaces; none if empty. After "Ctrl+", a
   * capital is its letter. Returns false and writes `error`, with the cure, if there is no such
   * action or if another action has one of the keys.
   */
  bool Set(const std::string& action, const std::string& keys, std::string& error);
  /** Returns the keys of an action; empty if it has none, or if the action does not exist. */
  std::string Get(const std::string& action) const;

  /**
   * Returns the default key of the action that a key has now; empty if the key has no action. A
   * capital without an action of its own has the action of its letter, and a key with a name, such
   * as Escape, keeps its action with Ctrl.
   */
  std::string Find(const std::string& pressed) const;
  /** Like Find(), but for a key that was perhaps pressed without the Ctrl that is down now. */
  std::string FindReleased(const std::string& released) const;
  /** Returns the default key of an action; empty if the action does not exist. */
  static std::string FindDefaultKey(const std::string& action);
  /** Returns what an action does; empty if the scene has no part for it. */
  static std::string GetText(const std::string& action, const KeyedParts& parts);
  /** Returns the title of an action's group, such as "Touch". */
  static std::string GetGroup(const std::string& action);
  /**
   * Returns the text that users see for an action's first key, such as "?"; empty if it has none.
   */
  std::string Name(const std::string& defaultKey) const;
  /**
   * Returns the texts that users see for all keys of the actions with these default keys, such as
   * "?  F1"; empty if none of them has a key that can arrive.
   */
  std::string Describe(const std::vector<std::string>& defaultKeys) const;

private:
  std::string FindExactly(const std::string& key) const;

  std::map<std::string, std::string> Changed; ///< action -> keys
  bool HasNames = true;                       ///< whether the last key that was pressed had a name
};

/**
 * Returns the text of vtkHapticHeadUpDisplay::HelpText: titles, and lines that consist of a key, a
 * tab and the key's meaning. Leaves out actions without a key.
 */
std::string ListKeys(const KeyedParts& parts, const KeyMap& keys);

} // namespace VolumeHaptics

#endif

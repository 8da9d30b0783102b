// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_CommandTable_h
#define Explore_CommandTable_h

#include "Applications/Explorer/Bar/Icons.h"
#include "VTK/Scene/Base/KeyRepeat.h"

#include "vtkCallbackCommand.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

namespace Explore
{
/// An action of the user in the window, with its text, key and button.
struct Command
{
  std::string Group; // title in the menu and in the list of keys
  std::string Text;  // such as "open a file"
  std::string Key;   // such as "F8", "x" or "Ctrl+o"; empty: no key
  std::function<void()> Run;
  // whether it is switched on or chosen; null: the command has no state
  std::function<bool()> IsOn = nullptr;
  std::function<bool()> IsUsable = nullptr; // whether the command can run now; null: always
  Icon Button = Icon::None; // the bar's button that runs the command, if there is one
  std::function<bool()> TakesKey = nullptr; // whether the command handles the key now; null: always
};

/// A group of commands: a section of the menu, and optionally a button that opens only this
/// section.
struct CommandGroup
{
  const char* Title;
  Icon Button; // Icon::None: the group is only in the menu
  const char* Tip;
};

/// All commands of the window. Keys, buttons, menus and the list of keys are generated from this
/// table. The parts of the window add their commands, and the actions of vtkInteractorStyleHaptic
/// are commands, too.
class CommandTable
{
public:
  CommandTable();
  ~CommandTable();
  CommandTable(const CommandTable&) = delete;
  CommandTable& operator=(const CommandTable&) = delete;

  /// Adds a command that belongs to `part`. The part must call Remove() before it is deleted.
  void Add(const void* part, const Command& command);
  void Remove(const void* part);

  /// Sets the interactor whose keys run the commands; null for none.
  void SetInteractor(vtkRenderWindowInteractor* interactor);
  vtkRenderWindowInteractor* GetInteractor() const { return this->Interactor; }
  /// Sets the style whose actions are commands.
  void SetStyle(vtkInteractorStyleHaptic* style);

  /// Returns all groups, in the order of the menu.
  static const std::vector<CommandGroup>& GetGroups();
  /// Returns the commands of a group that can be used now.
  std::vector<Command> ListGroup(const std::string& title) const;
  /// Returns the command of a button. Its Run is empty if the scene has no part that provides the
  /// command.
  Command FindButton(Icon button) const;
  /// Runs a command and draws the scene.
  void Run(const Command& command);
  /// Called before each command.
  std::function<void()> BeforeRun;

  /// Returns the parts' keys that can be used now, in the format of
  /// vtkHapticHeadUpDisplay::HelpText. The style lists its own actions itself.
  std::string ListKeys() const;
  /// Sets lines that stand before these keys in the style's list, which is kept up to date.
  void SetFacts(const std::string& facts);
  /// Returns the label of a key, such as "Ctrl+O".
  static std::string LabelKey(const std::string& key);

private:
  struct Added
  {
    const void* Part;
    Command What;
  };

  bool PressKey();
  std::string NameKey() const;
  void UpdateList();
  Command MakeAction(const std::string& name) const;

  std::vector<Added> All;
  vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  vtkSmartPointer<vtkInteractorStyleHaptic> Style;
  std::string Facts;
  /// Sets lines that precede these keys in the style's list. The list is updated whenever the
  /// commands change.
  std::string UsedKey;
  VolumeHaptics::KeyRepeat Repeat;
  vtkNew<vtkCallbackCommand> Observer;
};
} // namespace Explore

#endif

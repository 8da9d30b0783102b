// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Bar/CommandTable.h"

#include "vtkStringArray.h"

#include <algorithm>
#include <cctype>
#include <map>
#include <sstream>

namespace
{
constexpr const char* CONTROL = "Ctrl+";
constexpr float KEYS_PRIORITY = 5.0f; // before the keys of the style, after those of an open list

/// The actions of the style that have a button on the bar.
const std::map<std::string, Explore::Icon> ACTION_BUTTONS{ { "Touch", Explore::Icon::Touch },
  { "Slices", Explore::Icon::Slices }, { "Play", Explore::Icon::Play } };

std::string ToLower(std::string key)
{
  if (key.size() == 1)
  {
    key[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(key[0])));
  }
  return key;
}

bool IsUsable(const Explore::Command& command)
{
  return !command.IsUsable || command.IsUsable();
}
} // namespace

namespace Explore
{
CommandTable::CommandTable()
{
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void*)
    {
      auto& commands = *static_cast<CommandTable*>(self);
      if (event == vtkCommand::KeyReleaseEvent)
      {
        commands.Repeat.RecordRelease(commands.NameKey());
        return;
      }
      // A key that has run a command is passed on neither to the style nor to VTK.
      const bool isUsed =
        event == vtkCommand::KeyPressEvent ? commands.PressKey() : !commands.UsedKey.empty();
      commands.Observer->SetAbortFlag(isUsed);
    });
}

CommandTable::~CommandTable()
{
  this->SetInteractor(nullptr);
}

void CommandTable::Add(const void* part, const Command& command)
{
  this->All.push_back({ part, command });
}

void CommandTable::Remove(const void* part)
{
  this->All.erase(std::remove_if(this->All.begin(), this->All.end(),
                    [part](const Added& one) { return one.Part == part; }),
    this->All.end());
}

void CommandTable::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  if (this->Interactor)
  {
    this->Interactor->RemoveObserver(this->Observer);
  }
  this->Interactor = interactor;
  if (interactor)
  {
    interactor->AddObserver(vtkCommand::KeyPressEvent, this->Observer, KEYS_PRIORITY);
    interactor->AddObserver(vtkCommand::CharEvent, this->Observer, KEYS_PRIORITY);
    interactor->AddObserver(vtkCommand::KeyReleaseEvent, this->Observer, KEYS_PRIORITY);
  }
}

void CommandTable::SetStyle(vtkInteractorStyleHaptic* style)
{
  this->Style = style;
}

const std::vector<CommandGroup>& CommandTable::GetGroups()
{
  static const std::vector<CommandGroup> groups{
    { "File", Icon::Open, "Open, save, recent files" },
    { "Touch", Icon::None, "" },
    { "Method", Icon::Method, "Method: how forces are computed" },
    { "Preset", Icon::Preset, "Preset: the materials" },
    { "Tool", Icon::Tool, "Tool in the hand" },
    { "Cut", Icon::Cut, "Cut the volume open" },
    { "Slices", Icon::None, "" },
    { "Measure where you touch", Icon::Measure, "Measure where you touch" },
    { "Materials", Icon::None, "" },
    { "Look", Icon::Look, "Look: inside, opacity, colours, view" },
    { "Record", Icon::Record, "Record a movie, the touch, a picture" },
    { "Recording", Icon::None, "" },
    { "Time", Icon::None, "" },
    { "Display", Icon::None, "" },
    { "Device", Icon::None, "" },
    { "Window", Icon::None, "" },
  };
  return groups;
}

Command CommandTable::MakeAction(const std::string& name) const
{
  Command action;
  const std::string keys = this->Style->GetKey(name.c_str());
  const auto button = ACTION_BUTTONS.find(name);
  action.Group = vtkInteractorStyleHaptic::GetActionGroup(name.c_str());
  action.Text = this->Style->GetActionText(name.c_str());
  action.Key = keys.substr(0, keys.find(' '));
  action.Button = button == ACTION_BUTTONS.end() ? Icon::None : button->second;
  if (!action.Text.empty())
  {
    action.Run = [style = this->Style, name] { style->PerformAction(name.c_str()); };
  }
  if (name == "Touch")
  {
    action.IsOn = [style = this->Style] { return style->GetTouchMode(); };
  }
  return action;
}

std::vector<Command> CommandTable::ListGroup(const std::string& title) const
{
  std::vector<Command> list;
  for (const Added& one : this->All)
  {
    if (one.What.Group == title && IsUsable(one.What))
    {
      list.push_back(one.What);
    }
  }
  vtkStringArray* const actions = vtkInteractorStyleHaptic::GetKeyActions();
  for (vtkIdType i = 0; this->Style && i < actions->GetNumberOfValues(); ++i)
  {
    const std::string name = actions->GetValue(i);
    if (vtkInteractorStyleHaptic::GetActionGroup(name.c_str()) == title && name != "Clutch")
    {
      const Command action = this->MakeAction(name);
      if (action.Run)
      {
        list.push_back(action);
      }
    }
  }
  return list;
}

Command CommandTable::FindButton(Icon button) const
{
  for (const Added& one : this->All)
  {
    if (one.What.Button == button && IsUsable(one.What))
    {
      return one.What;
    }
  }
  for (const auto& [name, icon] : ACTION_BUTTONS)
  {
    if (icon == button && this->Style)
    {
      return this->MakeAction(name);
    }
  }
  return {};
}

void CommandTable::Run(const Command& wanted)
{
  const Command command = wanted; // a copy, because the command may remove itself
  const vtkSmartPointer<vtkRenderWindowInteractor> interactor = this->Interactor;
  this->UpdateList();
  if (command.Run)
  {
    if (this->BeforeRun)
    {
      this->BeforeRun();
    }
    command.Run();
  }
  if (interactor && !interactor->GetDone() && interactor->GetRenderWindow())
  {
    interactor->Render();
  }
}

std::string CommandTable::NameKey() const
{
  const char* const symbol = this->Interactor->GetKeySym();
  const std::string plain = symbol ? symbol : "";
  return this->Interactor->GetControlKey() != 0 ? CONTROL + ToLower(plain) : plain;
}

void CommandTable::SetFacts(const std::string& facts)
{
  this->Facts = facts;
  this->UpdateList();
}

void CommandTable::UpdateList()
{
  if (this->Style)
  {
    this->Style->SetApplicationKeys((this->Facts + this->ListKeys()).c_str());
  }
}

bool CommandTable::PressKey()
{
  const std::string name = this->NameKey();
  this->Repeat.Watch(this->Interactor->GetRenderWindow());
  const bool isRepeat = this->Repeat.IsRepeat(name);
  this->Repeat.RecordPress(name);
  if (isRepeat)
  {
    return !this->UsedKey.empty(); // a key that is held down runs its command only once
  }
  this->UpdateList();
  // Treat a capital letter like its small letter, as the style does, for example with Caps Lock.
  for (const std::string& key : { name, ToLower(name) })
  {
    const auto found = std::find_if(this->All.begin(), this->All.end(),
      [&](const Added& one)
      {
        return one.What.Key == key && IsUsable(one.What) &&
          (!one.What.TakesKey || one.What.TakesKey());
      });
    if (!key.empty() && found != this->All.end())
    {
      this->UsedKey = key;
      this->Run(found->What);
      return true;
    }
  }
  this->UsedKey.clear();
  return false;
}

std::string CommandTable::ListKeys() const
{
  std::ostringstream text;
  for (const CommandGroup& group : GetGroups())
  {
    bool hasTitle = false;
    for (const Added& one : this->All)
    {
      if (one.What.Group == group.Title && !one.What.Key.empty() && IsUsable(one.What))
      {
        text << (hasTitle ? "" : std::string(group.Title) + "\n");
        text << LabelKey(one.What.Key) << "\t" << one.What.Text << "\n";
        hasTitle = true;
      }
    }
  }
  return text.str();
}

std::string CommandTable::LabelKey(const std::string& key)
{
  static const std::map<std::string, std::string> labels{ { "question", "?" }, { "plus", "+" },
    { "minus", "-" }, { "comma", "," }, { "period", "." }, { "BackSpace", "Backspace" },
    { "space", "Space" }, { "Escape", "Esc" } };
  const bool hasControl = key.rfind(CONTROL, 0) == 0;
  std::string rest = hasControl ? key.substr(std::string(CONTROL).size()) : key;
  const auto label = labels.find(rest);
  rest = label == labels.end() ? rest : label->second;
  if (hasControl && rest.size() == 1)
  {
    rest[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(rest[0])));
  }
  return (hasControl ? CONTROL : "") + rest;
}
} // namespace Explore

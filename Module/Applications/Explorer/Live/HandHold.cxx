// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/HandHold.h"

#include <algorithm>
#include <utility>

namespace
{
constexpr unsigned long HOLD_EVENTS[] = { vtkCommand::MouseMoveEvent,
  vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonReleaseEvent,
  vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent };
constexpr float HOLD_PRIORITY = 15.0f; // after the bar, before the scene
} // namespace

namespace Explore
{
HandHold::HandHold(TouchScene& touch, vtkRenderWindowInteractor* interactor)
  : Touch(touch)
  , Interactor(interactor)
{
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void*)
    {
      auto& hold = *static_cast<HandHold*>(self);
      hold.Observer->SetAbortFlag(hold.Handle(event));
    });
  for (const unsigned long event : HOLD_EVENTS)
  {
    interactor->AddObserver(event, this->Observer, HOLD_PRIORITY);
  }
  Command hold{ "Touch", "hold the hand where it is; go on", "f", [this] { this->PressKey(); },
    [this] { return this->Now == State::Held; }, nullptr };
  touch.Commands.Add(this, hold);
  // The button has no line of its own in the menu.
  touch.Commands.Add(this,
    { "", "hold: click where the hand shall stay; click again to go on", "",
      [this] { this->PressButton(); }, [this] { return this->Now != State::Free; }, nullptr,
      Icon::Hold });
}

HandHold::~HandHold()
{
  this->Touch.Commands.Remove(this);
  this->Interactor->RemoveObserver(this->Observer);
}

void HandHold::PressKey()
{
  this->Change(this->Now == State::Held ? State::Free : State::Held, this->IsMenuOpen);
}

void HandHold::PressButton()
{
  const bool isFree = this->Now == State::Free;
  this->Change(isFree ? State::Awaited : State::Free, this->IsMenuOpen);
  if (isFree)
  {
    this->Touch.Display->SetNotice("Click where the hand shall stay");
    if (!this->Touch.Style->GetTouchMode())
    {
      this->Touch.Style->SetTouchMode(true);
    }
  }
}

void HandHold::SetMenuOpen(bool isOpen)
{
  this->Change(this->Now, isOpen);
}

void HandHold::Change(State state, bool isMenuOpen)
{
  const bool wasHeld = this->IsHeld();
  if (state != this->Now)
  {
    this->Touch.Display->SetNotice(
      state == State::Held ? "The hand stays here: a click or f goes on" : "");
  }
  this->Now = state;
  this->IsMenuOpen = isMenuOpen;
  const bool isHeld = this->IsHeld();
  const int* const at = this->Interactor->GetEventPosition();
  if (isHeld && !wasHeld)
  {
    std::copy_n(at, 2, this->Place);
  }
  else if (wasHeld && !isHeld && this->Touch.Style->GetTouchMode())
  {
    // Move the hand by the way that the pointer has gone meanwhile.
    const int now[2] = { at[0], at[1] };
    this->Interactor->SetEventInformation(this->Place[0], this->Place[1]);
    this->Interactor->SetEventInformation(now[0], now[1]);
    this->Interactor->InvokeEvent(vtkCommand::MouseMoveEvent);
  }
}

bool HandHold::Handle(unsigned long event)
{
  if (!this->Touch.Style->GetTouchMode())
  {
    if (this->Now == State::Held)
    {
      this->Change(State::Free, this->IsMenuOpen);
    }
    return false;
  }
  if (event == vtkCommand::LeftButtonReleaseEvent)
  {
    return std::exchange(this->HasPress, false);
  }
  if (event == vtkCommand::LeftButtonPressEvent && this->Now != State::Free)
  {
    this->HasPress = true;
    this->Change(this->Now == State::Held ? State::Free : State::Held, this->IsMenuOpen);
    this->Interactor->Render();
    return true;
  }
  return this->IsHeld();
}
} // namespace Explore

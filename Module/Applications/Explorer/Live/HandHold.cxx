// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/HandHold.h"

#include <utility>

namespace Explore
{
HandHold::HandHold(TouchScene& touch)
  : Touch(touch)
{
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<HandHold*>(self)->Report(); });
  touch.Style->AddObserver(vtkCommand::ModifiedEvent, this->Observer);
  const auto isUsable = [&touch] { return touch.Device->GetVirtualHand()->MayMouseLead(); };
  touch.Commands.Add(this,
    { "Touch", "hold the hand where it is; continue", "f", [this] { this->Toggle(1); },
      [&touch] { return touch.Style->GetHoldClicks() == 1; }, isUsable });
  // The key also works while Ctrl is held, which makes the hand press in depth. The menu shows no
  // line for this key or for the button.
  touch.Commands.Add(this,
    { "", "hold", "Ctrl+f", [this] { this->Toggle(1); }, nullptr, isUsable, Icon::None,
      [&touch] { return touch.Style->GetTouchMode(); } });
  touch.Commands.Add(this,
    { "", "hold: click where the hand should stay; click again to continue", "",
      [this] { this->Toggle(2); }, [&touch] { return touch.Style->GetHoldClicks() > 0; }, isUsable,
      Icon::Hold });
}

HandHold::~HandHold()
{
  this->Touch.Commands.Remove(this);
  this->Touch.Style->RemoveObserver(this->Observer);
}

void HandHold::Toggle(int clicks)
{
  vtkInteractorStyleHaptic* const style = this->Touch.Style;
  const int before = style->GetHoldClicks();
  if (before == 1 || before == clicks)
  {
    style->SetHoldClicks(0);
    return;
  }
  if (!style->GetTouchMode())
  {
    style->SetTouchMode(true);
  }
  // without effect if the touch could not begin
  style->SetHoldClicks(style->GetTouchMode() ? clicks : 0);
}

void HandHold::Report()
{
  const int clicks = this->Touch.Style->GetHoldClicks();
  if (std::exchange(this->Reported, clicks) != clicks)
  {
    const char* const notices[] = { "", "The hand stays here: click, or press f, to continue",
      "Click where the hand should stay" };
    this->Touch.Display->SetNotice(notices[clicks]);
  }
}
} // namespace Explore

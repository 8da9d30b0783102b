// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/TimerWatch.h"

#include "Core/Realtime/ServoClock.h"

#include "vtkCallbackCommand.h"
#include "vtkHapticDevice.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

constexpr double LongestTimerless = 1.0; // s of events without an update after which to warn
/// Longest counted pause (s) between two events, because no events arrive during a slow frame.
constexpr double LongestGap = 0.1;

constexpr unsigned long InputEvents[] = { vtkCommand::MouseMoveEvent, vtkCommand::KeyPressEvent,
  vtkCommand::LeftButtonPressEvent, vtkCommand::MouseWheelForwardEvent,
  vtkCommand::MouseWheelBackwardEvent };

} // namespace

//------------------------------------------------------------------------------
TimerWatch::TimerWatch(vtkInteractorStyleHaptic* style)
  : Style(style)
{
  // Passive observers get events even while another observer has grabbed the focus.
  this->Observer->PassiveObserverOn();
  this->Observer->SetClientData(this);
  this->Observer->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<TimerWatch*>(self)->OnEvent(); });
}

//------------------------------------------------------------------------------
TimerWatch::~TimerWatch()
{
  this->Leave();
}

//------------------------------------------------------------------------------
void TimerWatch::SetInteractor(vtkRenderWindowInteractor* interactor)
{
  this->Leave();
  this->Interactor = interactor;
  this->LastEvent = 0;
  this->Waited = 0.0;
  this->IsNeeded = false;
  for (const unsigned long event : InputEvents)
  {
    if (interactor)
    {
      interactor->AddObserver(event, this->Observer);
    }
  }
  this->WatchWindow();
}

//------------------------------------------------------------------------------
void TimerWatch::WatchWindow()
{
  vtkRenderWindow* const window = this->Interactor ? this->Interactor->GetRenderWindow() : nullptr;
  if (window && !this->Window)
  {
    this->Window = window;
    window->AddObserver(vtkCommand::EndEvent, this->Observer);
  }
}

//------------------------------------------------------------------------------
void TimerWatch::RecordUpdate()
{
  if (!this->IsUpdating)
  {
    this->Leave();
  }
}

//------------------------------------------------------------------------------
void TimerWatch::Leave()
{
  if (this->Interactor)
  {
    this->Interactor->RemoveObserver(this->Observer);
  }
  if (this->Window)
  {
    this->Window->RemoveObserver(this->Observer);
  }
  this->Interactor = nullptr;
  this->Window = nullptr;
}

//------------------------------------------------------------------------------
void TimerWatch::OnEvent()
{
  if (this->IsUpdating || !this->Interactor)
  {
    return; // ignores frames and notices that the update itself draws
  }
  this->WatchWindow();
  if (!this->IsNeeded)
  {
    const double gap = this->LastEvent == 0 ? 0.0 : ServoClock::SecondsSince(this->LastEvent);
    this->LastEvent = ServoClock::Now();
    this->Waited += std::min(gap, LongestGap);
    vtkHapticDevice* const device = this->Style->GetDevice();
    if (this->Waited < LongestTimerless || !this->Window || !device || !device->IsRunning())
    {
      return;
    }
    this->IsNeeded = true;
    vtkWarningWithObjectMacro(this->Style,
      "This window's event loop sends no timer events, so that the picture, the display and "
      "changes of the volume follow only while the mouse moves or something is drawn. Cure: call "
      "DrawHaptics() of this style 60 times a second by a timer of the program.");
  }
  this->Update();
}

//------------------------------------------------------------------------------
void TimerWatch::Update()
{
  const vtkSmartPointer<vtkInteractorStyleHaptic> keep(this->Style);
  this->IsUpdating = true;
  this->Window->CheckInRenderStatus() ? this->Style->UpdateHaptics() : this->Style->DrawHaptics();
  this->IsUpdating = false;
}

} // namespace VolumeHaptics

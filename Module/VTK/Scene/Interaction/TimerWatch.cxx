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

constexpr double LongestTimerless = 1.0; // s of input without an update before the warning
/// The longest time between two events that counts (s), because no events come while a slow frame
/// is drawn.
constexpr double LongestGap = 0.1;

constexpr unsigned long InputEvents[] = { vtkCommand::MouseMoveEvent, vtkCommand::KeyPressEvent,
  vtkCommand::LeftButtonPressEvent, vtkCommand::MouseWheelForwardEvent,
  vtkCommand::MouseWheelBackwardEvent };

} // namespace

//------------------------------------------------------------------------------
TimerWatch::TimerWatch(vtkInteractorStyleHaptic* style)
  : Style(style)
{
  // active observers get no events while another observer has grabbed the focus
  this->InputObserver->PassiveObserverOn();
  this->InputObserver->SetClientData(this);
  this->InputObserver->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<TimerWatch*>(self)->OnInput(); });
  this->FrameObserver->SetClientData(this);
  this->FrameObserver->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<TimerWatch*>(self)->Update(); });
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
  this->LastInput = 0;
  this->Waited = 0.0;
  for (const unsigned long event : InputEvents)
  {
    if (interactor)
    {
      interactor->AddObserver(event, this->InputObserver);
    }
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
    this->Interactor->RemoveObserver(this->InputObserver);
  }
  if (this->Window)
  {
    this->Window->RemoveObserver(this->FrameObserver);
  }
  this->Interactor = nullptr;
  this->Window = nullptr;
}

//------------------------------------------------------------------------------
void TimerWatch::OnInput()
{
  if (this->Window)
  {
    this->Update();
    return;
  }
  const double gap = this->LastInput == 0 ? 0.0 : ServoClock::SecondsSince(this->LastInput);
  this->LastInput = ServoClock::Now();
  this->Waited += std::min(gap, LongestGap);
  vtkRenderWindow* const window = this->Interactor->GetRenderWindow();
  vtkHapticDevice* const device = this->Style->GetDevice();
  if (this->Waited < LongestTimerless || !window || !device || !device->IsRunning())
  {
    return;
  }
  this->Window = window;
  window->AddObserver(vtkCommand::EndEvent, this->FrameObserver);
  vtkWarningWithObjectMacro(this->Style,
    "This window's loop of events sends no timer events, so that the picture, the display and "
    "changes of the volume follow only while the mouse moves or something is drawn. Cure: call "
    "DrawHaptics() of this style 60 times a second by a timer of the program.");
  this->Update();
}

//------------------------------------------------------------------------------
void TimerWatch::Update()
{
  if (!this->IsUpdating) // an update may draw a notice, which would call this again
  {
    const vtkSmartPointer<vtkInteractorStyleHaptic> keep(this->Style);
    this->IsUpdating = true;
    this->Window->CheckInRenderStatus() ? this->Style->UpdateHaptics() : this->Style->DrawHaptics();
    this->IsUpdating = false;
  }
}

} // namespace VolumeHaptics

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TouchedHead_h
#define TouchedHead_h

#include "Applications/Explorer/Live/TouchScene.h"
#include "HeadExploration.h"
#include "Rigs/LoopPauses.h"

#include "vtkCamera.h"
#include "vtkRenderWindowInteractor.h"

#include <chrono>
#include <thread>

/// The explorer's window on the head phantom, rendered off screen; the mouse moves the hand.
struct TouchedHead
{
  TouchedHead(
    int argc, char* argv[], Explore::MapperChoice mapper, const Explore::DeviceChoice& device = {})
    : Exploration(ExploreHead(argc, argv))
  {
    Explore::SceneOptions options;
    options.Width = 390;
    options.Height = 300;
    options.Mapper = mapper;
    options.Interactive = true;
    Explore::BuildTouchScene(this->Touch, this->Exploration, options, device);
    this->Touch.Scene.Renderer->GetActiveCamera()->Zoom(2.2);
    this->Interactor->SetRenderWindow(this->Touch.Scene.Window);
    this->Interactor->SetInteractorStyle(this->Touch.Style);
    this->Touch.Commands.SetInteractor(this->Interactor);
    // Hide the servo's live text, which changes in every frame.
    this->Touch.Display->SetTextVisibility(0);
    this->Touch.Display->SetPlotVisibility(0);
  }
  ~TouchedHead()
  {
    this->Touch.Commands.SetInteractor(nullptr);
    this->Interactor->SetInteractorStyle(nullptr);
  }

  void Event(int x, int y, unsigned long event)
  {
    this->Interactor->SetEventInformation(x, y);
    this->Interactor->InvokeEvent(event);
  }
  /// Runs the GUI's timer until the servo has made some ticks.
  void Run(vtkIdType ticks)
  {
    const vtkIdType end = this->Touch.Device->GetState()->GetTick() + ticks;
    while (this->Touch.Device->GetState()->GetTick() < end)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      this->Touch.Style->UpdateHaptics();
      this->Pauses.Look(this->Touch.Device);
    }
  }
  /// Calls `act` in touch mode with the pointer at (x, y). Repeats the call if a pause delayed the
  /// servo's loop meanwhile.
  template <typename F>
  void TouchAt(int x, int y, F&& act)
  {
    for (int attempt = 0; attempt < 20 && (attempt == 0 || this->Pauses.WasHeldUp()); ++attempt)
    {
      this->Touch.Style->TouchModeOff();
      this->Event(x, y, vtkCommand::MouseMoveEvent);
      this->Touch.Style->TouchModeOn();
      this->Run(20);
      this->Pauses.Forget();
      act();
    }
  }
  /// Moves the hand into the tissue at (x, y) by some steps of the mouse wheel.
  void Press(int x, int y, int steps)
  {
    for (int i = 0; i < steps; ++i)
    {
      this->Event(x, y, vtkCommand::MouseWheelForwardEvent);
      this->Run(20);
    }
    this->Run(600); // until the ramp after arming is over
  }

  Explore::Exploration Exploration;
  Explore::TouchScene Touch;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  LoopPauses Pauses;
};

#endif

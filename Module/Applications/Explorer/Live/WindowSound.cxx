// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/WindowSound.h"

#include <iostream>
#include <string>

namespace Explore
{
WindowSound::WindowSound(TouchScene& touch, vtkRenderWindowInteractor* interactor)
  : Device(touch.Device)
  , Style(touch.Style)
  , Ticks(touch.Device->GetVolumeHaptics())
  , Stream(SAMPLES_PER_SECOND)
  , Output(SoundOutput::Open(this->Stream))
  , Key(interactor, "o", [this] { this->PressKey(); })
{
  this->StatesObserver->SetClientData(this);
  this->StatesObserver->SetCallback([](vtkObject*, unsigned long, void* self, void*)
    { static_cast<WindowSound*>(self)->TakeStates(); });
  this->Style->AddObserver(vtkInteractorStyleHaptic::StatesEvent, this->StatesObserver);
}

WindowSound::~WindowSound()
{
  this->Style->RemoveObserver(this->StatesObserver);
}

void WindowSound::TakeStates()
{
  for (const SoundTick& tick : this->Ticks.Read(this->Style->GetStates(), this->Device->GetLabel()))
  {
    this->Stream.Push(tick);
  }
  const std::string trouble = this->Output ? this->Output->TakeTrouble() : std::string();
  if (!trouble.empty())
  {
    this->HasFailed = true;
    this->Stream.SetMuted(true);
    std::cerr << "--sound: there is no sound (" << trouble
              << "). Cure: start PulseAudio or PipeWire, then press o in the window." << std::endl;
  }
}

void WindowSound::PressKey()
{
  if (this->HasFailed)
  {
    this->Output.reset();
    this->Output = SoundOutput::Open(this->Stream);
    this->HasFailed = false;
  }
  this->Stream.SetMuted(!this->Stream.IsMuted());
  std::cout << (this->Stream.IsMuted() ? "Sound off" : "Sound on") << std::endl;
}
} // namespace Explore

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_WindowSound_h
#define Explore_WindowSound_h

#include "Applications/Explorer/Exploration/HeardTicks.h"
#include "Applications/Explorer/Live/KeyBinding.h"
#include "Applications/Explorer/Live/TouchScene.h"
#include "Applications/Explorer/Sound/SoundOutput.h"
#include "Applications/Explorer/Sound/SoundStream.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"

#include <memory>

namespace Explore
{
/// Plays the sound of touches in a scene, from now until it is deleted; key o turns it off and on.
/// If the output fails, it says so in one line, and the scene goes on; the key then tries again.
///
/// It uses the states that the scene's style reads for the displays (StatesEvent): nothing is added
/// to the servo's loop.
class WindowSound
{
public:
  WindowSound(TouchScene& touch, vtkRenderWindowInteractor* interactor);
  ~WindowSound();
  WindowSound(const WindowSound&) = delete;
  WindowSound& operator=(const WindowSound&) = delete;

  SoundStream& GetStream() { return this->Stream; }

private:
  void TakeStates();
  void PressKey();

  vtkSmartPointer<vtkHapticDevice> Device;
  vtkSmartPointer<vtkInteractorStyleHaptic> Style;
  HeardTicks Ticks;
  SoundStream Stream;
  std::unique_ptr<SoundOutput> Output; // after the stream that it plays
  bool HasFailed = false;
  vtkNew<vtkCallbackCommand> StatesObserver;
  KeyBinding Key;
};
} // namespace Explore

#endif

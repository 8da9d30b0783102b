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
/// The sound of what is touched in a scene, from now until it is deleted; key o turns it off and
/// on. If nothing can be played, or no longer, it says so in one line, and the scene goes on; the
/// key then tries again.
///
/// It takes the states that the scene's style takes for the displays (StatesEvent): nothing is
/// added to the servo's loop.
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
  std::unique_ptr<SoundOutput> Output; // after the stream, which it plays
  bool HasFailed = false;
  vtkNew<vtkCallbackCommand> StatesObserver;
  KeyBinding Key;
};
} // namespace Explore

#endif

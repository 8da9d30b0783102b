// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Notices that a program's event loop sends no timer events, and then updates the haptics without
 * timers.
 */
#ifndef TimerWatch_h
#define TimerWatch_h

#include "vtkNew.h"
#include "vtkWeakPointer.h"

#include <cstdint>

class vtkCallbackCommand;
class vtkInteractorStyleHaptic;
class vtkRenderWindow;
class vtkRenderWindowInteractor;

namespace VolumeHaptics
{

/**
 * A server, or a toolkit whose interactor was not initialised, passes events of mouse and keys to
 * VTK, but no timer events. If a second of such events passes without an update, this class warns
 * once. From then on it updates the haptics with each of these events and each frame of the window,
 * until an update comes from elsewhere.
 */
class TimerWatch
{
public:
  explicit TimerWatch(vtkInteractorStyleHaptic* style);
  ~TimerWatch();
  TimerWatch(const TimerWatch&) = delete;
  TimerWatch& operator=(const TimerWatch&) = delete;

  /** Watches the events of this interactor, from the beginning; nullptr for none. */
  void SetInteractor(vtkRenderWindowInteractor* interactor);

  /** Records an update of the haptics, by a timer or by the program. */
  void RecordUpdate();

private:
  void OnInput();
  void Update();
  void Leave();

  vtkInteractorStyleHaptic* const Style;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  vtkWeakPointer<vtkRenderWindow> Window; ///< the window whose frames update the haptics
  vtkNew<vtkCallbackCommand> InputObserver;
  vtkNew<vtkCallbackCommand> FrameObserver;
  std::int64_t LastInput = 0; ///< ServoClock; 0 before the first
  double Waited = 0.0;        ///< s of input without an update
  bool IsUpdating = false;
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detects that a program's event loop sends no timer events, and then updates the haptics without
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
 * Updates the haptics in programs whose timers do not work. A server, or a toolkit whose interactor
 * was not initialised, passes mouse and key events to VTK, but no timer events. If a second of such
 * events, or of frames that the program draws, passes without an update, this class warns once.
 * From then on it updates the haptics with each of them, until an update comes from elsewhere.
 */
class TimerWatch
{
public:
  explicit TimerWatch(vtkInteractorStyleHaptic* style);
  ~TimerWatch();
  TimerWatch(const TimerWatch&) = delete;
  TimerWatch& operator=(const TimerWatch&) = delete;

  /**
   * Watches the events of another interactor, and starts counting from zero; nullptr for no
   * interactor.
   */
  void SetInteractor(vtkRenderWindowInteractor* interactor);

  /** Records that a timer or the program has updated the haptics. */
  void RecordUpdate();

private:
  void OnEvent();
  void Update();
  void WatchWindow();
  void Leave();

  vtkInteractorStyleHaptic* const Style;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  vtkWeakPointer<vtkRenderWindow> Window; ///< the window whose frames are watched
  vtkNew<vtkCallbackCommand> Observer;
  std::int64_t LastEvent = 0; ///< ServoClock: time of the last event or frame; 0 before the first
  double Waited = 0.0;        ///< duration of events and frames without an update (s)
  bool IsNeeded = false;      ///< whether events and frames update the haptics
  bool IsUpdating = false;
};

} // namespace VolumeHaptics

#endif

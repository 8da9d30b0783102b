// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detects an event loop without timer events, and then updates the haptics on other events.
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
 * Updates the haptics in programs without working timers. A server, or a toolkit whose interactor
 * was not initialised, passes mouse and key events to VTK, but no timer events. If such events, or
 * frames that the program renders, continue for a second without an update, this class warns once.
 * From then on, it updates the haptics on each of them, until an update comes from elsewhere.
 */
class TimerWatch
{
public:
  explicit TimerWatch(vtkInteractorStyleHaptic* style);
  ~TimerWatch();
  TimerWatch(const TimerWatch&) = delete;
  TimerWatch& operator=(const TimerWatch&) = delete;

  /**
   * Watches the events of another interactor, with the counter reset to zero; nullptr stops
   * watching.
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
  vtkWeakPointer<vtkRenderWindow> Window; ///< window whose frames are watched
  vtkNew<vtkCallbackCommand> Observer;
  std::int64_t LastEvent = 0; ///< ServoClock: time of the last event or frame; 0 before the first
  double Waited = 0.0;        ///< time (s) that events and frames have continued without an update
  bool IsNeeded = false;      ///< whether events and frames update the haptics
  bool IsUpdating = false;
};

} // namespace VolumeHaptics

#endif

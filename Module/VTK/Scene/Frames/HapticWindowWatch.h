// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reports that a window ends during a touch.
 *
 * VTK has no event for the end of a loop or of a window, and each platform ends them in its own
 * order. So this watches all early signs of an end: ExitEvent (the key q, the window manager's
 * close button), the interactor's Disable(), and the release of the window's graphics resources,
 * which comes before the window is destroyed. Look(), which is called after events of keys, mouse
 * and timers, detects a call of TerminateApp(). LookAt() detects that the touched renderer was
 * taken out of the window or deleted; VTK sends no event for this.
 */
#ifndef HapticWindowWatch_h
#define HapticWindowWatch_h

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <cstdint>
#include <functional>

class vtkObject;
class vtkRenderWindow;
class vtkRenderWindowInteractor;
class vtkRenderer;

namespace VolumeHaptics
{

class HapticWindowWatch
{
public:
  /**
   * Watches a window for an owner. `end` is called at each sign of an end, so it may be called
   * twice. The owner is kept alive during the call.
   */
  HapticWindowWatch(vtkObject* owner, std::function<void()> end);
  ~HapticWindowWatch();
  HapticWindowWatch(const HapticWindowWatch&) = delete;
  HapticWindowWatch& operator=(const HapticWindowWatch&) = delete;

  /** Watches the window of this interactor; nullptr for none. */
  void SetInteractor(vtkRenderWindowInteractor* interactor);

  /**
   * Detects that the interactor was given a different window, or that its loop was told to end.
   * Call this often.
   */
  void Look();

  /**
   * Detects that the touched renderer was taken out of its window. Null stands for no renderer.
   * Call this often.
   */
  void LookAt(vtkRenderer* renderer);

  /**
   * Returns whether the window could be seen at an earlier call and can no longer be seen, if the
   * window system reports it: see PendingInput.h. Asks the window system at most ten times a
   * second.
   */
  bool HasVanished();

  /**
   * Returns whether the window was closed when the loop ended. Do not draw then, because VTK would
   * open a new window.
   */
  bool IsClosed() const;

private:
  class Closing;
  class Observer;

  void OnExit();
  void OnModified();
  void OnRelease();
  void OnRender();
  void End();

  vtkObject* const Owner;
  std::function<void()> ReportEnd;
  vtkWeakPointer<vtkRenderWindowInteractor> Interactor;
  vtkSmartPointer<Observer> Events;
  vtkSmartPointer<Closing> WindowClosing;
  vtkWeakPointer<vtkRenderer> Seen; ///< the renderer in the window at the last look
  bool HasSeen = false;
  bool WasViewable = false;
  std::int64_t ViewTime = 0; ///< ServoClock: when the window system was last asked
  bool IsEnabled = false;    ///< whether the interactor was enabled at the last look
  bool IsDone = false;       ///< whether the last look found that the loop was told to end
  /** whether the window has released its graphics resources and was not rendered since */
  bool IsReleased = false;
  vtkWeakPointer<vtkRenderWindow> ReleasedWindow;
};

} // namespace VolumeHaptics

#endif

// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Detects that a window ends while it is touched.
 *
 * VTK has no event for the end of a loop or of a window, and each platform ends them in its own
 * order. This class therefore watches all early signs of an end: ExitEvent (the key q, the window
 * manager's close button), the interactor's Disable(), and the release of the window's graphics
 * resources, which comes before the window is destroyed. Look(), which is called after key, mouse
 * and timer events, detects a call of TerminateApp(). LookAt() detects that the touched renderer
 * was removed from the window or deleted, for which VTK has no event.
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
   * Watches a window for an owner. Calls `end` at each sign of an end, possibly twice, and keeps
   * the owner alive during the call.
   */
  HapticWindowWatch(vtkObject* owner, std::function<void()> end);
  ~HapticWindowWatch();
  HapticWindowWatch(const HapticWindowWatch&) = delete;
  HapticWindowWatch& operator=(const HapticWindowWatch&) = delete;

  /** Watches the window of this interactor; nullptr stops watching. */
  void SetInteractor(vtkRenderWindowInteractor* interactor);

  /**
   * Detects that the interactor has a different window, or that its loop was told to end. Call this
   * often.
   */
  void Look();

  /**
   * Detects that the touched renderer was removed from its window. Null stands for no renderer.
   * Call this often.
   */
  void LookAt(vtkRenderer* renderer);

  /**
   * Returns whether the window was visible at an earlier call and no longer is, if the window
   * system reports this: see PendingInput.h. Queries the window system at most ten times a second.
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
  vtkWeakPointer<vtkRenderer> Seen; ///< renderer that was in the window at the last LookAt()
  bool HasSeen = false;
  bool WasViewable = false;
  std::int64_t ViewTime = 0; ///< ServoClock: time of the last query of the window system
  bool IsEnabled = false;    ///< whether the interactor was enabled at the last Look()
  bool IsDone = false;       ///< whether the loop had been told to end at the last Look()
  /** Whether the window has released its graphics resources and was not rendered since. */
  bool IsReleased = false;
  vtkWeakPointer<vtkRenderWindow> ReleasedWindow;
};

} // namespace VolumeHaptics

#endif

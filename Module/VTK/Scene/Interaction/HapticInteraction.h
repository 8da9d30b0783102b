// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lets keys, mouse and timer act on a haptic device, its tip, and the view.
 */
#ifndef HapticInteraction_h
#define HapticInteraction_h

#include "VTK/Scene/Base/KeyMap.h"
#include "VTK/Scene/Base/KeyRepeat.h"
#include "VTK/Scene/Frames/HapticWindowWatch.h"
#include "VTK/Scene/Interaction/ComparedSettings.h"
#include "VTK/Scene/Interaction/DisplayKeys.h"
#include "VTK/Scene/Interaction/EditorKeys.h"
#include "VTK/Scene/Interaction/FilterPublisher.h"
#include "VTK/Scene/Interaction/HapticStateWatch.h"
#include "VTK/Scene/Interaction/MeasureKeys.h"
#include "VTK/Scene/Interaction/ModeKeys.h"
#include "VTK/Scene/Interaction/PlaybackKeys.h"
#include "VTK/Scene/Interaction/SceneFrames.h"
#include "VTK/Scene/Interaction/SliceMouse.h"
#include "VTK/Scene/Interaction/ToolTurn.h"
#include "VTK/Scene/Interaction/TouchMode.h"
#include "VTK/Scene/Interaction/TouchedScene.h"
#include "VTK/Scene/Interaction/TouchedVolumes.h"
#include "VTK/Scene/Interaction/WorkspaceControl.h"
#include "VTK/Scene/Volumes/CarvedPictures.h"
#include "VTK/Scene/Volumes/HapticShownFrames.h"
#include "VTK/Scene/Volumes/HapticShownVolumes.h"

#include "vtkNew.h"
#include "vtkTable.h"

#include <cstdint>
#include <functional>
#include <string>

class vtkCallbackCommand;
class vtkObject;

namespace VolumeHaptics
{

/**
 * The implementation of vtkInteractorStyleHaptic, whose header documents the keys and buttons. It
 * consists of parts with one subject each, and connects them: the order of an update, the keys and
 * the mouse, and long work.
 *
 * Functions for keys and the mouse return true if they used the event; if not, the style's
 * superclass gets it.
 */
class HapticInteraction
{
public:
  /** The style's virtual functions. */
  struct Calls
  {
    std::function<void(bool)> DrawScene;
    std::function<bool()> ArmsAfterClutch;
  };
  HapticInteraction(vtkInteractorStyleHaptic* style, Calls calls);
  ~HapticInteraction() = default;
  HapticInteraction(const HapticInteraction&) = delete;
  HapticInteraction& operator=(const HapticInteraction&) = delete;

  ///@{
  /** False if it is the same as before. */
  bool SetDevice(vtkHapticDevice* device);
  bool SetFunctionEditor(vtkHapticFunctionEditor* editor);
  bool SetMeasurements(vtkHapticMeasurements* measurements);
  ///@}

  /** Stops observing the device and the editor, before the style is deleted. */
  void Leave();

  /**
   * Leaves the touch mode and disarms. For the end of the window, or if another style takes over.
   */
  void LetGo();

  /** Leaves the touch mode and lets the force fade. For a view that is no longer seen. */
  void FadeOut();

  bool MoveMouse();
  bool PressLeftButton();
  bool ReleaseLeftButton();
  bool DoubleClickLeftButton();
  bool PressRightButton();
  bool ReleaseRightButton();
  /** `steps` count away from the viewer. */
  bool TurnWheel(double steps);
  /** Keys have X11's names. */
  bool PressKey(const std::string& pressed);
  bool ReleaseKey(const std::string& released);
  /** Whether a press is a repeat of the one that was used last, because the key is held. */
  bool IsRepeat(const std::string& pressed) const
  {
    return pressed == this->UsedKey && this->Repeat.IsRepeat(pressed);
  }
  /**
   * True for a key that the superclass must not get, because it would do something else with it.
   */
  bool TypeKey(const std::string& typed) const;

  ///@{
  /** See the style's functions of these names. */
  bool UpdateHaptics();
  void CheckShownVolumes();
  bool NextMethod();
  bool SwapSettings();
  ///@}

  // The parts, in the order of their dependence.
  TouchedScene Scene;
  HapticWindowWatch Window;
  SceneFrames Frames;
  WorkspaceControl Workspace;
  TouchMode Touch;
  ToolTurn Turn;
  KeyMap Keys;
  DisplayKeys Displays;
  HapticShownFrames ShownFrames;
  CarvedPictures Carved;
  std::uint64_t CarvedChanges = 0; ///< of the removed tissue, when it was last looked at
  TouchedVolumes Touched;
  FilterPublisher Publisher;
  ComparedSettings Compared;
  vtkNew<vtkTable> States; ///< of the last update

private:
  void LeaveDevice();
  /** Feels what the touched volumes show, and lets go of what they no longer show. */
  void FollowVolumes();
  /** Volumes show what a tool has left of them. */
  void FollowCarving();
  /** Draws the scene if the mouse has changed what the slices show; true. */
  bool DrawSlices();
  void FollowWork(vtkObject* worker, bool begins);

  PlaybackKeys Playback;
  KeyRepeat Repeat;
  std::string UsedKey; ///< the last one that was pressed, if it was used
  ModeKeys Modes;
  EditorKeys Editor;
  SliceMouse Slices;
  MeasureKeys Measure;
  HapticShownVolumes Volumes;
  HapticStateWatch Watch;
  int Reader = 0;       ///< the number of this reader of the device's states
  double Updated = 0.0; ///< the device's time (s) at the last update
  bool EditorHasMouse = false;
  bool ListHasMouse = false; ///< that of the modes
  vtkNew<vtkCallbackCommand> DisarmObserver;
  vtkNew<vtkCallbackCommand> WorkObserver; ///< observes the device and the editor
  /// the device that has no force while the editor counts
  vtkSmartPointer<vtkHapticDevice> DeviceAtRest;
};

} // namespace VolumeHaptics

#endif

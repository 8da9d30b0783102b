// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Connects keys, mouse and timer with a haptic device, its tip and the view.
 */
#ifndef HapticInteraction_h
#define HapticInteraction_h

#include "VTK/Scene/Base/KeyMap.h"
#include "VTK/Scene/Base/KeyRepeat.h"
#include "VTK/Scene/Frames/HapticWindowWatch.h"
#include "VTK/Scene/Interaction/FilterPublisher.h"
#include "VTK/Scene/Interaction/MeasureKeys.h"
#include "VTK/Scene/Interaction/SceneFrames.h"
#include "VTK/Scene/Interaction/SceneKeys.h"
#include "VTK/Scene/Interaction/SceneMouse.h"
#include "VTK/Scene/Interaction/SecondHand.h"
#include "VTK/Scene/Interaction/TouchMode.h"
#include "VTK/Scene/Interaction/TouchedScene.h"
#include "VTK/Scene/Interaction/TouchedVolumes.h"
#include "VTK/Scene/Interaction/WorkspaceControl.h"
#include "VTK/Scene/Volumes/CarvedPicture.h"
#include "VTK/Scene/Volumes/HapticShownTimeSteps.h"
#include "VTK/Scene/Volumes/HapticShownVolumes.h"
#include "VTK/Scene/Volumes/RegionPicture.h"

#include "vtkNew.h"
#include "vtkTable.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

class vtkCallbackCommand;
class vtkObject;
class vtkRenderer;

namespace VolumeHaptics
{

/**
 * Detects events in tables of states, in the order of the states. Remembers the last state of a
 * table to compare it with the next table.
 */
class HapticStateWatch
{
public:
  /**
   * Returns the events (vtkInteractorStyleHaptic::HapticEvents) in the table's rows, oldest first.
   */
  std::vector<unsigned long> Watch(vtkTable* states);
  void Reset() { *this = HapticStateWatch(); }

private:
  bool IsTouching = false;
  bool IsArmed = false;
  bool HasFault = false;
};

/**
 * Implements vtkInteractorStyleHaptic, whose header documents the keys and buttons. This class
 * connects parts with one task each. It decides the order of an update, which part gets key and
 * mouse events, and which work counts as long.
 *
 * Functions for keys and mouse return true if they used the event. Otherwise, the style's
 * superclass gets it.
 */
class HapticInteraction
{
public:
  /** Virtual functions of the style, for calls from here. */
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
  /**
   * Set the objects. Return whether they differ from the previous ones. A device that is set during
   * an update takes effect at the end of the update.
   */
  bool SetDevice(vtkHapticDevice* device);
  bool SetSecondDevice(vtkHapticDevice* device);
  bool SetFunctionEditor(vtkHapticFunctionEditor* editor);
  bool SetMeasurements(vtkHapticMeasurements* measurements);
  ///@}
  /** Sets the coarse volume that is shown at full resolution around the hand; null for none. */
  void SetCoarseVolume(vtkVolume* volume);

  vtkHapticDevice* GetDevice() const;

  /** Stops observing the device and the editor. Call this before the style is deleted. */
  void Leave();

  /**
   * Leaves the touch mode and disarms. Call this when the window ends or another style takes over.
   */
  void LetGo();

  /** Leaves the touch mode and fades the force out, because the view is no longer visible. */
  void FadeOut();

  bool MoveMouse();
  bool PressLeftButton();
  bool ReleaseLeftButton();
  bool DoubleClickLeftButton();
  bool PressRightButton();
  bool ReleaseRightButton();
  /** Handles a turn of the wheel. `steps` are positive away from the user. */
  bool TurnWheel(double steps);
  /** Zooms with a function. A hand that the mouse moves stays under the pointer. */
  void Zoom(const std::function<void()>& zoom);
  /** Handles a pressed key, given by X11's name. */
  bool PressKey(const std::string& pressed);
  /** Returns the default key of the action that a key has now; empty if it has none. */
  std::string FindAction(const std::string& pressed) const;
  /**
   * Performs the action with a default key. Returns false if the scene lacks the part for it. With
   * `isPressed`, the position of the pointer decides what is undone.
   */
  bool Perform(const std::string& key, bool isPressed = false);
  bool ReleaseKey(const std::string& released);
  /** Returns whether a pressed key now belongs to the action with a default key. */
  bool IsPressOf(const std::string& pressed, const std::string& key) const
  {
    return !this->Repeat.IsRepeat(pressed) && this->FindAction(pressed) == key;
  }
  /**
   * Returns whether a press is an automatic repetition of the last used key, which is held. If so,
   * records the press.
   */
  bool IsRepeat(const std::string& pressed)
  {
    const bool isHeld = pressed == this->UsedKey && this->Repeat.IsRepeat(pressed);
    if (isHeld)
    {
      this->Repeat.RecordPress(pressed);
    }
    return isHeld;
  }
  /** Returns whether to keep a typed key from the superclass, where it has another effect. */
  bool TypeKey(const std::string& typed) const;

  ///@{
  /** See the functions of the same names in the style. */
  bool UpdateHaptics();
  void CheckShownVolumes();
  bool NextMethod();
  bool SwapSettings();
  ///@}

  // The order matters: later parts depend on earlier ones.
  TouchedScene Scene;
  HapticWindowWatch Window;
  SceneFrames Frames;
  WorkspaceControl Workspace;
  SecondHand Second;
  TouchMode Touch;
  ToolTurn Turn;
  KeyMap Keys;
  DisplayKeys Displays;
  HapticShownTimeSteps ShownTimeSteps;
  CarvedPictures Carved;
  std::uint64_t CarvedChanges = 0; ///< number of changes to removed tissue at the last update
  TouchedVolumes Touched;
  RegionPicture Refined; ///< shows a volume beyond memory at full resolution around the hand
  FilterPublisher Publisher;
  ComparedSettings Compared;
  vtkNew<vtkTable> States; ///< states that were read in the last update

private:
  void LeaveDevice();
  /** Arms all hands that are not armed. If that changes nothing, disarms both. */
  void ArmOrDisarm();
  /** Homes the real devices that wait for homing, or all real devices if none waits. */
  void HomeDevices();
  bool Update(vtkInteractorStyleHaptic* style);
  bool UpdateFirst(vtkInteractorStyleHaptic* style, vtkRenderer* renderer);
  /**
   * Updates the filters to what the touched volumes show. Ends the touch of volumes that are no
   * longer shown.
   */
  void UpdateVolumes();
  void UpdateRefined();
  /** Updates the volumes to the tissue that tools have left. */
  void UpdateCarving();
  /** Draws the scene if the mouse has changed what the slices show. Returns whether it did. */
  bool DrawSlices();
  void HandleWork(vtkObject* worker, bool begins);

  PlaybackKeys Playback;
  KeyRepeat Repeat;
  std::string UsedKey; ///< last pressed key that was used
  ModeKeys Modes;
  EditorKeys Editor;
  SliceMouse Slices;
  MeasureKeys Measure;
  HapticShownVolumes Volumes;
  HapticStateWatch Watch;
  int Reader = 0;       ///< number of this reader of the device's states
  double Updated = 0.0; ///< the device's time at the last update (s)
  bool IsUpdating = false;
  /// Device that an observer has set during this update.
  std::optional<vtkSmartPointer<vtkHapticDevice>> NextDevice;
  bool EditorHasMouse = false;
  bool ListHasMouse = false; ///< whether a click on the list of modes is in progress
  vtkNew<vtkCallbackCommand> DisarmObserver;
  vtkNew<vtkCallbackCommand> WorkObserver; ///< invoked at the start and end of long work of the
                                           ///< device and the editor
  /// Devices whose force is off while the editor is working.
  std::vector<vtkSmartPointer<vtkHapticDevice>> DevicesAtRest;
};

} // namespace VolumeHaptics

#endif

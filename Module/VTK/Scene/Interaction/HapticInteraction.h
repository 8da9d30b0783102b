// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Connects keys, mouse and timer with a haptic device, its tip, and the view.
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
 * Detects events in tables of states, in the order of the states. Keeps the last state of a table
 * for the next table.
 */
class HapticStateWatch
{
public:
  /**
   * Returns the events (vtkInteractorStyleHaptic::HapticEvents) of the table's rows, oldest first.
   */
  std::vector<unsigned long> Watch(vtkTable* states);
  void Reset() { *this = HapticStateWatch(); }

private:
  bool IsTouching = false;
  bool IsArmed = false;
  bool HasFault = false;
};

/**
 * The implementation of vtkInteractorStyleHaptic, whose header documents the keys and buttons. It
 * connects parts, each of which has one task. It decides the order of an update, which part gets
 * keys and mouse events, and when work counts as long.
 *
 * Functions for keys and the mouse return true if they used the event. Otherwise, the style's
 * superclass gets the event.
 */
class HapticInteraction
{
public:
  /** The virtual functions of the style. */
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
   * Set the objects. Return false if nothing changed. A device that is set during an update takes
   * effect at the update's end.
   */
  bool SetDevice(vtkHapticDevice* device);
  bool SetSecondDevice(vtkHapticDevice* device);
  bool SetFunctionEditor(vtkHapticFunctionEditor* editor);
  bool SetMeasurements(vtkHapticMeasurements* measurements);
  ///@}
  /** Sets the coarse volume that is shown finely around the hand; null for none. */
  void SetCoarseVolume(vtkVolume* volume);

  vtkHapticDevice* GetDevice() const;

  /** Stops observing the device and the editor. Call this before the style is deleted. */
  void Leave();

  /**
   * Leaves the touch mode and disarms. Call this when the window ends or another style takes over.
   */
  void LetGo();

  /** Leaves the touch mode and lets the force fade, because the view is no longer visible. */
  void FadeOut();

  bool MoveMouse();
  bool PressLeftButton();
  bool ReleaseLeftButton();
  bool DoubleClickLeftButton();
  bool PressRightButton();
  bool ReleaseRightButton();
  /** Handles a turn of the wheel. `steps` are positive away from the viewer. */
  bool TurnWheel(double steps);
  /** Zooms by a function; the hand that the mouse leads stays under the pointer. */
  void Zoom(const std::function<void()>& zoom);
  /** Handles the press of a key. `pressed` is X11's name of the key. */
  bool PressKey(const std::string& pressed);
  /** Returns the default key of a key's action now; empty if it has none. */
  std::string FindAction(const std::string& pressed) const;
  /**
   * Performs the action with a default key. Returns false if the scene has no part for it. With
   * `isPressed`, the pointer chooses what is undone.
   */
  bool Perform(const std::string& key, bool isPressed = false);
  bool ReleaseKey(const std::string& released);
  /** Returns whether a key was pressed now for the action with a default key. */
  bool IsPressOf(const std::string& pressed, const std::string& key) const
  {
    return !this->Repeat.IsRepeat(pressed) && this->FindAction(pressed) == key;
  }
  /** Returns whether a press repeats the last used press because the key is held. */
  bool IsRepeat(const std::string& pressed) const
  {
    return pressed == this->UsedKey && this->Repeat.IsRepeat(pressed);
  }
  /**
   * Returns whether the superclass must not get a typed key, because the key has another effect
   * there.
   */
  bool TypeKey(const std::string& typed) const;

  ///@{
  /** See the style's functions of the same names. */
  bool UpdateHaptics();
  void CheckShownVolumes();
  bool NextMethod();
  bool SwapSettings();
  ///@}

  // Later parts depend on earlier ones.
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
  std::uint64_t CarvedChanges = 0; ///< number of changes of the removed tissue at the last update
  TouchedVolumes Touched;
  RegionPicture Refined; ///< shows a volume beyond memory finely around the hand
  FilterPublisher Publisher;
  ComparedSettings Compared;
  vtkNew<vtkTable> States; ///< states of the last update

private:
  void LeaveDevice();
  /** Arms the hands that are not armed. If that changes nothing, disarms both. */
  void ArmOrDisarm();
  /** Homes the real devices that wait for homing. If no device waits, homes all of them. */
  void HomeDevices();
  bool Update(vtkInteractorStyleHaptic* style);
  bool UpdateFirst(vtkInteractorStyleHaptic* style, vtkRenderer* renderer);
  /**
   * Makes the filters feel what the touched volumes show, and lets go of volumes that are no longer
   * shown.
   */
  void UpdateVolumes();
  void UpdateRefined();
  /** Makes volumes show the tissue that a tool has left. */
  void UpdateCarving();
  /** If the mouse has changed what the slices show, draws the scene and returns true. */
  bool DrawSlices();
  void HandleWork(vtkObject* worker, bool begins);

  PlaybackKeys Playback;
  KeyRepeat Repeat;
  std::string UsedKey; ///< the last pressed key that was used
  ModeKeys Modes;
  EditorKeys Editor;
  SliceMouse Slices;
  MeasureKeys Measure;
  HapticShownVolumes Volumes;
  HapticStateWatch Watch;
  int Reader = 0;       ///< number by which the device's states know this reader
  double Updated = 0.0; ///< the device's time at the last update (s)
  bool IsUpdating = false;
  /// the device that an observer has set during the present update
  std::optional<vtkSmartPointer<vtkHapticDevice>> NextDevice;
  bool EditorHasMouse = false;
  bool ListHasMouse = false; ///< whether a click on the list of modes is under way
  vtkNew<vtkCallbackCommand> DisarmObserver;
  vtkNew<vtkCallbackCommand> WorkObserver; ///< observes long work of the device and the editor
  /// the devices whose force is off while the editor counts
  std::vector<vtkSmartPointer<vtkHapticDevice>> DevicesAtRest;
};

} // namespace VolumeHaptics

#endif

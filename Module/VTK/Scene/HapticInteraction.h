// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Lets keys, mouse and timer act on a haptic device, its tip, and the view.
 */
#ifndef HapticInteraction_h
#define HapticInteraction_h

#include "VTK/Scene/FilterPublisher.h"
#include "VTK/Scene/HapticShownVolumes.h"
#include "VTK/Scene/HapticStateWatch.h"
#include "VTK/Scene/HapticWindowWatch.h"
#include "VTK/Scene/SceneFrames.h"
#include "VTK/Scene/TouchMode.h"
#include "VTK/Scene/TouchedScene.h"
#include "VTK/Scene/WorkspaceControl.h"

#include "vtkNew.h"
#include "vtkTable.h"

#include <functional>
#include <string>

class vtkCallbackCommand;
class vtkObject;

namespace VolumeHaptics
{

/**
 * Stands behind vtkInteractorStyleHaptic, which says what each key and button does. It is composed
 * of parts that have a subject each, and connects them: the order of an update, the keys and the
 * mouse, and long work.
 *
 * Functions for keys and the mouse are true if they used the event, else the style's superclass
 * gets it.
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
  ///@}

  /** Stops observing the device and the editor; the style is going to be deleted. */
  void Leave();

  /** Leaves the touch mode and disarms, when the window closes or another style takes over. */
  void LetGo();

  bool MoveMouse();
  bool PressLeftButton();
  bool ReleaseLeftButton();
  bool DoubleClickLeftButton();
  /** By steps away from the viewer. */
  bool TurnWheel(double steps);
  bool PressKey(const std::string& key);
  bool ReleaseKey(const std::string& key);
  /** Keeps a key from the superclass that would do something else with it. */
  bool TypeKey(char key) const;

  ///@{
  /** See the style's functions of these names. */
  bool UpdateHaptics();
  void CheckShownVolumes();
  bool NextMethod();
  ///@}

  // The parts, in the order in which they need each other.
  TouchedScene Scene;
  HapticWindowWatch Window;
  SceneFrames Frames;
  WorkspaceControl Workspace;
  TouchMode Touch;
  vtkNew<vtkTable> States; ///< of the last update

private:
  void LeaveDevice();
  void FollowWork(vtkObject* worker, bool begins);

  FilterPublisher Publisher;
  HapticShownVolumes Volumes;
  HapticStateWatch Watch;
  int Reader = 0;       ///< of the device's states
  double Updated = 0.0; ///< the device's time (s) at the last update
  bool EditorHasMouse = false;
  vtkNew<vtkCallbackCommand> DisarmObserver;
  vtkNew<vtkCallbackCommand> WorkObserver;       ///< of the device and the editor
  vtkSmartPointer<vtkHapticDevice> DeviceAtRest; ///< while the editor counts
};

} // namespace VolumeHaptics

#endif

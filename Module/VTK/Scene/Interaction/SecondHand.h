// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Handles the second device of a scene, for the other hand. Its workspace, models and force are
 * separate; both hands share the keys, the window and the view of the scene.
 */
#ifndef SecondHand_h
#define SecondHand_h

#include "VTK/Scene/Interaction/FilterPublisher.h"
#include "VTK/Scene/Interaction/TouchedScene.h"
#include "VTK/Scene/Interaction/WorkspaceControl.h"

class vtkRenderer;

namespace VolumeHaptics
{

class SecondHand
{
public:
  explicit SecondHand(TouchedScene& first);
  ~SecondHand() = default;
  SecondHand(const SecondHand&) = delete;
  SecondHand& operator=(const SecondHand&) = delete;

  /** Sets the device, after disarming the previous one. Returns whether it differs. */
  bool SetDevice(vtkHapticDevice* device);
  bool IsArmOrdered() const { return this->Scene.Device && this->Scene.Device->IsArmOrdered(); }
  void Disarm();
  void FadeOut();

  /**
   * Publishes changes of the filter and of the camera, and reads the servo's state. Returns whether
   * the state is new.
   */
  bool Update(vtkRenderer* renderer);

  TouchedScene Scene; ///< scene with this hand's device
  WorkspaceControl Workspace;

private:
  TouchedScene& First; ///< scene with the first hand's device
  FilterPublisher Publisher;
};

} // namespace VolumeHaptics

#endif

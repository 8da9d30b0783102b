// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The private side of vtkInteractorStyleHaptic.
 */
#ifndef vtkInteractorStyleHapticInternals_h
#define vtkInteractorStyleHapticInternals_h

#include "vtkInteractorStyleHaptic.h"

#include "VTK/Scene/HapticRenderPace.h"
#include "VTK/Scene/HapticShownVolumes.h"
#include "VTK/Scene/HapticStateWatch.h"
#include "VTK/Scene/HapticWindowWatch.h"
#include "VTK/Scene/HapticWorkspace.h"
#include "VTK/Session/HapticChangeTime.h"
#include "VTK/Session/HapticLongWork.h"

#include "vtkCallbackCommand.h"
#include "vtkHapticDevice.h"
#include "vtkHapticFunctionEditor.h"
#include "vtkHapticHeadUpDisplay.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkVolumeHapticsFilter.h"

#include <string>

struct vtkInteractorStyleHaptic::vtkInternals
{
  explicit vtkInternals(vtkInteractorStyleHaptic* self)
    : Window(self, [self] { self->LetGo(); })
  {
  }

  vtkSmartPointer<vtkHapticDevice> Device;
  vtkSmartPointer<vtkHapticHeadUpDisplay> Display;
  vtkSmartPointer<vtkHapticFunctionEditor> Editor;
  vtkNew<vtkTable> States;
  VolumeHaptics::HapticWindowWatch Window;
  VolumeHaptics::HapticShownVolumes Volumes;
  int Reader = 0;       ///< of the device's states
  double Updated = 0.0; ///< the device's time (s) at the last update
  VolumeHaptics::HapticStateWatch Watch;
  VolumeHaptics::HapticWorkspace Workspace;

  VolumeHaptics::HapticRenderPace Pace;
  VolumeHaptics::Vector3 DrawnTip;   ///< world; as last drawn
  VolumeHaptics::Vector3 DrawnProxy; ///< world
  bool HasHappened = false;          ///< an event, since then

  int Timer = 0;
  int FiredTimer = 0; ///< interactors hand their timer's id to observers, but styles don't get it
  vtkNew<vtkCallbackCommand> TimerObserver;
  vtkMTimeType Published = 0; ///< the filter's time when the servo got it
  std::string Unfelt;         ///< the method that could not be felt, when it was tried last
  std::string FeltInstead;    ///< and the one that stayed
  vtkMTimeType Placed = 0;    ///< the camera's time when the workspace was put there
  bool IsPlaced = false;
  bool ArmAfterClutch = false;   ///< was armed before, and nobody has disarmed it since
  bool IsTouchBeginning = false; ///< and nothing has ended it since
  vtkNew<vtkCallbackCommand> DisarmObserver;
  VolumeHaptics::Vector3 ClutchedTip; ///< world
  VolumeHaptics::Vector3 Lead;        ///< world; where the mouse leads the tip
  bool EditorHasMouse = false;
  vtkNew<vtkCallbackCommand> WorkObserver;       ///< of the device and the editor
  vtkSmartPointer<vtkHapticDevice> DeviceAtRest; ///< while the editor counts

  bool IsVirtual() const { return this->Device && this->Device->GetDeviceId() == "virtual"; }
  bool IsReal() const { return this->Device && this->Device->IsOpen() && !this->IsVirtual(); }

  /** As of the last state. */
  bool IsArmed() const
  {
    const int status = this->Device->GetStatus();
    return status == vtkHapticDevice::ARMED || status == vtkHapticDevice::ACTIVE;
  }

  /** When something changed last that a servo is to know: the filter or what it is fed with. */
  vtkMTimeType GetChangeTime() const
  {
    return VolumeHaptics::FindChangeTime(this->Device->GetVolumeHaptics());
  }

  void LeadTo(const VolumeHaptics::Vector3& world)
  {
    this->Lead = world;
    this->Device->SetVirtualTip(world.X, world.Y, world.Z);
  }
};

#endif
